"""Where teeth touch: no farther than the limits of the line of action and than the teeth reach."""

from __future__ import annotations

import re
from dataclasses import replace
from math import cos, radians, sin, tan

import numpy as np
import pytest
from support.teeth import Pair, pair

from graphic_tmm.board.findings import examine
from graphic_tmm.chapters.gears.findings import failures
from graphic_tmm.chapters.gears.table import stations
from graphic_tmm.chapters.gears.task import GearTask

M = 0.008
WHOLE = GearTask(22, 31, M, 0.2, -0.1)
BEYOND_N1 = GearTask(12, 40, M)
BEYOND_N2 = GearTask(40, 12, M)
BEYOND_BOTH = GearTask(9, 9, M)
POINTED = GearTask(8, 60, M, 0.9, -0.9)
PASSES = 12
"""Each zooms a bracket to a tenth: far below the tangency that is looked for."""


def inv(angle: np.ndarray | float) -> np.ndarray | float:
    return np.tan(angle) - angle


def apex(z: int, x: float) -> float:
    """The radius, of a module, where both involutes of a tooth meet, by halving."""
    alpha, half = radians(20.0), np.pi / 2 + 2 * x * tan(radians(20.0))
    low, high = z / 2 * cos(alpha), 2.0 * z
    for _ in range(80):
        r = (low + high) / 2
        left = half / z + inv(alpha) - inv(np.arccos(z / 2 * cos(alpha) / r))
        low, high = (r, high) if left > 0.0 else (low, r)
    return low


def touches(order: GearTask) -> float:
    """The turn of wheel 1 during which two involutes touch, in pitches: flanks turned, gaps looked at.

    Nothing is used of a line of action: a point of flank 1 is as far from flank 2 as its angle about centre 2
    says; they touch where the least of these distances is nothing.
    """
    alpha, z, x = radians(20.0), (order.z1, order.z2), (order.x1 or 0.0, order.x2 or 0.0)
    low, high = 1e-3, 1.4
    due = inv(alpha) + 2 * sum(x) / sum(z) * tan(alpha)
    for _ in range(80):
        low, high = (
            (sum((low, high)) / 2, high) if inv((low + high) / 2) < due else (low, (low + high) / 2)
        )
    a_w = sum(z) / 2 * cos(alpha) / cos(low)
    dy = sum(x) - (a_w - sum(z) / 2)
    base = [n / 2 * cos(alpha) for n in z]
    roll = [b / cos(low) for b in base]
    tip = [min(n / 2 + 1 + s - dy, apex(n, s)) for n, s in zip(z, x, strict=True)]

    def flank(k: int, r: np.ndarray) -> np.ndarray:
        return np.asarray(
            inv(np.arccos(np.minimum(base[k] / r, 1.0))) - inv(np.arccos(base[k] / roll[k]))
        )

    def gaps(turn: float, r: np.ndarray) -> np.ndarray:
        spot = r * np.exp(1j * (np.pi / 2 + flank(0, r) + turn)) - 1j * a_w
        far = np.abs(spot)
        there = (far >= base[1]) & (far <= tip[1])
        own = np.angle(spot * 1j) + turn * z[0] / z[1]
        return np.where(there, -far * (own - flank(1, np.maximum(far, base[1]))), np.inf)

    def gap(turn: float) -> float:
        low, high = base[0], tip[0]
        for _ in range(PASSES):
            r = np.linspace(low, high, 401)
            found = gaps(turn, r)
            at = int(np.argmin(found))
            low, high = r[max(at - 20, 0)], r[min(at + 20, 400)]
        return float(found[at])

    def last(sense: float) -> float:
        good, bad = 0.0, sense * 3.0 * 2 * np.pi / z[0]
        for _ in range(45):
            turn = (good + bad) / 2
            good, bad = (turn, bad) if abs(gap(turn)) < 1e-11 else (good, turn)
        return good

    return abs(last(1.0) - last(-1.0)) * z[0] / (2 * np.pi)


@pytest.mark.parametrize("order", [WHOLE, BEYOND_N1, BEYOND_N2, BEYOND_BOTH, POINTED])
def test_the_contact_ratio_counts_where_flanks_that_are_there_touch(order: GearTask) -> None:
    found = pair(order).results()
    # beyond a limit by δ the flanks overlap by δ³/3r_b² (beyond a tip the gap is δ²/2ρ, seen earlier): the
    # 1e-11 modules that are looked for are there from δ = 1e-3 modules on, at either end of 2.95
    assert found["contact_ratio"][0] == pytest.approx(touches(order), abs=7e-4)
    assert found["contact_ratio_drawn"][0] == pytest.approx(found["contact_ratio"][0], rel=1e-10)
    of = pair(order)
    arc = found["contact_ratio"][0] * np.pi * cos(radians(20.0)) * M
    arc /= cos(radians(found["alpha_w"][0]))
    for k in (1, 2):
        assert found[f"arc_of_engagement{k}"][0] == pytest.approx(arc, abs=1e-3 * M)
    assert not examine(of.log, of.given, [step.it for step in of.log.steps])


def test_a_pinion_of_twelve_works_from_its_limit_on() -> None:
    """By hand: N₁b = √(r_a1² − r_b1²) over p_b; the verdict says so."""
    of = pair(BEYOND_N1)
    due = np.sqrt(7.0**2 - (6 * cos(radians(20.0))) ** 2) / (np.pi * cos(radians(20.0)))
    assert of.results()["contact_ratio"][0] == pytest.approx(due, rel=1e-12)
    assert round(due, 3) == 1.405
    told = list(failures(of.drawn, "en"))
    assert told[0].startswith("wheel 1 is undercut")
    assert told[1].startswith("interference")
    assert "1.405" in told[1]
    assert len(told) == 2


@pytest.mark.parametrize(
    ("order", "at"), [(BEYOND_N1, {"a": "N_{1}"}), (BEYOND_BOTH, {"a": "N_{1}", "b": "N_{2}"})]
)
def test_in_a_limit_point_one_flank_slides_without_end(order: GearTask, at: dict[str, str]) -> None:
    of = pair(order)
    found = {one.name: one for one in placed(of)}
    for name, limit in at.items():
        for own, due in zip(found[name].sliding, found[limit].sliding, strict=True):
            np.testing.assert_array_equal(own, due)
        assert sorted(float(row[0]) for row in found[name].sliding) == [-np.inf, 1.0]


def placed(of: Pair) -> list:
    return stations(of.drawn)


def test_told_shift_mends_an_undercut() -> None:
    told = re.search(r"take ([\d.]+) at least", next(failures(pair(BEYOND_N1).drawn, "en")))
    assert told is not None
    shift = float(told[1])
    assert 0.0 <= shift - (1 - 6 * sin(radians(20.0)) ** 2) < 1e-4
    assert not list(failures(pair(replace(BEYOND_N1, x1=shift)).drawn, "en"))
