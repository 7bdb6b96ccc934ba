"""Where the points of a view stand in pencil: crossings, ends and signs along a line; how sure each is."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.fitting import Fit
from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.signs import Sign

RULED = 0.08
"""A line is known no better, mm: it is bent by the ruler's edge, the lens, the paper."""
SURE = 0.3
"""A crossing known worse, mm (one standard deviation), is none: its lines are nearly parallel."""
MISFIT = 0.7
"""Lines that pass the place where they should meet farther, mm, do not meet there."""
SEARCH = 5.0
"""Along a line its end is sought as far, mm."""
ACROSS = 0.4
"""And beside it."""
LIKE = 0.5
"""Signs are seen at a place where the pencil is as much more on them than beside them, 0 ... 1."""
TELLING = 0.5
"""Of what of a sign tells where it is along a line, as much more."""
BETTER, ABOUT = 0.12, 2.5
"""Nor may they be seen so much better anywhere as near, mm."""
MOVED = 1.0
"""What tells where a sign is along a line is what changes if it is moved so far, mm."""
CLEAR = 0.12
"""And so much more than at any other place farther than `APART`."""
APART = 1.0
DOUBLE = 2.0
"""Of two points that should be so near to each other, mm, pencil does not tell which is which."""
UNSEEN, UNSURE, SEEN = "unseen", "unsure", "seen"


class Spot(NamedTuple):
    """A place of a view in pencil: where, mm on the sheet, how far that may be off, and whether it was seen."""

    at: complex
    error: float
    how: str


def spots(flat: Flat, view: View, fit: Fit, shift: complex) -> tuple[Spot, ...]:
    """Return where the places of a view stand; ``fit``: its lines, the view moved by ``shift``."""
    signs = Signs(view, fit, shift)
    return tuple(_spot(flat, view, fit, shift, k, signs) for k in range(len(view.places)))


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
        share = ((view.places[k].at - line.start) / line.way).real / line.length
        left = 1j * line.way
        rows.append([left.real, left.imag])
        asides.append(float(track.aside(share)))
        errors.append(_error(track, share, fit.doubt[n]))
        clear.append(_error(track, share, None))
    if not rows:
        return Cross(complex(fit.moved[k]), 1.0, np.inf, 0.0, 0, False)
    ways, off, weight = np.array(rows), np.array(asides), 1 / np.array(errors) ** 2
    normal = (ways * weight[:, None]).T @ ways
    before = np.array([fit.moved[k].real, fit.moved[k].imag])
    values, vectors = np.linalg.eigh(normal + 1e-6 * np.eye(2))
    step = vectors @ ((vectors.T @ (ways.T @ (weight * (off - ways @ before)))) / values)
    worst = vectors[:, 0]
    error = float(1 / np.sqrt(values[0]))
    if error > SURE:  # along the worst direction it stays where its neighbours have it
        step = step - worst * (worst @ step)
    moved = before + step
    misfit = float(abs(off - ways @ moved).max())
    best = (ways / np.array(clear)[:, None] ** 2).T @ ways
    doubted = error > SURE >= 1 / np.sqrt(max(float(np.linalg.eigvalsh(best)[0]), 1e-6))
    return Cross(complex(*moved), complex(*worst), error, misfit, len(rows), bool(doubted))


def _error(track: Track, share: float, doubt: tuple[float, float] | None) -> float:
    """Return how far a line may be aside at a share of its length, mm: least in its middle.

    ``doubt``: how far aside, at its ends, another one is that may be the right one.
    """
    other = 0.0 if doubt is None else abs(doubt[0] + (doubt[1] - doubt[0]) * share)
    error = track.error * np.sqrt(0.25 + 3 * (share - 0.5) ** 2)
    return float(np.sqrt(error**2 + RULED**2 + other**2))


def _spot(flat: Flat, view: View, fit: Fit, shift: complex, k: int, signs: Signs) -> Spot:
    cross = crossing(view, fit, k)
    at = view.places[k].at + shift + cross.moved
    if not cross.lines:
        return Spot(at, np.inf, UNSEEN)
    sign = signs.of(k)
    double = signs.double(k)
    if cross.error <= SURE:
        seen = cross.misfit <= MISFIT and not double and _alike(flat, sign, at)
        return Spot(at, cross.error, SEEN if seen else UNSURE)
    if double or cross.doubted:
        return Spot(at, cross.error, UNSURE)
    return _along(flat, sign, at, cross)


def _along(flat: Flat, sign: Sign, at: complex, cross: Cross) -> Spot:
    """Return the place along a line where its signs are seen best; a line that only passes tells none."""
    reach = min(SEARCH, 3.0 * cross.error + 0.5)
    along = np.arange(-reach, reach + 1e-9, 0.1)
    telling = sign.along(cross.way, MOVED)
    if telling is None:
        return Spot(at, np.inf, UNSEEN)
    like = telling.like(flat, np.asarray(at + cross.way * along, dtype=np.complex128))
    best = int(np.argmax(like))
    other = like[abs(along - along[best]) > APART].max(initial=0.0)
    clear = like[best] > TELLING and like[best] - other > CLEAR
    found = complex(at + cross.way * _peak(along, like, best))
    clear &= cross.misfit <= MISFIT
    clear &= float(sign.like(flat, np.array([found], dtype=np.complex128))[0]) > LIKE
    return Spot(found, 0.25, SEEN if clear else UNSURE)


def _alike(flat: Flat, sign: Sign, at: complex) -> bool:
    """Whether a sign is seen at a place, and nowhere about it much better."""
    axis = np.arange(-ABOUT, ABOUT + 1e-9, 0.5)
    near = np.concatenate([[at], (at + axis[:, None] + 1j * axis).ravel()])
    like = sign.like(flat, near)
    return bool(like[0] > LIKE and like[0] > like.max() - BETTER)


def _peak(along: Reals, like: Reals, best: int) -> float:
    """Return where a row of likenesses is largest, between its places."""
    if not 0 < best < len(along) - 1:
        return float(along[best])
    a, b, c = like[best - 1 : best + 2]
    bend = a - 2 * b + c
    return float(along[best] + (0.5 * (a - c) / bend * (along[1] - along[0]) if bend < 0 else 0.0))


class Signs:
    """The signs at the places of a view; what stands near them by other lines is left out."""

    def __init__(self, view: View, fit: Fit, shift: complex) -> None:
        self.view, self.fit, self.shift = view, fit, shift

    def double(self, k: int) -> bool:
        """Whether another point should stand so near to a place that either might be taken for the other.

        Where vectors of no length end at a pole it is still the pole, which lines of all others show.
        """
        places = self.view.places
        if self.view.of[k] is None:
            return False
        near = (n for n in range(len(places)) if abs(places[n].at - places[k].at) < DOUBLE)
        return any(n != k and self.view.of[n] in (None, self.view.of[k]) for n in near)

    def of(self, k: int) -> Sign:
        """Return the sign at a place."""
        at = self.view.places[k].at
        others = [
            (line.start - at, line.end - at) for line in self.view.lines if k not in line.places
        ]
        return Sign.made(
            self.view.ink[k] - at, np.array(others, dtype=np.complex128).reshape(-1, 2)
        )
