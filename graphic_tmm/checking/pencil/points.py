"""Where the points of a view stand in pencil: crossings, ends and signs along a line; how sure each is.

Signs are lines that end or cross, a head, a ring, and how alike pencil is to them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.fitting import SURE, Cross, Doubt, Fit, crossing

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
MOST_PLACES = 900
"""So many places of either are looked at, at most."""


class Sign(NamedTuple):
    """Places about a point (complex, mm) where its ink is, where there is none; its straight pieces."""

    ink: Complexes
    paper: Complexes
    pieces: Complexes

    @classmethod
    def of_pieces(cls, pieces: Complexes, others: Complexes) -> Sign:
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
    step = -(-len(spots) // MOST_PLACES)
    return spots[:: max(step, 1)]


MEETING = 4
"""So many lines that meet are a sign in themselves: the heads and rings of a pole lie on one another."""
THREE = 3
"""So many tell of a pole that another point is near, but not that one should be there."""
MISFIT = 0.7
"""Lines that pass the place where they should meet farther, mm, do not meet there."""
SEARCH = 5.0
"""Along a line its end is sought as far, mm."""
LIKE = 0.4
"""Signs are seen at a place where the pencil is as much more on them than beside them, 0 ... 1."""
FIRM, LOOSELY = 0.7, 1.0
"""Of points of a fan that a hand scatters farther (one deviation, mm) so much more."""
TELLING = 0.4
"""Of what of a sign tells where it is along a line, as much more."""
MOVED = 1.0
"""What tells where a sign is along a line is what changes if it is moved so far, mm."""
CLEAR = 0.12
"""And so much more than at any other place farther than `APART`."""
APART = 1.0
LOOSE = 0.3
"""Where all lines together have a place is known no better, mm: a point is drawn by itself, too."""
PRIOR, MOST_SQUARES = 0.03, 16.0
"""What a sign loses by each square of a deviation from there, and how many squares count; chosen by eye."""
FARTHEST = 2.5
"""A sign so many deviations from there is another point's."""
GAP = 4.0
"""Nor is a sign looked for where another place is nearer along the line, in deviations: twice its reach."""
DOUBLE = 2.0
"""Of two points that should be so near to each other, mm, pencil does not tell which is which."""
ONE = 0.5
"""And of two so near, mm, of whichever position, not even the lines do."""
CARRIED = 1.5
"""Of a fan's points that a hand scatters farther (one deviation, mm) a neighbour's line may be the nearer."""
SAME = 0.02
"""What should stand nearer to each other, mm, is one place."""
ANYWHERE = 1.0
"""How far a point is along a line when others are doubted, mm (one deviation)."""
AGREED = 0.6
"""A sign so near where the lines have a point is not another's, mm."""
RIVAL = 0.5
"""Another line that a fan's point may be on is no harm so near, mm."""
UNSEEN, UNSURE, SEEN = "unseen", "unsure", "seen"


class Alike(NamedTuple):
    """How much more pencil there must be on a sign than beside it, how much more anywhere ``about``, mm."""

    least: float
    better: float
    about: float


CROWDED = Alike(0.5, 0.12, 2.5)
"""Asked of a crossing of lines in a fan of positions."""
FREE = Alike(0.35, 0.3, 1.5)
"""Of one in a plan of one position: its lines are hardly another's."""
DOUBTED = Alike(0.5, 0.12, SEARCH)
"""Of one of which another line may be the right one. All chosen by eye on 36 sheets."""


class Spot(NamedTuple):
    """A place of a view in pencil: where, mm on the sheet, how far that may be off, and whether it was seen."""

    at: complex
    error: float
    how: str


def spots(
    flat: Flat, view: View, fit: Fit, shift: complex, drawn: Sequence[Sign]
) -> tuple[Spot, ...]:
    """Return where the places of a view stand; ``fit``: its lines, the view moved by ``shift``.

    ``drawn``: the `signs_of` the view.
    """
    signs = Signs(view, fit, shift, drawn)
    return tuple(_spot(flat, view, fit, shift, k, signs) for k in range(len(view.places)))


