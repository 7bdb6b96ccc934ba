"""Where all places about a point are taken a letter goes farther: on no main line."""

from __future__ import annotations

import pytest

from graphic_tmm.paper.axes import position_numbers
from graphic_tmm.paper.drawing import Drawing, Stroke, Wanted, line
from graphic_tmm.paper.labels import Named, finished
from graphic_tmm.paper.shapes import box, shape

HALF = 52.0
"""So far about the point main lines stand close together, mm."""


def crowded() -> list[Stroke]:
    """Return main lines 4 mm apart: no letter stands between two of them."""
    rows = range(-int(HALF) // 4, int(HALF) // 4 + 1)
    return [line("main", complex(-HALF, 4 * k), complex(HALF, 4 * k)) for k in rows]


def test_a_letter_leaves_a_crowd_of_main_lines() -> None:
    strokes = tuple(crowded())
    wanted = (Wanted("h_{G3} = 10,6", 0j, 3.5, 1.0, 1j),)
    view = finished(Drawing("lever", "", strokes, wanted=wanted))
    (label,) = view.labels
    assert all(not box(label).intersects(shape(one)) for one in strokes)


@pytest.mark.parametrize("sense", [1, -1])
def test_the_number_of_a_position_leaves_two_curves_that_cross_its_places(sense: int) -> None:
    """They pass through those at the axis and through those of the next level."""
    heights = (2.0, 7.5, -3.0, -8.0)
    strokes = [line("main", complex(34, sense * y), complex(46, sense * y + 0.4)) for y in heights]
    named = [Named(complex(20.0 * k), str(k)) for k in range(3)]
    labels = position_numbers(named, [], strokes, 3.5)
    assert len(labels) == len(named)
    assert all(not box(one).intersects(shape(stroke)) for one in labels for stroke in strokes)
