"""Which line of pencil is which of a view: one choice for all, whether it is sure, where they meet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.web import Pin, Solved, Web

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


RULED = 0.08
"""A line is known no better, mm: it is bent by the ruler's edge, the lens, the paper."""
SURE = 0.3
"""A crossing known worse, mm (one standard deviation), is none: its lines are nearly parallel."""
PRICK = 0.1
"""A vector begins so far from its pole (one standard deviation, mm): by eye; a student pricks to 0.15."""
FEW = 2
"""Of more lines than these one that passes the others' crossing is told from them."""
CROSSING_ROUNDS, ASTRAY = 5, 1.5
"""So often all are weighed again; a line that passes by so many of its errors counts half."""


class Cross(NamedTuple):
    """What lines tell of a place: its displacement, mm, in which direction it is known worst, how badly.

    ``misfit``: how far a line passes it; ``lines``: how many there are; ``doubted``: it is known so badly
    because another line may be the right one.
    """

    moved: complex
    way: complex
    error: float
    misfit: float
    lines: int
    doubted: bool


def crossing(view: View, fit: Fit, k: int) -> Cross:
    """Return where the lines of a place meet."""
    rows, asides, errors, clear = [], [], [], []
    for n, (line, track) in enumerate(zip(view.lines, fit.tracks, strict=True)):
        if track is None or k not in line.places:
            continue
        share = line.share(view.places[k].at)
        left = 1j * line.way
        rows.append([left.real, left.imag])
        asides.append(float(track.offset(share)))
        errors.append(_error(track, share, fit.doubt[n]))
        clear.append(_error(track, share, None))
    if not rows:
        return Cross(complex(fit.moved[k]), 1.0, np.inf, 0.0, 0, False)
    ways, off, own = np.array(rows), np.array(asides), np.array(errors)
    sharp = np.array(clear)
    if view.of[k] is None:
        own, sharp = np.hypot(own, PRICK), np.hypot(sharp, PRICK)
    weight = 1 / own**2
    before = np.array([fit.moved[k].real, fit.moved[k].imag])
    for _ in range(CROSSING_ROUNDS if len(rows) > FEW else 1):
        normal = (ways * weight[:, None]).T @ ways
        values, vectors = np.linalg.eigh(normal + 1e-6 * np.eye(2))
        step = vectors @ ((vectors.T @ (ways.T @ (weight * (off - ways @ before)))) / values)
        worst = vectors[:, 0]
        error = float(1 / np.sqrt(values[0]))
        if error > SURE:  # along the worst direction it stays where its neighbours have it
            step = step - worst * (worst @ step)
        moved = before + step
        rest = abs(off - ways @ moved)
        weight = 1 / (own**2 + (rest / ASTRAY) ** 2) if len(rows) > FEW else weight
    misfit = float(np.sort(rest)[-1 - len(rest) // 4])
    best = (ways / sharp[:, None] ** 2).T @ ways
    doubted = error > SURE >= 1 / np.sqrt(max(float(np.linalg.eigvalsh(best)[0]), 1e-6))
    return Cross(complex(*moved), complex(*worst), error, misfit, len(rows), bool(doubted))


def _error(track: Track, share: float, doubt: tuple[float, float] | None) -> float:
    """Return how far a line may be aside at a share of its length, mm: least in its middle.

    ``doubt``: how far aside, at its ends, another one is that may be the right one.
    """
    other = 0.0 if doubt is None else abs(doubt[0] + (doubt[1] - doubt[0]) * share)
    error = track.error * np.sqrt(0.25 + 3 * (share - 0.5) ** 2)
    return float(np.sqrt(error**2 + RULED**2 + other**2))
