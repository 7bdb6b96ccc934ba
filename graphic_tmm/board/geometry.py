"""Arithmetic of the plane on complex arrays that stays accurate in hard cases."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.values import Complexes, Reals

EPS = float(np.finfo(np.float64).eps)
TANGENT = 16 * EPS
"""A gap negative by less than this share of the lengths is rounding: the figures touch."""
PARALLEL = 4 * EPS
"""Two unit directions whose wedge is not larger than this are parallel: their rounding alone reaches it."""
_QUADRANTS = np.array([1, 1j, -1, -1j])


def cis(degrees: Reals) -> Complexes:
    """Return e^{iφ} of an angle in degrees; exact at every multiple of 90°."""
    quarter = np.rint(degrees / 90.0)
    rest = np.radians(degrees - 90.0 * quarter)
    # a NaN becomes some whole number here, and stays NaN in the rest
    return np.asarray(_QUADRANTS[quarter.astype(np.intp) & 3] * np.exp(1j * rest))


def degrees(z: Complexes) -> Reals:
    """Return the direction of ``z`` in degrees, (-180, 180]; exact in the eight main directions.

    NaN where ``z`` has no length.
    """
    angle = np.degrees(np.arctan2(z.imag + 0.0, z.real))
    return np.where(z == 0.0, np.nan, angle)


def wedge(a: Complexes, b: Complexes) -> Reals:
    """Return the signed area of the parallelogram of two vectors."""
    return np.asarray(a.real * b.imag - a.imag * b.real)


def along(a: Complexes, unit: Complexes) -> Reals:
    """Return the component of ``a`` along a unit direction."""
    return np.asarray(a.real * unit.real + a.imag * unit.imag)


def unit(a: Complexes) -> Complexes:
    """Return the direction of ``a``; NaN where it has no length."""
    return np.asarray(a / np.abs(a))


def root(product: Reals, gap: Reals, scale: Reals) -> Reals:
    """Return √product; 0 where ``gap`` is negative within rounding of ``scale``, NaN where it is beyond.

    ``gap`` is the factor of ``product`` that becomes negative where two figures no longer meet.
    """
    touching = (gap < 0) & (gap >= -TANGENT * scale)
    return np.asarray(np.sqrt(np.where(touching, 0.0, product)))
