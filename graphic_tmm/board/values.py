"""What a mark is. Every value carries the axes (trial, position), size 1 where it does not vary.

Points are complex numbers x + iy in mm of the sheet, so a turn by 90° is a factor 1j. A value that cannot be
drawn is NaN; nothing else is. A `Curve` folds the position axis into itself: it is drawn across positions.
"""

from __future__ import annotations

from typing import Any, NamedTuple, NewType

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]

Point = NewType("Point", Complexes)
"""A place on the board, x + iy, mm."""
Length = NewType("Length", Reals)
"""A length on the board, mm; signed where it is measured along a line."""
Angle = NewType("Angle", Reals)
"""An angle, degrees, counter-clockwise positive."""
Number = NewType("Number", Reals)
"""A quantity in SI, or a scale factor μ in SI units per mm."""
Side = NewType("Side", Reals)
"""+1 or -1: which of two intersections an assembly keeps."""
Vector = NewType("Vector", Complexes)
"""What a reader has of a plan, x + iy in SI: it leaves the log, and is no mark that a plan draws."""


class Line(NamedTuple):
    """A line: a point of it (mm) and its unit direction; both complex (trial, position)."""

    at: Complexes
    along: Complexes


class Arc(NamedTuple):
    """An arc of the compass: its centre (complex, mm) and its radius (mm), (trial, position)."""

    centre: Complexes
    radius: Reals


class Curve(NamedTuple):
    """A French curve through points: knots and tangents (complex, mm), (trial, knot); open or closed."""

    knots: Complexes
    tangents: Complexes
    closed: bool


Kind = Any
"""One of the kinds above, as it stands in an operation's annotations."""
KINDS: dict[Kind, str] = {
    Point: "Point",
    Length: "Length",
    Angle: "Angle",
    Number: "Number",
    Side: "Side",
    Line: "Line",
    Arc: "Arc",
    Curve: "Curve",
}


def arrays(value: Any) -> tuple[NDArray[Any], ...]:
    """Return the arrays a value is made of."""
    if isinstance(value, Curve):
        return (value.knots, value.tangents)
    return tuple(value) if isinstance(value, tuple) else (value,)


def complexes(kind: Kind) -> tuple[bool, ...]:
    """Return which of the arrays of a kind are complex."""
    return {
        Point: (True,),
        Vector: (True,),
        Line: (True, True),
        Arc: (True, False),
        Curve: (True, True),
    }.get(kind, (False,))


def places(value: Any) -> int:
    """Return how many positions a value has: 1 where it does not vary, as a curve does not."""
    if isinstance(value, Curve):
        return 1
    return max(int(part.shape[1]) for part in arrays(value))


def undefined(value: Any) -> NDArray[np.bool_]:
    """Return where a value is not a finite one, (trial, position)."""
    bad = [~np.isfinite(part) for part in arrays(value)]
    return np.asarray(np.logical_or.reduce(np.broadcast_arrays(*bad)))


def at(row: Any, places: Any) -> Any:
    """Return a row (1, position) at some positions; None for all."""
    return row if places is None or row.shape[1] == 1 else row[:, list(places)]


def blank(value: Any, mask: NDArray[np.bool_]) -> Any:
    """Return a value with NaN where a mask (trial, position) is true; a curve is whole, or is not."""
    if isinstance(value, Curve):
        gone = np.nan if mask.any() else 0.0
        return Curve(value.knots + gone, value.tangents + gone, value.closed)
    if isinstance(value, tuple):
        return type(value)(*(blank(part, mask) for part in value))
    return np.where(mask, np.nan, value)


def given(value: object, kind: Kind) -> Any:
    """Return plain numbers as a value of ``kind`` with axes (trial, position): a scalar becomes (1, 1).

    What was drawn elsewhere (a line, a curve) is one already.
    """
    if isinstance(value, tuple):
        return value
    dtype = np.complex128 if complexes(kind)[0] else np.float64
    found = np.asarray(value, dtype=dtype)
    return found if found.ndim > 1 else np.array(found, ndmin=2)
