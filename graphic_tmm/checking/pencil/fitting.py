"""Which line of pencil is which of a view: one choice for all lines, so that they meet where points can be.

A student's points are off by millimetres, but neighbours together: a line that was drawn from a point begins
where that point was found. Each place of a view has an unknown displacement, small, and like those of the
places that it was drawn from; each line of pencil chosen says how far the places on it are aside. The
choice and the displacements are found in turn.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.expected import Line, View
from graphic_tmm.checking.pencil.lines import BAND, Track

MORE = 1.4
"""A hand may err so many times as far as that of the student, who is the usual one."""
OWN, WHOLE = 0.4, 0.7
"""And each place for itself, and a plan as a whole, after it was laid over its pencil, mm."""
TURNED = 1.5
"""A line is turned from its due by some degrees (one standard deviation)."""
ROUNDS = 3
MARGINS = (8.0, 5.0, 3.0, 1.5, 0.0)
"""A line is chosen, round by round, if it is worth so much more than any other one."""
TAKEN = 6.0
"""What a track loses that another line has chosen."""
WORTH = 16.0
"""What full cover is worth against the squares of displacements: chosen by eye."""
NONE = 0.4
"""A line with less cover than this is better taken for not drawn."""
DOUBT = 3.0
"""Of two choices that differ less in worth either may be right."""
GRAIN = 0.2
"""A track is known no better than that, mm."""
SAME = 0.5
"""Two lines have chosen one line of pencil if they are nearer at both its ends, mm."""


class Fit(NamedTuple):
    """The track of each line (None: not seen), and the displacement of each place, mm.

    ``doubt``: by line how far aside of it, mm, at its two ends, the next best choice is; NaN where it is clear.
    """

    tracks: tuple[Track | None, ...]
    moved: Complexes
    doubt: tuple[tuple[float, float] | None, ...] = ()


class Web:
    """The least squares of a view: what neighbours and lines tell of the displacements of its places."""

    def __init__(self, view: View) -> None:
        self.view = view
        spots = np.array([place.at for place in view.places])
        self.shares = [line.shares(spots) for line in view.lines]
        self.base = _told_by(view.astray)
        count = range(len(view.lines))
        self.rivals = [[k for k in count if _rival(one, view.lines[k])] for one in view.lines]

    def solved(self, chosen: Sequence[Track | None]) -> Solved:
        """Return the displacements that the lines chosen tell, and their scatter."""
        normal, right = self.base.copy(), np.zeros(len(self.base))
        for k, track in enumerate(chosen):
            if track is not None:
                at, rows = self._rows(k)
                weight = _weight(track)
                normal[np.ix_(at, at)] += weight * rows.T @ rows
                right[at] += weight * rows.T @ np.asarray(track.aside(self.shares[k]))
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
        due = due - weight * spread @ np.asarray(track.aside(self.shares[k]))
        gain = spread @ np.linalg.inv(np.eye(len(due)) / weight - spread)
        return due + gain @ due, spread + gain @ spread

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
    scatter = MORE**2 * parts.T @ parts / len(parts) + OWN**2 * np.eye(parts.shape[1])
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


def _rival(line: Line, other: Line) -> bool:
    """Whether one line of pencil may be taken for either of two lines that should be apart."""
    if line is other or abs((other.way / line.way).imag) > 0.25:
        return False
    own = (np.array([line.start, line.end]) - other.start) / other.way
    near = abs(own.imag).min() < 2 * BAND and own.real.max() > 0 and own.real.min() < other.length
    return bool(near and abs(own.imag).max() > 2 * SAME)


class Choice(NamedTuple):
    """The best of a line's tracks (None: none is worth it), by how much, how far aside the next best is."""

    track: Track | None
    margin: float
    doubt: tuple[float, float] | None


