"""Points that were turned, mirrored or counted from elsewhere, by plane geometry."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.congruence.moves import MOVES, NONE, Move, Placed, placed, turned_back
from graphic_tmm.checking.records import Taken

DUE = {
    ("velocities", letter, place): complex(x, y)
    for place, spots in {
        "1": {"a": (60.0, 35.0), "b": (80.0, 0.0), "s": (71.0, 20.0)},
        "2": {"a": (-10.0, 68.0), "b": (-20.0, 0.0), "s": (-14.0, 31.0)},
        "3": {"a": (-55.0, -41.0), "b": (-60.0, 0.0), "s": (-57.0, -19.0)},
    }.items()
    for letter, (x, y) in spots.items()
}


def rows(move: Move, times: float, origin: complex, slip: float = 0.7) -> list[Taken]:
    """Return the points as a hand reads them."""
    rng, found = np.random.default_rng(5), []
    for (plan, letter, place), due in DUE.items():
        z = origin + times * move.moved(due) + slip * complex(*rng.standard_normal(2))
        found.append(Taken(plan, place, letter, x=z.real, y=z.imag))
    return found


@pytest.mark.parametrize("origin", [0j, 143.0 - 88.0j])
@pytest.mark.parametrize("times", [0.6, 1.0, 1.6])
@pytest.mark.parametrize("move", MOVES)
def test_every_move_is_told(move: Move, times: float, origin: complex) -> None:
    found = placed(rows(move, times, origin), DUE, "velocities", MOVES)
    if (move, origin) == (NONE, 0j):
        assert found is None
        return
    assert found is not None
    assert found.move == move
    assert found.times == pytest.approx(times, abs=0.06)
    for z in found.origins.values():
        assert abs(z - origin) < 3.0
    for due in DUE.values():
        assert abs(move.back(move.moved(due)) - due) < 1e-9


def test_points_of_another_figure_are_no_move() -> None:
    """Points anywhere: nothing is told."""
    rng = np.random.default_rng(3)
    some = [
        row._replace(x=float(x), y=float(y))
        for row, (x, y) in zip(rows(NONE, 1.0, 0j), 60.0 * rng.standard_normal((9, 2)), strict=True)
    ]
    assert placed(some, DUE, "velocities", MOVES) is None


def test_two_points_tell_no_move() -> None:
    assert placed(rows(Move(1), 1.0, 0j)[:2], DUE, "velocities", MOVES) is None


def test_a_plan_turned_against_the_others_is_counted_as_they_are() -> None:
    down, left = Move(0, mirrored=True), Move(2, mirrored=True)
    found = {p: Placed(down, 1.0, {}) for p in ("positions", "accelerations")}
    found["velocities"] = Placed(left, 2.0, {})
    assert turned_back(found) == {"velocities": Placed(down, 2.0, {})}
    assert turned_back({**found, "accelerations": None}) == {}
    assert turned_back({**found, "velocities": Placed(Move(1), 1.0, {})}) == {}


def test_points_of_a_mistake_are_no_origin_nearby() -> None:
    """One point of three stands elsewhere: its plan is not counted from between them."""
    some = [
        row._replace(x=row.x + 22.0) if row.segment != "a" and row.x is not None else row
        for row in rows(NONE, 1.0, 0j, slip=0.1)
    ]
    assert placed(some, DUE, "velocities", MOVES) is None
