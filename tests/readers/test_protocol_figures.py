"""What a protocol tells could be read, and exists: no figure of rounding alone, no step that is none."""

from __future__ import annotations

import json
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size
from support.gallery import ALL, exact, made
from support.scenes import edited
from support.sheets_of_random import scenes

from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.catalogue import languages
from graphic_tmm.readers.protocol import plans, protocol
from graphic_tmm.readers.table import table
from graphic_tmm.scene.read import read

READABLE = 0.9e-9
"""The least share of its plan that a figure may have; the rest of 1e-9 is for the digits that are told."""
_RESULT = re.compile(r"= (−?[\d,.]+(?:·10[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)?) (mm|мм)$")
_STEP = re.compile(r" *(\d+)(?:–(\d+))?\. ")
_LEFT = {"en": "      [steps that do not exist here: ", "ru": "      [здесь нет шагов: "}


ON_THE_BOARD = tuple(plan for plan in plans() if plan not in ("synthesis", "scales"))
"""The plans whose steps are of the log; lengths and scale factors are chosen before it is run."""


def told(
    drawn: Drawn, position: str, language: str = "en", wanted: Sequence[str] = plans()
) -> list[str]:
    return list(protocol(drawn, wanted, position, language))


def value(text: str) -> float:
    mantissa, _, power = text.replace("−", "-").replace(",", ".").partition("·10")
    return float(mantissa) * 10.0 ** int(
        power.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")) or 0
    )


def by_plan(lines: Iterable[str]) -> Iterator[list[float]]:
    """Yield the lengths, mm, that are told of each plan; a plan ends with an empty line."""
    found: list[float] = []
    for line in lines:
        if measured := _RESULT.search(line):
            found.append(value(measured[1]))
        if not line and found:
            yield found
            found = []


def assert_readable(made: DrawnScene, most: int = 100) -> None:
    plans = [
        (drawn.board, position, lengths)
        for drawn in made.boards
        for position in drawn.names[:most]
        for lengths in by_plan(told(drawn, position))
    ]
    columns = defaultdict[tuple[str, str], list[float]](list)
    for column in json.loads(table(made, "json"))["columns"]:
        for position, length in zip(column["positions"], column["mm"], strict=True):
            columns[column["plan"], position] += [] if length is None else [length]
    plans += [(*where, lengths) for where, lengths in columns.items() if lengths]
    for plan, position, lengths in plans:
        sizes = np.abs(lengths)
        unreadable = (sizes > 0.0) & (sizes < READABLE * sizes.max())
        assert not unreadable.any(), (plan, position, lengths)


@pytest.mark.turns(3)
@pytest.mark.parametrize(
    "name",
    [
        name
        if name in ("windrower", "crank-rocker")
        else pytest.param(name, marks=pytest.mark.slow)
        for name in ALL
    ],
)
def test_no_figure_of_a_scene_is_rounding_alone(name: str) -> None:
    assert_readable(exact(name))


@pytest.mark.slow
@pytest.mark.parametrize("which", [0, 6])
def test_no_figure_of_a_random_mechanism_is_rounding_alone(which: int, tmp_path: Path) -> None:
    """The seventh is nearly locked in one position: there its plan of forces is a million times another."""
    file = tmp_path / "scene.toml"
    file.write_text(list(scenes(7, seed=5))[which], encoding="utf-8")
    assert_readable(in_usual_size(read(file), exact=True), most=3)


def assert_tells_what_there_is(drawn: Drawn, position: str, language: str) -> None:
    """Every step that has a value is told once, the others once by their numbers; of all plans of the board."""
    place, steps = drawn.names.index(position), defaultdict(list)
    for step in drawn.construction.steps:
        steps[step.it.view].append(step.it)
    due = []
    for view, marks in steps.items():
        if drawn.of(view) is None or place not in drawn.row(view):
            continue
        reading = drawn.of(view)
        index = drawn.row(view).index(place) if view in drawn.project.rows else place
        for number, mark in enumerate(marks, 1):
            row = [False] if mark.kind is Curve else undefined(reading[mark])[0]
            due.append((number, bool(row[index if len(row) > 1 else 0])))
    found = []
    for line in told(drawn, position, language, ON_THE_BOARD):
        assert "—" not in line
        assert "не строится" not in line
        assert "cannot be drawn" not in line
        if step := _STEP.match(line):
            found += [(n, False) for n in range(int(step[1]), int(step[2] or step[1]) + 1)]
        elif line.startswith(_LEFT[language]):
            for part in line.removeprefix(_LEFT[language]).rstrip("]").split(", "):
                first, _, last = part.partition("–")
                found += [(n, True) for n in range(int(first), int(last or first) + 1)]
    assert sorted(found) == sorted(due)


@pytest.mark.parametrize("language", languages())
@pytest.mark.parametrize(
    ("name", "position"), [("windrower", "7*"), ("crank-press", "0"), ("crank-press", "1")]
)
def test_a_step_that_does_not_exist_is_left_out_and_told_once(
    name: str, position: str, language: str
) -> None:
    drawn = made(name).mechanism
    assert drawn is not None
    assert_tells_what_there_is(drawn, position, language)


def test_of_a_position_that_cannot_be_drawn_only_what_exists_is_told(tmp_path: Path) -> None:
    """Beyond sin φ = 0.25/0.3 the connecting rod does not reach its guide: positions 3 to 5."""
    drawn = in_usual_size(read(edited(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"')))).mechanism
    assert drawn is not None
    lines = told(drawn, "3")
    assert any(line.startswith(_LEFT["en"]) for line in lines)
    assert_tells_what_there_is(drawn, "3", "en")
    there = told(drawn, "1", wanted=("positions", "velocities"))
    assert not any(line.startswith(_LEFT["en"]) for line in there)
