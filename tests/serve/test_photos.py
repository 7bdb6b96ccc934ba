"""Photographs that a browser sends: what may be clicked, the report of the command, refusals and remedies."""

from __future__ import annotations

import io
import shutil
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

import pytest
from PIL import Image
from support.command import invoke
from support.each import each
from support.own_sheets import Kind, Sheet, own_sheet
from support.served import HOST, Answer, Browser, opened, run, small

from graphic_tmm.serve import routes

CASES = Path(__file__).parents[1] / "cases" / "check"
BYTES = "application/octet-stream"
DULL = io.BytesIO()
Image.new("RGB", (300, 200), (90, 90, 90)).save(DULL, "PNG")


async def sent(
    browser: Browser,
    name: str,
    data: bytes | list[bytes],
    *options: tuple[str, Any],
    to: str = "photo",
    **headers: str | None,
) -> Answer:
    path = f"/s/{name}/{to}?{urlencode(options)}"
    return await browser.ask(path, "POST", data, **{"content_type": BYTES, **headers})


@pytest.fixture(scope="session")
def sheet() -> Sheet:
    """A photograph of a sheet of A4 with a plan of velocities and one of accelerations, Coriolis' left out."""
    return own_sheet(Kind("rpr", "k left out", "A4", wide=2800), 3)


def lever(folder: Path) -> Path:
    """The scene of a slotted lever, in a folder of its own."""
    (folder / "lever").mkdir()
    return Path(shutil.copy(CASES / "rpr.toml", folder / "lever" / "scene.toml"))


@pytest.mark.slow
def test_plans_of_vectors_may_be_clicked_with_their_letters(tmp_path: Path) -> None:
    file = lever(tmp_path)
    bare = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            told = (await browser.ask("/s/lever/plans")).json()
        assert [(one["plan"], one["pole"], one["first"]) for one in told["plans"]] == [
            ("velocities", "p", "a"),
            ("accelerations", "π", "a"),
        ]
        assert [one["positions"] for one in told["plans"]] == [list("01234567"), list("136")]
        assert told["sheets"] == ["A1"]
        assert told["papers"][0] == "A4"
        async with opened(bare, drawing=False) as (browser, _):
            assert (await browser.ask("/s/small/plans")).json()["plans"] == []

    run(serving)


@pytest.mark.slow
def test_the_report_is_the_command_s(
    sheet: Sheet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = lever(tmp_path)
    (tmp_path / "own.jpg").write_bytes(sheet.jpeg)
    plans = [
        f"{plan}:{position}={p.real:.1f},{p.imag:.1f},{a.real:.1f},{a.imag:.1f}"
        for (plan, position), (p, a) in sheet.plans.items()
    ]
    monkeypatch.chdir(tmp_path)
    clicked = [part for plan in plans for part in ("--plan", plan)]
    done = invoke("photo", file, "own.jpg", "--paper", "A4", *clicked, "-o", "report.html")
    assert done.exit_code == 1, done.output

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            options = [("name", "own.jpg"), ("paper", "A4"), *(("plan", plan) for plan in plans)]
            answer = await sent(browser, "lever", sheet.jpeg, *options)
            assert answer.status == 200, answer.body
            told = answer.json()
            report = await browser.ask(f"/s/lever/report/{told['page']}.html")
            assert report.body == (tmp_path / "report.html").read_bytes()
            assert "default-src 'none'" in report.headers["content-security-policy"]
            assert report.headers["x-frame-options"] == "SAMEORIGIN"
            assert told["says"] in report.body.decode()
            # where points were seen is where the end of the first vector was drawn
            _, first = sheet.plans["velocities", "1"]
            marks = [complex(one["x"], one["y"]) for one in told["marks"]]
            assert min(abs(mark - first) for mark in marks) < 6.0
            assert "wrong" in {one["verdict"] for one in told["marks"]}

    run(serving)


@pytest.mark.slow
def test_plans_are_proposed_as_by_the_command(sheet: Sheet, tmp_path: Path) -> None:
    file = lever(tmp_path)
    photo = tmp_path / "own.jpg"
    photo.write_bytes(sheet.jpeg)
    done = invoke(
        "photo", file, photo, "--paper", "A4", "--propose", "--overlay", tmp_path / "a.svg"
    )

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            answer = await sent(browser, "lever", sheet.jpeg, ("paper", "A4"), to="proposals")
            plans = answer.json()["plans"]
            assert plans
            for one in plans:
                at = ",".join(f"{x:.0f}" for x in (*one["pole"], *one["first"]))
                assert f"--plan {one['plan']}:{one['position']}={at}\n" in done.stdout
            assert done.stdout.count("--plan") == len(plans)
            answer = await sent(browser, "lever", b"", ("paper", "A4"), to="proposals")
            assert answer.status == 400

    run(serving)


@pytest.mark.slow
def test_what_is_not_found_is_told_with_its_remedy(tmp_path: Path) -> None:
    file = lever(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            for data, options, says in (
                (DULL.getvalue(), [("paper", "A4")], "give its corners with --corners"),
                (b"no picture", [("name", "a\x1b.jpg")], "save it as JPEG or PNG"),
                (DULL.getvalue(), [("plan", "velocities")], "--plan: write plan, position"),
                (DULL.getvalue(), [("sheet", 7)], "there is no sheet 7"),
            ):
                for to in ("photo", "proposals")[: 1 if says.startswith("--plan") else 2]:
                    answer = await sent(browser, "lever", data, *options, to=to)
                    assert answer.status == 422
                    (fault,) = answer.json()["errors"]
                    assert says in fault["text"]
                    assert "\x1b" not in fault["text"]

    run(serving)


WRONG = [
    *([("sheet", text)] for text in ("0", "-1", "1.5", "٣", "99999", "")),
    *([("paper", text)] for text in ("A0", "A4 landscape", "..")),
    [("plan", "x" * 30_000)],
]


@each("options", WRONG)
def test_what_no_page_of_ours_asks_is_refused(
    options: list[tuple[str, str]], tmp_path: Path
) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            assert (await sent(browser, "small", b"x", *options)).status == 400

    run(serving)


def test_photographs_are_limited_and_of_this_page_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = small(tmp_path)
    monkeypatch.setattr(routes, "PHOTO", 1000)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            assert (await sent(browser, "small", b"")).status == 400
            assert (await sent(browser, "small", [b" " * 600] * 2)).status == 400
            assert (await sent(browser, "none", b" ")).status == 404
            for headers in (
                {"origin": "http://evil.example"},
                {"sec_fetch_site": "cross-site"},
                {"content_type": "text/plain"},
                {"content_type": "image/jpeg"},
                {"content_type": "multipart/form-data"},
            ):
                assert (await sent(browser, "small", b" ", **headers)).status == 404, headers
            answer = await sent(browser, "small", b" ", origin=f"http://{HOST}")
            assert answer.status == 422
            assert (await browser.ask("/s/small/report/none.html")).status == 404

    run(serving)
