"""Points where a line of pencil ends in the open: no head, no ring, nothing but paper behind it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.pencil.darkness import Flat, Greys
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.pencil.points import DOUBLE, SEEN, UNSEEN, UNSURE, Spot

REACH = 8.0
"""An end is sought as far before and behind the place where it is expected, mm."""
KNOWN = 0.3
"""Where lines of other directions meet, known so well, mm, is a point of a plan of one position."""
STEP = 0.1
"""And so densely, mm."""
LINE, PAPER = 4.0, 3.0
"""There is pencil so far before it, and paper so far behind it, mm."""
HEAD = 2.5
"""And no farther from where a sign is seen, mm."""
CLEAR = 0.4
"""Not yet looked at behind it, mm: half of a thick line, and the camera's blur."""
DRAWN, BLANK = 0.85, 0.2
"""So much of the one is pencil at least, and of the other at most."""
ASIDE = np.array([-0.35, 0.0, 0.35])
"""Pencil is looked for about the line, mm."""
OPEN = 120.0
"""About an end in the open there is nothing so far to either side of its line's direction, degrees."""
ABOUT = np.array([0.9, 1.3, 1.7])
"""As far from it, mm."""
RADII = (0.6, 0.8, 1.0, 1.3)
"""Rings about points, mm."""
ROUND, BETTER = 0.55, 0.15
"""So much more pencil there is on a ring than about it, and than on any other place of the line."""
RINGS = 0.6
"""A ring's pencil ends no farther behind its circle, mm."""
SIDES = 0.7
"""Of a ring what stands aside of the line is pencil, too: of directions whose cosine is less."""
POLE, POLE_ERROR, CLICKED = 1.5, 0.25, 0.4
"""A pole is no farther from where it was clicked, mm; known so well where its lines begin, and by a click."""
BOTH = 2
"""So many lines must begin there."""
FADING = 4
"""So many steps on the pencil is gone."""
SINE = 0.17
"""Of the angle between lines that cross: ten degrees."""
LONG = 6.0
"""The direction of a shorter line is not known, mm."""
ERROR = 0.3
"""How far such an end may be off, mm."""


def with_open_ends(
    flat: Flat, view: View, spots: Sequence[Spot], clicked: complex
) -> tuple[Spot, ...]:
    """Return the spots of a view; those that were not sure, but are where a line ends in the open, are seen.

    ``clicked``: its pole, mm.
    """
    found = list(spots)
    for k in set(view.poles.values()):
        found[k] = _begun(flat, view, spots, k, clicked)
    spots = tuple(found)
    for k, spot in enumerate(spots):
        beside = float(np.delete(abs(view.at - view.at[k]), k).min(initial=np.inf))
        if not view.places[k].names or beside < DOUBLE:
            continue
        if _crossed(view, k):
            if spot.how == UNSURE and spot.error < KNOWN:
                found[k] = spot._replace(how=SEEN)
            continue
        # a head of the student's own is longer or shorter than ours: where it is seen its tip tells more
        reach = HEAD if spot.how == SEEN else REACH
        ways = _ways(view, spots, k)
        ends = [
            end for way in ways if (end := _ring(flat, spot.at, way) or _end(flat, spot.at, way))
        ]
        ends = [end for end in ends if abs(end - spot.at) < reach]
        if len(ends) == 1 or (ends and max(abs(end - ends[0]) for end in ends) < 2 * ERROR):
            found[k] = Spot(sum(ends) / len(ends), ERROR, SEEN)
    return tuple(found)


def _begun(flat: Flat, view: View, spots: Sequence[Spot], k: int, clicked: complex) -> Spot:
    """Return a pole: where its lines begin, if they go to one side; where they cross; where it was clicked."""
    spot = spots[k]
    ends = [end for way in _ways(view, spots, k) if (end := _end(flat, spot.at, way))]
    near = [end for end in ends if abs(end - clicked) < POLE]
    if len(near) >= BOTH and max(abs(a - b) for a in near for b in near) < 2 * POLE_ERROR:
        return Spot(complex(np.mean(near)), POLE_ERROR, SEEN)
    if spot.how == SEEN and spot.error < POLE_ERROR:
        return spot
    # its sign is another one than ours: a click tells as much
    close = spot.how != UNSEEN and abs(spot.at - clicked) < POLE
    return Spot((spot.at + clicked) / 2 if close else clicked, CLICKED, SEEN)


def _ways(view: View, spots: Sequence[Spot], k: int) -> list[complex]:
    """Return in which directions lines end with a place, each from the first place of it that is seen."""
    found = []
    for line in view.lines:
        if k not in line.places or len(line.places) < 2:
            continue
        order = sorted(line.places, key=lambda n: line.share(view.places[n].at))
        if k not in (order[0], order[-1]):
            continue
        rest = order[::-1] if k == order[0] else order
        before = [n for n in rest[:-1] if spots[n].how == SEEN]
        if before and abs(spots[k].at - spots[before[0]].at) > LONG:
            way = spots[k].at - spots[before[0]].at
            found.append(way / abs(way))
    return found


