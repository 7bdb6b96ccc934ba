"""Whether another line of pencil may be the right one: it may belong to a neighbour, which then needs another.

Of thirteen lines of a fan each lies near its neighbours' pencil; but if it were one of these, the neighbour
would have to be on another, and so on, until one is left without: such an exchange costs what all lose by it.
"""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.web import Solved, Web

DOUBT = 3.0
"""Of two choices that differ less in worth either may be right."""
FAR = 12.0
"""Where others may be as near, so much is to tell them apart."""
WHOLE = 0.6
"""Pencil that a line without any might be on is seen on so much of it at least."""
DEEP = 6
"""So many lines at most are exchanged at once."""

Doubt = tuple[float, float]


def doubts(
    web: Web, found: Sequence[Sequence[Track]], told: Solved, chosen: Sequence[Track | None]
) -> tuple[tuple[Doubt | None, ...], tuple[Doubt | None, ...]]:
    """Return by line how far aside, mm, at its two ends, the farthest is that may be right; None: none may.

    The second: that is right more seldom, but not never (`FAR`).
    """
    swaps = Swaps(web, found, told, chosen)
    left = robbed(web, found, chosen)
    count = range(len(chosen))
    near, far = ([swaps.doubt(k, most) for k in count] for most in (DOUBT, FAR))
    return tuple(left.get(k, near[k]) for k in count), tuple(left.get(k, far[k]) for k in count)


def robbed(
    web: Web, found: Sequence[Sequence[Track]], chosen: Sequence[Track | None]
) -> dict[int, Doubt]:
    """Return the lines that have the pencil of another, left without, and how far aside that should be, mm."""
    by: dict[int, Doubt] = {}
    if web.view.fan:  # of many lines some are always hidden
        return by
    for k, tracks in enumerate(found):
        if chosen[k] is not None:
            continue
        seen = [track for track in tracks if track.covered > WHOLE]
        for holders in web.holders(k, seen, chosen) if seen else ():
            for holder in holders:
                mine, other = web.view.lines[holder], web.view.lines[k]
                ends = sorted((other.start, other.end), key=lambda z: abs(z - mine.start))
                aside = [((z - mine.start) / mine.way).imag for z in ends]
                by[holder] = max(by.get(holder, (0.0, 0.0)), (aside[0], aside[1]), key=_most)
    return by


def _most(ends: Doubt) -> float:
    return max(map(abs, ends))


class Swaps:
    """What each line loses if it is on another of its tracks, and which lines are to go elsewhere then."""

    def __init__(
        self,
        web: Web,
        found: Sequence[Sequence[Track]],
        told: Solved,
        chosen: Sequence[Track | None],
    ) -> None:
        self.found, self.chosen = found, chosen
        self.loses: list[list[tuple[float, int, list[int]]]] = []
        for k, (tracks, one) in enumerate(zip(found, chosen, strict=True)):
            if one is None:
                self.loses.append([])
                continue
            worth = web.worth(k, tracks, told, one)
            now = worth[tracks.index(one)]
            by = web.holders(k, tracks, chosen)
            others = [
                (now - worth[n], n, by[n]) for n, track in enumerate(tracks) if track is not one
            ]
            self.loses.append(sorted([*others, (now, -1, [])]))

    def doubt(self, k: int, most: float = DOUBT) -> Doubt | None:
        """Return how far aside the farthest choice is that costs all lines together less than ``most``."""
        one = self.chosen[k]
        if one is None:
            return None
        aside = [
            (self.found[k][n].start - one.start, self.found[k][n].end - one.end)
            for loss, n, by in self.loses[k]
            if n >= 0 and loss + self._left(by, most - loss, (k,)) < most
        ]
        return max(aside, key=_most, default=None)

    def _left(self, lines: Sequence[int], most: float, before: tuple[int, ...]) -> float:
        """Return what it costs that lines leave their pencil, or more than ``most``."""
        cost = 0.0
        for k in lines:
            if k in before:
                continue
            if len(before) > DEEP or cost >= most:
                return most
            best = most - cost
            for loss, _, by in self.loses[k]:
                if loss >= best:
                    break
                best = min(best, loss + self._left(by, best - loss, (*before, k)))
            cost += best
        return cost
