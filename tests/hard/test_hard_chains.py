"""Long chains and lengths in the ratio 1 : 1e6, judged at 50 digits."""

from __future__ import annotations

from typing import Any

import mpmath as mp  # type: ignore[import-untyped]
import pytest
from support import oracle
from support.drawn import board
from support.each import each
from support.hard_judge import DIGITS, Verdict, exact_of, judge, named, right
from support.hard_mechanisms import FRAMES, Frame, chain, coulisse, four_bar, put, slider_crank

from graphic_tmm.mechanism.records import Mechanism


def _solved(mechanism: Mechanism, degrees: float) -> Verdict:
    read = board(mechanism).read([[degrees]])
    places = {key[0]: complex(value[0]) for key, value in read["r"].items()}
    start = oracle.poses_from_points(mechanism, degrees, places)

    def phi() -> Any:
        return mp.mpf(degrees) * mp.pi / 180

    found = oracle.solve_digits(mechanism, phi, start, dps=DIGITS)
    with mp.workdps(DIGITS + 5):
        return judge(mechanism, degrees, exact_of(mechanism, found))


@pytest.mark.slow
@pytest.mark.parametrize(("angle", "frame"), [(0.0, FRAMES[3]), (200.0, FRAMES[4])])
def test_eight_groups_in_a_row(angle: float, frame: Frame) -> None:
    found = _solved(put(chain(8), frame), frame.angle(angle))
    assert right(found), (found.shares, found.conditions)


@pytest.mark.slow
def test_errors_of_a_chain_grow_no_faster_than_its_conditions_multiply() -> None:
    """The errors of the last group, absolute: from one group to six, less than κ grows."""
    off, kappa = [], []
    for groups in (1, 3, 6):
        found = _solved(chain(groups), 77.0)
        assert right(found)
        off.append(max(found.shares["v"] * found.bounds["v"], 1e-15))
        kappa.append(found.conditions[0] * found.conditions[1])
    assert off[-1] <= off[0] * 6 * kappa[-1] / kappa[0]


RATIOS = {
    "short crank, long rod": (slider_crank(1e-6, 1.0), (0.0, 45.0, 90.0, 200.0)),
    "crank and rod that differ by a millionth": (slider_crank(1.0, 1.0 + 1e-6), (0.0, 45.0, 200.0)),
    "short crank of a four-bar": (four_bar(1e-6, 1.0, 0.8, 1.2), (0.0, 90.0, 200.0)),
    "far pivot of a rocker": (four_bar(1.0, 1e6, 1e6, 1.5), (0.0, 90.0, 200.0)),
    "short crank of a rocker": (coulisse(1e-6, 1.0), (0.0, 90.0, 200.0)),
    "far pivot of a stone": (coulisse(1.0, 1e6), (0.0, 90.0, 200.0)),
    "frame of a millionth": (coulisse(1.0, 1e-6), (0.0, 90.0, 200.0)),
}


@pytest.mark.slow
@each("frame", [FRAMES[k] for k in (0, 1, 3, 4)])
@pytest.mark.parametrize("name", RATIOS)
def test_lengths_in_the_ratio_of_a_million(name: str, frame: Frame) -> None:
    mechanism, angles = RATIOS[name]
    for angle in angles:
        found = judge(put(mechanism, frame), frame.angle(angle))
        assert right(found), (angle, found.shares, found.conditions)
        assert not named(found) or max(found.conditions) > 1e4
