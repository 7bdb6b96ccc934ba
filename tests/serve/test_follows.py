"""A scene that is served follows its file: sheets first, the page behind, both as the commands draw them."""

from __future__ import annotations

import asyncio
import json
import os
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import pytest
import watchfiles
from support.served import SMALL, Browser, opened, run, small

from graphic_tmm.page.page import page
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.serve import desk as desks
from graphic_tmm.serve import jobs
from graphic_tmm.serve.kept import hashed
from graphic_tmm.studio import composed_sheets


async def fetched(browser: Browser, name: str, state: dict[str, Any]) -> tuple[list[bytes], bytes]:
    sheets = [
        (await browser.ask(f"/s/{name}/sheet/{one['hash']}.svg")).body for one in state["sheets"]
    ]
    shown = await browser.ask(f"/s/{name}/page/{state['page']}.html")
    assert shown.headers["content-type"] == "text/html; charset=utf-8"
    return sheets, shown.body


def drawn(file: Path) -> tuple[list[bytes], bytes]:
    made, found = composed_sheets(read(file))
    whole = page(made, found.sheets, practised=True)
    return [svg(one).encode() for one in found.sheets], whole.encode()


def replaced(file: Path, text: str) -> None:
    """Write a file as editors do: beside it, then in its place."""
    other = file.with_name("other~")
    other.write_text(text, encoding="utf-8")
    os.replace(other, file)


