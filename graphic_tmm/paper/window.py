"""What of the plane a drawing shows: a rectangle, the parts of lines and of curves that are inside."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes
from graphic_tmm.paper.clipping import cut, points

SAMPLES, HALVINGS = 24, 40
"""Places of an arc at which it is looked whether it is inside; how often its ends are halved then."""


class Window(NamedTuple):
    """A rectangle, by its lower left and its upper right corner (complex), mm or m."""

    low: complex
    high: complex

    @property
    def reach(self) -> float:
        """Its longer side."""
        across = self.high - self.low
        return max(across.real, across.imag)

    def grown(self, by: float) -> Window:
        """Return it with so much more on every side."""
        return Window(self.low - by * (1 + 1j), self.high + by * (1 + 1j))

    def holds(self, spots: Complexes | complex) -> np.ndarray:
        """Return which places are inside."""
        z = np.asarray(spots, dtype=np.complex128)
        x, y = z.real, z.imag
        across = (x >= self.low.real) & (x <= self.high.real)
        return np.asarray(across & (y >= self.low.imag) & (y <= self.high.imag))

    def span(self, at: complex, way: complex) -> tuple[float, float] | None:
        """Return between which distances along a line it is inside, in lengths of its ``way``."""
        corners = np.array([self.low, self.high]) - at
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = np.sort([corners.real / way.real, corners.imag / way.imag], axis=1)
        first, last = float(np.fmax(*ends[:, 0])), float(np.fmin(*ends[:, 1]))
        return (first, last) if first < last else None

    def segment(self, start: complex, end: complex) -> tuple[complex, complex] | None:
        """Return the part of a straight line that is inside, None where none is."""
        way = end - start
        low, high = self.span(start, way) or (1.0, 0.0)
        low, high = max(low, 0.0), min(high, 1.0)
        return (start + low * way, start + high * way) if low < high else None

    def parts(self, controls: Sequence[complex]) -> list[tuple[complex, ...]]:
        """Return the parts of a chain of cubic arcs that are inside."""
        arcs = len(controls) // 3
        count = SAMPLES * arcs + 1
        inside = self.holds(points(controls, count))
        places = np.linspace(0.0, arcs, count)
        ends = [0.0] if inside[0] else []
        for k in np.flatnonzero(inside[1:] != inside[:-1]):
            ends.append(self._crossing(controls, places[k], places[k + 1], bool(inside[k])))
        ends += [float(arcs)] if inside[-1] else []
        pairs = zip(ends[::2], ends[1::2], strict=True)
        return [cut(controls, a, b) for a, b in pairs if b > a]

    def _crossing(
        self, controls: Sequence[complex], low: float, high: float, inside: bool
    ) -> float:
        for _ in range(HALVINGS):
            middle = (low + high) / 2.0
            spot = np.asarray(cut(controls, middle, high)[:1])
            low, high = (middle, high) if self.holds(spot)[0] == inside else (low, middle)
        return low if inside else high


def about(spots: Complexes | Sequence[complex]) -> Window:
    """Return the window that just holds some places."""
    z = np.asarray(spots, dtype=np.complex128)
    x, y = z.real, z.imag
    return Window(complex(x.min(), y.min()), complex(x.max(), y.max()))
