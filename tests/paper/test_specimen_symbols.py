"""The specimen of lines and symbols: every pen of a line, every symbol in its cell, each with its name."""

from __future__ import annotations

from itertools import combinations

import pytest

from graphic_tmm.chapters.lettering.specimen_symbols import CELL, specimen_symbols
from graphic_tmm.paper.drawing import Bezier
from graphic_tmm.paper.lettering.heights import HEIGHTS
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.shapes import box, shape

LINES, SYMBOLS = specimen_symbols("ru", HEIGHTS["A1"])


def test_every_pen_that_draws_lines_is_shown() -> None:
    shown = {s.pen for s in LINES.strokes}
    hiding = {"body", "rod", "over", "paper", "joint"}
    assert shown == set(pens("A1")) - hiding
    assert any(isinstance(s, Bezier) for s in LINES.strokes)
    assert len(LINES.labels) == 1 + len(LINES.strokes)


@pytest.mark.parametrize("language", ["ru", "en"])
def test_names_stand_clear_of_each_other_and_of_the_ink(language: str) -> None:
    for view in specimen_symbols(language, HEIGHTS["A1"]):
        boxes = [box(label) for label in view.labels]
        assert all(a.disjoint(b) for a, b in combinations(boxes, 2))
        assert all(frame.disjoint(shape(s)) for frame in boxes for s in view.strokes)


def test_every_symbol_stays_in_its_cell() -> None:
    names = SYMBOLS.labels[1:]
    for stroke in SYMBOLS.strokes:
        left, _, right, _ = shape(stroke).bounds
        assert any(
            abs((left + right) / 2 - k.at.real) < CELL / 2 > (right - left) / 2 for k in names
        )
    cells = {int(shape(s).bounds[0] // CELL) for s in SYMBOLS.strokes}
    assert cells == {0, 1, 2, 3, 4}
