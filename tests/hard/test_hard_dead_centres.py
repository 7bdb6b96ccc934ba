"""Dead centres of slider-crank, rocker and four-bar: exactly, and off by 1e-3 … 1e-15 rad."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from support import oracle
from support.drawn import board
from support.hard_judge import DIGITS, exact_of, judge, right
from support.hard_mechanisms import FRAMES, Frame, coulisse, four_bar, put, slider_crank
from support.scenes import slider_crank as slider_crank_text
from support.scenes import written

import graphic_tmm as tmm
from graphic_tmm.mechanism.records import Mechanism

OFFS = (0.0, *(s * 10.0**-k for k in (3, 9, 15) for s in (1, -1)))


def _in_line(r: float, rod: float, s: float, d: float, way: int) -> float:
    """The crank's angle (degrees) at which crank and coupler are in line, the rocker extreme."""
    long = rod + way * r
    phi = math.degrees(math.acos((long * long + d * d - s * s) / (2 * long * d)))
    return phi if way > 0 else phi + 180.0


def _square(r: float, d: float) -> float:
    """The crank's angle (degrees) at which the crank is square to the rocker."""
    return math.degrees(math.acos(r / d))


CASES: dict[str, tuple[Mechanism, tuple[float, ...]]] = {
    "slider-crank": (slider_crank(0.3, 0.64), (0.0, 180.0, 90.0, 270.0)),
    "slider-crank with an offset": (
        slider_crank(0.045, 0.18, -0.018),
        (
            math.degrees(math.asin(-0.018 / 0.225)),
            180.0 - math.degrees(math.asin(-0.018 / 0.135)),
        ),
    ),
    "four-bar": (
        four_bar(1.0, 2.5, 2.0, 3.0),
        tuple(_in_line(1.0, 2.5, 2.0, 3.0, way) for way in (1, -1)),
    ),
    "rocker": (coulisse(0.13657, 0.48), (_square(0.13657, 0.48), -_square(0.13657, 0.48))),
    "rocker off its pivot": (coulisse(0.1, 0.3, 0.05), (0.0, 180.0)),
}
NEAR = (FRAMES[0], FRAMES[4])
"""Frames in which all distances from a dead centre are tried; in the others, the dead centre itself."""


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_right_at_and_about_the_dead_centres(name: str) -> None:
    mechanism, angles = CASES[name]
    for angle in angles:
        for frame in FRAMES:
            for off in OFFS if frame in NEAR else OFFS[:1]:
                at = frame.angle(angle + math.degrees(off))
                found = judge(put(mechanism, frame), at, turned=frame.mirrored)
                assert right(found), (frame, at, found.shares)
                assert not found.findings


@pytest.mark.parametrize("frame", FRAMES[:3])
def test_a_slider_stands_at_its_dead_centres(frame: Frame) -> None:
    """Zero to the last bit in the main directions, in every reading; directions stay defined."""
    mechanism = put(slider_crank(0.3, 0.64), frame)
    read = board(mechanism).read([[frame.angle(0.0), frame.angle(180.0)]])
    assert read["v"]["B", 3].tolist() == [0, 0]
    assert all(np.isfinite(v).all() for plan in read.values() for v in plan.values())


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("turns", ["counterclockwise", "clockwise"])
def test_a_row_from_a_dead_centre_at_half_a_turn_is_drawn(
    side: str, turns: str, tmp_path: Path
) -> None:
    """The crank lies at 180° there, which is −180° as well: a rounding may tell either."""
    drive = f'speed = 5\nturns = "{turns}"\npositions = 12\nextra = ["other extreme"]\n'
    zero = f'zero = {{ point = "B", at = "{side}" }}\n'
    table = tmm.draw(written(tmp_path, slider_crank_text(drive + zero))).table("velocities")
    assert table.positions[-1] == "6*"
    assert np.isfinite(table["pb"].value).all()
    assert np.isfinite(table["omega2"].value).all()
    assert table["pb"].value[0, [0, 6, 12]].tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("name", ["slider-crank", "four-bar", "rocker"])
def test_the_oracles_own_newton_agrees(name: str) -> None:
    """The closed positions are not alone: the loops, solved by Newton at 50 digits, say the same."""
    mechanism, angles = CASES[name]
    for angle in angles:
        read = board(mechanism).read([[angle]])
        places = {
            letter: complex(read["r"][letter, link.number][0])
            for link in mechanism.links
            for letter in link.points
        }
        start = oracle.poses_from_points(mechanism, angle, places)

        def phi(angle: float = angle) -> mp.mpf:
            return mp.mpf(angle) * mp.pi / 180

        found = oracle.solve_digits(mechanism, phi, start, dps=DIGITS)
        with mp.workdps(DIGITS + 5):
            verdict = judge(mechanism, angle, exact_of(mechanism, found))
        assert right(verdict), verdict.shares


def test_the_return_of_a_rocker_is_where_the_crank_is_square_to_it() -> None:
    """ω3 vanishes there: what is left is below the bound, and changes its sign across it."""
    mechanism, (angle, _) = CASES["rocker"]
    rows = [[angle - 1e-9, angle + 1e-9]]
    low, high = board(mechanism).read(rows)["omega"][3]
    assert low * high < 0
    assert abs(board(mechanism).read([[angle]])["omega"][3][0]) < 1e-14
    assert cmath.isfinite(board(mechanism).read([[angle]])["a"]["D", 3][0])
