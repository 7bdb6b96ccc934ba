"""What the operations of a cam leave on paper; letters, axes and phases of its views."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import accumulate
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.operations.instruments import strike
from graphic_tmm.board.record import Figure, Mark, Step
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.operations import (
    divide_semicircle,
    extreme_of_two,
    farther_from_axis,
    in_turn,
    phase_end,
    slant,
    steeper_of_two,
    steepest_ray,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.graph_rules import DOT
from graphic_tmm.paper.labels import Named, shared
from graphic_tmm.paper.rules import segment, struck_arc
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import arrowhead

TRACELESS = frozenset(
    one.name
    for one in (
        phase_end,
        extreme_of_two,
        farther_from_axis,
        slant,
        in_turn,
        steepest_ray,
        steeper_of_two,
    )
)
"""Operations that leave no trace: what is there already under another letter, angles measured with the
protractor, rays to which the ruler is laid."""
POINT = 0.4
"""Radius of a point, mm."""


class CamInk(Seen):
    """A view of a cam's log and its numbers while it is inked."""

    def __init__(self, on: Subject, cam: Cam, view: str) -> None:
        positions = range(cam.diagrams.turn.positions)
        super().__init__(on.construction, on.reading, (view,), positions)
        self.cam, self.view, self.heights = cam, view, on.heights

    def used(self, mark: Mark, which: int = 0) -> Mark:
        """What the step that left a mark used."""
        return self.by_mark[mark].uses[which]

    def figures(self, kind: str) -> list[Figure]:
        """The bodies of a kind, as the plan tells them."""
        told = self.construction.figures
        return [figure for figure in told if figure.view == self.view and figure.kind == kind]


def between(starts: Complexes, ends: Complexes) -> Rule:
    """Return the rule of a line that is drawn between two places of each position."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield from segment("thin", complex(starts[k]), complex(ends[k]))

    return drawn


def dots(
    first: int, last: int, seen: Seen, step: Step, k: int, *, below: bool = False
) -> Iterator[Ink]:
    """A point of a stretch of positions; ``below``: only where it stands below the axis."""
    spot = seen.point(step.it, k)
    if first <= k <= last and finite(spot) and not (below and spot.imag >= 0.0):
        yield circle("thin", spot, POINT)


def whole(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A whole circle."""
    centre, radius = seen.arc(step.it, k)
    if math.isfinite(radius) and finite(centre):
        yield circle("thin", centre, radius)


EVERY, APART = (1, 2, 5, 10), 1.2
"""Of positions that stand too close every second, fifth … is numbered: their middle way, of the height."""
OVER = 9.0
"""How far an axis goes on behind what stands on it, mm."""


def directions(spots: Complexes) -> Complexes:
    """Return the directions of complex numbers; NaN where there is none."""
    size = np.abs(spots)
    there = size > 0.0
    return np.asarray(np.where(there, spots / np.where(there, size, 1.0), np.nan))


def arrow_axis(start: complex, end: complex) -> list[Ink]:
    """Return an axis with its arrow at ``end``."""
    return [line("thin", start, end), *arrowhead(end, end - start, pen="thin")]


def numbered(
    ink: CamInk,
    names: Sequence[str],
    mark: Mark,
    spots: Complexes,
    toward: Complexes,
    *,
    radius: float = 0.8,
) -> list[Wanted]:
    """Return the numbers of positions at their points; positions that coincide share one label.

    Where they have no room every second, fifth … is numbered.

    ``mark``: of the point that is numbered; ``spots``: where its numbers stand, ``toward``: on which side.
    """
    ways, every = np.broadcast_to(toward, spots.shape), _every(spots, ink.heights.number)
    named, aim = [], dict[complex, complex]()
    for k, (name, spot, way) in enumerate(zip(names, spots, ways, strict=True)):
        if k % every:
            continue
        at = complex(spot)
        named.append(Named(at, name, (mark.slot,), k))
        aim.setdefault(at, complex(way))
    return [
        Wanted(one.text, one.at, ink.heights.number, radius, aim[one.at], one.of, one.position)
        for one in shared(named)
    ]


def _every(spots: Complexes, height: float) -> int:
    """Return every how many-th position has room for its number."""
    steps = np.abs(np.diff(spots))
    apart = steps[np.isfinite(steps) & (steps > height * 0.1)]
    middle = float(np.median(apart)) if apart.size else height * APART
    return next((n for n in EVERY if n * middle >= APART * height), EVERY[-1])


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
    return SHARE * ink.arc(ink.cam.profile.working.lower, 0)[1]


def _phases(ink: CamInk) -> Iterator[Phase]:
    """The phases that there are; none where they have no room."""
    sense, spots = -ink.cam.sense, ink.all(_marks(ink))
    angles, ways = np.array(ink.cam.diagrams.turn.angles), list[complex]()
    for begin in accumulate((stage.angle for stage in ink.cam.order.stages[:-1]), initial=0.0):
        k = int(np.argmin(np.abs(angles - begin)))
        # no position stands where the turn begins with a dwell: the next one is turned back
        way = cmath.rect(1.0, sense * math.radians(begin - angles[k])) if k == 0 else 1.0
        ways.append(complex(spots[k]) * way)
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


def semicircle(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The semicircle that is divided, with its diameter; of one that is halved, the half that is used."""
    division = next((s for s in seen.uses.get(step.it, ()) if s.op is divide_semicircle), None)
    if division is None:
        yield from struck_arc(seen, step, k)
        return
    centre, radius = seen.arc(step.it, k)
    _, way = seen.line(division.uses[1], k)
    if not finite(centre, radius, way):
        return
    sense, by = division.choice["sense"], seen.by_mark[division.uses[2]].op
    start = math.degrees(cmath.phase(way))
    if by is law.half_around_outer:
        yield arc("thin", centre, radius, start, 90.0 * sense)
        return
    start -= 90.0 * sense if by is law.around_outer else 0.0
    yield arc("thin", centre, radius, start, 180.0 * sense)
    end = centre + cmath.rect(radius, math.radians(start))
    yield line("thin", end, 2 * centre - end)


def divided(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A point of the division."""
    if finite(seen.point(step.it, k)):
        yield circle("thin", seen.point(step.it, k), DOT)


DIAGRAM_RULES: Mapping[str, Rule] = {strike.name: semicircle, divide_semicircle.name: divided}
"""By operation."""
