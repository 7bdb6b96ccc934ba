"""Wheels on links as their page runs them with other givens: the teeth alone say how fast they turn."""

from __future__ import annotations

import numpy as np
import pytest
from support import gallery
from support.live_logs import by_page, live_page
from support.wheel_loops import FiveBar

import graphic_tmm as tmm
from graphic_tmm.board.record import Mark
from graphic_tmm.studio import make

RING = FiveBar(0.03, 0.19, 0.18, 0.03, 0.1, (60, 20), True)
INNER = RING._replace(teeth=(20, 60))
CASES = {"outside": (None, -2.0), "in a ring": (RING, 3.0), "a ring": (INNER, 1.0 / 3.0)}


@pytest.mark.parametrize("case", CASES)
def test_centres_farther_apart_leave_the_ratio_to_the_teeth(case: str) -> None:
    bar, ratio = CASES[case]
    drawn = gallery.drawn("geared-five-bar") if bar is None else make(tmm.read(bar.scene)).mechanism
    assert drawn is not None
    page = live_page(drawn)
    assert page is not None
    given = {mark.name: mark for mark in page.log.own}
    assert not [name for name in given if "K" in name], "the pitch radius follows from the teeth"
    at = [0, 7, 19]
    marks = {step.it.name: step.it for step in page.log.live if step.it.view == "velocities"}
    values: dict[Mark, float] = page.log.own
    apart = given["l_{OD}"]
    for share in (1.0, 1.25, 0.9):
        (told,) = by_page(page, [{apart: float(values[apart]) * share}], at)
        rates = [one[marks["ω_4"].slot][0] for one in told]
        assert np.allclose(rates, ratio * float(np.ravel(values[given["ω_1"]])[0]), rtol=1e-9)
