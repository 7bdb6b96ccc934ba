"""Clicked plans of a student's own making read as they were drawn: right or wrong, in his μ, turned."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from support.own_boards import MACHINES, A, Board, V
from support.own_sheets import WRONGLY, Kind, strokes
from support.photographed.pencil import DOTS, drawn

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
    """Draw velocities 1 and accelerations 1 and 3 of a mechanism; click p and a of each."""
    machine, rng = MACHINES[kind.machine], np.random.default_rng(seed)
    mu = {plan: machine.mu[plan] * kind.mu[plan] for plan in (V, A)}
    lines, clicked, spots, wrong = [], [], {}, set()
    for n, (plan, k) in enumerate([(V, 1), (A, 1), (A, 3)]):
        board, mistaken, due = Board(rng), Board(None), Board(None)
        for one, how in ((board, kind.wrong), (mistaken, kind.wrong), (due, "")):
            machine.draw(one, plan, k * np.pi / 4, mu, how)
        turn = np.exp(1j * np.radians(kind.turn)) if plan == V else 1.0
        middle = turn * np.mean([z for two in board.lines for z in two[:2]])
        origin = complex(70 + 140 * n, 100) - middle
        lines += strokes(board, origin, turn, kind, rng)
        slips = 0.2 * (rng.standard_normal(2) + 1j * rng.standard_normal(2))
        first = origin + turn * board.points["a"] + slips[1]
        clicked.append(ClickedPlan(plan, str(k), origin + slips[0], first))
        for letter, z in board.points.items():
            if letter:
                spots[plan, letter, str(k)] = z
                if abs(mistaken.points[letter] - due.points[letter]) > WRONGLY:
                    wrong.add((plan, letter, str(k)))
    lead = drawn(lines, SIZE, kind.pencil, seed)
    step = DOTS // HIGH
    rows, columns = (side // step for side in lead.shape)
    mean = lead.reshape(rows, step, columns, step).mean(axis=(1, 3))
    image = 235 - 0.7 * mean + rng.normal(0, 3, mean.shape)
    grey = np.clip(image, 0, 255).astype(np.uint8)[::-1]
    flat = Flat(np.repeat(grey[..., None], 3, axis=2), Box(0.0, 0.0, *SIZE), float(HIGH))
    found = read_clicked(exact(kind.machine), flat, clicked, HANDS["student"])
    return Own(found, spots, wrong)


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


@pytest.mark.parametrize("number", range(len(RIGHT)))
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