def _spot(flat: Flat, view: View, fit: Fit, shift: complex, k: int, signs: Signs) -> Spot:
    cross = crossing(view, fit, k)
    at = view.places[k].at + shift + cross.moved
    if not cross.lines:
        return Spot(at, np.inf, UNSEEN)
    sign = signs.drawn[k]
    crowded = signs.crowded(k)
    if cross.error <= SURE:
        alone = signs.apart(k) if crowded else not signs.veiled(k, cross.lines)
        met = cross.lines >= MEETING or _alike(flat, sign, at, CROWDED if signs.fan else FREE)
        seen = cross.misfit <= MISFIT and alone and met
        return Spot(at, cross.error, SEEN if seen else UNSURE)
    together = fit.spread(k, cross.way)
    sure = together <= SURE and not (cross.doubted or crowded or signs.veiled(k, cross.lines))
    if not sure and ((signs.fan and _rivalled(view, fit, k)) or signs.none(k)):
        return Spot(at, cross.error, UNSURE)
    if cross.doubted and not sure:
        if signs.near(k):
            return Spot(at, cross.error, UNSURE)
        found = _along(flat, sign, at, cross, ANYWHERE)
        seen = found.how == SEEN and not crowded and _alike(flat, sign, found.at, DOUBTED)
        return Spot(found.at, cross.error, SEEN if seen else UNSURE)
    spread = float(np.hypot(together, LOOSE))
    found = _along(flat, sign, at, cross, spread, FIRM if signs.carried(k) else LIKE)
    if sure and found.how == UNSEEN:  # nothing tells more than the lines do
        met = _alike(flat, sign, at, CROWDED if signs.fan else FREE)
        return Spot(at, together, SEEN if met and cross.misfit <= MISFIT else UNSURE)
    if sure or not signs.hemmed(k, cross.way, GAP * spread):
        return found
    agreed = abs(found.at - at) < AGREED and signs.farthest_other(k, fit.doubt) < RIVAL
    return found if agreed else Spot(at, cross.error, UNSURE)


def _rivalled(view: View, fit: Fit, k: int) -> bool:
    """Whether a line that goes through a place is not seen, or another one may be the right one."""
    own = [n for n, line in enumerate(view.lines) if k in line.places]
    return any(fit.doubt[n] is not None or fit.tracks[n] is None for n in own)


def _along(
    flat: Flat, sign: Sign, at: complex, cross: Cross, spread: float, least: float = LIKE
) -> Spot:
    """Return the place along a line where its signs are seen best; a line that only passes tells none.

    ``spread``: how far along it may be from where its neighbours have it, mm; ``least``: how much more pencil
    there is on its signs than beside them.
    """
    along = np.arange(-SEARCH, SEARCH + 1e-9, 0.1)
    telling = sign.along(cross.way, MOVED)
    if telling is None:
        return Spot(at, np.inf, UNSEEN)
    like = telling.like(flat, np.asarray(at + cross.way * along, dtype=np.complex128))
    worth = like - PRIOR * np.minimum((along / spread) ** 2, MOST_SQUARES)
    best = int(np.argmax(worth))
    other = worth[abs(along - along[best]) > APART].max(initial=-1.0)
    clear = like[best] > TELLING and worth[best] - other > CLEAR
    found = complex(at + cross.way * _peak(along, like, best))
    clear &= cross.misfit <= MISFIT and abs(along[best]) < FARTHEST * spread
    clear &= float(sign.like(flat, np.array([found], dtype=np.complex128))[0]) > least
    return Spot(found, 0.25, SEEN if clear else UNSURE)


def _alike(flat: Flat, sign: Sign, at: complex, asked: Alike) -> bool:
    """Whether a sign is seen at a place, and nowhere about it much better."""
    axis = np.arange(-asked.about, asked.about + 1e-9, 0.5)
    near = np.concatenate([[at], (at + axis[:, None] + 1j * axis).ravel()])
    like = sign.like(flat, near)
    return bool(like[0] > asked.least and like[0] > like.max() - asked.better)


def _peak(along: Reals, like: Reals, best: int) -> float:
    """Return where a row of likenesses is largest, between its places."""
    if not 0 < best < len(along) - 1:
        return float(along[best])
    a, b, c = like[best - 1 : best + 2]
    bend = a - 2 * b + c
    return float(along[best] + (0.5 * (a - c) / bend * (along[1] - along[0]) if bend < 0 else 0.0))


