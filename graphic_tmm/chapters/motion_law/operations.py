"""Operations and formulas of a machine's motion: where it comes to rest, ω by a ray, ε by a subnormal, t."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.operations.graphs import HALVINGS, alike
from graphic_tmm.board.values import Complexes, Curve, Length, Number, Point, Reals
from graphic_tmm.language.said import said

LEVEL = 1e-9
"""An energy that is lower than 0 by less than this share of the largest is 0 but for rounding."""
_STANDS = "the machine has no reduced moment of inertia"
_AT_REST = "the machine stands still in this interval"


def _negative(heights: Reals) -> np.ndarray:
    """Return which ordinates lie below the base, but for rounding; a missing one lies nowhere.

    The first position is where the machine is, however a hand pricks its ordinate.
    """
    size = np.nanmax(np.abs(heights), axis=1, keepdims=True, initial=0.0)
    return np.asarray((heights < -LEVEL * size) & (np.arange(heights.shape[1]) > 0))


@operation(
    symbol=FREE,
    across=True,
    everywhere=True,
    why=said(
        "A machine whose energy is used up stands: it does not reach the positions behind the first in which "
        "the energy would be negative."
    ),
)
def until_rest(of: Length, *, row: int) -> Length:
    """Keep {of} up to the first below the base: {it}."""
    found = np.array(of)
    below = np.cumsum(_negative(of[:, :row]), axis=1)
    gone = np.concatenate([np.zeros_like(below[:, :1]), below[:, :-1]], axis=1) > 0
    found[:, :row] = np.where(gone, np.nan, found[:, :row])
    return Length(found)


@formula(why=said("In the first position this moment turns the machine, or holds it."))
def moment_at(ordinate: Length, mu: Number) -> Number:
    """{ordinate}·{mu}"""


@operation(
    symbol=FREE,
    across=True,
    everywhere=True,
    why=said("A machine at rest starts only where the moment in the first position drives it."),
)
def from_rest(of: Number, first: Number) -> Number:
    """Keep {of} if {first} of the first position does not hold the machine: {it}."""
    of, first = alike(of, first)
    held = first[:, :1] < -LEVEL * np.nanmax(np.abs(first), axis=1, keepdims=True, initial=0.0)
    return Number(
        np.concatenate([of[:, :1], np.where(held, -np.abs(of[:, 1:]), of[:, 1:])], axis=1)
    )


@operation(
    symbol=FREE,
    across=True,
    why=said("The end of the base is reached only by a machine that did not come to rest before."),
)
def reached(end: Length, of: Length, *, row: int) -> Length:
    """Keep {end} if no ordinate {of} lies below the base: {it}."""
    gone = ~np.isfinite(of[:, :row]) | _negative(of[:, :row])
    return Length(np.where(gone.any(axis=1, keepdims=True), np.nan, end[:, :1]))


@operation(
    symbol="E1 + E2",
    across=True,
    why=said(
        "Where the energy is used up the machine stands; else its motion is known to the end of the base."
    ),
)
def comes_to_rest(curve: Curve) -> Point:
    """Where the curve {curve} first comes down to the base, else at its end, mark {it}."""
    heights = np.where(np.isfinite(curve.knots), curve.knots.imag, np.nan)
    below = _negative(heights)
    stops = np.any(below, axis=1, keepdims=True)
    before = np.maximum(np.argmax(below, axis=1), 1)[:, None] - 1
    return Point(np.where(stops, _down(curve, before), curve.knots[:, -1:]))


def _down(curve: Curve, at: np.ndarray) -> Complexes:
    """Return where an arc that ends below the base comes down to it."""
    p, q = (np.take_along_axis(curve.knots, k, axis=1) for k in (at, at + 1))
    m, n = (np.take_along_axis(curve.tangents, k, axis=1) for k in (at, at + 1))
    low, high = np.zeros_like(p.real), np.full_like(p.real, 1.0)
    for _ in range(HALVINGS):
        u = (low + high) / 2.0
        rise = q.imag - p.imag
        y = p.imag + u * (
            m.imag + u * (3.0 * rise - 2.0 * m.imag - n.imag + u * (m.imag + n.imag - 2.0 * rise))
        )
        low, high = np.where(y > 0.0, u, low), np.where(y > 0.0, high, u)
    return np.asarray(p.real + high * (q - p).real + 0j)


@operation(
    symbol=FREE,
    across=True,
    why=said("From the last position that is reached on the motion slows down evenly."),
)
def last_before(of: Point, end: Point, *, row: int) -> Point:
    """Of {of} take the last that is not behind {end}; mark {it}."""
    of, last = alike(of[:, :row], end[:, :1])
    there = np.isfinite(of) & (of.real <= last.real)
    place = row - 1 - np.argmax(there[:, ::-1], axis=1)[:, None]
    found = np.take_along_axis(of, place, axis=1)
    return Point(np.where(there.any(axis=1, keepdims=True), found, np.nan))


@operation(
    kept=True,
    across=True,
    everywhere=True,
    why=said("The speed in the first position is given: no ray has to tell it."),
)
def begins_with(of: Number, first: Number) -> Number:
    """In the first position {it} is {first}, in all others {of}."""
    of, first = alike(of, first)
    return Number(np.concatenate([first[:, :1], of[:, 1:]], axis=1))


@formula(
    why=said("At the beginning the machine has the energy of its first speed: {x}·{mu_J} is its J.")
)
def first_energy(x: Length, mu_J: Number, omega: Number) -> Number:
    """{x}·{mu_J}·{omega}²/2"""


@formula(
    why=said(
        "What all forces have done since the beginning is what the kinetic energy of the machine has gained."
    )
)
def energy(first: Number, work: Length, mu: Number) -> Number:
    """{first} + {work}·{mu}"""


@formula(
    fails=_STANDS,
    why=said("The ray from the origin to the point of a position rises by T over J."),
)
def slope_of_ray(up: Length, along: Length) -> Number:
    """{up}/{along}"""


@formula(
    holds="{slope} ≥ 0",
    fails="the machine comes to rest before this position",
    why=said(
        "T = J·ω²/2, so the ray to the point of a position has the slope tan ψ = ω²·μ_J/(2·μ_T)."
    ),
)
def speed_of_ray(slope: Number, mu_T: Number, mu_J: Number) -> Number:
    """√(2·{mu_T}·{slope}/{mu_J})"""
    square = 2.0 * mu_T * np.maximum(slope, 0.0) / mu_J
    # a slope of nothing but rounding is that of rest
    return Number(np.sqrt(np.where(slope > -LEVEL, square, np.nan)))


@formula(
    why=said(
        "The normal cuts off on the base the subnormal, ω·dω/dφ to scale: that is dω/dt, for dφ = ω·dt."
    )
)
def by_subnormal(segment: Length, mu_omega: Number, mu_phi: Number) -> Number:
    """{segment}·{mu_omega}²/{mu_phi}"""


@formula(
    holds="{segment} > 0",
    fails=_AT_REST,
    why=said(
        "A radian takes the time 1/ω; the mean speed of an interval is that in its middle, also where it "
        "begins or ends at rest."
    ),
)
def slowness(segment: Length, mu: Number) -> Number:
    """1/({segment}·{mu})"""


@formula(
    holds="{first} + {last} > 0",
    fails="the machine does not start",
    why=said(
        "Over the last stretch the speed changes evenly, so the mean of its two ends tells the time of it."
    ),
)
def time_at_end(
    before: Length,
    mu_t: Number,
    far: Length,
    near: Length,
    mu_phi: Number,
    first: Length,
    last: Length,
    mu_omega: Number,
) -> Number:
    """{before}·{mu_t} + 2·({far} − {near})·{mu_phi}/(({first} + {last})·{mu_omega})"""
