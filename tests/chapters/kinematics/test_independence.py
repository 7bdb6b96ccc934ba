"""Positions are independent: one at a time, in blocks, sliced, with links in any order: the same plans."""

from __future__ import annotations

import random
from typing import Any

import numpy as np
import pytest
from support.drawn import board
from support.each import each
from support.mechanisms import Sampled, sample
from support.turns import in_turn

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import arrays
from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide

ANGLES = np.arange(12)[None, :] * 30.0
DRAWN = sample(25, seed=11)


def _same(first: dict[str, Any], second: dict[str, Any], places: Any = slice(None)) -> None:
    """Assert that readings agree to 12 digits of the largest value of their kind, NaN where NaN."""
    for name, columns in first.items():
        assert columns.keys() == second[name].keys()
        finite = [np.abs(v[np.isfinite(v)]) for v in map(np.ravel, columns.values())]
        size = max((float(v.max()) for v in finite if v.size), default=0.0)
        for key, value in columns.items():
            a = np.broadcast_to(np.ravel(value), 12)[places]
            b = np.broadcast_to(np.ravel(second[name][key]), a.shape)
            np.testing.assert_allclose(a, b, rtol=0, atol=1e-12 * size, err_msg=f"{name} {key}")


@pytest.mark.slow
@each("drawn", DRAWN, turns=8)
def test_twelve_at_once_are_twelve_times_one(drawn: Sampled) -> None:
    sheet, angles = board(drawn.mechanism), ANGLES + drawn.phi
    whole = sheet.read(angles)
    for index in range(12):
        single = sheet.read(angles[:, index : index + 1])
        _same(whole, single, places=[index])


@pytest.mark.slow
@pytest.mark.parametrize("block", [1, 2, 7, 4096])
def test_a_block_boundary_changes_nothing(block: int) -> None:
    for drawn in in_turn(DRAWN, 8):
        sheet, angles = board(drawn.mechanism), ANGLES + drawn.phi
        _same(sheet.read(angles), sheet.read(angles, block=block))


def test_a_subset_of_positions_changes_nothing() -> None:
    for drawn in DRAWN:
        sheet, angles = board(drawn.mechanism), ANGLES + drawn.phi
        whole, some = sheet.read(angles), sheet.read(angles, positions=[9, 0, 4])
        for name, columns in whole.items():
            for key, value in columns.items():
                due = value if value.size == 1 else value[[9, 0, 4]]
                np.testing.assert_allclose(some[name][key], due, rtol=1e-12, atol=0)


@pytest.mark.slow
def test_the_order_of_links_changes_nothing() -> None:
    source = random.Random(5)
    for drawn in DRAWN:
        mechanism = drawn.mechanism
        first = board(mechanism).read([[drawn.phi]])
        links = list(mechanism.links)
        for _ in range(3):
            source.shuffle(links)
            shuffled = Mechanism(mechanism.frame, tuple(links), mechanism.drive)
            second = board(shuffled).read([[drawn.phi]])
            for name, columns in first.items():
                assert columns.keys() == second[name].keys()
                size = max((float(np.abs(v).max()) for v in columns.values()), default=0.0)
                for key, value in columns.items():
                    assert np.abs(value - second[name][key]).max() <= 1e-10 * size, (name, key)


def test_a_slice_of_the_log_changes_nothing() -> None:
    for drawn in DRAWN[:8]:
        sheet = board(drawn.mechanism)
        given = sheet.given | {sheet.positions.row[0]: ANGLES}
        whole = execute(sheet.log, given)
        for step in sheet.log.steps[::3]:
            alone = execute(sheet.log, given, [step.it])
            assert set(alone.values) == {step.it.slot}
            for a, b in zip(arrays(whole[step.it]), arrays(alone[step.it]), strict=True):
                assert np.array_equal(a, b, equal_nan=True)


def _slider_crank(crank: float = 0.3, rod: float = 0.64) -> Mechanism:
    guide = Guide("x", 0j, 0.0)
    return Mechanism(
        Link(0, {"O": 0j}, (guide,)),
        (
            Link(1, {"O": 0j, "A": crank}),
            Link(2, {"A": 0j, "B": rod, "S": 0.22}),
            Link(3, {"B": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
        ),
        Drive(1, 50.0),
    )


@pytest.mark.slow
@pytest.mark.parametrize("turned", [False, True])
def test_dead_centres_give_zero_exactly(turned: bool) -> None:
    """pb = 0 at 0° and 180°, ab = 0 at 90° and 270°; not nearly zero, and never NaN."""
    source = random.Random(2)
    for _ in range(100):
        crank = source.uniform(0.01, 1.0)
        made = _slider_crank(crank, crank * source.uniform(1.01, 6.0))
        read = board(made, turned=turned).read(
            [[0.0, 180.0, 360.0, -180.0, 90.0, 270.0, -90.0, 450.0]]
        )
        assert read["v"]["B", 3][:4].tolist() == [0, 0, 0, 0]
        assert read["omega"][2][4:].tolist() == [0.0, 0.0, 0.0, 0.0]
        speeds = read["v"]["B", 3][4:]
        np.testing.assert_allclose(np.abs(speeds), 50 * crank, rtol=1e-15)
        np.testing.assert_allclose(speeds, speeds.real, rtol=0, atol=1e-13 * crank)
        assert np.sign(speeds.real).tolist() == [-1, 1, 1, -1]
        for key in (("B", 2), ("B", 3), ("S", 2)):
            assert np.isfinite(read["a"][key]).all()
        assert np.isfinite(read["epsilon"][2]).all()
