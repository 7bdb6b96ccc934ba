"""What is warned of a mechanism found through three positions: other branches, another order."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.linkage_synthesis.figure import Dyad
from graphic_tmm.chapters.linkage_synthesis.plan import SYNTHESIS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import Said, said
from graphic_tmm.readers.findings import Warned

APART = said(
    "synthesis: the mechanism found reaches position {listed} only taken apart: it lies on another branch; "
    "give other places, or another length",
    "synthesis: the mechanism found reaches positions {listed} only taken apart: they lie on another "
    "branch; give other places, or another length",
)
PAST = said(
    "synthesis: position {listed} is reached from the first only past a dead place, in which coupler and "
    "rocker lie in line: drive the other link",
    "synthesis: positions {listed} are reached from the first only past a dead place, in which coupler and "
    "rocker lie in line: drive the other link",
)
OPEN = said(
    "synthesis: with the crank at {listed}° the links MD and DE do not reach each other: move E"
)
ORDER = said(
    "synthesis: the crank does not turn all round and goes through the positions in the order {listed}"
)


def defects(
    pivots: tuple[complex, complex], first: Sequence[complex], second: Sequence[complex]
) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Yield what is wrong with positions of a four-bar, by a word, with their numbers.

    ``pivots``: O and C; ``first``, ``second``: the places of A and B.

    "apart": another branch, which only taking the mechanism apart leads to; "past": beyond a dead place of
    coupler and rocker; "order": not one after the other.
    """
    origin, end = pivots
    pairs = list(zip(first, second, strict=True))
    frame, crank = abs(end - origin), abs(first[0] - origin)
    rod, rocker = abs(second[0] - first[0]), abs(end - second[0])
    short, long_ = abs(frame - crank) < abs(rod - rocker), frame + crank > rod + rocker
    # directions of the crank from the line of the pivots; behind it they are counted on
    turns = [math.degrees(cmath.phase((a - origin) / (end - origin))) for a in first]
    if short and not long_:
        turns = [turn % 360.0 for turn in turns]
    sides = [((b - a) * (end - a).conjugate()).imag > 0.0 for a, b in pairs]
    if short and long_:
        apart = [k for k, turn in enumerate(turns, 1) if (turn > 0.0) != (turns[0] > 0.0)]
    elif short or long_:
        apart = []
    else:
        apart = [k for k, side in enumerate(sides, 1) if side != sides[0]]
    if apart:
        yield "apart", tuple(apart)
        return
    if past := [k for k, side in enumerate(sides, 1) if side != sides[0]]:
        yield "past", tuple(past)
    elif short or long_:
        order = tuple(sorted((1, 2, 3), key=lambda k: turns[k - 1]))
        order = order if order.index(1) < order.index(3) else order[::-1]
        if order != (1, 2, 3):
            yield "order", order


SAYS: dict[str, Said | str] = {"apart": APART, "past": PAST, "order": ORDER}


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = SYNTHESIS_PLAN.of(drawn)
    if made is not None and made.dyad is not None:
        yield from _open(drawn, made.dyad, made.pivots[-1], language)
    if made is None or not made.places:
        return
    spots = [
        [complex(drawn.reading[mark][0, 0]) for mark in position.joints]
        for position in made.positions
    ]
    if not all(cmath.isfinite(one) for row in spots for one in row):
        return
    pivot, _, _, other = spots[0]
    first, second = ([row[k] for row in spots] for k in (1, 2))
    for word, which in defects((pivot, other), first, second):
        yield speaking(language)(SAYS[word], n=len(which), listed=", ".join(map(str, which)))


def _open(drawn: Drawn, dyad: Dyad, pivot: Mark, language: str) -> Iterator[str]:
    """Yield at which angles of the crank, of those that were drawn, a second dyad does not close."""
    reading = drawn.reading
    arm, lever = (float(reading[mark][0, 0]) for mark in dyad.links)
    away = np.abs(reading[dyad.course][0] - reading[pivot][0, 0])
    beyond = np.flatnonzero((away > arm + lever) | (away < abs(arm - lever)))
    if beyond.size:
        listed = ", ".join(f"{360.0 / away.size * k:g}" for k in beyond)
        yield speaking(language)(OPEN, listed=listed)


WARNINGS = Warned(_warnings)
