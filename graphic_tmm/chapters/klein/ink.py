"""The constructions in ink: crank, rod and slider heavy, circles and lines thin, the sides of the figures."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import combinations

from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import similar
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.klein.operations import circle_through
from graphic_tmm.chapters.klein.record import Figure
from graphic_tmm.chapters.klein.task import KLEIN
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.rules import segment
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, pole, slider, turning_pair

BEYOND = 8.0
"""By how many degrees the circle on the rod goes on behind the points that it shares."""
TICK = 2.0
"""How far the mark of the rod's middle reaches to either side of the rod, mm."""
CLOSE = 2.0
"""Points nearer than this, mm, share one label."""


def _circle(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The whole circle that the compass strikes."""
    centre, radius = seen.arc(step.it, k)
    if finite(centre, complex(radius)) and radius > 0.0:
        yield circle("thin", centre, radius)


def _side(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A side of the figure, where it was measured."""
    start, end = (seen.point(mark, k) for mark in step.uses)
    if finite(start, end) and start != end:
        yield line("medium", start, end)


def _laid(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """A side of the figure, where it was laid off."""
    yield from segment("medium", seen.line(step.uses[0], k)[0], seen.point(step.it, k))


def _rules(made: Figure) -> dict[Mark, Rule]:
    """Return how marks of a construction are inked: its sides, of Klein's circles as much as is needed."""
    rules: dict[Mark, Rule] = {one.segment: _side for one in made.quantities}
    rules |= dict.fromkeys(made.moved, _laid)
    if made.view != KLEIN:
        return rules
    centre, arc_, both, chord = made.through

    def far(seen: Seen, k: int) -> tuple[complex, complex]:
        """Return the two points that both circles share."""
        spot, pin, stone = (seen.point(mark, k) for mark in (both, made.pin, made.slider))
        way = (stone - pin) / abs(stone - pin)
        return spot, pin + ((spot - pin) / way).conjugate() * way

    def on_rod(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The circle on the rod from beyond the one common point to beyond the other, about the pin."""
        middle, ends = seen.point(centre, k), far(seen, k)
        if not finite(middle, *ends):
            yield from _circle(seen, step, k)
            return
        radius, pin = seen.arc(step.it, k)[1], seen.point(made.pin, k)
        half = max(abs(cmath.phase((end - middle) / (pin - middle))) for end in ends)
        half = min(math.degrees(half) + BEYOND, 180.0)
        start = math.degrees(cmath.phase(pin - middle)) - half
        yield arc("thin", middle, radius, start, 2.0 * half)

    def across(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The common chord, as far as N where N is on it."""
        spots = [*far(seen, k), *(() if made.moved else (seen.point(made.N, k),))]
        if not finite(*spots):
            return
        ends = max(combinations(spots, 2), key=lambda one: abs(one[1] - one[0]))
        yield from segment("thin", *ends)

    def middle(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """A tick across the rod at its middle."""
        spot, pin, stone = (seen.point(mark, k) for mark in (centre, made.pin, made.slider))
        if finite(spot, pin, stone):
            way = 1j * TICK * (stone - pin) / abs(stone - pin)
            yield line("thin", spot - way, spot + way)

    return {**rules, centre: middle, arc_: on_rod, chord: across}


def _stays(seen: Seen, step: Step) -> bool:
    return step.op in (circle_through, halve, similar) or step.it.kind is Line or usual(seen, step)


def draw_construction(on: Subject, made: Figure, place: int) -> Drawing:
    """Return a construction in one position (index in the reading)."""
    seen = on.seen((made.view,), [place])
    traces = figure(seen, Manner({circle_through.name: _circle}, _stays, _rules(made)))
    strokes: list[Ink] = [*traces.staying]
    marks = [made.pivot, made.pin, made.slider]
    pivot, pin, stone = (seen.point(mark, place) for mark in marks)
    if finite(pivot, pin, stone):
        along = seen.line(made.along, place)[1]
        turn = math.degrees(cmath.phase(along))
        links = [line("rod", pivot, pin), line("rod", pin, stone)]
        for part, signs in (
            ("link", links), ("slider", slider(stone, turn, pin=True)), ("pivot", fixed_pivot(pivot)),
            ("pair", turning_pair(pin)),
        ):  # fmt: skip
            strokes += body(signs, part, marks, place)
    for one in made.points:
        spot = seen.point(one.at, place)
        if finite(spot):
            strokes += body(pole(spot), "point", [one.at], place)
    return traces.drawing(on, strokes, _letters(on, seen, made, place))


def _letters(on: Subject, seen: Seen, made: Figure, place: int) -> list[Wanted]:
    marks: list[Mark] = [made.pivot, made.pin, made.slider, made.M, made.Q, made.N, *made.moved]
    marks += [mark for mark in made.through if mark.kind is Point]
    marks += [mark for one in made.points for mark in one[1:]]
    spots = [(mark, seen.point(mark, place)) for mark in marks]
    named = [Named(spot, mark.name, (mark.slot,), place) for mark, spot in spots if finite(spot)]
    middle = sum(one.at for one in named) / max(1, len(named))
    return lettered(shared(named, CLOSE), on.heights.point, away_from=middle)
