"""Which line of pencil is which of a view: one choice for all lines, so that they meet where points can be.

A student's points are off by millimetres, but neighbours together: a line that was drawn from a point begins where
that point was found. Each place of a view has an unknown displacement, small, and like those of the places that
lines join it with; each line of pencil chosen says how far the places on it are aside. The choice and the
displacements are found in turn, ever more narrowly.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.expected import Line, View
from graphic_tmm.checking.pencil.lines import Track

FAR = 3.0
"""The displacement of a place, mm (one standard deviation), before anything is seen of it."""
BESIDE = 1.2
"""And against a place that a line joins it with."""
NARROWER = (3.0, 2.0, 1.3, 0.9, 0.7, 0.7)
"""How far a line may be from the places found so far, mm: round by round."""
WORTH = 14.0
"""What full cover is worth against squares of that: chosen by eye."""
NONE = 0.35
"""A line with less cover than this, beside its displacement, is better taken for not drawn."""
SAME = 0.5
"""Two lines have chosen one line of pencil if they are nearer at both its ends, mm."""


class Fit(NamedTuple):
    """The track of each line (None: not seen), and the displacement of each place, mm."""

    tracks: tuple[Track | None, ...]
    moved: Complexes


def fit(view: View, found: Sequence[Sequence[Track]]) -> Fit:
    """Return which tracks belong together; ``found``: by line."""
    spots = np.array([place.at for place in view.places])
    shares = [_shares(line, spots) for line in view.lines]
    moved = np.zeros(len(spots), dtype=np.complex128)
    chosen: list[Track | None] = [None] * len(view.lines)
    for reach in NARROWER:
        for k, line in enumerate(view.lines):
            chosen[k] = _chosen(line, shares[k], found[k], moved, reach)
        _once(view, chosen)
        moved = displaced(view, shares, chosen, BESIDE)
    return Fit(tuple(chosen), moved)


def _shares(line: Line, spots: Complexes) -> Reals:
    """Return where on a line its places are, as shares of its length."""
    own: Reals = (((spots[list(line.places)] - line.start) / line.way).real / line.length).astype(
        np.float64
    )
    return own


def _chosen(
    line: Line, shares: Reals, found: Sequence[Track], moved: Complexes, reach: float
) -> Track | None:
    """Return the track that is most covered and nearest to where its places are; None if none is."""
    if not found:
        return None
    aside = (moved[list(line.places)] / (1j * line.way)).real
    worth = []
    for track in found:
        off = (track.aside(shares) - aside) / reach
        worth.append(WORTH * (track.covered - NONE) - 0.5 * float(np.mean(off**2)))
    best = int(np.argmax(worth))
    return found[best] if worth[best] > 0 else None


def _once(view: View, chosen: list[Track | None]) -> None:
    """Let a line of pencil belong to one line only: to the longer one, if they are two where they should be."""
    ends = np.full((len(chosen), 2), np.nan, dtype=np.complex128)
    for k, track in enumerate(chosen):
        if track is not None:
            line = view.lines[k]
            ends[k] = (
                line.start + 1j * line.way * track.start,
                line.end + 1j * line.way * track.end,
            )
    order = sorted(range(len(chosen)), key=lambda k: -view.lines[k].length)
    for n, k in enumerate(order):
        if chosen[k] is None:
            continue
        a, b = ends[k]
        for other in order[n + 1 :]:
            if chosen[other] is None:
                continue
            own = (ends[other] - a) / (b - a) * abs(b - a)
            if max(abs(own.imag)) < SAME and _overlap(own, abs(b - a)):
                due = view.lines[k]
                was = np.array([view.lines[other].start, view.lines[other].end])
                apart = abs(((was - due.start) / due.way).imag).max()
                if apart > 2 * SAME:
                    chosen[other] = None


def _overlap(own: Complexes, length: float) -> bool:
    low, high = min(own.real), max(own.real)
    return bool(min(high, length) - max(low, 0.0) > 0.5 * (high - low))


def displaced(
    view: View, shares: Sequence[Reals], chosen: Sequence[Track | None], beside: float
) -> Complexes:
    """Return the displacements that the lines chosen tell, with the least squares."""
    count = len(view.places)
    normal = np.eye(2 * count) / FAR**2
    right = np.zeros(2 * count)
    for k, line in enumerate(view.lines):
        on = list(line.places)
        for a, b in zip(on, on[1:], strict=False):
            for part in (0, 1):
                i, j = 2 * a + part, 2 * b + part
                weight = 1 / beside**2
                normal[i, i] += weight
                normal[j, j] += weight
                normal[i, j] -= weight
                normal[j, i] -= weight
        track = chosen[k]
        if track is None:
            continue
        left = 1j * line.way
        row = np.array([left.real, left.imag])
        for place, share in zip(on, shares[k], strict=True):
            weight = 1 / max(track.error, 0.1) ** 2
            block = slice(2 * place, 2 * place + 2)
            normal[block, block] += weight * np.outer(row, row)
            right[block] += weight * row * track.aside(share)
    found = np.linalg.solve(normal, right)
    return found[::2] + 1j * found[1::2]
