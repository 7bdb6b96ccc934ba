"""The lens: there and back, by mpmath's roots; straight lines of a known camera."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest

from graphic_tmm.checking.photo.lens import MOST, Lens, straightening

MIDDLE, RADIUS = 1999.5 + 1499.5j, 2000.0
PLACES = np.array([0, 3999, 3999 + 2999j, 1999.5 + 1499.5j, 2500 + 10j, 17 + 2000j])


def by_roots(share: float, straight: complex) -> complex:
    """The smallest positive root of the cubic of the radius, 40 digits."""
    with mpmath.workdps(40):
        off = mpmath.mpc(straight) - mpmath.mpc(MIDDLE)
        far = abs(off) / RADIUS
        if far == 0:
            return MIDDLE
        roots = mpmath.polyroots([-far, 1, 0, share], asc=True, maxsteps=200, extraprec=200)
        real = [mpmath.re(one) for one in roots if abs(mpmath.im(one)) < 1e-20]
        return complex(MIDDLE + off * min(one for one in real if one > 0) / far)


@pytest.mark.parametrize("share", [0.002, -0.002, 0.05, MOST, -0.05])
def test_a_ray_is_seen_where_the_cubic_says(share: float) -> None:
    lens = Lens(MIDDLE, RADIUS, share)
    seen = lens.seen(PLACES)
    assert max(abs(a - by_roots(share, b)) for a, b in zip(seen, PLACES, strict=True)) < 1e-6
    assert abs(lens.straight(seen) - PLACES).max() < 1e-6


def test_beyond_what_a_lens_can_show_nothing_is_seen() -> None:
    assert np.isnan(Lens(MIDDLE, RADIUS, -MOST).seen(np.array([1e5 + 0j, -9e4j]))).all()
    assert (Lens(MIDDLE, RADIUS).seen(PLACES) == PLACES).all()


def bowed(share: float, foot: complex, head: complex) -> tuple[np.ndarray, np.ndarray]:
    line = foot + (head - foot) * np.linspace(0, 1, 50)
    return Lens(MIDDLE, RADIUS, share).seen(line), np.ones(50)


@pytest.mark.parametrize("share", [0.0, 0.002, -0.03])
def test_straight_lines_tell_the_lens(share: float) -> None:
    lines = [bowed(share, 300 + 200j, 3700 + 350j), bowed(share, 400 + 300j, 250 + 2700j)]
    found = straightening(Lens(MIDDLE, RADIUS, 0.01), lines)
    # a chord of the bowed line is turned against the straight one's by a share of the share
    assert abs(found.share - share) < 1e-9 + share**2
    assert straightening(found, [bowed(found.share, *ends) for ends in ENDS]).share == (
        pytest.approx(found.share, abs=1e-9 + share**2)
    )


ENDS = ((300 + 200j, 3700 + 350j), (400 + 300j, 250 + 2700j))


def test_what_is_not_believed_does_not_count() -> None:
    (one, weights), other = bowed(0.01, *ENDS[0]), bowed(0.01, *ENDS[1])
    spoilt = one.copy()
    spoilt[20:30] += 40j
    believed = weights.copy()
    believed[20:30] = 0
    lens = Lens(MIDDLE, RADIUS)
    assert straightening(lens, [(spoilt, believed), other]).share == pytest.approx(0.01, abs=1e-4)
    assert abs(straightening(lens, [(spoilt, weights), other]).share - 0.01) > 1e-3


def test_one_line_tells_no_lens() -> None:
    lens = Lens(MIDDLE, RADIUS, 0.004)
    assert straightening(lens, [bowed(0.02, *ENDS[0])]) == lens
    assert straightening(lens, []) == lens


def test_a_reduced_photograph_has_the_same_lens() -> None:
    lens = Lens(MIDDLE, RADIUS, 0.02)
    reduced = lens.reduced(4)
    assert (
        abs(4 * reduced.seen(PLACES / 4) + 1.5 + 1.5j - lens.seen(PLACES + 1.5 + 1.5j)).max() < 1e-9
    )
