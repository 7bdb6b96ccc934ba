"""Dimensions: the line is as long as what it measures, the figure stands clear of it; hatching stays inside."""

from __future__ import annotations

import math

import pytest
import shapely
from support.each import each

from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.symbols.dimensions import dimension, shelf
from graphic_tmm.paper.symbols.kinematic import HATCH, hatched

ENDS = [
    (0j, 60 + 0j),
    (60 + 0j, 0j),
    (0j, 60j),
    (60j, 0j),
    (5 + 5j, 45 + 35j),
    (0j, 4 + 0j),
    (0j, 4j),
]


@each("offset", [10.0, -10.0])
@each("start, end", ENDS)
def test_a_dimension_stands_beside_what_it_measures(
    start: complex, end: complex, offset: float
) -> None:
    made = dimension(start, end, offset, "⌀45")
    tips = [complex(*s.path[0][:2]) for s in made.strokes if s.filled]
    assert abs(tips[1] - tips[0]) == pytest.approx(abs(end - start))
    way = (end - start) / abs(end - start)
    for tip, spot in zip(tips, (start, end), strict=True):
        assert tip - spot == pytest.approx(1j * way * offset)


@each("offset", [10.0, -10.0])
@each("start, end", ENDS)
def test_its_figure_reads_from_below_or_from_the_right_and_touches_no_line(
    start: complex, end: complex, offset: float
) -> None:
    made = dimension(start, end, offset, "115")
    assert -90 < made.label.turn <= 90
    frame = box(made.label)
    assert all(frame.distance(shape(stroke)) > 0.3 for stroke in made.strokes)


@each("length", [11.0, 13.0, 14.5, 16.0, 20.0])
def test_a_figure_keeps_off_the_extension_lines(length: float) -> None:
    made = dimension(0j, complex(length), 10.0, "H_{a} = 15")
    frame = box(made.label)
    assert all(frame.distance(shape(stroke)) > 0.9 for stroke in made.strokes[:2])


def test_arrows_stand_outside_where_they_have_no_room() -> None:
    wide, narrow = dimension(0j, 40 + 0j, 10, "40"), dimension(0j, 4 + 0j, 10, "4")
    first = [next(s for s in d.strokes if s.filled) for d in (wide, narrow)]
    assert [arrow.path[1][0] > arrow.path[0][0] for arrow in first] == [True, False]


def test_what_has_no_length_has_a_dimension_still() -> None:
    made = dimension(3 + 4j, 3 + 4j, -10.0, "0")
    tips = [complex(*s.path[0][:2]) for s in made.strokes if s.filled]
    assert tips == [3 - 6j, 3 - 6j]
    assert made.label.turn == 0
    assert all(box(made.label).distance(shape(stroke)) > 0.3 for stroke in made.strokes)


def test_a_shelf_is_as_long_as_its_text() -> None:
    made = shelf(0j, 20 - 10j, "3 отв. ⌀12")
    (leader, arrow) = made.strokes
    assert (
        leader.path[-1][0] - leader.path[1][0]
        > box(made.label).bounds[2] - box(made.label).bounds[0]
    )
    assert complex(*arrow.path[0][:2]) == 0j
    assert box(made.label).distance(shape(leader)) > 0.3


@pytest.mark.parametrize("rising", [True, False])
def test_hatching_covers_its_area_and_nothing_else(rising: bool) -> None:
    area = shapely.box(0, 0, 30, 20).difference(shapely.box(10, 5, 20, 15))
    lines = [shape(s) for s in hatched(area, rising=rising)]
    assert all(area.buffer(1e-6).covers(one) for one in lines)
    slopes = {
        round((c[1][1] - c[0][1]) / (c[1][0] - c[0][0]), 6) for c in (list(k.coords) for k in lines)
    }
    assert slopes == {1.0 if rising else -1.0}
    length = sum(one.length for one in lines)
    assert length == pytest.approx(area.area / HATCH, rel=0.1)
    assert math.isclose(min(one.distance(shapely.Point(0, 0)) for one in lines), 0, abs_tol=HATCH)
