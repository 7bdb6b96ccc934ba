"""A step that owns a smaller construction, run a fixed number of times: refinement on the board.

The draughtsman tries a row of positions, sees between which two the sign changes, and tries again between
them. Sixteen parts a pass and fourteen passes leave less than the last bit of an angle.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.values import Angle, Complexes, Number, Point, Reals
from graphic_tmm.language.said import said

PARTS, PASSES = 16, 14
"""Parts of a pass, and passes: 16¹⁴ = 2⁵⁶ parts in all."""
REFINE = "refine"
"""What the operation is called."""


def narrow(tried: Callable[[Reals], Reals], low: Reals, high: Reals) -> Reals:
    """Return where ``tried`` changes its sign between ``low`` and ``high``, both (trial, 1).

    ``tried`` takes and returns arrays (trial, position). NaN where the signs at both ends agree.
    """
    share = np.linspace(0.0, 1.0, PARTS + 1)[None, :]
    for _ in range(PASSES):
        row = low + (high - low) * share
        value = tried(row)
        positive = np.broadcast_to(value, row.shape) > 0
        changes = positive[:, 1:] != positive[:, :-1]
        at = np.argmax(changes, axis=1)[:, None]
        found = np.take_along_axis(changes, at, axis=1)
        low = np.where(found, np.take_along_axis(row, at, axis=1), np.nan)
        high = np.where(found, np.take_along_axis(row, at + 1, axis=1), np.nan)
        zero = np.broadcast_to(value, row.shape) == 0.0
        hit = zero.any(axis=1, keepdims=True)
        exact = np.take_along_axis(row, np.argmax(zero, axis=1)[:, None], axis=1)
        low, high = np.where(hit, exact, low), np.where(hit, exact, high)
        if hit.all():
            break
    return np.asarray((low + high) / 2.0)


@dataclass(frozen=True, eq=False)
class _Refine:
    """The smaller construction, narrowed down; no function within another, so that a log can be pickled."""

    tried: Callable[[Reals], Reals]

    def __call__(self, low: Reals, high: Reals) -> Reals:
        every = np.broadcast_arrays(low, high)
        found = narrow(self.tried, *(one.reshape(-1, 1) for one in every))
        return found.reshape(every[0].shape)


def refinement(tried: Callable[[Reals], Reals], sentence: str, kind: object = Angle) -> Operation:
    """Return the operation that finds, between two coordinates, where a smaller construction changes its sign.

    ``tried`` runs the smaller construction at a row of them (of the ``kind``: degrees, or Number in m) and
    returns its last reading; ``sentence`` names them as {low} and {high}, what is found as {it}.
    """
    lengths = said("no change of sign between the two lengths")
    return Operation(
        REFINE,
        _Refine(tried),
        (kind, kind),
        ("low", "high"),
        kind,
        (),
        sentence,
        fails=said("no change of sign between the two angles") if kind is Angle else lengths,
        # of a trial: its angle laid off, its last segment read; the trial itself comes on top
        symbol="nP1 + nP2 + nM1 + nR1 + nM3",
    )


@dataclass(frozen=True, eq=False)
class _Redraw:
    """The smaller construction at one angle; where a point of it stands (m), to scale."""

    placed: Callable[[Reals], Complexes]

    def __call__(self, angle: Angle, mu_l: Number) -> Point:
        rows, mu = np.broadcast_arrays(angle, mu_l)
        spots = self.placed(rows.reshape(-1, 1)).reshape(rows.shape)
        return Point(spots / mu)


def drawn_once_more(placed: Callable[[Reals], Complexes], sentence: str) -> Operation:
    """Return the operation that draws a smaller construction once more and marks a point of it.

    ``placed`` runs it at a row of angles (degrees) and returns where the point stands (m); ``sentence`` names
    the angle as {angle}, the point as {it}.
    """
    return Operation(
        "redraw",
        _Redraw(placed),
        (Angle, Number),
        ("angle", "mu_l"),
        Point,
        (),
        sentence,
        fails=said("the mechanism cannot be drawn at that angle"),
        symbol="nP1 + nP2 + nM1 + nR1 + nM3",
    )
