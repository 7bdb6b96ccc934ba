"""The fields of scenes: every value of a file has one, every key that is declared can be set."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest
from support.gallery import ROOT

from graphic_tmm.scene.new import schema
from graphic_tmm.scene.vary import path_of
from graphic_tmm.serve.form import MOST, Field, blank, choices_in, form, form_json

SCENES = sorted((ROOT / "sheets").glob("*/scene.toml"))
WINDROWER = ROOT / "sheets" / "windrower" / "scene.toml"


def fields_of(file: Path) -> dict[str, Field]:
    return {one.key: one for group in form(file.read_bytes(), file) for one in group.fields}


def leaves(value: object, path: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """The paths of a document at which a value stands, lists whole."""
    if isinstance(value, dict):
        for name, one in value.items():
            yield from leaves(one, (*path, name))
    elif isinstance(value, list) and value and all(isinstance(one, dict) for one in value):
        for k, one in enumerate(value):
            yield from leaves(one, (*path, k))
    else:
        yield path


@pytest.mark.parametrize("file", SCENES, ids=lambda file: file.parent.name)
def test_every_value_of_a_file_has_a_field_as_it_is_written(file: Path) -> None:
    doc = tomllib.loads(file.read_text("utf-8"))
    found = {one.path: one for one in fields_of(file).values() if one.written}
    for path in leaves(doc):
        point = {(*path, 0), (*path, 1)} <= found.keys()
        points = {(*path, 0, 0), (*path, 0, 1)} <= found.keys()
        assert path in found or point or points, path
    for path, one in found.items():
        value: object = doc
        for part in path:
            value = value[part]  # type: ignore[index]
        read = one.text if one.in_quotes else tomllib.loads(f"x = {one.text}")["x"]
        assert read == value


@pytest.mark.parametrize("file", SCENES, ids=lambda file: file.parent.name)
def test_a_key_leads_back_to_its_path_and_none_stands_twice(file: Path) -> None:
    doc = tomllib.loads(file.read_text("utf-8"))
    every = [one for group in form(file.read_bytes(), file) for one in group.fields]
    assert len({one.key for one in every}) == len(every)
    assert [one.key for one in every if path_of(doc, one.key) != one.path] == []


def test_a_section_offers_what_the_schema_says_of_it() -> None:
    given = fields_of(WINDROWER)
    known = schema()
    for name in ("drive", "hand", "scales", "plans", "title_block", "note"):
        section = known["properties"][name]
        told_there = section.get("$ref", section.get("anyOf", [{}])[0].get("$ref")).rpartition("/")[
            2
        ]
        keys = known["$defs"][told_there]["properties"]
        offered = {one.path[1] for one in given.values() if one.path[0] == name}
        simple = {key for key, one in keys.items() if "$ref" not in one and key != "remarks"}
        assert simple <= offered, name


def test_what_a_field_says() -> None:
    given = fields_of(WINDROWER)
    speed = given["drive.speed"]
    assert (speed.text, speed.kind, str(speed.unit)) == ("380 rpm", "quantity", "an angular speed")
    assert speed.wanted
    assert speed.says.startswith("its angular speed, positive")
    count = given["drive.positions"]
    assert (count.text, count.kind, count.default) == ("12", "number", "12")
    assert str(count.unit) == "a whole number 1 to 100000"
    turns = given["drive.turns"]
    assert (turns.kind, turns.default) == ("choice", "counterclockwise")
    assert {"clockwise", "counterclockwise"} <= set(turns.choices)
    assert given["effects.gravity"].kind == "switch"
    assert given["drive.accelerations"].text == "[2, 6, 8]"
    assert given["link 3, points.C[1]"].text == "-BC"
    assert given["link 3, points.C[1]"].label == "points.C, x"
    assert given["scales.mu_l"].kind == "quantity"
    seed = given["hand.seed"]
    assert (seed.text, seed.written, seed.default) == ("", False, "0")
    assert given["title"].wanted


def test_a_form_is_json_in_a_language() -> None:
    groups = form(WINDROWER.read_bytes(), WINDROWER)
    russian = json.loads(json.dumps(form_json(groups, "ru")))
    every = {one["key"]: one for group in russian for one in group["fields"]}
    assert every["drive.speed"]["unit"] == "угловая скорость"
    assert [group["title"] for group in russian][1:3] == ["task", "frame"]
    assert "link 3 кулиса" in [group["title"] for group in russian]
    assert every["drive.turns"]["choices"] == [
        "counterclockwise",
        "против часовой стрелки",
        "по часовой стрелке",
    ]


def test_words_to_choose_are_of_one_language_where_each_has_its_own() -> None:
    side = blank(None, None)._replace(choices=("+", "-", "left", "слева"), text="left")
    assert choices_in(side, "ru") == ["+", "-", "left", "слева"]
    assert choices_in(side._replace(text=""), "ru") == ["+", "-", "слева"]
    assert choices_in(side._replace(text=""), "en") == ["+", "-", "left"]
    hand = blank(None, None)._replace(choices=("exact", "cad", "точная"))
    assert choices_in(hand, "ru") == ["exact", "cad", "точная"]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "drive = 3",
        "[[drive]]\nlink = 1",
        "link = 5",
        "link = [1, 2]",
        "[link]\nnumber = 1",
        "lengths = 3",
        '[[link]]\nnumber = "x"\npoints = 3\nslides = [1]\nguides = { q = 4 }\nname = 5',
        "[frame]\nO = 3\nB = [1, 2, 3]\nC = { x = 1 }",
        "[lengths]\nr = [1]",
        "title = 1979-05-27\nlanguage = ['a']",
        "[diagrams]\npoint = { a = { b = 1 } }",
        "[indicator]\ncover = 'a'\ncover_points = 5\ncover_strokes = { a = 1 }",
    ],
)
def test_a_scene_may_be_as_wrong_as_it_likes(text: str) -> None:
    groups = form(text.encode(), WINDROWER)
    json.dumps(form_json(groups, "en"))


def test_a_giant_has_no_more_fields_than_can_be_shown() -> None:
    text = "[lengths]\n" + "".join(f'l{k} = "1 m"\n' for k in range(12_000))
    groups = form(text.encode(), WINDROWER)
    assert sum(len(group.fields) for group in groups) <= MOST
