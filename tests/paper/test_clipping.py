"""Parts of chains of cubic arcs: cut where told, on the curve, in the sense told."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.paper.clipping import at, cut, nearest, points

CHAIN = (0j, 1 + 2j, 3 + 2j, 4 + 0j, 5 - 2j, 7 - 1j, 8 + 0j)
places = st.floats(0.0, 2.0)


def bernstein(arc: tuple[complex, ...], t: float) -> complex:
    a, b, c, d = arc
    return (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d


@given(places)
def test_a_point_of_the_chain(u: float) -> None:
    k = min(int(u), 1)
    assert abs(at(CHAIN, u) - bernstein(CHAIN[3 * k : 3 * k + 4], u - k)) < 1e-14


@given(places)
def test_a_point_of_the_chain_is_the_nearest_to_itself(u: float) -> None:
    spot = at(CHAIN, u)
    # the distance is flat at its least: half of the digits of the place, all of those of the point
    assert abs(at(CHAIN, nearest(CHAIN, spot)) - spot) < 1e-7


@given(places, places)
def test_a_part_lies_on_the_chain_from_its_start_to_its_end(u: float, v: float) -> None:
    if abs(u - v) < 1e-6:
        return
    part = cut(CHAIN, u, v)
    assert len(part) % 3 == 1
    assert abs(part[0] - at(CHAIN, u)) < 1e-13
    assert abs(part[-1] - at(CHAIN, v)) < 1e-13
    fine = np.array([at(CHAIN, w) for w in np.linspace(min(u, v), max(u, v), 2001)])
    for z in points(part, 9):
        assert np.abs(fine - z).min() < 0.01


def test_a_whole_chain_and_its_reverse() -> None:
    assert cut(CHAIN, 0.0, 2.0) == pytest.approx(CHAIN)
    assert cut(CHAIN, 2.0, 0.0) == pytest.approx(CHAIN[::-1])
