"""Passes over real arrays that numpy has no function for: some look first whether they can be spared.

Each leaves its numbers in ``out`` or, where they stand somewhere already, says where.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board import geometry
from graphic_tmm.board.values import Reals

_LEAST, _MOST = 1e-280, 1e300
"""Squares between these have lost nothing."""
_FEW = 128
"""Numbers of which it does not pay to look what they are."""


def length(x: Any, y: Any, out: Reals, other: Reals) -> Any:
    """Return √(x² + y²); where the squares leave the range of numbers, by numpy's slower way."""
    if out.size < _FEW:
        return np.hypot(x, y, out)
    np.multiply(x, x, out)
    np.multiply(y, y, other)
    np.add(out, other, out)
    if out.min() > _LEAST and out.max() < _MOST:
        return np.sqrt(out, out)
    return np.hypot(x, y, out)


def count(mask: NDArray[np.bool_]) -> int:
    """Return at how many positions a mask is true; −1 for all of them."""
    true = int(np.count_nonzero(mask))
    return -1 if true == mask.size else true


def choose(true: int, mask: NDArray[np.bool_], first: Any, second: Any) -> Any:
    """Return ``first`` where a mask is true, ``second`` elsewhere; ``true``: how often, see `count`."""
    if true < 0:
        return first
    # numpy's own array costs less than the filling of another in two passes
    return np.where(mask, first, second) if true else second


def alike(quarters: Reals) -> bool:
    """Whether whole numbers are all one."""
    if quarters.size < _FEW or quarters[0] != quarters[-1]:
        return False
    return bool(np.count_nonzero(np.equal(quarters, quarters[0])) == quarters.size)


def turn_x(same: bool, quarters: Any, x: Any, y: Any) -> Any:
    """Return the real part of x + iy turned by right angles; ``same``: whether all are, see `alike`."""
    if same:
        at = int(quarters[0]) & 3
        return (x, y)[at & 1] if at in (0, 3) else np.negative((x, y)[at & 1])
    at = quarters.astype(np.intp) & 3
    return x * _COSINES[at] - y * _COSINES[at - 1]


def turn_y(same: bool, quarters: Any, x: Any, y: Any) -> Any:
    """Return the imaginary part of x + iy turned by right angles."""
    return turn_x(same, quarters, y, np.negative(x))


def root(product: Any, gap: Any, scale: Any, out: Reals) -> Any:
    """Return √product, as `geometry.root` does, which is asked only where the figures do not meet all over."""
    if gap.min() >= 0.0:
        return np.sqrt(product, out)
    out[:] = geometry.root(product, gap, scale)
    return out


def signed(x: Any, y: Any, out: Reals) -> Any:
    """Return x, of which nothing is below 0, with the sign of y, by bits: several at a time."""
    bits = out.view(np.int64)
    np.bitwise_and(y.view(np.int64), _MINUS, bits)
    np.bitwise_or(bits, x.view(np.int64), bits)
    return out


_MINUS = np.array(np.iinfo(np.int64).min)
_COSINES = np.array([1.0, 0.0, -1.0, 0.0])