def test_what_is_served_is_what_the_commands_draw_and_an_edit_is_drawn_anew(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small")
            assert first["ok"]
            assert first["errors"] == []
            assert await fetched(browser, "small", first) == drawn(file)
            replaced(file, SMALL.replace("0.1 m", "0.12 m"))
            second = await browser.settled("small", lambda one: one["page"] != first["page"])
            assert second["version"] > first["version"]
            assert second["text_version"] != first["text_version"]
            assert second["sheets"][0]["hash"] != first["sheets"][0]["hash"]
            assert await fetched(browser, "small", second) == drawn(file)
            # whoever has not heard of it yet still finds what there was
            assert (await browser.ask(f"/s/small/page/{first['page']}.html")).status == 200

    run(serving)


@pytest.mark.slow
def test_comments_and_layout_draw_nothing_anew(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, desk):
            first = await browser.settled("small")
            file.write_text("# one more line\n\n" + SMALL, encoding="utf-8")
            version = first["text_version"]
            second = await browser.settled("small", lambda one: one["text_version"] != version)
            assert second["page"] == first["page"]
            assert second["sheets"] == first["sheets"]
            assert len(desk.scenes["small"].kept.contents) == len(first["sheets"]) + 1

    run(serving)


@pytest.mark.slow
def test_that_no_speed_is_given_is_told(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            assert (await browser.settled("small"))["warnings"] == []
            file.write_text(SMALL.replace('"10 1/s"', "0"), encoding="utf-8")
            stands = await browser.settled("small", lambda one: one["warnings"])
            assert "plans of velocities are of possible ones" in stands["warnings"][0]

    run(serving)


def test_faults_are_told_by_line_and_the_last_sheets_stay(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small")
            for text, line, key, words in (
                (SMALL.replace("0.3 m", "0.3 kg"), 11, "link 2, points.B", "length"),
                (SMALL.replace("[drive]", "[drive"), 16, "", ""),
                (SMALL.replace("slides =", "#"), 0, "", "pair is missing"),
            ):
                file.write_text(text, encoding="utf-8")
                bad = await browser.settled("small", lambda one: not one["ok"])
                assert bad["sheets"] == first["sheets"]
                told = bad["errors"][0]
                assert (told["line"], told["key"]) == (line, key)
                assert words in told["text"]
                assert str(tmp_path) not in told["text"]
                file.write_text(SMALL, encoding="utf-8")
                again = await browser.settled("small", lambda one: one["ok"])
                assert again["errors"] == []
            file.unlink()
            assert not (await browser.settled("small", lambda one: not one["ok"]))["ok"]
            file.write_text(SMALL, encoding="utf-8")
            assert (await browser.settled("small", lambda one: one["ok"]))["sheets"] == first[
                "sheets"
            ]

    run(serving)


@pytest.mark.slow
def test_a_page_that_fails_leaves_the_sheets_new_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """``fresh`` tells whether the sheets are those of the text that has faults, or those of before."""
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small", lambda one: one["page"])
            assert first["fresh"]
            monkeypatch.setattr(jobs, "paged", json.loads)  # which takes no task
            file.write_text(SMALL.replace("0.1 m", "0.12 m"), encoding="utf-8")
            failed = await browser.settled("small", lambda one: not one["ok"])
            assert failed["fresh"]
            assert failed["errors"] == []  # nothing is wrong with what the file says
            assert "fault of the program" in failed["failed"]
            assert failed["sheets"] != first["sheets"]
            assert failed["page"] == first["page"]
            file.write_text(SMALL.replace("0.3 m", "0.3 kg"), encoding="utf-8")
            version = failed["text_version"]
            bad = await browser.settled("small", lambda one: one["text_version"] != version)
            assert not bad["ok"]
            assert not bad["fresh"]
            assert bad["sheets"] == failed["sheets"]
            monkeypatch.undo()
            file.write_text(SMALL, encoding="utf-8")
            again = await browser.settled("small", lambda one: one["ok"] and not one["busy"])
            assert (again["fresh"], again["sheets"]) == (True, first["sheets"])

    run(serving)


def test_errors_speak_the_language_of_the_scene(tmp_path: Path) -> None:
    file = small(tmp_path)
    file.write_text(SMALL.replace('"en"', '"ru"').replace("0.3 m", "0.3 kg"), encoding="utf-8")

    async def serving() -> None:
        async with opened(file) as (browser, _):
            (told,) = (await browser.settled("small"))["errors"]
            assert "длина" in told["text"]

    run(serving)


@pytest.mark.slow
def test_a_composition_beside_the_scene_is_used(tmp_path: Path) -> None:
    file = small(tmp_path)
    given = '[[sheet]]\norder = 1\nformat = "A4"\n[sheet.views]\npositions = [{x}, 90.0]\n'

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small")
            beside = file.with_name("composition.toml")
            beside.write_text(given.format(x="60.0"), encoding="utf-8")
            second = await browser.settled("small", lambda one: one["page"] != first["page"])
            beside.write_text(given.format(x="none"), encoding="utf-8")
            assert (await browser.settled("small", lambda one: not one["ok"]))["errors"]
            beside.unlink()
            third = await browser.settled(
                "small", lambda one: one["page"] == first["page"] and one["ok"]
            )
            assert third["sheets"] == first["sheets"] != second["sheets"]

    run(serving)


@pytest.mark.slow
def test_a_folder_is_a_gallery_and_a_new_scene_is_seen(tmp_path: Path) -> None:
    small(tmp_path, "one")
    (tmp_path / "two.toml").write_text(SMALL, encoding="utf-8")
    for other in ("composition.toml", "x.composition.toml", "notes.txt", ".hidden.toml"):
        (tmp_path / other).write_text("", encoding="utf-8")
    (tmp_path / "empty").mkdir()

    async def serving() -> None:
        async with opened(tmp_path) as (browser, desk):
            assert list(desk.folder.scenes()) == ["one", "two"]
            assert (await browser.settled("two"))["ok"]
            small(tmp_path, "three")
            assert (await browser.settled("three"))["ok"]
            (tmp_path / "three" / "scene.toml").write_text("x", encoding="utf-8")
            assert not (await browser.settled("three", lambda one: not one["ok"]))["ok"]
            seen = set()
            async for state in browser.states("/events"):
                if not state["busy"]:
                    seen.add((state["name"], state["ok"]))
                if len(seen) == 3:
                    break
            assert seen == {("one", True), ("two", True), ("three", False)}
            # of what is seen in the gallery only the sheets are drawn; its page is made when it is opened
            assert desk.scenes["one"].kept.sheets
            assert desk.scenes["one"].kept.page is None
            assert (await browser.settled("one", lambda one: one["page"] is not None))["ok"]

    run(serving)


@pytest.mark.slow
def test_two_browsers_are_told_the_same(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small")
            assert await Browser(browser.app).settled("small") == first

    run(serving)


@pytest.mark.slow
def test_an_edit_that_is_taken_back_amid_its_drawing_leaves_the_sheets_of_before(
    tmp_path: Path,
) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small")
            file.write_text(SMALL.replace("0.1 m", "0.12 m"), encoding="utf-8")
            follow = browser.states("/s/small/events")
            async for state in follow:
                if state["sheets"] != first["sheets"]:
                    break  # these are there, their page is not
            file.write_text(SMALL, encoding="utf-8")
            async for state in follow:
                if state["text_version"] == first["text_version"] and not state["busy"]:
                    break
            await follow.aclose()  # type: ignore[attr-defined]
            assert (state["sheets"], state["page"]) == (first["sheets"], first["page"])

    run(serving)


@pytest.mark.slow
def test_what_changes_before_a_folder_is_watched_is_seen(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody tells of it: between a look at the files and the watch over their folders anything may change."""
    file, awatch, looked = small(tmp_path), watchfiles.awatch, asyncio.Event()

    async def late(*folders: Path, **options: Any) -> AsyncIterator[object]:
        await looked.wait()
        file.write_text(SMALL.replace("0.1 m", "0.12 m"), encoding="utf-8")
        async for changes in awatch(*folders, **options):
            yield changes

    monkeypatch.setattr(watchfiles, "awatch", late)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            first = await browser.settled("small")
            looked.set()
            second = await browser.settled("small", lambda one: one["version"] > first["version"])
            assert second["text_version"] == hashed(file.read_bytes()) != first["text_version"]

    run(serving)


@pytest.mark.slow
def test_what_took_too_long_is_no_fault_of_the_scene_and_is_drawn_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file) as (browser, _):
            await browser.settled("small", lambda one: one["page"])
            for length, again, method in (
                ("0.12 m", "/s/small/again", "POST"),
                ("0.13 m", "/s/small/", "GET"),  # loaded anew
            ):
                monkeypatch.setattr(desks, "DRAWING", 0.0)
                file.write_text(SMALL.replace("0.1 m", length), encoding="utf-8")
                late = await browser.settled("small", lambda one: one["failed"])
                assert late["errors"] == []
                assert "took longer" in late["failed"]
                monkeypatch.undo()
                assert (await browser.ask(again, method)).status in (200, 204)
                there = await browser.settled("small", lambda one: one["ok"])
                assert there["failed"] == ""
                assert await fetched(browser, "small", there) == drawn(file)

    run(serving)
