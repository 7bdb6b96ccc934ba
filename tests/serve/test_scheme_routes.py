"""Schemes as they are asked for: written where they are whole, never over another's text; a name is no path."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from support.gallery import SHEETS
from support.served import SMALL, Answer, Browser, opened, run, small


async def post(browser: Browser, path: str, **told: Any) -> Answer:
    return await browser.ask(path, "POST", json.dumps(told).encode())


def moved(scheme: dict[str, Any]) -> dict[str, Any]:
    """A sketch of the slider-crank with another pivot of its crank."""
    sketch = scheme["sketch"]
    return {**sketch, "places": {**sketch["places"], "A": [0.1, 0.05]}}


def test_an_act_is_written_and_of_two_the_later_is_told(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            first = (await post(browser, "/s/small/scheme")).json()
            assert file.read_text("utf-8") == SMALL
            version = first["version"]
            # nothing that only looks writes
            turned = await post(browser, "/s/small/scheme", version=version, text=SMALL, at=30)
            assert (turned.status, turned.json()["version"]) == (200, version)
            act = {"version": version, "text": SMALL, "sketch": moved(first)}
            done = await post(browser, "/s/small/scheme", **act)
            assert done.status == 200
            assert file.read_text("utf-8") == done.json()["text"]
            assert 'A = ["0.112 m", 0]' in done.json()["text"]
            late = await post(browser, "/s/small/scheme", **act)
            assert (late.status, late.json()["version"]) == (409, done.json()["version"])

    run(serving)


def test_what_lacks_something_is_not_written(tmp_path: Path) -> None:
    file = small(tmp_path)

    async def serving() -> None:
        async with opened(file, drawing=False) as (browser, _):
            first = (await post(browser, "/s/small/scheme")).json()
            links = [{**one, "slides": []} for one in first["sketch"]["links"]]
            sketch = {**first["sketch"], "links": links}
            act = {"version": first["version"], "text": SMALL, "sketch": sketch}
            told = (await post(browser, "/s/small/scheme", **act)).json()
            assert told["text"] is None
            assert told["mobility"] == 3
            wrong = {**act, "sketch": None, "typed": {"link 2, points.B[1]": "1 mm"}, "at": 90}
            refused = await post(browser, "/s/small/scheme", **wrong)
            assert refused.status == 422
            assert "cannot be assembled" in refused.json()["errors"][0]["text"]
            assert (await post(browser, "/s/small/scheme", sketch=[1])).status == 400
            assert (await post(browser, "/s/none/scheme")).status == 404

    run(serving)
    assert file.read_text("utf-8") == SMALL


TITLES = {
    "Slotting machine": "slotting-machine",
    "../../etc/passwd": "etc-passwd",
    "Станок №1": "станок-1",
    "///": "scheme",
    "CON\0": "con",
    "a" * 60: "a" * 40,
}


def test_a_new_scene_has_a_folder_that_its_title_names(tmp_path: Path) -> None:
    async def serving() -> None:
        async with opened(tmp_path, drawing=False) as (browser, _):
            for title, name in TITLES.items():
                told = await post(browser, "/new", text=SMALL, title=title)
                if "\0" in title:
                    assert told.status == 422
                    continue
                assert (told.status, told.json()) == (201, {"name": name})
                assert (tmp_path / name / "scene.toml").is_file()
            again = await post(browser, "/new", text=SMALL, title="Slotting machine")
            assert again.json() == {"name": "slotting-machine-2"}
            for text in ("title = 1", "", SMALL.replace('"0.3 m"', '"0.3 kg"')):
                assert (await post(browser, "/new", text=text, title="x")).status == 422
            assert (await post(browser, "/new", text=1, title="x")).status == 400
            assert (await browser.ask("/draw")).status == 200

    run(serving)
    names = {name for title, name in TITLES.items() if "\0" not in title}
    assert {one.name for one in tmp_path.iterdir()} == {*names, "slotting-machine-2"}


@pytest.mark.parametrize("place", ["package", "alone"])
def test_nothing_is_put_into_what_stays_as_it_is(place: str, tmp_path: Path) -> None:
    folder = SHEETS if place == "package" else small(tmp_path)
    before = sorted(folder.parent.iterdir())

    async def serving() -> None:
        async with opened(folder, drawing=False) as (browser, _):
            assert (await post(browser, "/new", text=SMALL, title="x")).status == 403
            assert (await browser.ask("/draw")).status == 404
            if place == "package":
                first = (await post(browser, "/s/crank-rocker/scheme")).json()
                sketch = {**first["sketch"], "places": {**first["sketch"]["places"], "E": [0, 0.1]}}
                act = {"version": first["version"], "text": first["text"], "sketch": sketch}
                assert (await post(browser, "/s/crank-rocker/scheme", **act)).status == 200

    run(serving)
    assert sorted(folder.parent.iterdir()) == before
    if place == "package":
        assert "E = [0, 0.1]" not in (SHEETS / "crank-rocker/scene.toml").read_text("utf-8")
