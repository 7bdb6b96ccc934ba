"""Pencil lines near an expected one: tracks on which there is pencil nearly all along, then the axis of one.

A track is told by how far it is aside of the expected line at its two ends. The pencil is summed along every
track of a band; its axis is then the centroid of the darkness across it, much finer than a dot.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.checking.pencil.darkness import Flat, Greys
from graphic_tmm.checking.pencil.expected import Line

BAND = 5.0
"""Pencil is sought as far aside of the expected line, mm: of a student's points nine in ten are nearer."""
TURN = np.tan(np.radians(6.0))
"""And turned from it as far."""
ASIDE = 0.25
"""Tracks lie as far from each other, mm: a dot of the usual picture, half a thin line of pencil."""
STATIONS = (12, 90)
"""Places of a track at which pencil is looked for: at least and at most; about one a millimetre."""
COVERED = 0.35
"""A track with less pencil is no line, as a share: a dashed line has a half and more; lettering has a fifth."""
MANY = 10
"""So many tracks are kept of a line, the best."""
APART, ONE = 0.8, 0.75
"""Tracks are one line of pencil if neither end is farther from the other's, mm: as they are found, as axes."""
WINDOW = 0.6
"""From the axis of a line to where its darkness ends, mm: half a thick line, and the camera's blur."""
FLOOR = 0.03
"""A ruled line of pencil is no straighter, mm: keeps the weights defined."""


class Track(NamedTuple):
    """A line of pencil by an expected one: how far aside (to the left) at its start and its end, mm.

    ``covered``: 0 ... 1. ``error``: how far its axis may be off at either end, mm (one standard deviation).
    """

    start: float
    end: float
    covered: float
    error: float = 0.3

    def aside(self, share: float | Reals) -> float | Reals:
        """Return how far it is aside at a share (0 ... 1, or beyond) of the line, mm."""
        return self.start + (self.end - self.start) * share


def tracks(flat: Flat, line: Line, shift: complex, band: float = BAND) -> tuple[Track, ...]:
    """Return the lines of pencil near a line that is moved by ``shift``, mm, the most covered first.

    ``band``: how far aside it is sought, mm.
    """
    count = int(np.clip(line.length, *STATIONS))
    share = (np.arange(count) + 0.5) / count
    turn = max(round(TURN * line.length / 2 / ASIDE), 1)
    half = round(band / ASIDE)
    aside = ASIDE * np.arange(-half - turn, half + turn + 1)
    axis = line.start + shift + line.way * line.length * share
    pencil = flat.pencil(axis[:, None] + 1j * line.way * aside)
    sums = _summed(pencil, share, turn, half)
    found = list[Track]()
    for one in _best(sums, turn, half):
        track = refined(flat, line, shift, one)
        if all(max(abs(track.start - t.start), abs(track.end - t.end)) > ONE for t in found):
            found.append(track)
    return tuple(found)


def _summed(pencil: Greys, share: Reals, turn: int, half: int) -> Greys:
    """Return the mean pencil of tracks (turns, asides), turned about their middle."""
    rows = np.arange(len(share))
    sums = np.empty((2 * turn + 1, 2 * half + 1), dtype=np.float32)
    columns = np.arange(2 * half + 1) + turn
    for k in range(-turn, turn + 1):
        steps = np.rint(k * (2 * share - 1)).astype(np.intp)
        sums[k + turn] = pencil[rows[:, None], columns + steps[:, None]].mean(axis=0)
    return sums


def _best(sums: Greys, turn: int, half: int) -> list[Track]:
    found = list[Track]()
    for k in np.argsort(-sums, axis=None)[:4000]:
        i, j = divmod(int(k), sums.shape[1])
        if sums[i, j] < COVERED or len(found) == MANY:
            break
        start, end = ASIDE * (j - half - (i - turn)), ASIDE * (j - half + (i - turn))
        if all(max(abs(start - t.start), abs(end - t.end)) > APART for t in found):
            found.append(Track(start, end, float(sums[i, j])))
    return found


def refined(flat: Flat, line: Line, shift: complex, track: Track) -> Track:
    """Return the axis of a line of pencil, by centroids of darkness; as it was if too little is seen."""
    count = int(np.clip(line.length * 1.5, 16, 120))
    share = (np.arange(count) + 0.5) / count
    axis = line.start + shift + line.way * line.length * share
    window = np.linspace(-WINDOW, WINDOW, 9)
    start, end, error, seen = track.start, track.end, track.error, np.zeros(count, dtype=bool)
    for _ in range(3):
        centre = start + (end - start) * share
        dark = flat.darkness(axis[:, None] + 1j * line.way * (centre[:, None] + window))
        whole = dark.sum(axis=1)
        seen = dark[:, 2:-2].max(axis=1) > flat.level
        if seen.sum() < 6:
            return track
        off = centre + (dark * window).sum(axis=1) / np.where(whole > 0, whole, 1.0)
        start, end, error = _straight(share, off, seen, line.length)
    return Track(start, end, float(seen.mean()), error)


def _straight(share: Reals, off: Reals, seen: Reals, length: float) -> tuple[float, float, float]:
    """Return the straight line through most of the places seen: its ends, and their error.

    Neighbouring places err alike, as pencil does; of 3 mm one counts.
    """
    weights = seen.astype(np.float64)
    slope, base = 0.0, 0.0
    scatter, half = FLOOR, int(seen.sum()) // 2
    for _ in range(4):
        whole = weights.sum()
        if whole < 1e-9:
            break
        middle = (weights * share).sum() / whole
        mean = (weights * off).sum() / whole
        spread = (weights * (share - middle) ** 2).sum()
        slope = (weights * (share - middle) * (off - mean)).sum() / max(spread, 1e-9)
        base = mean - slope * middle
        rest = abs(off - base - slope * share)
        scatter = 1.4826 * float(np.partition(rest[seen], half)[half]) + FLOOR
        weights = seen * np.maximum(1 - (rest / (4.7 * scatter)) ** 2, 0.0) ** 2
    independent = max(length / 3.0 * float((weights > 0).mean()), 1.0)
    return base, base + slope, 2.0 * scatter / np.sqrt(independent)
