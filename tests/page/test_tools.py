"""The instrument of a step: every step of drawing has one in words; an outline lies on the ink of its step."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest
from support.each import each
from support.gallery import ALL, paper

from graphic_tmm.accuracy.geometrography import ELEMENTARY, symbol
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.page.tools import NAMES
from graphic_tmm.page.views import played
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.paper.write.svg import ids

SOME = ("arc-cam", "cam", "engine", "windrower")
WORTH = 0.05
"""Places of instruments are told to a hundredth of a mm."""


@cache
def views(name: str) -> list[dict[str, Any]]:
    return played(*paper(name))


def test_every_instrument_of_geometrography_has_a_name() -> None:
    assert {one[0] for one in ELEMENTARY} == set(NAMES)
    used = "".join(symbol(op) for op in OPERATIONS.values())
    assert set(re.findall("[A-Z]", used)) <= set(NAMES)


@pytest.mark.turns(1)
@pytest.mark.parametrize("name", SOME)
def test_every_step_of_drawing_has_its_instrument(name: str) -> None:
    assert_named(name)


@pytest.mark.slow
@each("name", ALL, turns=4)
def test_every_step_of_all_scenes_has_its_instrument(name: str) -> None:
    assert_named(name)


def assert_named(name: str) -> None:
    for view in views(name):
        for stop in view["pictures"][1:]:
            told = [line for line in stop["lines"] if "it" in line]
            for line in told if not stop.get("again") else ():
                kind, words, *numbers = line.get("tool", ["", line.get("calc"), ()])
                assert words, line
                assert all(isinstance(x, float) for x in numbers) or kind == ""
                assert not re.search(r"(?<![_^])\{", words), (
                    "every name of the sentence is filled in"
                )


@pytest.mark.parametrize("name", ["engine", "cam", "windrower"])
def test_compass_and_square_lie_on_the_ink_of_their_step(name: str) -> None:
    """Needle and pencil of the compass are a radius of the arc; the edge of the square runs along the line."""
    met = {"compass": 0, "square": 0}
    for view in views(name):
        height, ink = inked(name, view)
        for kind, spots, slot in laid(view, height):
            for stroke in ink.get(slot, ()) if kind in met else ():
                corners = [complex(x, y) for x, y, _ in stroke.path]
                if kind == "square":
                    assert max(aside(z, spots) for z in corners) < WORTH
                elif any(bulge for *_, bulge in stroke.path):
                    radius = abs(spots[1] - spots[0])
                    assert max(abs(abs(z - spots[0]) - radius) for z in corners) < WORTH
                met[kind] += 1
    assert met["square"]


def aside(z: complex, spots: list[complex]) -> float:
    """How far a place is beside the line through the first two of some places, mm; relative beyond these."""
    way = spots[1] - spots[0]
    off = abs(((z - spots[0]) * way.conjugate()).imag) / abs(way)
    return off / max(1.0, abs(z - spots[0]) / abs(way))


def inked(name: str, view: dict[str, Any]) -> tuple[float, dict[int, list[Stroke]]]:
    """The height of the sheet of a view, mm, and its strokes by the only mark that they come from."""
    sheet = paper(name)[1][view["sheet"]]
    (drawing,) = (d for i, d in zip(ids(sheet), sheet.drawings, strict=True) if i == view["id"])
    found: dict[int, list[Stroke]] = {}
    for stroke in (*drawing.strokes, *drawing.rubbed):
        plain = isinstance(stroke, Stroke) and len(stroke.of) == 1 and not stroke.closed
        if plain and not stroke.part and stroke.position in (None, view["first"]):
            found.setdefault(stroke.of[0], []).append(stroke)
    return sheet.height, found


def laid(view: dict[str, Any], height: float) -> Iterator[tuple[str, list[complex], int]]:
    """Every instrument that lies on a view where its step leaves ink: its kind, its places, the mark."""
    for stop in view["pictures"]:
        for line in stop["lines"] if stop["keys"] and not stop.get("again") else ():
            kind, _, *x = line.get("tool", ["", ""])
            places = zip(x[::2], x[1::2], strict=True)
            yield kind, [complex(a, height - b) for a, b in places], line.get("it", -1)
