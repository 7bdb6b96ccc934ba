"""A synthesis in ink: its construction in thin lines, the mechanism found in its positions."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.linkage_synthesis.figure import Circle, Position, SynthesisFigure
from graphic_tmm.chapters.linkage_synthesis.task import SYNTHESIS
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import Manner, added, body, figure
from graphic_tmm.paper.rules import stays
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import angular
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, guide, slider, turning_pair

BEYOND = 12.0
"""How far a guide goes on behind the ends of the stroke, mm."""
ANGLE = 18.0
"""Radius of the arc that shows an angle, mm."""
PIVOT, PIN = 3.0, 2.0
"""How far the symbols of a pivot and of a pin reach, mm."""


def draw_synthesis(on: Subject, made: SynthesisFigure, names: Sequence[str]) -> Drawing:
    """Return the construction with the mechanism that it found; ``names``: of the positions of a path."""
    ink = Seen(on.construction, on.reading, (SYNTHESIS,), range(len(names)))
    traces = figure(ink, Manner(stays=_stays))
    strokes = [*traces.staying]
    for one in made.circles:
        strokes += body(_circle(ink, one), "path", (one.centre, *one.through))
    if made.guide is not None:
        strokes += body(_guide(ink, *made.guide), "guide", made.guide)
    drawn = made.dyad.positions if made.dyad is not None else ()
    for position in drawn:
        strokes += body(_links(ink, position, "main"), "link", position.joints)
    for position in made.worst:
        strokes += body(_links(ink, position, "thin"), "link", position.joints)
    for k, position in reversed([*enumerate(made.positions)]):
        strokes += body(_links(ink, position, "medium" if k else "main"), "link", position.joints)
    for pivot in made.pivots:
        at = ink.fixed_place(pivot)
        strokes += body(fixed_pivot(at) if finite(at) else (), "pivot", (pivot,))
    for between in made.angles:
        places = [ink.fixed_place(mark) for mark in between[:3]]
        if finite(*places):
            vertex, start, end = places
            begin, turn = _sweep(vertex, start, end)
            strokes += added(angular(vertex, begin, turn, ANGLE), "angle")
    letters = _letters(ink, made, on.heights.point)
    numbers = enumerate(names) if len(names) > 1 else ()
    return traces.drawing(on, strokes, letters, (), numbers)


def _stays(seen: Seen, step: Step) -> bool:
    """Whether a step's line is there at the end: of what differs over the turn only the path is."""
    return stays(seen, step) and not seen.varies(step)


def _sweep(vertex: complex, start: complex, end: complex) -> tuple[float, float]:
    """Return where an angle begins and how far it goes, degrees."""
    begin = math.degrees(cmath.phase(start - vertex))
    return begin, math.degrees(cmath.phase((end - vertex) / (start - vertex)))


def _circle(ink: Seen, of: Circle) -> Iterator[Ink]:
    centre = ink.fixed_place(of.centre)
    spots = [ink.fixed_place(mark) - centre for mark in of.through]
    if not finite(centre, *spots):
        return
    if of.pen == "centre":
        yield circle(of.pen, centre, abs(spots[0]))
        return
    angles = sorted(math.degrees(cmath.phase(spot)) % 360.0 for spot in spots)
    gaps = [(b - a) % 360.0 for a, b in zip(angles, [*angles[1:], angles[0]], strict=True)]
    widest = max(range(len(gaps)), key=gaps.__getitem__)
    start = angles[(widest + 1) % len(angles)]
    farther = min(of.farther, gaps[widest] / 2.0)
    sweep = 360.0 - gaps[widest] + 2.0 * farther
    yield arc(of.pen, centre, abs(spots[0]), start - farther, sweep)


def _guide(ink: Seen, start: Mark, end: Mark) -> Sequence[Ink]:
    first, last = ink.fixed_place(start), ink.fixed_place(end)
    if not finite(first, last) or first == last:
        return ()
    way = BEYOND * (last - first) / abs(last - first)
    return guide(first - way, last + way)


def _links(ink: Seen, position: Position, pen: str) -> Iterator[Ink]:
    spots = [ink.fixed_place(mark) for mark in position.joints]
    if not finite(*spots):
        return
    for start, end in pairwise(spots):
        yield line(pen, start, end)
    if position.slides:
        yield from slider(spots[-1])
    for spot in spots[1 : len(spots) - 1]:
        yield from turning_pair(spot)


def _letters(ink: Seen, made: SynthesisFigure, size: float) -> Iterator[Wanted]:
    for marks, radius in ((made.pivots, PIVOT), (made.points, PIN)):
        for mark in marks:
            at = ink.fixed_place(mark)
            if finite(at):
                yield Wanted(mark.letter, at, size, radius, of=(mark.slot,))
    for vertex, start, end, letter in made.angles:
        places = [ink.fixed_place(mark) for mark in (vertex, start, end)]
        if finite(*places):
            begin, turn = _sweep(*places)
            way = cmath.rect(1.0, math.radians(begin + 0.5 * turn))
            at = places[0] + ANGLE * way
            yield Wanted(letter.letter, at, size, 1.0, toward=way, of=(letter.slot,))
