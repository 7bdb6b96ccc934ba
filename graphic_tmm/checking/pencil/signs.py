"""What stands at a point: lines that end or cross, a head, a ring; and how alike pencil is to it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.darkness import Flat

REACH = 6.0
"""What is farther from the point is no part of its sign, mm."""
BEYOND = 2.0
"""Nor are pieces looked at that end so far before, mm."""
AT_ONCE = 64
"""So many pieces are measured at once: memory."""
STEP = 0.25
"""Ink is looked at so densely, mm."""
BESIDE = 0.7
"""Paper is looked at no nearer to any ink, mm."""
GRID = 0.3
"""And so densely, mm."""
HALF = 0.35
"""Half the width of pencil, mm."""
LEAST = 3
"""So many places of ink, and of paper, tell where a sign is."""
MOST = 900
"""So many places of either are looked at, at most."""


class Sign(NamedTuple):
    """Places about a point (complex, mm) where its ink is, where there is none; its straight pieces."""

    ink: Complexes
    paper: Complexes
    pieces: Complexes

    @classmethod
    def made(cls, pieces: Complexes, others: Complexes) -> Sign:
        """Return the sign of straight ``pieces`` (pieces, 2) about 0; ``others``: what may be ink beside it."""
        pieces, others = _about(pieces), _about(others)
        ink = [a + (b - a) * np.linspace(0, 1, max(int(abs(b - a) / STEP), 2)) for a, b in pieces]
        inked = np.concatenate(ink) if ink else np.empty(0, dtype=np.complex128)
        inked = inked[abs(inked) < REACH]
        axis = np.arange(-REACH, REACH + 1e-9, GRID)
        paper = (axis[:, None] + 1j * axis).ravel()
        paper = paper[abs(paper) < REACH]
        for some in (pieces, others):
            if len(some):
                paper = paper[_distance(paper, some) > BESIDE]
        return cls(_some(inked), _some(paper), pieces)

    def along(self, way: complex, apart: float) -> Sign | None:
        """Return what of it tells where it is along a direction: what is not alike a little before or behind.

        None where too little does: a line only passes there.
        """
        if not len(self.ink) or not len(self.paper):
            return None
        ink = np.zeros(len(self.ink), dtype=bool)
        paper = np.zeros(len(self.paper), dtype=bool)
        for move in (-apart * way, apart * way):
            ink |= _distance(self.ink + move, self.pieces) > HALF
            paper |= _distance(self.paper + move, self.pieces) < HALF
        if min(ink.sum(), paper.sum()) < LEAST:
            return None
        return Sign(self.ink[ink], self.paper[paper], self.pieces)

    def like(self, flat: Flat, at: Complexes) -> Reals:
        """Return how much more pencil there is on its ink than beside it at places of the sheet, −1 ... 1."""
        if not len(self.ink):
            return np.zeros(len(at))
        on = flat.pencil(at[:, None] + self.ink).mean(axis=1)
        off = flat.pencil(at[:, None] + self.paper).mean(axis=1) if len(self.paper) else 0.0
        found: Reals = (on - off).astype(np.float64)
        return found


def _about(pieces: Complexes) -> Complexes:
    """Return the pieces that come near 0: what is farther tells nothing of a sign."""
    if not len(pieces):
        return pieces
    near = _apart(np.zeros(1, dtype=np.complex128), pieces)[0] < REACH + BEYOND
    return np.asarray(pieces[near], dtype=np.complex128)


def _distance(spots: Complexes, pieces: Complexes) -> Reals:
    """Return how far places are from the nearest of straight pieces, mm."""
    found = np.full(len(spots), np.inf)
    for first in range(0, len(pieces), AT_ONCE):
        some = _apart(spots, pieces[first : first + AT_ONCE])
        np.minimum(found, some.min(axis=1), out=found)
    return found


def _apart(spots: Complexes, pieces: Complexes) -> Reals:
    """Return how far places are from straight pieces, (places, pieces), mm."""
    a, b = pieces[:, 0], pieces[:, 1]
    along = np.clip(((spots[:, None] - a) / (b - a + 1e-12)).real, 0, 1)
    off: Complexes = a + along * (b - a) - spots[:, None]
    return np.asarray(np.abs(off), dtype=np.float64)


def _some(spots: Complexes) -> Complexes:
    step = -(-len(spots) // MOST)
    return spots[:: max(step, 1)]