def _crossed(view: View, k: int) -> bool:
    """Whether lines of different directions go through a place."""
    ways = [line.way for line in view.lines if k in line.places]
    return any(abs((one / other).imag) > SINE for one in ways for other in ways)


def _end(flat: Flat, at: complex, way: complex) -> complex | None:
    """Return where the pencil along a direction ends, near a place; None if it does not, or more than once."""
    along = np.arange(-REACH - LINE, REACH + PAPER + CLEAR, STEP)
    places = at + way * along[:, None] + 1j * way * ASIDE
    pencil = flat.pencil(np.asarray(places, np.complex128)).max(axis=1).astype(np.float64)
    before = _mean(pencil, along, -LINE, 0.0)
    behind = _mean(pencil, along, CLEAR, CLEAR + PAPER)
    ends = np.flatnonzero((before > DRAWN) & (behind < BLANK) & (abs(along) < REACH))
    if not ends.size or along[ends[-1]] - along[ends[0]] > 2 * LINE:
        return None
    # where it fades to a half for the first time: behind that may be the ring about a point
    fading = [k for k in ends if pencil[k] > 0.5 and pencil[k + 1 : k + FADING].min() < 0.5]
    if not fading:
        return None
    dark = flat.darkness(np.asarray(places, np.complex128)).max(axis=1)
    last = int(fading[0])
    half = _half(dark, last)
    while last and dark[last] < half:
        last -= 1
    end = complex(at + way * along[last])
    around = way * np.exp(1j * np.radians(np.arange(-OPEN, OPEN + 1, 15.0)))
    beside = flat.pencil(np.asarray(end + around[:, None] * ABOUT, np.complex128)).mean(axis=1)
    return end if beside.mean() < BLANK and beside.max() < 0.5 else None


def _half(dark: Reals | Greys, last: int) -> float:
    """Return half of how dark a line is before a place of its profile: sure pencil is far fainter."""
    return 0.5 * float(np.median(dark[max(last - round(LINE / STEP), 0) : last + 1]))


def _ring(flat: Flat, at: complex, way: complex) -> complex | None:
    """Return the middle of a ring of pencil on a line, near a place; None if it is not clear."""
    along = np.arange(-REACH, REACH + STEP / 2, STEP)
    turns: Complexes = way * np.exp(1j * np.radians(np.arange(0, 360, 15.0)))
    ahead = np.extract(abs(np.angle(turns / way)) < np.radians(OPEN), turns)
    sides = np.extract(abs((turns / way).real) < SIDES, turns)
    middles = np.asarray(at + way * along, np.complex128)
    dark = flat.darkness(middles)
    level = _half(dark, int(np.flatnonzero(abs(along) < STEP / 2)[0]))
    on = [_about(flat, middles, turns, radius, level) for radius in RADII]
    off = [_about(flat, middles, ahead, radius + 0.8, level) for radius in RADII]
    # a line so thick that it fills a ring does so all along
    thick = [_about(flat, middles, sides, radius, level) for radius in RADII]
    wider = np.array(thick) - np.median(thick, axis=1, keepdims=True)
    worth = np.minimum(np.array(on) - np.array(off), wider)
    whole = worth.max(axis=0)
    drawn = (np.array(on) > DRAWN) & (worth > ROUND)
    if not drawn.any():
        return None
    # smaller circles lie in a thick ring's pencil, and before its middle in that of the line: the largest tells
    row = int(np.flatnonzero(drawn.any(axis=1))[-1])
    own = worth[row]
    best = int(np.argmax(own))
    # with a ring pencil ends: the broad part of a head has its tip ahead, a line that crosses goes on
    paper = np.flatnonzero(dark[best:] < level)
    if not paper.size or paper[0] * STEP > RADII[row] + RINGS:
        return None
    other = whole[abs(along - along[best]) > 2 * RADII[-1]].max(initial=-1.0)
    if whole[best] - other < BETTER:
        return None
    near = (abs(along - along[best]) < RADII[-1]) & (own > own[best] - BETTER)
    return complex(middles[near].mean())


def _about(flat: Flat, middles: Complexes, turns: Complexes, radius: float, level: float) -> Reals:
    """Return how much pencil there is on a circle, or an arc of it, about each of some places."""
    places = np.asarray(middles[:, None] + radius * turns, np.complex128)
    return np.asarray((flat.darkness(places) > level).mean(axis=1), dtype=np.float64)


def _mean(pencil: Reals, along: Reals, low: float, high: float) -> Reals:
    """Return the mean of a profile from ``low`` to ``high`` beside each of its places."""
    whole = np.concatenate([[0.0], np.cumsum(pencil)])
    row = np.arange(len(along))
    first = np.clip(row + round(low / STEP), 0, len(along))
    last = np.clip(row + round(high / STEP), 0, len(along))
    return np.asarray((whole[last] - whole[first]) / np.maximum(last - first, 1), dtype=np.float64)
