"""Which line of pencil is which of a view: one choice for all lines, so that they meet where points can be.

A student's points are off by millimetres, but neighbours together: a line that was drawn from a point begins
where that point was found. Each place of a view has an unknown displacement, small, and like those of the
places that it was drawn from; each line of pencil chosen says how far the places on it are aside. The
choice and the displacements are found in turn.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.doubting import Doubt, doubts
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.web import Pin, Solved, Web

ROUNDS = 3
MARGINS = (8.0, 5.0, 3.0, 1.5, 0.0)
"""A line is chosen, round by round, if it is worth so much more than any other one."""
TAKEN = 6.0
"""What a track loses that another line has chosen."""


NOTHING: Mapping[int, Pin] = MappingProxyType({})


class Fit(NamedTuple):
    """The track of each line (None: not seen), and the displacement of each place, mm.

    ``doubt``: by line how far aside of it, mm, at its two ends, the next best choice is; NaN where it is clear.
    ``far``: that of choices that are right more seldom.
    ``scatter``: of the displacements, x and y of all places, as neighbours and lines leave it.
    """

    tracks: tuple[Track | None, ...]
    moved: Complexes
    scatter: Reals
    doubt: tuple[Doubt | None, ...] = ()
    far: tuple[Doubt | None, ...] = ()

    def spread(self, k: int, way: complex) -> float:
        """Return how far a place may be from where all together have it, in a direction, mm (one deviation)."""
        own = self.scatter[2 * k : 2 * k + 2, 2 * k : 2 * k + 2]
        to = np.array([way.real, way.imag])
        return float(np.sqrt(to @ own @ to))


class Choice(NamedTuple):
    """The best of a line's tracks (None: none is worth it), and by how much."""

    track: Track | None
    margin: float


def fit(view: View, found: Sequence[Sequence[Track]], pins: Mapping[int, Pin] = NOTHING) -> Fit:
    """Return which tracks belong together; ``found``: by line; ``pins``: places that are known already.

    Clear lines first: what they tell of the places makes others clear. Then each again beside all others.
    """
    web = Web(view, pins)
    chosen: list[Track | None] = [None] * len(view.lines)
    waiting = {k for k in range(len(chosen)) if found[k]}
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
            chosen[k] = _chosen(web, k, found[k], told, before).track
        _once(web, chosen)
        if chosen == before:
            break
    told = web.solved(chosen)
    return Fit(tuple(chosen), told.places, told.scatter, *doubts(web, found, told, chosen))


def _chosen(
    web: Web, k: int, found: Sequence[Track], told: Solved, chosen: Sequence[Track | None]
) -> Choice:
    """Return the track that is most covered and nearest to where the other lines have its places."""
    if not found:
        return Choice(None, 0.0)
    free = web.worth(k, found, told, chosen[k])
    taken = [bool(by) for by in web.holders(k, found, chosen)]
    worth = [one - TAKEN * there for one, there in zip(free, taken, strict=True)]
    best = int(np.argmax(worth))
    if worth[best] <= 0:
        return Choice(None, -float(worth[best]))
    others = [n for n in range(len(worth)) if n != best]
    margin = worth[best] - max((worth[n] for n in others), default=0.0)
    return Choice(found[best], float(min(margin, worth[best])))


def _once(web: Web, chosen: list[Track | None]) -> None:
    """Let a line of pencil belong to one line only: to the longer one, if they are two where they should be."""
    order = sorted(range(len(chosen)), key=lambda k: -web.view.lines[k].length)
    kept: list[Track | None] = [None] * len(chosen)
    for k in order:
        one = chosen[k]
        if one is not None and not web.holders(k, [one], kept)[0]:
            kept[k] = one
    chosen[:] = kept
