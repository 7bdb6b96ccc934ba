"""Who may ask: nobody without the token, under another name of the host, from another page, nor too much."""

from __future__ import annotations

import asyncio
import json
import os
import socket
from contextlib import ExitStack
from pathlib import Path

import pytest
from support.each import each
from support.real_server import serving
from support.served import HOST, SMALL, TOKEN, opened, run, small

from graphic_tmm.errors import SceneError
from graphic_tmm.serve import limits, routes, sent
from graphic_tmm.serve.folder import Folder, folder_of

PATHS = [
    *("/s/../scene.toml", "/s/..%2fscene.toml", "/s/small/../../scene.toml", "/s//", "/s/"),
    *("/web/../routes.py", "/web/%2e%2e/routes.py", "/web/..\\routes.py", "/web/", "/web/a/b.js"),
    *("/s/small/sheet/../x.svg", "/s/small/sheet/.svg", "/s/small/sheet/*.svg", "/s/small\0/"),
    *("/s/small/download/exe", "/s/small/download/../toml", "/s/small/download/", "/s/small"),
    *(
        "/s/SMALL/",
        "/s/small.toml/",
        "/s/%73mall/",
        "/s/" + "a" * 5000 + "/",
        "/s/é/",
        "/s/\ud800/",
    ),
    *("/s//etc/passwd", "//etc/passwd", "/etc/passwd", "/.git/config", "/scene.toml", "/s/./form"),
]
TOKENS = [
    *(
        "",
        TOKEN[:-1],
        TOKEN + "x",
        TOKEN.upper(),
        "..",
        TOKEN.replace("a", "а"),
        "\ud800",
        "x" * 70_000,
    ),
    *(f"../{TOKEN}", f"x/{TOKEN}", f"{TOKEN}\0"),
]
HOSTS = [
    *(None, "", "evil.example", "127.0.0.1.evil.example", "evil.example:8000", "192.168.0.7:8000"),
    *("127.0.0.1@evil.example", "[::1", "[::1].evil.example", "localhost.", "0.0.0.0:8000"),
]


