"""Arithmetic of the plane that stays accurate in hard cases, on complex arrays.

What `vector`, `reverse`, `quadrant`, `sine`, `some` and `pick` do is done to one number as well, in other
words: `compile.trace` has these, and runs everything else here as it stands on symbols of single numbers.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals

EPS = float(np.finfo(np.float64).eps)
TANGENT = 16 * EPS
"""A gap negative by less than this share of the lengths is rounding: the figures touch."""
PARALLEL = 4 * EPS
"""Two unit directions whose wedge is not larger than this are parallel: their rounding alone reaches it.

So does that of a gap beside the lengths from which it comes: figures that meet by less touch."""
RADIAN = np.pi / 180.0
_QUADRANTS = np.array([1, 1j, -1, -1j])


def vector(x: Reals, y: Reals) -> Complexes:
    """Return x + iy."""
    shape = x.shape if x.shape == y.shape else np.broadcast_shapes(x.shape, y.shape)
    found = np.empty(shape, np.complex128)
    found.real = x
    found.imag = y
    return found


def reverse(z: Complexes) -> Complexes:
    """Return −z."""
    if z.strides[-1] != z.itemsize:
        return -z
    # numpy turns the signs of real numbers several at a time
    return np.negative(z.view(np.float64)).view(np.complex128)


def quadrant(quarters: Reals) -> Complexes:
    """Return i to the power of a whole number; of a NaN, one of the four."""
    found: Complexes = _QUADRANTS[quarters.astype(np.intp) & 3]
    return found


def sine(x: Reals) -> Reals:
    """Return the sine of angles up to 45°, in radians."""
    found: Reals = np.sin(x)
    return found


_SINE = (
    1.58969099521155010221e-10,
    -2.50507602534068634195e-08,
    2.75573137070700676789e-06,
    -1.98412698298579493134e-04,
    8.33333333332248946124e-03,
    -1.66666666666666324348e-01,
)


def series_of_sine(x: Any) -> Any:
    """Return the sine of angles up to 45° by the usual minimax polynomial of degree 13, right to an ulp.

    A polynomial runs at several positions in step, which a call of the system's sine does not.
    """
    square = x * x
    s5, s4, s3, s2, s1, s0 = _SINE
    series = square * (
        s0 + square * (s1 + square * (s2 + square * (s3 + square * (s4 + square * s5))))
    )
    return x + x * series


def some(mask: NDArray[np.bool_]) -> bool:
    """Whether a mask is true anywhere."""
    return bool(np.count_nonzero(mask))


def pick(mask: NDArray[np.bool_], first: Any, second: Any) -> Any:
    """Return ``first`` where the mask is true, ``second`` elsewhere.

    Where it is true, or false, all over, that one is returned in the shape it has.
    """
    true = np.count_nonzero(mask)
    if true == mask.size:
        return first
    return np.where(mask, first, second) if true else second


def cis(degrees: Reals) -> Complexes:
    """Return e^{iφ} of an angle in degrees; exact at every multiple of 90°."""
    quarters = np.rint(degrees / 90.0)
    # within 45° of a quarter the cosine is known as well from the sine as by itself
    rest = degrees - 90.0 * quarters
    rest *= RADIAN
    y = sine(rest)
    return quadrant(quarters) * vector(np.sqrt((1.0 - y) * (1.0 + y)), y)


def degrees(z: Complexes) -> Reals:
    """Return the direction of ``z`` in degrees, (-180, 180]; exact in the eight main directions.

    NaN where ``z`` has no length.
    """
    angle = np.degrees(np.arctan2(z.imag + 0.0, z.real))
    return np.where(z == 0.0, np.nan, angle)


def wedge(a: Complexes, b: Complexes) -> Reals:
    """Return the signed area of the parallelogram of two vectors."""
    area: Reals = a.real * b.imag
    area -= a.imag * b.real
    return area


def along(a: Complexes, unit: Complexes) -> Reals:
    """Return the component of ``a`` along a unit direction."""
    part: Reals = a.real * unit.real
    part += a.imag * unit.imag
    return part


def unit(a: Complexes) -> Complexes:
    """Return the direction of ``a``; NaN where it has no length."""
    return a * (1.0 / np.abs(a))


def root(product: Reals, gap: Reals, scale: Reals) -> Reals:
    """Return √product; 0 where ``gap`` is within rounding of ``scale``, NaN where it is negative beyond.

    ``gap`` is the factor of ``product`` that becomes negative where two figures no longer meet.
    """
    touching = (gap <= PARALLEL * scale) & (gap >= -TANGENT * scale)
    if some(touching):
        product = np.where(touching, 0.0, product)
    found: Reals = np.sqrt(product)
    return found