class Signs:
    """The signs at the places of a view; what stands near them by other lines is left out."""

    def __init__(self, view: View, fit: Fit, shift: complex, drawn: Sequence[Sign] = ()) -> None:
        self.view, self.fit, self.shift, self.drawn = view, fit, shift, drawn
        self.fan = view.fan

    def crowded(self, k: int) -> bool:
        """Whether a place may be taken for another: one is there, or a hand carries it past those of its fan.

        Where vectors of no length end at a pole it is still the pole, which lines of all others show.
        """
        at, of = self.view.at, self.view.of
        if of[k] is None:
            return False
        if float(np.delete(abs(at - at[k]), k).min(initial=np.inf)) < ONE:
            return True
        return self.fan and (self.astray(k) > CARRIED or self.near(k) or self.passed(k))

    def astray(self, k: int) -> float:
        """Return how far a hand scatters a place, mm (one deviation)."""
        return float(np.sqrt((abs(self.view.astray[:, k]) ** 2).mean() / 2))

    def carried(self, k: int) -> bool:
        """Whether a hand may carry a place of a fan to where a sign of another line is."""
        return self.fan and self.astray(k) > LOOSELY

    def passed(self, k: int) -> bool:
        """Whether a hand scatters a place of a fan as far as to the nearest other one."""
        apart = np.delete(abs(self.view.at - self.view.at[k]), k)
        return self.fan and float(apart.min(initial=np.inf)) < self.astray(k)

    def veiled(self, k: int, lines: int) -> bool:
        """Whether vectors of no length end at a pole that few ``lines`` show: they are drawn somewhere else."""
        if self.view.of[k] is not None or lines >= MEETING:
            return False
        return self.elsewhere(k) or (lines < THREE and self.near(k))

    def near(self, k: int) -> bool:
        """Whether another point should stand so near to a place that one's end is the other's."""
        of = self.view.of
        near = np.flatnonzero(abs(self.view.at - self.view.at[k]) < DOUBLE)
        return any(n != k and (of[n] == of[k] or None in (of[n], of[k])) for n in near)

    def elsewhere(self, k: int) -> bool:
        """Whether another place should stand where a place does."""
        return float(np.delete(abs(self.view.at - self.view.at[k]), k).min(initial=np.inf)) < SAME

    def apart(self, k: int) -> bool:
        """Whether the lines of a crowded place are its own, by all lines together."""
        return self.farthest_other(k, self.fit.far) < RIVAL and not self.passed(k)

    def none(self, k: int) -> bool:
        """Whether a vector of no length leads to a place: another one of its position should stand there."""
        return self.elsewhere(k) and self.near(k)

    def hemmed(self, k: int, way: complex, reach: float) -> bool:
        """Whether the sign of another place may be taken for that of a place, along a direction."""
        return self.near(k) or self.passed(k) or self.alone(k, way) < reach

    def farthest_other(self, k: int, doubts: Sequence[Doubt | None]) -> float:
        """Return how far from a place another line is, at most, that one through it may be, mm."""
        at = self.view.places[k].at
        found = 0.0
        for line, far in zip(self.view.lines, doubts, strict=True):
            if far is not None and k in line.places:
                found = max(found, abs(far[0] + (far[1] - far[0]) * line.share(at)))
        return found

    def alone(self, k: int, way: complex) -> float:
        """Return how far it is along a direction to the nearest other place, whose sign may be as good, mm."""
        at = self.view.at
        off = (np.delete(at, k) - at[k]) / way
        return float(abs(off.real[abs(off.imag) < DOUBLE]).min(initial=np.inf))


def signs_of(view: View) -> tuple[Sign, ...]:
    """Return the signs at the places of a view."""
    found = []
    for k, place in enumerate(view.places):
        others = [
            (line.start - place.at, line.end - place.at)
            for line in view.lines
            if k not in line.places
        ]
        beside = np.array(others, dtype=np.complex128).reshape(-1, 2)
        found.append(Sign.of_pieces(view.ink[k] - place.at, beside))
    return tuple(found)
