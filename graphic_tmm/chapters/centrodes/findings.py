"""What is warned of centrodes: centres at infinity or off the drawing, arcs that slip, tangents apart."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.chapters.centrodes.plan import CENTRODES_PLAN, Centrodes
from graphic_tmm.chapters.centrodes.scales import window_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.readers.findings import Warned

SLIP = 0.25
"""Arcs are as equal as the positions can tell if they differ by this share of what both are longer than chords."""
ANGLE = 10.0
"""Tangents that are drawn farther apart than this are told, degrees: the curve has too few points there."""


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    for made in CENTRODES_PLAN.of(drawn) or ():
        yield from _of_link(drawn, made, language)


def _of_link(drawn: Drawn, made: Centrodes, language: str) -> Iterator[str]:
    _, link, names, reading = speaking(language), made.moving.link, drawn.names, drawn.reading

    def listed(places: Iterable[int]) -> str:
        return ", ".join(names[int(k)] for k in places)

    centres = _row(reading[made.fixed.centre], len(names))
    known = np.isfinite(_row(reading[made.moving.points[0]], len(names)))
    lost = np.flatnonzero(known & ~np.isfinite(centres))
    if lost.size:
        yield _(
            "centrodes: link {link} only shifts for a moment, its normals are parallel and its instantaneous "
            "centre is at infinity or unknown: position {listed}",
            "centrodes: link {link} only shifts for a moment, its normals are parallel and its instantaneous "
            "centre is at infinity or unknown: positions {listed}",
            n=lost.size, link=link, listed=listed(lost),
        )  # fmt: skip
    if made.touching in lost:
        yield _(
            "centrodes: in position {name} the centrodes of link {link} touch at infinity: write another "
            "position for at",
            name=names[made.touching], link=link,
        )  # fmt: skip
    off = np.flatnonzero(np.isfinite(centres) & ~window_of(made, reading).holds(centres))
    if off.size:
        yield _(
            "centrodes: the instantaneous centre of link {link} lies off the drawing, an arrow points to it: "
            "position {listed}",
            "centrodes: the instantaneous centre of link {link} lies off the drawing, arrows point to it: "
            "positions {listed}",
            n=off.size, link=link, listed=listed(off),
        )  # fmt: skip
    slips = np.flatnonzero(slipping(drawn, made))
    if slips.size:
        yield _(
            "centrodes: behind position {listed} the arcs of both centrodes of link {link} differ by more than "
            "the curves tell: take more positions",
            "centrodes: behind positions {listed} the arcs of both centrodes of link {link} differ by more than "
            "the curves tell: take more positions",
            n=slips.size, link=link, listed=listed(slips),
        )  # fmt: skip
    angle = abs(float(reading[made.off][0, 0]))
    if angle > ANGLE:
        yield _(
            "centrodes: the tangents of both centrodes of link {link} are {angle}° apart where they touch: take "
            "more positions, or another one for at",
            link=link, angle=number(angle, language, 2),
        )  # fmt: skip


def _row(values: Complexes, count: int) -> Complexes:
    return np.broadcast_to(values[0], (count,))


def slipping(drawn: Drawn, made: Centrodes) -> np.ndarray:
    """Return behind which positions the arcs of both centrodes are not equal.

    A curve through few points is known to a share of what it is longer than its chords, a reading to a division.
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
