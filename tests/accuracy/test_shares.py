"""Shares of the variance: they add up to that of a hand all of whose steps slip, and none is missing."""

from __future__ import annotations

import numpy as np
import pytest
from support.tasks import by, drawing, quantity

from graphic_tmm.accuracy.shares import shares
from graphic_tmm.board.execute import execute, needed
from graphic_tmm.board.hand import HANDS, Hand, slip_of

SMALL = Hand(prick=0.002, compass=0.002, swing=0.002, reading=0.002, seed=3)
"""Slips so small that what they leave is linear in them."""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["slider-diagrams", "crank-rocker"])
def test_variances_of_single_steps_add_up_to_that_of_all(name: str) -> None:
    """Each variance is the mean of 40 trials at 8 positions or more, the whole of 400: within 10 % at 3 sigma
    (a step that slips once for the row has 40 numbers, 22 %, but no more than half of the variance).
    """
    drawn = drawing(name)
    for one, row in shares(drawn, SMALL, each=40).items():
        q = quantity(drawn, one)
        values = q.read(
            execute(drawn.construction, drawn.given, q.marks, hand=SMALL._replace(trials=400)), 400
        )
        exact = q.read(execute(drawn.construction, drawn.given, q.marks), 1)
        largest = np.abs(exact).max()
        whole = np.mean((100.0 * (values - exact) / largest) ** 2)
        assert sum(s.deviation**2 for s in row) == pytest.approx(whole, rel=0.3)
        assert sum(s.share for s in row) == pytest.approx(1.0, rel=1e-12)
        assert [s.share for s in row] == sorted((s.share for s in row), reverse=True)


def test_every_step_that_slips_and_is_needed_has_a_share() -> None:
    drawn = drawing("slider-diagrams")
    v = quantity(drawn, "v")
    steps = {
        step.it
        for step in needed(drawn.construction, v.marks)
        if (slip := slip_of(step.op, step.it.view, step.it.letter)) and slip.kind != "digits"
    }
    assert {share.step.it for share in shares(drawn, HANDS["student"])["v"]} == steps


@pytest.mark.slow
def test_the_reading_itself_has_the_variance_of_its_slip() -> None:
    """Readings of v are pb and ab: that of pb leaves its slip and the ruler's rounding, 0.75² + 0.5²/12 mm².

    v has two readings a position, so a reading of one of them leaves half of its variance in the mean of both;
    2 · 200 · 8 numbers are certain to 2.5 %.
    """
    drawn = drawing("slider-diagrams")
    v = quantity(drawn, "v")
    reading = execute(drawn.construction, drawn.given)
    mu = float(reading[v.values[0].by][0, 0])  # type: ignore[index]
    largest = np.abs(v.read(reading, 1)).max()
    due = 100.0 * np.sqrt((0.75**2 + 0.5**2 / 12) / 2) * mu / largest
    found = {s.step.it.letter: s.deviation for s in shares(drawn, HANDS["student"], each=200)["v"]}
    assert found["pb"] == pytest.approx(due, rel=0.08)


def test_an_exact_hand_has_no_shares() -> None:
    assert shares(drawing("slider-diagrams"), by("slider-diagrams", "exact").who) == {}
