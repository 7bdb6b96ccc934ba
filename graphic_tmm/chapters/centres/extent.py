"""What part of the scheme of centres is drawn: the mechanism, and the centres that lie near to it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.centres.plan import Centres

NEAR = 0.75
"""Centres are drawn that lie off the mechanism by less than this share of its size; to others arrows lead."""


class Room(NamedTuple):
    """A rectangle, mm or m: its lower left and its upper right corner."""

    low: complex
    high: complex

    def grown(self, by: float) -> Room:
        """Return it wider to all sides."""
        return Room(self.low - complex(by, by), self.high + complex(by, by))

    def holds(self, spot: complex) -> bool:
        """Whether a place lies in it."""
        off, back = spot - self.low, self.high - spot
        return min(off.real, off.imag, back.real, back.imag) >= 0.0

    @property
    def size(self) -> complex:
        """Its width and its height."""
        return self.high - self.low

    def part(self, at: complex, way: complex) -> tuple[float, float] | None:
        """Return between which distances along a line it lies inside; None where it does not."""
        first, last = -np.inf, np.inf
        for start, step, low, high in (
            (at.real, way.real, self.low.real, self.high.real),
            (at.imag, way.imag, self.low.imag, self.high.imag),
        ):
            if abs(step) < 1e-12:
                if not low <= start <= high:
                    return None
                continue
            ends = sorted(((low - start) / step, (high - start) / step))
            first, last = max(first, ends[0]), min(last, ends[1])
        return (float(first), float(last)) if first < last else None


def _about(spots: Sequence[complex] | NDArray[np.complex128]) -> Room:
    points = np.asarray(spots)
    points = points[np.isfinite(points)]
    return Room(
        complex(points.real.min(), points.imag.min()), complex(points.real.max(), points.imag.max())
    )


def room(links: Sequence[complex], centres: Sequence[complex]) -> Room | None:
    """Return what part is drawn; None where the mechanism is not there."""
    there = [spot for spot in links if np.isfinite(spot)]
    if not there:
        return None
    own = _about(there)
    near = own.grown(NEAR * max(own.size.real, own.size.imag))
    return _about([*there, *(spot for spot in centres if np.isfinite(spot) and near.holds(spot))])


def spots(made: Centres, reading: Reading, place: int) -> tuple[list[complex], list[complex]]:
    """Return the points of the mechanism in a position, and the centres that are not at infinity."""

    def at(mark: Mark) -> complex:
        value: Reals = reading[mark][0]
        return complex(value[place if value.size > 1 else 0])

    return [*map(at, made.points.values())], [at(one.mark) for one in made.centres if not one.far]
