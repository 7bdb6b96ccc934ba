"""Numbers of positions along an axis: on one level, clear of curves and of each other, in their order."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.paper.axes import on_axis, position_numbers
from graphic_tmm.paper.drawing import Label, line
from graphic_tmm.paper.labels import Named
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.paper.symbols.dimensions import angular

SIZE = 3.5


def row(count: int, length: float) -> tuple[list[Named], list[Named]]:
    feet = [Named(complex(length * k / count), str(k), (7,), k) for k in range(count)]
    return feet, [Named(complex(length), "0", (8,))]


def wave(length: float, high: float, turns: float, late: float) -> list[complex]:
    x = np.linspace(0.0, length, 241)
    return [complex(a, high * math.sin(2 * math.pi * turns * a / length + late)) for a in x]


def levels(labels: tuple[Label, ...]) -> set[float]:
    return {round(label.at.imag, 6) for label in labels}


@given(
    st.integers(4, 24),
    st.floats(0.0, 60.0),
    st.floats(0.5, 2.0),
    st.floats(0.0, 6.28),
)
def test_numbers_stand_apart_and_in_their_order(
    count: int, high: float, turns: float, late: float
) -> None:
    """A curve leaves few levels: that of nearly all, the other side of the axis, one farther out."""
    feet, others = row(count, 120.0)
    curve = line("main", *wave(120.0, high, turns, late))
    labels = position_numbers(feet, others, [curve], SIZE)
    texts = [label.text for label in labels]
    numbers = [int(text) for text in texts[:-1]]
    assert texts[-1] == "0"
    assert numbers == sorted(numbers)
    boxes = [box(label) for label in labels]
    assert all(one.disjoint(other) for one, other in pairwise(boxes))
    assert len(levels(labels)) <= 3
    assert [label.position for label in labels[:-1]] == numbers
    assert {label.of for label in labels} == {(7,), (8,)}


@pytest.mark.parametrize("extra", [40.3, 40.6, 41.0, 41.6, 43.1])
def test_a_number_does_not_stand_past_the_foot_of_another_position(extra: float) -> None:
    """5* a millimetre before 6 is not read as one behind it."""
    feet, others = row(12, 84.0)
    star = Named(complex(extra), "5*", (9,), 12)
    ink = [line("thin", one.at, one.at - 10j) for one in (*feet, star)]
    labels = position_numbers(feet, [star, *others], ink, SIZE)
    at = {one.text: one.at.real for one in feet} | {"5*": extra}
    assert {label.text for label in labels} >= {"5", "5*", "6"}
    for label in labels[:-1]:
        left, _, right, _ = box(label).bounds
        own = at[label.text]
        between = [x for x in at.values() if min(left, own) < x < max(right, own) and x != own]
        assert not between, label.text


def test_a_number_stands_on_no_curve_where_there_is_room_farther_out() -> None:
    """Two steep curves leave it no place next to its foot."""
    feet, others = row(12, 120.0)
    ink = [line("main", complex(60 + by, -5.2), complex(60 + by, 5.2)) for by in (-1.6, 1.6)]
    ink += [line("main", complex(0, y), complex(48, y)) for y in (4.0, -9.0, -13.0)]
    labels = position_numbers(feet, others, ink, SIZE)
    assert len(labels) == 13
    assert all(box(label).disjoint(shape(one)) for label in labels for one in ink)


@pytest.mark.parametrize("sign", [1, -1])
def test_all_stand_on_one_level_where_a_curve_leaves_room_below(sign: int) -> None:
    feet, others = row(12, 120.0)
    curve = line("main", *wave(120.0, 40.0, 0.5, 0.0 if sign > 0 else math.pi / 4))
    labels = position_numbers(feet, others, [curve], SIZE)
    (level,) = levels(labels)
    assert level < 0.0
    assert all(box(label).disjoint(shape(curve)) for label in labels)


def test_all_stand_lower_where_a_curve_runs_along_the_axis() -> None:
    feet, others = row(12, 120.0)
    curve = line("main", *wave(120.0, 0.8, 0.5, math.pi)), line("main", -2.5j, 120 - 2.5j)
    labels = position_numbers(feet, others, curve, SIZE)
    assert len(levels(labels)) == 1
    assert all(box(label).disjoint(shape(one)) for label in labels for one in curve)


def test_of_positions_too_close_for_their_numbers_some_bear_one() -> None:
    for count, every in ((12, 1), (36, 2), (72, 5), (360, 50)):
        labels = position_numbers(*row(count, 120.0), [], SIZE)
        assert [label.text for label in labels] == [str(k) for k in range(0, count, every)] + ["0"]


@pytest.mark.parametrize("length", [90.0, 140.0, 160.0])
@pytest.mark.parametrize("size", [8.0, 9.8])
def test_large_numbers_do_not_run_together(size: float, length: float) -> None:
    """As on a figure of a note: side by side they are as far apart as words are, however large they are."""
    feet, others = row(12, length)
    curve = [line("main", *wave(length, 60.0, 0.5, math.pi)), line("main", -10 + 3j, 25 - 30j)]
    labels = position_numbers(feet, others, curve, size)
    assert len(labels) > 3
    for one, other in pairwise(labels):
        end = one.at.real + letter(one.text, size=size).width
        assert one.at.imag != other.at.imag or other.at.real - end > 0.4 * size


def test_a_position_that_is_not_there_bears_no_number() -> None:
    feet, others = row(6, 120.0)
    feet[2] = feet[2]._replace(at=complex("nan"))
    labels = position_numbers(feet, others, [], SIZE)
    assert [label.text for label in labels] == ["0", "1", "3", "4", "5", "0"]
    assert position_numbers([feet[2]], [], [], SIZE) == ()


def test_an_axis_is_called_by_its_quantity_and_unit() -> None:
    assert on_axis("V", "m/s") == "V, m/s"
    assert on_axis("k", "") == "k"


@pytest.mark.parametrize("sweep", [57.5, 12.9, 3.0, -40.0])
def test_an_angle_is_dimensioned_from_side_to_side(sweep: float) -> None:
    side, arc, *arrows = angular(2 + 3j, 0.0, sweep, 26.0)
    ends = shapely.LineString([(side.path[0][0], side.path[0][1]), side.path[1][:2]])
    assert ends.bounds[1] == ends.bounds[3] == 3.0
    tips = [complex(*arrow.path[0][:2]) - (2 + 3j) for arrow in arrows]
    turns = sorted(math.degrees(math.atan2(z.imag, z.real)) for z in tips)
    assert turns == pytest.approx(sorted((0.0, sweep)), abs=1e-6)
    assert all(abs(z) == pytest.approx(26.0) for z in tips)
    first, last = (complex(x, y) - (2 + 3j) for x, y, _ in (arc.path[0], arc.path[-1]))
    drawn = abs(math.degrees(math.atan2((last / first).imag, (last / first).real)))
    assert drawn >= abs(sweep) - 1e-6  # where the arrows stand outside the arc goes on behind them


@pytest.mark.parametrize("height", [-4.0, -3.0, 3.0, 4.5])
def test_no_number_stands_on_a_level_line(height: float) -> None:
    """Between two numbers a line along the axis is read as a minus."""
    feet, others = row(12, 120.0)
    level = line("thin", complex(-10.0, height), complex(60.0, height))
    labels = position_numbers(feet, others, [level], SIZE)
    assert len(labels) == 13
    assert all(box(label).disjoint(shape(level)) for label in labels)


def test_a_run_of_numbers_changes_sides_together() -> None:
    """The first half has a level line below the axis, the second a curve above it."""
    feet, others = row(12, 120.0)
    level = line("thin", -10.0 - 3.5j, 55.0 - 3.5j)
    deeper = [line("thin", complex(-10.0, y), complex(55.0, y)) for y in (-8.0, -12.0)]
    curve = line("main", 62 + 3j, 90 + 4j, 120 + 3j)
    labels = position_numbers(feet, others, [level, *deeper, curve], SIZE)
    sides = [label.at.imag > 0.0 for label in labels]
    assert sides == sorted(sides, reverse=True)
    assert sides[0]
    assert not sides[-1]
