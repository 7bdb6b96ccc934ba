"""How the places of a view and the lines through them hang together: least squares over displacements.

Each place has an unknown displacement, small, and like those of the places that it was drawn from; each line
of pencil chosen says how far the places on it are aside.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.expected import ExpectedLine, View
from graphic_tmm.checking.pencil.lines import BAND, Track

MORE = 1.4
"""A hand may err so many times as far as that of the student, who is the usual one."""
OWN, WHOLE = 0.4, 0.7
"""And each place for itself, and a plan as a whole, after it was laid over its pencil, mm."""
STILL = 0.05
"""What a hand does not move, a pole or a pivot, stands where its plan stands as a whole, mm."""
TURNED = 1.5
"""A line is turned from its due by some degrees (one standard deviation)."""
WORTH = 16.0
"""What full cover is worth against the squares of displacements: chosen by eye."""
NONE = 0.4
"""A line with less cover than this is better taken for not drawn."""
GRAIN = 0.2
"""A track is known no better than that, mm."""
SAME = 0.5
"""Two lines have chosen one line of pencil if they are nearer at both its ends, mm."""


class Pin(NamedTuple):
    """A place that was seen: its displacement, mm, and how far that may be off."""

    moved: complex
    error: float


class Web:
    """The least squares of a view: what neighbours and lines tell of the displacements of its places."""

    def __init__(self, view: View, pins: Mapping[int, Pin]) -> None:
        self.view = view
        spots = np.array([place.at for place in view.places])
        self.shares = [line.shares(spots) for line in view.lines]
        self.base = _told_by(view.astray)
        self.pinned = np.zeros(len(self.base))
        for k, pin in pins.items():
            for part, much in enumerate((pin.moved.real, pin.moved.imag)):
                self.base[2 * k + part, 2 * k + part] += pin.error**-2
                self.pinned[2 * k + part] = pin.error**-2 * much
        count = range(len(view.lines))
        self.rivals = [[k for k in count if _rival(one, view.lines[k])] for one in view.lines]

    def solved(self, chosen: Sequence[Track | None]) -> Solved:
        """Return the displacements that the lines chosen tell, and their scatter."""
        normal, right = self.base.copy(), self.pinned.copy()
        for k, track in enumerate(chosen):
            if track is not None:
                at, rows = self._rows(k)
                weight = _weight(track)
                normal[np.ix_(at, at)] += weight * rows.T @ rows
                right[at] += weight * rows.T @ np.asarray(track.offset(self.shares[k]))
        scatter = np.asarray(np.linalg.inv(normal), dtype=np.float64)
        return Solved(scatter @ right, scatter)

    def without(self, k: int, told: Solved, track: Track | None) -> tuple[Reals, Reals]:
        """Return how far a line's places are aside by all other lines, (places,), and how that scatters."""
        at, rows = self._rows(k)
        due = rows @ told.moved[at]
        spread = rows @ told.scatter[np.ix_(at, at)] @ rows.T
        if track is None:
            return due, spread
        weight = _weight(track)
        due = due - weight * spread @ np.asarray(track.offset(self.shares[k]))
        gain = spread @ np.linalg.inv(np.eye(len(due)) / weight - spread)
        return due + gain @ due, spread + gain @ spread

    def worth(
        self, k: int, found: Sequence[Track], told: Solved, chosen: Track | None
    ) -> list[float]:
        """Return what each track found of a line is worth beside all other lines; ``chosen``: its own now."""
        due, spread = self.without(k, told, chosen)
        turned = np.radians(TURNED) * self.view.lines[k].length + 0.3
        inverse = np.linalg.inv(spread + GRAIN**2 * np.eye(len(due)))
        worth = []
        for track in found:
            off = np.asarray(track.offset(self.shares[k])) - due
            chi = off @ inverse @ off / max(len(off) / 2, 1)
            chi += ((track.end - track.start) / turned) ** 2
            worth.append(float(WORTH * (track.covered - NONE) - 0.5 * chi))
        return worth

    def holders(
        self, k: int, found: Sequence[Track], chosen: Sequence[Track | None]
    ) -> list[list[int]]:
        """Return by track the other lines, that should be elsewhere, that have chosen the same pencil."""
        mine = np.array([_ends(self.view.lines[k], track) for track in found])
        by: list[list[int]] = [[] for _ in found]
        for rival in self.rivals[k]:
            track = chosen[rival]
            if track is None:
                continue
            a, b = _ends(self.view.lines[rival], track)
            own = (mine - a) / (b - a) * abs(b - a)
            low, high = own.real.min(axis=1), own.real.max(axis=1)
            over = np.minimum(high, abs(b - a)) - np.maximum(low, 0.0)
            for n in np.flatnonzero(
                (abs(own.imag).max(axis=1) < SAME) & (over > 0.5 * (high - low))
            ):
                by[n].append(rival)
        return by

    def _rows(self, k: int) -> tuple[list[int], Reals]:
        """Return which displacements move a line's places aside, and by how much each, (places, 2 · places)."""
        line = self.view.lines[k]
        left = 1j * line.way
        made = np.zeros((len(line.places), 2 * len(line.places)))
        for n in range(len(line.places)):
            made[n, 2 * n : 2 * n + 2] = left.real, left.imag
        return [2 * place + part for place in line.places for part in (0, 1)], made


def _told_by(astray: Complexes) -> Reals:
    """Return what drawings of a hand tell of displacements at first: the inverse of their scatter.

    ``astray``: (drawings, places). Another hand errs more, each place for itself; the plan as a whole is aside.
    """
    parts = np.stack([astray.real, astray.imag], axis=-1).reshape(len(astray), -1)
    own = np.where(parts.any(axis=0), OWN, STILL)
    scatter = MORE**2 * parts.T @ parts / len(parts) + np.diag(own**2)
    for part in (0, 1):
        scatter[part::2, part::2] += WHOLE**2
    return np.asarray(np.linalg.inv(scatter), dtype=np.float64)


class Solved(NamedTuple):
    """Displacements, x and y of all places, and their scatter."""

    moved: Reals
    scatter: Reals

    @property
    def places(self) -> Complexes:
        """The displacements as complex numbers, mm."""
        return np.asarray(self.moved[::2] + 1j * self.moved[1::2], dtype=np.complex128)


def _weight(track: Track) -> float:
    return max(track.error, 0.08) ** -2


def _rival(line: ExpectedLine, other: ExpectedLine) -> bool:
    """Whether one line of pencil may be taken for either of two lines that should be apart."""
    if line is other or abs((other.way / line.way).imag) > 0.25:
        return False
    own = (np.array([line.start, line.end]) - other.start) / other.way
    near = abs(own.imag).min() < 2 * BAND and own.real.max() > 0 and own.real.min() < other.length
    return bool(near and abs(own.imag).max() > 2 * SAME)


def _ends(line: ExpectedLine, track: Track) -> tuple[complex, complex]:
    left = 1j * line.way
    return line.start + left * track.start, line.end + left * track.end
