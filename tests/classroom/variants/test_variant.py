"""Values of a variant: where they stand in the scene, with which unit, and what is told of wrong ones."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest
from support.each import each
from support.gallery import SHEETS

from graphic_tmm.classroom.variants.variant import (
    Base,
    Value,
    Variant,
    base,
    is_name,
    scene_of,
    source_of,
    text_of,
)
from graphic_tmm.errors import SceneError


@pytest.fixture(scope="module")
def shaper() -> Base:
    return base(SHEETS / "shaper")


def said_by(of: Base, *values: Value) -> dict[str, Any]:
    return tomllib.loads(text_of(of, Variant("7", values)))


def without(doc: dict[str, Any], *path: Any) -> dict[str, Any]:
    at: Any = doc
    for part in path[:-1]:
        at = at[part]
    del at[path[-1]]
    return doc


@each(
    "key, typed, unit, path, due",
    [
        ("OA", "120", "", ("lengths", "OA"), "120 mm"),
        ("lengths.OA", "12,5 cm", "", ("lengths", "OA"), "12,5 cm"),
        ("links.1.OA", "0.12", "m", ("lengths", "OA"), "0.12 m"),
        ("drive.speed", "75.5", "", ("drive", "speed"), "75.5 rpm"),
        ("drive.positions", "8", "", ("drive", "positions"), 8),
        ("link 5, mass", "60", "", ("link", 4, "mass"), "60 kg"),
        ("links.5.mass", "60 kg", "", ("link", 4, "mass"), "60 kg"),
        ("links.3.points.S3[1]", "0.4 BC", "", ("link", 2, "points", "S3", 0), "0.4 BC"),
        ("drive.accelerations", "[2, 5]", "", ("drive", "accelerations"), [2, 5]),
        ("title", "Мой станок", "", ("title",), "Мой станок"),
    ],
)
def test_a_value_stands_where_its_key_says_and_nothing_else_changes(
    key: str, typed: str, unit: str, path: tuple[Any, ...], due: object, shaper: Base
) -> None:
    made = said_by(shaper, Value(key, typed, unit))
    at: Any = made
    for part in path:
        at = at[part]
    assert at == due
    if path != ("title",):
        assert made.pop("title") == "Поперечно-строгальный станок. Вариант 7"
    before = tomllib.loads(shaper.text)
    before.pop("title", None)
    made.pop("title", None)
    if path != ("title",):
        assert without(made, *path) == without(before, *path)


def test_a_bare_number_needs_a_unit_where_the_scene_has_none(shaper: Base) -> None:
    with pytest.raises(SceneError, match=r'shaper.*S3.*"0\.5 BC"'):
        text_of(shaper, Variant("7", (Value("links.3.points.S3[1]", "300"),)))


@each(
    "key, typed",
    [
        ("drive.positions", "1000000"),
        ("AO", "5"),
        ("OA", "120 kg"),
        ("frame.B", "5"),
        ("link 9, mass", "5"),
        ("OA", ""),
    ],
)
def test_a_fault_is_told_at_the_variant_and_the_key_of_its_table(
    key: str, typed: str, shaper: Base
) -> None:
    with pytest.raises(SceneError) as told:
        scene_of(shaper, Variant("Иванов", (Value(key, typed),), 12), "v.csv")
    assert str(told.value).startswith(f"v.csv:12: {key}: ")


def test_a_key_that_is_named_in_two_ways_is_told(shaper: Base) -> None:
    twice = Variant("7", (Value("OA", "120"), Value("lengths.OA", "110")), 3)
    with pytest.raises(SceneError, match=r"v\.csv:3: lengths\.OA: this is the same key as OA"):
        text_of(shaper, twice, "v.csv")


def test_the_scene_of_a_variant_is_called_by_it(shaper: Base) -> None:
    one = Variant("07", (Value("OA", "120"),))
    assert source_of(shaper, one) == SHEETS / "shaper" / "shaper-07.toml"
    assert scene_of(shaper, one).source == str(source_of(shaper, one))


@each("name, good", [("7", True), ("Иванов_А.", True), ("", False), ("../x", False), ("a b", False),
                     (".x", False), ("x" * 41, False)])  # fmt: skip
def test_names_are_those_of_files(name: str, good: bool) -> None:
    assert is_name(name) is good


def test_there_is_no_scene_without_a_file() -> None:
    with pytest.raises(SceneError, match="no such file"):
        base(Path("nowhere.toml"))
