"""Diagrams of a row that does not come back: a press driven by a rod, judged by its loop in closed form."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import cast

import numpy as np
import pytest
from support.boards import drawn_of
from support.drives import LEVER

import graphic_tmm as tmm
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.record import BESIDE
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError

PRESS = """
title = "Press"
language = "{language}"
[frame]
O = [0, 0]
x = {{ through = [0, -0.26], angle = "0 deg" }}
y = {{ through = [0, 0], angle = "-90 deg" }}
[[link]]
number = 1
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "left" }}
[[link]]
number = 2
points = {{ B = [0, 0], A = [0.26, 0] }}
side = "left of BO"
[[link]]
number = 3
points = {{ O = [0, 0], A = [0.3, 0] }}
[[link]]
number = 4
points = {{ A = [0, 0], D = [0.3, 0] }}
[[link]]
number = 5
points = {{ D = [0, 0] }}
slides = {{ on = "frame", along = "y", side = "+" }}
[drive]
link = 1
speed = "0.1 m/s"
from = "-450 mm"
to = "-320 mm"
positions = {count}
[diagrams]
point = "D"
{asked}
[hand]
ruler = "exact"
[plans]
"""
SPEED, FROM, TO = 0.1, -0.45, -0.32


def press(asked: str, count: int = 13, language: str = "en") -> Drawn:
    """Return the press with its diagrams drawn exactly."""
    return drawn_of(tmm.read(PRESS.format(asked=asked, count=count, language=language)))


def depth(x: np.ndarray) -> np.ndarray:
    """How far D is below O, m, where B stands at x: analytic, so that a complex step differentiates it."""
    apart = np.sqrt(x**2 + 0.26**2)
    cosine = (0.26**2 + apart**2 - 0.3**2) / (2 * 0.26 * apart)
    rise = 0.26 / apart * cosine - x / apart * np.sqrt(1.0 - cosine**2)
    return 0.52 - 0.52 * rise


def travel(time: Reals) -> Reals:
    """How far D has come along y, m."""
    return (depth(FROM + SPEED * time) - depth(np.array(FROM))).astype(float)


def speed_of(time: Reals) -> Reals:
    """How fast D is along y, m/s."""
    return cast(Reals, depth(FROM + SPEED * time + 1e-30j).imag / 1e-30 * SPEED)


def rows(made: Drawn, symbol: str) -> Reals:
    """Return what the ordinates of a diagram stand for, at the positions."""
    chart = DIAGRAMS_PLAN.on(made).charts[symbol]
    value = made.reading[chart.ordinates[0]] * made.reading[chart.mu]
    return cast(Reals, value[0])


def test_chords_give_the_mean_speed_of_every_interval_and_none_after_the_last() -> None:
    made = press('H_V = "20 mm"\nH_a = "20 mm"')
    times = np.linspace(0.0, (TO - FROM) / SPEED, 13)
    np.testing.assert_allclose(rows(made, "S"), travel(times), atol=1e-12)
    middles = made.reading[BESIDE.on(made).middles["V"].value][0]
    np.testing.assert_allclose(middles[:12], np.diff(travel(times)) * 12 / times[-1], atol=1e-11)
    assert np.isnan(middles[12:]).all()
    base = DIAGRAMS_PLAN.on(made).base
    assert base.intervals == 12
    np.testing.assert_allclose(made.reading[base.mu] * made.reading[base.length], times[-1])


@pytest.mark.parametrize("method", ["chords", "tangents"])
@pytest.mark.parametrize("start", ["displacement", "velocity"])
def test_the_error_falls_with_the_intervals_at_both_ends_too(method: str, start: str) -> None:
    """Curves of second order: with three times the intervals a sixth of the error at most."""
    asked = f'start = "{start}"\nmethod = "{method}"'
    errors = []
    for count in (9, 25, 73):
        made = press(asked, count)
        times = np.linspace(0.0, (TO - FROM) / SPEED, count)
        due = {"S": travel, "V": speed_of}
        symbol = "V" if start == "displacement" else "S"
        off = np.abs(rows(made, symbol) - due[symbol](times))
        errors.append(off.max() / np.abs(due[symbol](times)).max())
        assert np.isfinite(off).all()
    assert all(fine < coarse / 6.0 for coarse, fine in pairwise(errors))


def test_a_lever_that_turns_in_part_has_diagrams_over_its_angle() -> None:
    lever = LEVER.replace(
        "\n[drive]",
        "\n[[link]]\nnumber = 4\npoints = {B = [0, 0], E = [0.4, 0]}\n"
        "[[link]]\nnumber = 5\npoints = {E = [0, 0]}\n"
        'slides = { on = "frame", along = "x", side = "+" }\n[drive]',
    )
    lever = lever.replace(
        "C = [0.4, 0]", 'C = [0.4, 0]\nx = { through = [0, 0.1], angle = "0 deg" }'
    )
    asked, off = '[diagrams]\npoint = "E"\nover = "angle"\n[hand]\nruler = "exact"\n', []
    for count in (6, 16, 46):
        text = lever.replace("positions = 6", f"positions = {count}")
        made = drawn_of(tmm.read(f"{text}{asked}"))
        base, motion = DIAGRAMS_PLAN.on(made).base, KINEMATICS_PLAN.on(made).velocities
        assert base.intervals == count - 1
        whole = (made.reading[base.mu] * made.reading[base.length]).item()
        assert whole == pytest.approx(math.radians(55.0))
        assert motion is not None
        planned = (made.reading[motion.readings[5]] * made.reading[motion.mu])[0]
        off.append(np.abs(2.0 * rows(made, "V") - planned).max() / np.abs(planned).max())
    assert all(fine < coarse / 6.0 for coarse, fine in pairwise(off))


LISTED = "speed = [" + ", ".join(['"0.1 m/s"'] * 5 + ['"0.2 m/s"']) + "]"


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('speed = "0.1 m/s"', LISTED, "the speed of link 1 changes"),
        ('speed = "0.1 m/s"', "speed = 0", "link 1 stands still"),
        ("[diagrams]", '[diagrams]\nover = "angle"', 'write over = "time"'),
        ("positions = 6", "positions = 4", "4 intervals at least, not 3"),
    ],
)
def test_what_no_diagram_can_be_drawn_of_is_refused(old: str, new: str, says: str) -> None:
    text = PRESS.format(asked="", count=6, language="en")
    with pytest.raises(TmmError, match=says):
        drawn_of(tmm.read(text.replace(old, new)))
