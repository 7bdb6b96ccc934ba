"""What of the plane the drawing of centrodes shows: far centres are left outside, curves end at its edge."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes
from graphic_tmm.paper.clipping import cut, points

FAR = 0.8
"""How far from the mechanism a centre is still shown, of the mechanism's own reach."""
EDGE = 0.04
"""White about what is shown, of its reach."""
SAMPLES, HALVINGS = 24, 40
"""Places of an arc at which it is looked whether it is inside; how often its ends are halved then."""


class Window(NamedTuple):
    """A rectangle, by its lower left and its upper right corner (complex)."""

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

    def holds(self, spots: Complexes) -> np.ndarray:
        """Return which places are inside."""
        x, y = np.real(spots), np.imag(spots)
        across = (x >= self.low.real) & (x <= self.high.real)
        return np.asarray(across & (y >= self.low.imag) & (y <= self.high.imag))

    def segment(self, start: complex, end: complex) -> tuple[complex, complex] | None:
        """Return the part of a straight line that is inside, None where none is."""
        way, low, high = end - start, 0.0, 1.0
        sides = (
            (way.real, start.real, self.low.real, self.high.real),
            (way.imag, start.imag, self.low.imag, self.high.imag),
        )
        for rate, at, least, most in sides:
            if abs(rate) * 1e12 <= abs(way):
                if not least <= at <= most:
                    return None
                continue
            first, last = sorted(((least - at) / rate, (most - at) / rate))
            low, high = max(low, first), min(high, last)
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


def _about(spots: Complexes) -> Window:
    x, y = spots.real, spots.imag
    return Window(complex(x.min(), y.min()), complex(x.max(), y.max()))


def window(mechanism: Iterable[Complexes], centres: Iterable[Complexes]) -> Window:
    """Return what is seen: the ``mechanism`` as both centrodes touch, and ``centres`` that are not too far."""
    own, far = _flat(mechanism), _flat(centres)
    base = _about(own)
    near = base.grown(FAR * base.reach)
    x = np.clip(far.real, near.low.real, near.high.real)
    y = np.clip(far.imag, near.low.imag, near.high.imag)
    whole = _about(np.concatenate([own, x + 1j * y]))
    return whole.grown(EDGE * whole.reach)


def _flat(spots: Iterable[Complexes]) -> Complexes:
    found = np.concatenate([np.ravel(one) for one in spots])
    return np.asarray(found[np.isfinite(found)])
