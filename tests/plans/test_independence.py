"""Positions are independent: one at a time, in blocks, sliced, with links in any order: the same plans."""

from __future__ import annotations

import numpy as np
import pytest
from drawn import board
from mechanisms import sample

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import arrays
from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide

ANGLES = np.arange(12)[None, :] * 30.0
DRAWN = sample(25, seed=11)


def _told(value: complex) -> str:
    """A number as it is told: 12 significant digits of a unit-sized plan."""
    return "nan" if np.isnan(value) else f"{value.real:.9e}{value.imag:+.9e}"


def _same(first: dict, second: dict, scale: float) -> None:
    for name in first:
        assert first[name].keys() == second[name].keys()
        for key, value in first[name].items():
            a, b = np.broadcast_arrays(value, second[name][key])
            assert np.array_equal(np.isnan(a), np.isnan(b)), (name, key)
            close = np.abs(a - b) <= 1e-12 * np.maximum(np.abs(a), scale)
            assert np.all(close | np.isnan(a)), (name, key)


@pytest.mark.parametrize("drawn", DRAWN, ids=lambda d: "-".join(d.kinds))
def test_twelve_at_once_are_twelve_times_one(drawn) -> None:
    sheet = board(drawn.mechanism)
    whole = sheet.read(ANGLES)
    for index in range(12):
        single = sheet.read(ANGLES[:, index : index + 1])
        for name, columns in single.items():
            for key, value in columns.items():
                row = whole[name][key]
                there = row[index] if row.size > 1 else row[0]
                assert _told(complex(value[0])) == _told(complex(there)), (name, key, index)


@pytest.mark.parametrize("block", [1, 2, 7, 4096])
def test_a_block_boundary_changes_nothing(block: int) -> None:
    for drawn in DRAWN[:6]:
        sheet = board(drawn.mechanism)
        whole, parted = sheet.read(ANGLES), sheet.read(ANGLES, block=block)
        for name, columns in whole.items():
            for key, row in columns.items():
                assert [_told(complex(z)) for z in np.ravel(row)] == [
                    _told(complex(z)) for z in np.ravel(parted[name][key])
                ]


def test_the_order_of_links_changes_nothing() -> None:
    for drawn in DRAWN:
        mechanism = drawn.mechanism
        turned = Mechanism(mechanism.frame, mechanism.links[::-1], mechanism.drive)
        scale = max(abs(z) for z in drawn.points.values()) + 1e-30
        first, second = board(mechanism).read([[drawn.phi]]), board(turned).read([[drawn.phi]])
        for name, power in (("r", 0), ("v", 1), ("a", 2)):
            size = scale * abs(mechanism.drive.speed) ** power
            for key, value in first[name].items():
                assert abs(value[0] - second[name][key][0]) <= 1e-9 * size, (name, key)


def test_a_slice_of_the_log_changes_nothing() -> None:
    for drawn in DRAWN[:8]:
        sheet = board(drawn.mechanism)
        given = sheet.given | {sheet.positions.phi: ANGLES}
        whole = execute(sheet.log, given)
        for step in sheet.log.steps[::5]:
            alone = execute(sheet.log, given, [step.it])
            assert set(alone.values) == {step.it.slot}
            for a, b in zip(arrays(whole[step.it]), arrays(alone[step.it]), strict=True):
                assert np.array_equal(a, b, equal_nan=True)


def _slider_crank() -> Mechanism:
    guide = Guide("x", 0j, 0.0)
    return Mechanism(
        Link(0, {"O": 0j}, (guide,)),
        (
            Link(1, {"O": 0j, "A": 0.3}),
            Link(2, {"A": 0j, "B": 0.64, "S": 0.22}),
            Link(3, {"B": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
        ),
        Drive(1, 50.0),
    )


@pytest.mark.parametrize("turned", [False, True])
def test_dead_centres_give_zero_exactly(turned: bool) -> None:
    read = board(_slider_crank(), turned=turned).read([[0.0, 90.0, 180.0, 270.0, 360.0]])
    assert np.isfinite(read["v"]["B", 2]).all()
    assert read["v"]["B", 3][[0, 2, 4]].tolist() == [0, 0, 0]
    assert read["omega"][2][[1, 3]].tolist() == [0.0, 0.0]
    assert read["v"]["B", 2][1] == pytest.approx(-15.0, abs=1e-13)
    assert np.isfinite(read["a"]["B", 2]).all()
