"""Honest drawings are fine; the limits grow and shrink with the hand."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from support.gallery import SHEETS, exact
from support.trials import honest

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.judging.scatter import Limits, sample, scatter
from graphic_tmm.checking.judging.taken_marks import Reader
from graphic_tmm.scene.read import read
from graphic_tmm.studio import drawings, make


@pytest.mark.slow
def test_honest_drawings_are_fine(many: Callable[[int, int], int]) -> None:
    """At most 5 % of readings doubtful, at most 1 % of drawings with a wrong one; 500 with ``--measured``."""
    scenes, hands = (
        ("engine", "crank-rocker", "offset-slider", "slider-diagrams"),
        ("student", "careful"),
    )
    rows = [
        honest(name, hand, many(63, 30))
        for k, name in enumerate(scenes)
        for hand in (hands if many(1, 0) else hands[k % 2 : k % 2 + 1])
    ]
    drawings_made = sum(one.drawings for one in rows)
    assert drawings_made >= many(500, 120)
    for one in rows:
        assert one.doubtful <= 0.05 * one.readings
    assert sum(one.broken for one in rows) <= 0.01 * drawings_made


@pytest.mark.slow
def test_scatter_goes_to_zero_with_the_hand() -> None:
    due = cells(exact("engine"))
    key = ("velocities", "ab", "2")
    wide = []
    for share in (1.0, 0.1, 0.01):
        hand = HANDS["student"]._replace(
            ruler=None, digits=None, prick=0.15 * share, compass=0.15 * share,
            swing=0.6 * share, reading=0.75 * share, trials=200,
        )  # fmt: skip
        drawn = sample(exact("engine"), hand, {key: {True}})
        found = scatter(exact("engine"), drawn, Reader(hand), {key: {True}}, Limits())
        wide.append(float(np.sqrt(np.mean(found[key, True].sorted ** 2))))
    assert wide[1] == pytest.approx(0.1 * wide[0], rel=0.05)
    assert wide[2] == pytest.approx(0.01 * wide[0], rel=0.05)
    assert math.isfinite(due[key].mm or math.nan)


@pytest.mark.slow
def test_the_same_seed_is_the_same_hand() -> None:
    scene = replace(read(SHEETS / "lever"), hand="student", seed=7, ruler=0.5)
    one, other = make(scene), make(scene)
    assert cells(one) == cells(other)
    assert cells(make(replace(scene, seed=8))) != cells(one)
    first = next(iter(drawings(one, HANDS["student"]._replace(ruler=0.5, seed=7, trials=3))))
    assert cells(first).keys() == cells(one).keys()
