"""Pencil lines near an expected one: tracks on which there is pencil nearly all along, then the axis of one.

A track is told by how far it is aside of the expected line at its two ends. The pencil is summed along every
track of a band; its axis is then the centroid of the darkness across it, much finer than a dot.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.checking.pencil.darkness import Flat, Greys
from graphic_tmm.checking.pencil.expected import ExpectedLine

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

    def offset(self, share: float | Reals) -> float | Reals:
        """Return how far it is aside at a share (0 ... 1, or beyond) of the line, mm."""
        return self.start + (self.end - self.start) * share

    def is_another(self, apart: float, *others: Track) -> bool:
        """Whether one of its ends is farther than ``apart``, mm, from those of each of others."""
        ends = ((abs(self.start - one.start), abs(self.end - one.end)) for one in others)
        return all(max(off) > apart for off in ends)


def tracks(flat: Flat, line: ExpectedLine, shift: complex, band: float = BAND) -> tuple[Track, ...]:
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
    for track in refined(flat, line, shift, _best(sums, turn, half)):
        if track.is_another(ONE, *found):
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
        track = Track(start, end, float(sums[i, j]))
        if track.is_another(APART, *found):
            found.append(track)
    return found


def refined(
    flat: Flat, line: ExpectedLine, shift: complex, some: Sequence[Track]
) -> Iterator[Track]:
    """Yield the axes of lines of pencil, by centroids of darkness; as one was if too little of it is seen."""
    count = int(np.clip(line.length * 1.5, 16, 120))
    share = (np.arange(count) + 0.5) / count
    axis = line.start + shift + line.way * line.length * share
    window = np.linspace(-WINDOW, WINDOW, 9)
    ends = np.array([(one.start, one.end) for one in some]).reshape(-1, 2, 1)
    known = np.ones(len(some), dtype=bool)
    for _ in range(3):
        centre = ends[:, 0] + (ends[:, 1] - ends[:, 0]) * share
        dark = flat.darkness(axis[:, None] + 1j * line.way * (centre[..., None] + window))
        whole = dark.sum(axis=-1)
        seen = dark[..., 2:-2].max(axis=-1) > flat.level
        known &= seen.sum(axis=-1) >= 6
        off = centre + (dark * window).sum(axis=-1) / np.where(whole > 0, whole, 1.0)
        ends, error = _straight(share, off, seen, line.length)
    for k, one in enumerate(some):
        start, end = ends[k, :, 0].tolist()
        yield Track(start, end, float(seen[k].mean()), float(error[k])) if known[k] else one


def _straight(
    share: Reals, off: Reals, seen: NDArray[np.bool_], length: float
) -> tuple[Reals, Reals]:
    """Return the straight lines through most of the places seen of each, (lines, 2, 1), and their errors.

    ``off``, ``seen``: (lines, places). Neighbouring places err alike, as pencil does; of 3 mm one counts.
    """
    weights = seen.astype(np.float64)
    slope = np.zeros((len(off), 1))
    base, scatter, half = slope, slope + FLOOR, seen.sum(axis=1, keepdims=True) // 2
    for _ in range(4):
        whole = weights.sum(axis=1, keepdims=True)
        live = whole >= 1e-9
        whole = np.where(live, whole, 1.0)
        middle = (weights * share).sum(axis=1, keepdims=True) / whole
        mean = (weights * off).sum(axis=1, keepdims=True) / whole
        spread = (weights * (share - middle) ** 2).sum(axis=1, keepdims=True)
        turned = (weights * (share - middle) * (off - mean)).sum(axis=1, keepdims=True)
        slope = np.where(live, turned / np.maximum(spread, 1e-9), slope)
        base = np.where(live, mean - slope * middle, base)
        rest = abs(off - base - slope * share)
        ranked = np.sort(np.where(seen, rest, np.inf), axis=1)
        usual = 1.4826 * np.take_along_axis(ranked, half, axis=1) + FLOOR
        scatter = np.where(live, usual, scatter)
        less = seen * np.maximum(1 - (rest / (4.7 * scatter)) ** 2, 0.0) ** 2
        weights = np.where(live, less, weights)
    independent = np.maximum(length / 3.0 * (weights > 0).mean(axis=1), 1.0)
    return np.stack([base, base + slope], axis=1), 2.0 * scatter[:, 0] / np.sqrt(independent)
