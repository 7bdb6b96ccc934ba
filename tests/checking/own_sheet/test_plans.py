"""Clicked plans of a student's own making read as they were drawn: right or wrong, in his μ, turned."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from support.own_boards import MACHINES, A, V
from support.own_plans import own_plans, own_positions
from support.own_sheets import Kind

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.check import check
from graphic_tmm.checking.own_sheet.clicked import ClickedPlan
from graphic_tmm.checking.own_sheet.plans import OwnPlans, read_clicked
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.points import SEEN
from graphic_tmm.checking.pencil.reading import readings
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.ruled import Box
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

CASES = Path(__file__).parents[2] / "cases" / "check"
SIZE = (420.0, 200.0)
HIGH = 4


@functools.cache
def exact(machine: str) -> DrawnScene:
    return make(read(CASES / f"{machine}.toml"), exact=True)


class Own(NamedTuple):
    """A kind of drawing of three plans, how it was read, and where its points stand, mm from the pole."""

    found: OwnPlans
    drawn: dict[tuple[str, str, str], complex]
    wrong: set[tuple[str, str, str]]


@functools.cache
def own(kind: Kind, seed: int = 1) -> Own:
    """Draw three plans of a mechanism; click p and a of each."""
    drawn = own_plans(kind, seed)
    found = read_clicked(exact(kind.machine), drawn.flat, drawn.clicked, HANDS["student"])
    return Own(found, drawn.spots, drawn.wrong)


def far(one: Own, keys: set[tuple[str, str, str]]) -> list[float]:
    """Return how far the points seen of some are from where they were drawn, mm."""
    points = (p for p in one.found.found.points if p.how == SEEN and p.name in keys)
    return [abs(p.spot - one.drawn[p.name]) for p in points]


RIGHT = [
    Kind("sc", mu={V: 0.8, A: 1.25}),
    Kind("fb", mu={V: 1.6, A: 1.0}, heads=0.0),
    Kind("rpr", mu={V: 1.3, A: 1.6}, rings=True),
    Kind("sc", turn=90.0),
    Kind("rpr", turn=-90.0, mu={V: 1.25, A: 1.0}),
]


@pytest.mark.turns(2)
@pytest.mark.parametrize("number", range(len(RIGHT)))
@pytest.mark.slow
def test_a_right_drawing_is_read_in_its_own_scale_and_turn(number: int) -> None:
    kind = RIGHT[number]
    one = own(kind)
    errors = far(one, set(one.drawn))
    assert len(errors) >= 0.8 * len(one.drawn)
    assert np.quantile(errors, 0.9) < 1.0
    for scale in one.found.scales:
        due = MACHINES[kind.machine].mu[scale.plan] * kind.mu[scale.plan]
        assert scale.mu == pytest.approx(due, rel=0.02)
        turn = np.exp(1j * np.radians(kind.turn if scale.plan == V else 0.0))
        assert scale.turns == pytest.approx((turn,))
    report = check(
        one.found.made.scene,
        readings(one.found.found.points),
        points="photo",
        scales=[f"{scale.plan}={scale.mu}" for scale in one.found.scales],
    )
    assert not report.wrong


WRONG = [
    ("sc", "n from the wrong end"),
    ("sc", "t from a"),
    ("sc", "other assembly"),
    ("sc", "a outwards"),
    ("sc", "n too long"),
    ("fb", "a outwards"),
    ("fb", "e mirrored"),
    ("rpr", "k the other way"),
    ("rpr", "k left out"),
]


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize(("machine", "mistake"), WRONG)
def test_a_wrong_drawing_is_read_as_it_was_drawn(machine: str, mistake: str) -> None:
    one = own(Kind(machine, mistake, mu={V: 1.25, A: 1.0}), 2)
    assert one.wrong
    errors = far(one, one.wrong)
    assert len(errors) >= 0.5 * len(one.wrong)
    assert np.quantile(errors, 0.75) < 1.0
    report = check(
        one.found.made.scene,
        readings(one.found.found.points),
        points="photo",
        scales=[f"{scale.plan}={scale.mu}" for scale in one.found.scales],
    )
    assert report.wrong


def test_where_nothing_is_drawn_nothing_is_read() -> None:
    flat = Flat(np.full((800, 1680, 3), 230, np.uint8), Box(0.0, 0.0, *SIZE), 4.0)
    clicked = [ClickedPlan(V, "1", 100 + 100j, 150 + 130j)]
    found = read_clicked(exact("sc"), flat, clicked, HANDS["student"]).found
    assert (found.points, found.missing) == ((), ((V, "1"),))


@pytest.mark.parametrize("times", [0.8, 1.0])
@pytest.mark.slow
def test_positions_upon_one_another_are_read_by_the_crank_s_pivot_and_pin(times: float) -> None:
    drawn = own_positions(times)
    found = read_clicked(exact("fb"), drawn.flat, drawn.clicked, HANDS["student"])
    (scale,) = found.scales
    assert scale.mu == pytest.approx(0.002 / times, rel=1e-6)
    off = [abs(p.spot - drawn.spots[p.name]) for p in found.found.points if p.how == SEEN]
    assert len(off) >= 22
    assert max(off) < 1.5
    report = check(
        exact("fb").scene,
        readings(found.found.points),
        hand="student",
        points="own sheet",
        scales=[f"positions={scale.mu if scale.another else 'scene'}"],
    )
    assert not report.wrong
