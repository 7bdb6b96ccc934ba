"""What is said to be seen is seen so often: errors planted in drawings of the hand itself."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from click.testing import CliRunner
from support.gallery import exact
from support.trials import readings

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging.judge import judge
from graphic_tmm.checking.judging.power import SeenError, seen_errors
from graphic_tmm.checking.judging.residuals import sharpened
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardsticks
from graphic_tmm.checking.records import WRONG
from graphic_tmm.commands.check import check
from graphic_tmm.studio import drawings

SCENE = "crank-rocker"


@cache
def yardsticks() -> Yardsticks:
    return Yardsticks(exact(SCENE), HANDS["student"]._replace(trials=400), Limits())


@cache
def rows() -> tuple[SeenError, ...]:
    return seen_errors(exact(SCENE), yardsticks())


@pytest.mark.slow
def test_errors_are_seen_as_often_as_is_said() -> None:
    """Planted one at a time at any position: the medians are of all, so that some do not reach 19 of 20."""
    made, rng = exact(SCENE), np.random.default_rng(8)
    segments = {(one.plan, one.segment): one for one in rows()}
    seen = {"half": 0, "nearly": 0}
    count = 0
    hand = HANDS["student"]._replace(trials=12, seed=77)
    for drawn in drawings(made, hand):
        taken = readings(cells(drawn), cells(made))
        lengths = [
            k for k, one in enumerate(taken) if one.mm and (one.plan, one.segment) in segments
        ]
        for k in rng.choice(lengths, 6, replace=False):
            one = taken[k]
            said = segments[one.plan, one.segment]
            count += 1
            for name, by in (("half", said.half), ("nearly", said.nearly)):
                mm = one.mm or 0.0
                sign = np.sign(mm) if abs(mm) < 10.0 else rng.choice([-1.0, 1.0])
                off = [*taken[:k], one._replace(mm=mm + by * sign), *taken[k + 1 :]]
                usual = yardsticks().of(off)
                judged, _ = sharpened(made, judge(made, off, usual), usual)
                seen[name] += any(
                    row.verdict == WRONG
                    for row in judged
                    if row.taken.key == one.key and row.taken.mm is not None
                )
    assert 0.3 * count < seen["half"] < 0.7 * count
    assert 0.72 * count < seen["nearly"]


def test_more_is_needed_to_be_seen_in_nearly_all() -> None:
    assert len(rows()) > 8
    for one in rows():
        assert 2.0 < one.least <= one.half <= one.most < 10.0
        assert one.half + 1.0 < one.nearly < 2.0 * one.half


def test_the_command_prints_every_segment() -> None:
    done = CliRunner().invoke(check, [SCENE, "--power"])
    assert done.exit_code == 0, done.output
    assert {one.segment for one in rows()} <= set(done.output.split())
    refused = CliRunner().invoke(check, [SCENE, "readings.csv", "--power"])
    assert refused.exit_code == 2