@each("path", PATHS)
def test_a_path_is_no_path_of_files(path: str, tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            answer = await browser.ask(path)
            assert answer.status == 404, answer
            assert b"points" not in answer.body

    run(serving)


@each("token", TOKENS)
def test_without_the_token_nothing_is_there(token: str, tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            for path in ("/", "/s/small/", "/s/small/form", "/web/studio.js"):
                answer = await browser.ask(f"//{token}{path}")
                assert (answer.status, answer.body) == (404, b"")

    run(serving)


@each("host", HOSTS)
def test_under_another_name_nothing_is_there(host: str | None, tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            assert (await browser.ask("/web/studio.js", host=host)).status == 404
            for own in (HOST, "localhost:99", "[::1]:8000", "LOCALHOST"):
                assert (await browser.ask("/web/studio.js", host=own)).status == 200

    run(serving)


def test_to_other_computers_it_is_there_under_figures_only(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, desk):
            browser.app = routes.application(desk, TOKEN, open=True)
            for host, status in (
                ("192.168.0.7:80", 200),
                ("[fe80::1]:80", 200),
                ("evil.example", 404),
            ):
                assert (await browser.ask("/web/studio.js", host=host)).status == status

    run(serving)


def test_no_other_page_writes_in_a_persons_name(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            body = json.dumps({"version": "", "changes": {"title": "Taken"}}).encode()
            for headers in (
                {"origin": "http://evil.example"},
                {"origin": "null"},
                {"origin": "http://127.0.0.1:8001"},
                {"origin": "http://[::1"},
                {"sec_fetch_site": "cross-site"},
                {"sec_fetch_site": "same-site"},
                {"content_type": "text/plain"},
                {"content_type": "application/x-www-form-urlencoded"},
                {"content_type": None},
            ):
                answer = await browser.ask("/s/small/form", "POST", body, **headers)
                assert answer.status == 404, headers
            for method in ("PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "BREW"):
                answer = await browser.ask("/s/small/form", method, body, origin=f"http://{HOST}")
                assert answer.status in (404, 405), method

    run(serving)
    assert file.read_text(encoding="utf-8") == SMALL


@pytest.mark.slow
def test_every_answer_says_what_it_may_do_and_is_kept_nowhere(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            state = await browser.settled("small")
            sheet = f"/s/small/sheet/{state['sheets'][0]['hash']}.svg"
            page = f"/s/small/page/{state['page']}.html"
            for path in (
                "/",
                "/s/small/",
                "/s/small/form",
                "/web/studio.js",
                "/no",
                "//no",
                sheet,
                page,
            ):
                told = (await browser.ask(path)).headers
                assert told["cache-control"] == "no-store"
                assert told["referrer-policy"] == "no-referrer"
                assert told["x-content-type-options"] == "nosniff"
                policy = told["content-security-policy"]
                assert ("frame-ancestors 'self'" if path in (sheet, page) else "'none'") in policy
                assert path == page or "default-src 'none'" in policy
            shown = (await browser.ask(page)).body
            assert b'http-equiv="Content-Security-Policy" content="default-src \'none\'' in shown

    run(serving)


def test_bodies_are_limited_in_size_and_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = small(tmp_path)
    monkeypatch.setattr(sent, "BODY_TIME", 0.2)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            many = [b" " * 100_000] * 50
            for body in (b"", b"{", b"[]", b"1", b"\xff", b"[" * 200_000, b'{"version": 1}', many):
                answer = await browser.ask("/s/small/form", "POST", body)
                assert answer.status == 400
                assert body is not many or len(many) == 50
            for changes in ('{"a": 1}', '["a"]', '{"a": null}', '{"a": {}}', "1e999"):
                body = f'{{"version": "", "changes": {changes}}}'.encode()
                assert (await browser.ask("/s/small/form", "POST", body)).status == 400
            slow = browser.ask("/s/small/form", "POST", [b"{", b""])
            assert (await asyncio.wait_for(slow, 5)).status == 400

    run(serving)
    assert file.read_text(encoding="utf-8") == SMALL


def test_only_so_many_follow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = small(tmp_path)
    monkeypatch.setattr(routes, "STREAMS", 2)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            followers = [browser.states("/s/small/events") for _ in range(2)]
            for one in followers:
                await anext(one)
            assert (await browser.ask("/s/small/events")).status == 503
            for one in followers:
                await one.aclose()  # type: ignore[attr-defined]
            await browser.settled("small")

    run(serving)
    assert routes.Stream.open == 0


# files


def test_links_that_lead_out_are_not_followed(tmp_path: Path) -> None:
    secret = tmp_path / "secret.toml"
    secret.write_text(SMALL, encoding="utf-8")
    folder = tmp_path / "scenes"
    kept = small(folder, "kept")
    (folder / "link.toml").symlink_to(secret)
    (folder / "round.toml").symlink_to(folder / "round.toml")
    (folder / "far").symlink_to(tmp_path)
    (tmp_path / "scene.toml").write_text(SMALL, encoding="utf-8")
    small(folder, "bare").unlink()
    (folder / "bare" / "scene.toml").symlink_to(secret)
    (folder / "within.toml").symlink_to(kept)
    (kept.parent / "composition.toml").symlink_to(secret)
    there = Folder(folder)
    for name, file in there.scenes().items():
        if name not in ("kept", "within"):
            with pytest.raises(SceneError, match="leads out"):
                there.read(file)
            with pytest.raises(SceneError, match="leads out"):
                there.write(file, b"")
    with pytest.raises(SceneError, match="leads out"):
        there.composition(kept)
    assert there.read(folder / "within.toml") == SMALL.encode()
    there.write(folder / "within.toml", b"# changed")
    assert (folder / "within.toml").is_symlink()
    assert kept.read_bytes() == b"# changed"
    assert secret.read_text(encoding="utf-8") == SMALL
    assert set(there.watched()) == {folder, kept.parent}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_pipes_folders_and_giants_are_not_read(tmp_path: Path) -> None:
    for name in ("pipe", "folder", "giant", "none"):
        (tmp_path / name).mkdir()
    os.mkfifo(tmp_path / "pipe" / "scene.toml")
    (tmp_path / "folder" / "scene.toml").mkdir()
    with (tmp_path / "giant" / "scene.toml").open("wb") as giant:
        giant.truncate(10**12)
    there = Folder(tmp_path)
    assert list(there.scenes()) == ["giant"]
    for name in ("pipe", "folder", "giant", "none"):
        with pytest.raises(SceneError):
            there.read(tmp_path / name / "scene.toml")


def test_a_scene_of_the_package_is_shown_and_never_written() -> None:
    there = folder_of("lever")
    assert there.fixed
    before = there.read(next(iter(there.scenes().values())))

    async def serving() -> None:
        async with opened(there, drawing=False) as (browser, _):
            form = (await browser.ask("/s/lever/form")).json()
            assert form["groups"]
            body = json.dumps({"version": form["version"], "changes": {"title": "Taken"}}).encode()
            assert (await browser.ask("/s/lever/form", "POST", body)).status == 403

    run(serving)
    assert there.read(next(iter(there.scenes().values()))) == before


def test_a_folder_shows_so_many_scenes_at_most(tmp_path: Path) -> None:
    for k in range(limits.SCENES + 5):
        (tmp_path / f"{k:03d}.toml").write_text("", encoding="utf-8")
    assert list(Folder(tmp_path).scenes()) == [f"{k:03d}" for k in range(limits.SCENES)]


@pytest.mark.slow
@pytest.mark.parametrize("says", [b"", b"GET /s/ HT", b"GET /secret/ HTTP/1.1\r\nhost: x\r\n\r\n"])
def test_whoever_knows_no_token_keeps_nobody_out(says: bytes, tmp_path: Path) -> None:
    """Twice as many connections as are answered at once: silent, amid a request, refused and kept open."""
    with serving(small(tmp_path)) as server, ExitStack() as lines:
        for _ in range(2 * limits.CONNECTIONS):
            line = lines.enter_context(socket.create_connection((server.host, server.port), 10))
            line.sendall(says)
        for _ in range(3):
            assert server.ask("/")[0] in (200, 307)
