"""The diagrams of a page: results and straight lines are the same marks, whatever the lengths are."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support import gallery, pages
from support.other_lengths import other

from graphic_tmm.board.values import Complexes, Line
from graphic_tmm.page.cursors import cursors
from graphic_tmm.page.dense import dense
from graphic_tmm.page.live.charts import LiveCharts
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.readers.table import results_of

LEAST = {"slider-diagrams": (0, 8), "engine": (15, 19), "windrower": (14, 29)}
"""How many results and straight lines follow a length at least."""
BEYOND = 2.0
"""A line goes on beyond its mark, mm at most; it has gaps where letters stand."""


@cache
def charts(name: str, share: float = 0.0) -> LiveCharts:
    """The diagrams of a scene of the package, its links longer or shorter by up to a share."""
    scene = gallery.scene(name)
    made, sheets = pages.sheets(other(scene, share) if share else scene)
    drawn = made.mechanism
    assert drawn is not None
    found = dense(drawn)
    assert found is not None
    return LiveCharts(found, drawn, list(cursors(found, drawn, sheets)), sheets)


def places(one: LiveCharts, slot: int) -> Complexes:
    """Return where a mark is in the positions of the sheet, mm of its plan."""
    value = one.drawn.numbers.drawn.values[slot]
    at = value.at if isinstance(value, Line) else value
    return np.ravel(np.asarray(at)[0, : one.drawn.project.count])


def from_lines(spot: complex, first: Complexes, last: Complexes) -> float:
    """Return how far a spot is from the nearest of some lines, mm."""
    way = last - first
    share = ((spot - first) * np.conj(way)).real / np.maximum(np.abs(way) ** 2, 1e-12)
    return float(np.nanmin(np.abs(spot - first - np.clip(share, 0, 1) * way)))


@pytest.mark.slow
@pytest.mark.parametrize("name", LEAST)
def test_results_are_the_marks_that_have_their_values(name: str) -> None:
    """A mark has the figure that the table tells, whatever the lengths are, and it is always the same one."""
    given, longer = charts(name), charts(name, 0.05)
    results, lines = LEAST[name]
    assert len(given.results) >= results
    assert len(given.segments) >= lines
    assert [(one[1], one[4]) for one in given.results] == [
        (one[1], one[4]) for one in longer.results
    ]
    for there in (given, longer):
        sheet = there.found.sheet
        table = results_of(sheet)
        for _, of, value, _, mark in there.results:
            assert value == np.ravel(table[of][0]).item()
            # what is calculated beside a plan is told to three figures
            assert sheet.numbers.drawn[mark].item() == pytest.approx(value, rel=5e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", LEAST)
def test_lines_lie_between_the_same_marks_with_other_lengths(name: str) -> None:
    """What the sheet of longer links draws of a mark lies between the two marks that the page draws it to."""
    given, longer = charts(name), charts(name, 0.05)
    pairs = {(one[0], one[1]): (*one[3:5], *(one[7:] or (0.0, 0.0))) for one in given.segments}
    drawn = 0
    for view, (_, drawing) in longer.views.items():
        for stroke in drawing.strokes:
            pair = pairs.get((view, stroke.of[0])) if len(stroke.of) == 1 else None
            if (
                pair is None
                or not isinstance(stroke, Stroke)
                or stroke.part
                or len(stroke.path) != 2
            ):
                continue
            origin = drawing.origin(longer.plans[stroke.of[0]])
            first, last = (places(longer, int(slot)) for slot in pair[:2])
            way = (last - first) / np.maximum(np.abs(last - first), 1e-12)
            first, last = first - pair[2] * way, last + pair[3] * way
            off = [from_lines(complex(x, y) - origin, first, last) for x, y, _ in stroke.path]
            assert max(off) < BEYOND, (view, stroke.of, off)
            drawn += 1
    assert drawn >= len(pairs) / 2
