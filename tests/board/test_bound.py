"""A bound loop leaves what the log leaves, of rows that enter it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from graphic_tmm.board.bound import Bound, bound
from graphic_tmm.board.execute import prepare
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.loop_passes import WIDTH
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.formulas import rate
from graphic_tmm.board.operations.instruments import join, lay_off, measure
from graphic_tmm.board.record import Board, Mark
from graphic_tmm.board.values import Length, Number, Point

pytest.importorskip("llvmlite")
COUNT = 53
PLACES = (np.linspace(0.0, 9.0, COUNT) ** 2 + 1j * np.linspace(5.0, -3.0, COUNT))[None, :]


class Plan:
    """A point that moves, one that stands, what is read between them, and what stands still."""

    def __init__(self, *, curve: bool = False) -> None:
        draft = Board()
        draft.open("plan")
        self.p, self.q, self.r = (draft.take(Point, letter) for letter in "PQR")
        self.mu = draft.take(Number, "μ", "m/mm")
        self.length = draft.take(Length, "l")
        self.given: dict[Mark, Any] = {
            self.p: PLACES,
            self.q: np.array([[3.0 - 2.0j]]),
            self.r: np.array([[4.0 + 1.0j]]),
            self.mu: np.array([[0.02]]),
            self.length: np.array([[7.0]]),
        }
        self.line = draft.draw(join, "(PQ)", self.p, self.q)
        self.far = draft.draw(lay_off, "S", self.line, self.length)
        self.read = draft.draw(measure, "PS", self.q, self.far)
        self.omega = draft.draw(rate, "ω", self.read, self.mu, self.length, self.mu)
        self.still = draft.draw(measure, "QR", self.q, self.r)
        if curve:
            draft.draw(french_curve, "(P)", self.far, row=COUNT - 1)
        self.log = draft.construction()
        self.asked = [mark.slot for mark in (self.omega, self.far, self.still, self.read)]

    def values(self, given: dict[Mark, Any]) -> dict[int, Any]:
        return {mark.slot: value for mark, value in given.items()}

    def bound(
        self, hand: Hand = EXACT, asked: list[int] | None = None, **more: Any
    ) -> Bound | None:
        values = self.values(self.given) | more.get("values", {})
        (calls, _), *_ = prepare(self.log).strata
        return bound(calls, values, hand, self.asked if asked is None else asked)


@pytest.mark.parametrize("hand", [EXACT, Hand(ruler=0.5)])
@pytest.mark.parametrize("count", [2, WIDTH - 1, WIDTH, WIDTH + 1, COUNT])
def test_it_leaves_what_the_log_leaves(count: int, hand: Hand) -> None:
    """A point, which enters as two rows; numbers; one that is the same at all positions, asked for too."""
    plan = Plan()
    loop = plan.bound(hand)
    assert loop is not None
    place = PLACES[:, -count:]
    found = loop.run(count, [feed.of({plan.p.slot: place})[0] for feed in loop.feeds])
    assert len(loop.feeds) == 2
    due = prepare(plan.log).run({**plan.given, plan.p: place}, hand=hand, fast=True)
    for slot, one in zip(plan.asked, found, strict=True):
        np.testing.assert_array_equal(one, np.broadcast_to(due.values[slot][0], (count,)))
        assert one.dtype == due.values[slot].dtype
        assert one.shape == (count,)
    assert found[2].strides == (0,)
    assert not found[2].flags.writeable


def test_one_position_is_worked_as_one_of_many() -> None:
    plan = Plan()
    loop = plan.bound()
    assert loop is not None
    whole = loop.run(COUNT, [PLACES.real[0], PLACES.imag[0]])
    one = loop.run(1, [PLACES.real[0, 30:31], PLACES.imag[0, 30:31]])
    for all_, alone in zip(whole, one, strict=True):
        assert alone.tobytes() == all_[30:31].tobytes()


def test_what_is_no_one_loop_is_not_bound() -> None:
    """A curve behind it is none of its calls; trials, a line asked for, a row of one number are no one loop."""
    plan = Plan()
    assert Plan(curve=True).bound() is not None
    assert plan.bound(asked=[plan.line.slot]) is None
    assert plan.bound(asked=[plan.p.slot]) is None
    assert plan.bound(values={plan.length.slot: np.array([[7.0], [8.0]])}) is None
    assert plan.bound(values={plan.p.slot: PLACES[:, :1]}) is None