def fit(view: View, found: Sequence[Sequence[Track]]) -> Fit:
    """Return which tracks belong together; ``found``: by line.

    Clear lines first: what they tell of the places makes others clear. Then each again beside all others.
    """
    web = Web(view)
    chosen: list[Track | None] = [None] * len(view.lines)
    waiting = {k for k in range(len(chosen)) if found[k]}
    doubt: list[tuple[float, float] | None] = [None] * len(chosen)
    for margin in MARGINS:
        told = web.solved(chosen)
        made = {k: _chosen(web, k, found[k], told, chosen) for k in waiting}
        for k in sorted(waiting, key=lambda k: -made[k].margin):
            if made[k].track is not None and made[k].margin > margin:
                chosen[k] = made[k].track
                waiting.discard(k)
        _once(web, chosen)
    for _ in range(ROUNDS):
        before = list(chosen)
        told = web.solved(chosen)
        for k in range(len(chosen)):
            chosen[k], _, doubt[k] = _chosen(web, k, found[k], told, before)
        _once(web, chosen)
        if chosen == before:
            break
    return Fit(tuple(chosen), web.solved(chosen).places, tuple(doubt))


def _chosen(
    web: Web, k: int, found: Sequence[Track], told: Solved, chosen: Sequence[Track | None]
) -> Choice:
    """Return the track that is most covered and nearest to where the other lines have its places."""
    if not found:
        return Choice(None, 0.0, None)
    due, spread = web.without(k, told, chosen[k])
    turned = np.radians(TURNED) * web.view.lines[k].length + 0.3
    inverse = np.linalg.inv(spread + GRAIN**2 * np.eye(len(due)))
    taken = _taken(web, k, found, chosen)
    free = []
    for track in found:
        off = np.asarray(track.aside(web.shares[k])) - due
        chi = off @ inverse @ off / max(len(off) / 2, 1)
        chi += ((track.end - track.start) / turned) ** 2
        free.append(WORTH * (track.covered - NONE) - 0.5 * chi)
    worth = [one - TAKEN * there for one, there in zip(free, taken, strict=True)]
    best = int(np.argmax(worth))
    if worth[best] <= 0:
        return Choice(None, -float(worth[best]), None)
    others = [n for n in range(len(worth)) if n != best]
    margin = worth[best] - max((worth[n] for n in others), default=0.0)
    one = found[best]
    aside = [
        (found[n].start - one.start, found[n].end - one.end)
        for n in others
        if free[n] > worth[best] - DOUBT
    ]
    doubt = max(aside, key=lambda ends: max(map(abs, ends)), default=None)
    return Choice(one, float(min(margin, worth[best])), doubt)


def _taken(web: Web, k: int, found: Sequence[Track], chosen: Sequence[Track | None]) -> list[bool]:
    """Return of tracks whether another line, that should be elsewhere, has chosen the same pencil."""
    line = web.view.lines[k]
    mine = np.array([_ends(line, track) for track in found])
    taken = np.zeros(len(found), dtype=bool)
    for rival in web.rivals[k]:
        track = chosen[rival]
        if track is None:
            continue
        a, b = _ends(web.view.lines[rival], track)
        own = (mine - a) / (b - a) * abs(b - a)
        low, high = own.real.min(axis=1), own.real.max(axis=1)
        over = np.minimum(high, abs(b - a)) - np.maximum(low, 0.0)
        taken |= (abs(own.imag).max(axis=1) < SAME) & (over > 0.5 * (high - low))
    return [bool(there) for there in taken]


def _ends(line: Line, track: Track) -> tuple[complex, complex]:
    left = 1j * line.way
    return line.start + left * track.start, line.end + left * track.end


def _once(web: Web, chosen: list[Track | None]) -> None:
    """Let a line of pencil belong to one line only: to the longer one, if they are two where they should be."""
    order = sorted(range(len(chosen)), key=lambda k: -web.view.lines[k].length)
    kept: list[Track | None] = [None] * len(chosen)
    for k in order:
        one = chosen[k]
        if one is not None and not _taken(web, k, [one], kept)[0]:
            kept[k] = one
    chosen[:] = kept
