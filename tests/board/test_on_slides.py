"""Plates on tracing paper of which no leg turns: on guides, past points, on nothing, at their dead places."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.board.geometry import cis
from graphic_tmm.board.operations.on_slides import (
    lay_on_guide_past,
    lay_on_guides,
    lay_on_guides_past,
    lay_past_all,
)
from graphic_tmm.board.values import Line

rng = np.random.default_rng(41)
N = 400
OPERATIONS = (lay_on_guides, lay_on_guides_past, lay_on_guide_past, lay_past_all)
"""By how many guides of the plate pass points."""
SLOTS = pytest.mark.parametrize("slots", range(4))
SIZES = pytest.mark.parametrize("size", [2.0**-40, 1.0, 2.0**40])


def places() -> np.ndarray:
    return np.asarray(rng.uniform(-90, 90, (1, N)) + 1j * rng.uniform(-90, 90, (1, N)))


def case(slots: int, *, one_point: bool = False, size: float = 1.0) -> tuple[list[object], Line]:
    """Plates laid at random on three slides, the last ``slots`` along them; the answer.

    ``one_point``: what is square to the slides goes through one point, about which the plate can turn.
    """
    b, along = places(), cis(rng.uniform(0, 360, (1, N)))
    apart, x, y = (rng.uniform(*ends, (1, N)) for ends in ((40, 90), (-60, 60), (20, 60)))
    pins = [b, b + apart * along, b + (x + 1j * y) * along]
    pins = [places() if k >= 3 - slots else pin for k, pin in enumerate(pins)]
    about = places()
    arms = [about - pin for pin in pins] if one_point else [places() for _ in pins]
    ways = [1j * arm / np.abs(arm) for arm in arms]
    # the line of a plate whose second leg slides along it goes that way
    along = ways[1] if slots > 1 else along
    heights = [(np.conj(one) * (pin - b)).imag for pin, one in zip(pins, ways, strict=True)]
    bends = [np.degrees(np.angle(one / along)) for one in ways]
    lengths = [heights[1] if slots > 1 else apart, *([heights[2]] if slots else [x, y])]
    loci: list[object] = [
        pin * size if k >= 3 - slots else Line((pin - 30 * one) * size, one)
        for k, (pin, one) in enumerate(zip(pins, ways, strict=True))
    ]
    sizes: list[object] = [one * size for one in lengths]
    sizes += [bends[2]] if slots else []
    sizes += [heights[0] * size, bends[0]] if slots == 3 else []
    return [*loci, *sizes], Line(b * size, along)


def laid(slots: int, uses: list[object], answer: Line, off: float = 0.0) -> Line:
    """Lay plates near the answer, so many degrees off at most."""
    near = np.degrees(np.angle(answer.along)) + rng.uniform(-off, off, (1, N))
    with np.errstate(all="ignore"):
        found = OPERATIONS[slots].run(*uses, near)
    assert isinstance(found, Line)
    return found


@SIZES
@SLOTS
def test_a_plate_is_laid_where_its_slides_are(slots: int, size: float) -> None:
    uses, answer = case(slots, size=size)
    found = laid(slots, uses, answer, 0.2)
    there = np.isfinite(found.along)
    assert there.mean() > 0.95
    off = np.abs(found.at - answer.at) / size + 90 * np.abs(found.along - answer.along)
    # near a place where the plate is not held the other of two is as near
    assert (off[there] < 1e-9).mean() > 0.95


def test_guides_that_would_have_to_pass_too_far_off_lay_no_plate() -> None:
    uses, answer = case(3)
    uses[3] = uses[3] + 2000.0  # type: ignore[operator]
    assert np.isnan(laid(3, uses, answer).along).mean() > 0.95


def test_a_plate_of_other_lengths_is_on_its_guides_or_nowhere() -> None:
    uses, answer = case(0)
    uses[3] = uses[3] + 500.0  # type: ignore[operator]
    first, second, third, apart, x, y = uses
    found = laid(0, uses, answer)
    there = np.isfinite(found.along)
    assert 0.1 < there.mean() < 0.9
    for guide, arm in ((first, 0.0), (second, apart), (third, x + 1j * y)):  # type: ignore[operator]
        assert isinstance(guide, Line)
        off = (np.conj(guide.along) * (found.at + arm * found.along - guide.at)).imag
        assert np.abs(off / np.abs(found.at))[there].max() < 1e-9
    turned = np.abs(np.angle(found.along / answer.along))
    assert np.nanmax(turned) < np.radians(45.6)


@SIZES
@SLOTS
def test_a_plate_that_can_turn_on_its_slides_is_laid_at_no_size(slots: int, size: float) -> None:
    uses, answer = case(slots, one_point=True, size=size)
    found = laid(slots, uses, answer)
    # a correction from there may lead to another of its places
    assert not (np.abs(found.along - answer.along) < 1e-3).any()
    assert np.isnan(found.along).mean() > 0.9


def test_three_guides_that_are_parallel_hold_no_plate() -> None:
    uses, answer = case(0)
    uses[:3] = [Line(one.at, answer.along) for one in uses[:3]]  # type: ignore[attr-defined]
    assert np.isnan(laid(0, uses, answer).along).all()
