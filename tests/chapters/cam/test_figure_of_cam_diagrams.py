"""Diagrams of cams are read off the log: every law, every follower, cams drawn at random."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from support.cams import C6, Made, made
from support.each import each
from support.graphs import assert_read_off_the_log, graphs

from graphic_tmm.chapters.cam.ink_rules import DIAGRAM_RULES, TRACELESS
from graphic_tmm.chapters.cam.task import (
    CamTask,
    FlatFollower,
    Follower,
    Law,
    RockerFollower,
    RollerFollower,
)

GIVEN = Law("diagram", ((0, 0), (0.25, 1), (0.75, -1), (1, 0)))
JUMPING = Law("diagram", ((0, 1), (0.5, 1), (0.5, -1), (1, -1)))
LAWS = {
    "sine": Law("sine"),
    "cosine": Law("cosine"),
    "constant": Law("constant acceleration"),
    "3-4-5": Law("3-4-5"),
    "given": GIVEN,
    "jumping": JUMPING,
}


@cache
def order(seed: int) -> CamTask:
    """A cam drawn at random."""
    rng = np.random.default_rng(seed)
    names = list(LAWS)
    shares = rng.dirichlet([30.0, 4.0, 30.0, 12.0])
    rise, upper, fall = (float(round(360.0 * share)) for share in shares[:3])
    followers: list[Follower] = [
        RollerFollower(float(rng.uniform(-0.01, 0.01))),
        FlatFollower(0.005),
        RockerFollower(0.08, 0.1, same_sense=bool(rng.integers(2))),
    ]
    follower = followers[seed % 3]
    stroke = 0.3 if isinstance(follower, RockerFollower) else float(rng.uniform(0.01, 0.05))
    return CamTask(
        stroke, rise, upper, fall, 360.0 - rise - upper - fall,
        rise_law=LAWS[names[seed % 6]], return_law=LAWS[names[seed // 6 % 6]],
        follower=follower, pressure=40.0,
        turns=("clockwise", "counterclockwise")[seed % 2],
    )  # fmt: skip


def assert_diagrams(of: Made) -> None:
    assert np.isfinite(of.one(of.cam.r0)), "without a centre there is nothing to draw of it"
    names = [str(k) for k in range(of.reading.positions)]
    views = graphs(of.log, of.reading, names, of.reading.positions, DIAGRAM_RULES)
    assert {"cam S", "cam dS", "cam ddS"} <= {view.name for view in views}
    assert_read_off_the_log(of.log, views, TRACELESS)


@pytest.mark.slow
@each("law", LAWS, turns=3)
def test_every_law_is_read_off_the_log(law: str) -> None:
    assert_diagrams(made(CamTask(**C6, rise_law=LAWS[law], return_law=LAWS[law])))


@pytest.mark.slow
@each("seed", range(12), turns=4)
def test_cams_drawn_at_random_are_read_off_the_log(seed: int) -> None:
    assert_diagrams(made(order(seed)))
