"""What a browser asks for besides: values set in the file by two at once, files in every format."""

from __future__ import annotations

import asyncio
import io
import json
import os
import stat
import zipfile
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import pytest
from support.command import invoke, printed
from support.served import SMALL, Browser, opened, run, small

from graphic_tmm.serve import extra
from graphic_tmm.serve.answers import EXTRAS, FORMS, forms, zipped

CRANK = "link 1, points.A[1]"


async def set_(browser: Browser, version: str, **changes: str):  # type: ignore[no-untyped-def]
    told = {"version": version, "changes": changes}
    return await browser.ask("/s/small/form", "POST", json.dumps(told).encode())


def test_of_two_who_write_at_once_one_is_told_of_the_other(tmp_path: Path) -> None:
    file = small(tmp_path)
    file.chmod(0o600)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, desk):
            form = (await browser.ask("/s/small/form")).json()
            answers = await asyncio.gather(
                *(set_(browser, form["version"], title=f"Of {k}") for k in range(4))
            )
            assert sorted(one.status for one in answers) == [200, 409, 409, 409]
            (done,) = {one.json()["version"] for one in answers}
            assert (await browser.ask("/s/small/form")).json()["version"] == done
            # an editor that saves while a form is judged is not written over
            plain = desk.front.ask

            async def late(*given: Any, **limits: Any) -> Any:
                found = await plain(*given, **limits)
                file.write_text("# theirs", encoding="utf-8")
                return found

            desk.front.ask = late  # type: ignore[method-assign]
            assert (await set_(browser, done, title="Mine")).status == 409

    run(serving)
    assert file.read_text(encoding="utf-8") == "# theirs"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600


def test_a_refused_value_is_told_by_its_key_and_nothing_is_written(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            version = (await browser.ask("/s/small/form")).json()["version"]
            answer = await set_(browser, version, **{"drive.speed": "10 kg"})
            assert answer.status == 422
            (told,) = answer.json()["errors"]
            assert told["key"] == "drive.speed"
            file.write_text("no = [toml", encoding="utf-8")
            answer = await browser.ask("/s/small/form")
            assert answer.status == 422
            assert answer.json()["errors"][0]["line"] == 1

    run(serving)


@pytest.mark.slow
def test_downloads_are_the_files_of_the_commands(tmp_path: Path) -> None:
    file = small(tmp_path)
    printed("draw", file, "-o", tmp_path / "out", "-f", "svg,html,dxf")

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            for form in ("svg", "html"):
                found = await browser.ask(f"/s/small/download/{form}")
                assert found.body == (tmp_path / "out" / f"small.{form}").read_bytes()
                assert found.headers["content-type"] == "application/octet-stream"
                named = found.headers["content-disposition"]
                assert named == f"attachment; filename*=UTF-8''small.{form}"
            table = await browser.ask("/s/small/download/csv")
            assert table.body.decode() == printed("table", file, "-f", "csv")
            assert (await browser.ask("/s/small/download/toml")).body == SMALL.encode()
            file.write_text(SMALL.replace("0.3 m", "0.3 kg"), encoding="utf-8")
            assert (await browser.ask("/s/small/download/toml")).status == 200

    run(serving)


@pytest.mark.slow
def test_every_format_can_be_downloaded(tmp_path: Path) -> None:
    file = small(tmp_path)
    begins = {"pdf": b"%PDF", "png": b"\x89PNG", "note": b"PK", "dxf": b"  0", "svg": b"<svg"}

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            for form in FORMS:
                found = await browser.ask(f"/s/small/download/{form}")
                assert found.status == 200, form
                assert found.body.startswith(begins.get(form, b"")), form

    run(serving)


def test_several_files_come_in_a_zip_of_the_same_bytes_always() -> None:
    files = {"a-1.svg": "один", "a-2.svg": b"two"}
    found = zipped(files)
    assert found == zipped(files)
    with zipfile.ZipFile(io.BytesIO(found)) as archive:
        assert archive.namelist() == list(files)
        assert archive.read("a-1.svg") == "один".encode()


def test_what_is_not_installed_is_not_offered(monkeypatch: pytest.MonkeyPatch) -> None:
    assert set(forms()) == set(FORMS)
    monkeypatch.setattr("graphic_tmm.serve.answers._there", lambda module: False)
    assert set(forms()) == set(FORMS) - set(EXTRAS)
    monkeypatch.setattr(extra, "find_spec", lambda name: None)
    done = invoke("serve", "lever")
    assert done.exit_code == 2
    assert 'pip install "graphic-tmm[serve]"' in done.stderr


def test_what_cannot_be_served_is_told(tmp_path: Path) -> None:
    for name in (tmp_path / "none.toml", "no-such-scene", "-"):
        done = invoke("serve", name)
        assert done.exit_code == 2
        assert done.stderr.count("\n") == 1
    assert os.listdir(tmp_path) == []


def test_the_address_is_opened_in_a_browser_where_that_is_asked(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    address, shown = "http://127.0.0.1:1/token/", SimpleQueue[str]()
    monkeypatch.setattr(extra, "served", lambda *given, tell, **others: tell(address))
    monkeypatch.setattr("webbrowser.open", shown.put)
    assert invoke("serve", "-l", "en").stdout == f"{address}\n"
    done = invoke("serve", "--browser", "-l", "en")
    assert (done.stdout, "Ctrl-C" in done.stderr) == (f"{address}\n", True)
    assert shown.get(timeout=60) == address
    assert shown.empty()
