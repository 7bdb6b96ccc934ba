"""The phases of a cam's turn on its profile, in ink: angles about its centre, lettered as in the diagrams.

A phase is the angle by which the follower is turned back: between its guides where they pass through the
centre, between the radii to the points on which they stand where they do not.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam.ink_rules import CamInk
from graphic_tmm.paper.drawing import Ink, Wanted, arc, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.seen import finite
from graphic_tmm.paper.symbols.kinematic import arrowhead

SHARE = 0.62
"""Radius of the arcs, of that of the working profile in the lower dwell."""
ROOM = 4.0
"""Arcs of a smaller radius have no room for letters, of their height."""
HEAD = 3.0
"""Length of an arrowhead on an arc, mm."""
BEYOND = 2.0
"""How far the radii go on behind the arcs, mm."""
LEAST = 1e-6
"""What is shorter is no phase, degrees."""


class Phase(NamedTuple):
    """A phase: its number, the direction in which it begins, its angle (degrees, counter-clockwise)."""

    number: int
    start: complex
    turn: float


def _marks(ink: CamInk) -> Mark:
    """What tells the directions: where the guides stand, or the points that they pass."""
    made = ink.cam.profile
    return made.feet or (made.theoretical or made.working).points


def _radius(ink: CamInk) -> float:
    return SHARE * ink.seen.arc(ink.cam.profile.working.lower, 0)[1]


def _phases(ink: CamInk) -> Iterator[Phase]:
    """The phases that there are: rise, upper dwell, return, lower dwell; none where they have no room."""
    turn, sense, spots = ink.cam.diagrams.turn, -ink.cam.sense, ink.all(_marks(ink))
    at = (0, turn.rise.last, turn.fall.first, turn.fall.last)
    ways = [complex(spots[k]) for k in at]
    radius = _radius(ink)
    if not finite(*ways, complex(radius)) or 0j in ways or radius < ROOM * ink.heights.number:
        return
    for n, (start, end) in enumerate(zip(ways, [*ways[1:], ways[0]], strict=True), 1):
        angle = (sense * math.degrees(cmath.phase(end / start))) % 360.0
        if LEAST < angle < 360.0 - LEAST:
            yield Phase(n, start / abs(start), sense * angle)


def draw_phases(ink: CamInk) -> Iterator[Ink]:
    """The arcs of the phases with arrows at their ends, and the radii between which they stand."""
    radius, mark, strokes = _radius(ink), _marks(ink), list[Ink]()
    through = ink.cam.path is None or ink.cam.profile.feet is None  # guides pass through the centre
    for phase in _phases(ink):
        begin = math.degrees(cmath.phase(phase.start))
        if not through:
            strokes.append(line("thin", 0j, (radius + BEYOND) * phase.start))
        strokes.append(arc("thin", 0j, radius, begin, phase.turn))
        if radius * math.radians(abs(phase.turn)) > 2.5 * HEAD:
            sense = math.copysign(1.0, phase.turn)
            end = phase.start * cmath.rect(1.0, math.radians(phase.turn))
            strokes += arrowhead(
                radius * phase.start, -1j * sense * phase.start, pen="thin", length=HEAD
            )
            strokes += arrowhead(radius * end, 1j * sense * end, pen="thin", length=HEAD)
    yield from body(strokes, "dimension", [mark])


def phase_letters(ink: CamInk) -> Iterator[Wanted]:
    """The letters of the phases, outside their arcs."""
    radius, of = _radius(ink), (_marks(ink).slot,)
    for phase in _phases(ink):
        way = phase.start * cmath.rect(1.0, math.radians(phase.turn / 2))
        yield Wanted(f"φ_{{{phase.number}}}", radius * way, ink.heights.number, 0.5, way, of)
