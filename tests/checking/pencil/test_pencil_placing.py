"""Where a plan stands: near its due, or surely elsewhere; a plan of one position has points, too."""

from __future__ import annotations

import numpy as np
import pytest
from support.photographed.rubbed import flat, paper, rubbed
from support.photographed.student import exact

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.pencil.expected import Line, Place, View, views
from graphic_tmm.checking.pencil.placing import SURELY, THERE, stood

ENDS = (30 + 30j, 100 + 40j, 60 + 80j)


def plan() -> View:
    """Return three vectors from a pole."""
    places = 40 + 50j, *ENDS
    count = len(places)
    return View(
        "velocities",
        tuple(Place(at, ()) for at in places),
        tuple(Line(places[0], at, (0, k)) for k, at in enumerate(ENDS, 1)),
        {},
        (np.empty((0, 2), dtype=np.complex128),) * count,
        (None, 0, 0, 0),
        np.zeros((4, count), dtype=np.complex128),
    )


@pytest.mark.parametrize("moved", [0j, 3 - 4j, 28 + 12j])
def test_a_plan_is_found_wherever_it_was_drawn(moved: complex) -> None:
    grey = paper()
    for line in plan().lines:
        grey = rubbed(grey, line.start + moved, line.end + moved)
    shift, cover = stood(flat(grey), plan())
    assert abs(shift - moved) < 1.5  # lines are followed from there
    assert cover > SURELY


def test_a_plan_that_is_nowhere_is_not_taken_for_another() -> None:
    grey = paper()
    for line in plan().lines:
        middle = line.start + 20 + 10j
        grey = rubbed(grey, middle, middle + (line.end - line.start) * np.exp(0.5j))
    assert stood(flat(grey), plan())[1] < THERE


def test_a_plan_of_one_position_has_points_and_lines() -> None:
    made, sheets = exact("lever")
    by = {one.name: one for one in views(made, sheets[0], HANDS["student"])}
    names = {name for place in by["accelerations-4"].places for name in place.names}
    assert {("accelerations", "a", "4"), ("accelerations", "b", "4")} <= names
    assert len(by["accelerations-4"].lines) > 5
    assert all(line.places for line in by["accelerations-4"].lines)
