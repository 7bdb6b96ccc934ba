"""Sections that are added beside a scheme are filled in with words, numbers and entries, and not as TOML."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest
from support.served import SMALL

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.declare import keys_of
from graphic_tmm.scene.sections import declared
from graphic_tmm.serve.scheme.act import SchemeAct, scheme
from graphic_tmm.serve.scheme.entries import entered
from graphic_tmm.serve.scheme.sections import _fields, offered

FILE = Path("scheme.toml")
DOC = tomllib.loads(SMALL)


def added(section: str, typed: dict[str, str], text: str = SMALL) -> Any:
    act = SchemeAct(section=section, typed=typed)
    found = scheme(text.encode(), FILE, act, speaking("en"))
    made = tomllib.loads(found["text"])[section]
    return made[-1] if isinstance(made, list) else made


def keys(section: str, language: str = "en") -> dict[str, dict[str, Any]]:
    of = next(one for one in offered(DOC, speaking(language)) if one["name"] == section)
    return {one["name"]: one for one in of["keys"]}


LOAD = {"link": "3", "point": "B"}
ENTERED = [
    ("load", {**LOAD, "force": "190"}, "force", "190 N"),
    ("load", {**LOAD, "force": "0,5 kN"}, "force", "0,5 kN"),
    ("load", {"link": "1", "moment": "-12"}, "moment", "-12 N*m"),
    ("load", {**LOAD, "force": "190 N", "direction": "30"}, "direction", "30 deg"),
    ("load", {**LOAD, "force": "1 N", "direction": "along AB"}, "direction", "along AB"),
    ("load", {**LOAD, "by_position": "190, 0"}, "by_position", ["190 N", "0 N"]),
    ("load", {**LOAD, "by_position": "190,5 N, 0"}, "by_position", ["190,5 N", "0 N"]),
    (
        "load",
        {**LOAD, "of": "B", "out": "0: 0 N; 0,5: 190 N; 1: 0"},
        "out",
        [[0, "0 N"], [0.5, "190 N"], [1, 0]],
    ),
    ("load", {**LOAD, "of": "B", "out": '[[0, "0 N"], [1, "9 N"]]'}, "out", [[0, "0 N"], [1, "9 N"]]),
    ("spring", {"between": "A, C", "rate": "2", "free": "100"}, "between", ["A", "C"]),
    ("spring", {"between": "A,C", "rate": "2", "free": "100"}, "rate", "2 N/m"),
    ("spring", {"between": "A; C", "rate": "2", "free": "100"}, "free", "100 mm"),
    ("forces", {"positions": "1,2"}, "positions", [1, 2]),
    ("forces", {"positions": "all"}, "positions", "all"),
    ("sheet", {"place": "positions, velocities"}, "place", ["positions", "velocities"]),
    ("note", {"conclusions": "It turns, and well; it holds."}, "conclusions", "It turns, and well; it holds."),
]  # fmt: skip


@pytest.mark.parametrize(("section", "typed", "key", "holds"), ENTERED)
def test_what_is_entered_is_what_the_file_says(
    section: str, typed: dict[str, str], key: str, holds: Any
) -> None:
    text = SMALL.replace("O = [0, 0]\nx", 'O = [0, 0]\nC = ["0.1 m", "0.1 m"]\nx')
    assert added(section, typed, text)[key] == holds


@pytest.mark.parametrize("language", ["en", "ru"])
def test_no_example_is_written_as_the_file_has_it(language: str) -> None:
    shown = [
        key
        for section in offered(DOC, speaking(language))
        for key in section["keys"]
        if not key["choices"]
    ]
    assert len(shown) > 50
    assert [one["example"] for one in shown if set('[]{}"') & set(one["example"])] == []


def test_every_example_of_a_list_can_be_entered() -> None:
    """As it is shown, it becomes the list that the declaration has for an example."""
    lists = [(of["name"], key) for of in offered(DOC, speaking("en")) for key in of["keys"]]
    lists = [
        (name, key) for name, key in lists if key["form"] in ("row", "table") and key["example"]
    ]
    assert {"load", "spring", "moment"} <= {name for name, _ in lists}
    for name, key in lists:
        section = declared()[name]
        asked = next(one for one in _fields(section, speaking("en")) if one.name == key["name"])
        found = entered(key["example"], asked, DOC, SMALL)
        kind = keys_of(section.record)[key["name"]].kind
        assert found == "all" or kind.read(found, {}) == kind.read(
            keys_of(section.record)[key["name"]].example, {}
        )


def test_units_and_words_stand_beside_their_fields() -> None:
    load = keys("load")
    assert {name: load[name]["unit"] for name in ("link", "force", "moment", "by_position", "out")} == {
        "link": "", "force": "N", "moment": "N·m", "by_position": "N", "out": "",
    }  # fmt: skip
    assert load["direction"]["unit"] == "°"
    assert keys("indicator", "ru")["bore"]["unit"] == "мм"
    assert keys("effects", "ru")["gravity"]["choices"] == [["true", "да"], ["false", "нет"]]
    places = keys("sheet", "ru")["place"]
    assert ["velocities", "План скоростей"] in places["choices"]
    assert "forces" not in dict(places["choices"])  # nothing of the scene asks for them


def test_what_is_there_is_told_without_keys() -> None:
    text = SMALL + '[[load]]\nlink = 3\npoint = "B"\nby_position = ["190 N", "0 N"]\n'
    there = next(
        one for one in offered(tomllib.loads(text), speaking("en")) if one["name"] == "load"
    )
    assert there["there"] == [
        "the number of the link: 3; the letter of the point where a force acts: B; its size in each position: "
        "190 N, 0 N"
    ]
