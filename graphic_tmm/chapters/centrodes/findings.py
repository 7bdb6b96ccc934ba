"""What is warned of centrodes: centres at infinity or off the drawing, arcs that slip, tangents apart."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN, Centrodes
from graphic_tmm.chapters.centrodes.scales import window_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned

SLIP = 0.25
"""Arcs may differ by this share of what both are longer than their chords."""
ANGLE = 10.0
"""Tangents that are drawn farther apart than this are told, degrees."""
LOST = said(
    "centrodes: in position {listed} the normals of link {link} are parallel: it shifts for a moment, its "
    "instantaneous centre is at infinity",
    "centrodes: in positions {listed} the normals of link {link} are parallel: it shifts for a moment, its "
    "instantaneous centre is at infinity",
)
NOTHING = said(
    "centrodes: in position {name} nothing of link {link} touches: write another position for at"
)
OFF = said(
    "centrodes: the instantaneous centre of link {link} lies off the drawing in position {listed}: an arrow "
    "points to it",
    "centrodes: the instantaneous centre of link {link} lies off the drawing in positions {listed}: arrows "
    "point to it",
)
SLIPS = said(
    "centrodes: behind position {listed} the arcs of link {link} differ: take more positions",
    "centrodes: behind positions {listed} the arcs of link {link} differ: take more positions",
)
APART = said(
    "centrodes: where both centrodes of link {link} touch their tangents are {angle}° apart: take more "
    "positions, or another one for at"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    for made in CENTRODES_PLAN.of(drawn) or ():
        yield from _of_link(drawn, made, language)


def _of_link(drawn: Drawn, made: Centrodes, language: str) -> Iterator[str]:
    _, link, names, reading = speaking(language), made.moving.link, drawn.names, drawn.reading
    centres = _row(reading[made.fixed.centre], len(names))
    there, pins = np.isfinite(centres), _row(reading[made.moving.points[0]], len(names))
    off = there & ~window_of(made, reading).holds(centres)
    told = ((LOST, ~there & np.isfinite(pins)), (OFF, off), (SLIPS, slipping(drawn, made)))
    for says, where in told:
        places = np.flatnonzero(where)
        if places.size:
            listed = ", ".join(names[k] for k in places)
            yield _(says, n=places.size, link=link, listed=listed)
    if not there[made.touching]:
        yield _(NOTHING, name=names[made.touching], link=link)
    angle = abs(float(reading[made.off][0, 0]))
    if angle > ANGLE:
        yield _(APART, link=link, angle=number(angle, language, 2))


def _row(values: Complexes, count: int) -> Complexes:
    return np.broadcast_to(values[0], (count,))


def slipping(drawn: Drawn, made: Centrodes) -> np.ndarray:
    """Return behind which positions the arcs of both centrodes are not equal.

    A curve through few points is known to a share of what it is longer than its chords, a reading to a
    division of the ruler.
    """
    reading, row = drawn.reading, made.count
    arcs, longer = list[Reals](), np.zeros(row)
    for side in made.sides:
        spots = _row(reading[side.centre], len(drawn.names))[:row]
        arcs.append(reading[side.arc][0, :row])
        longer += arcs[-1] - np.abs(np.roll(spots, -1) - spots)
    apart = np.abs(arcs[1] - arcs[0])
    allowed = SLIP * np.abs(longer) + (drawn.hand.ruler or 0.0) + 1e-6 * arcs[0]
    return np.asarray(np.isfinite(apart) & (apart > allowed))


WARNINGS = Warned(
    _warnings, covers=lambda drawn: [made.view for made in CENTRODES_PLAN.of(drawn) or ()]
)
