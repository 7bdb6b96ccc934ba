"""The constructions of curvature in ink, in one position."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.curvature.link_figure import Held, LinkFigure
from graphic_tmm.chapters.curvature.plan import Curvature
from graphic_tmm.chapters.kinematics.ink_links import rigid_figure
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import dotted
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, guide, slider, turning_pair

GUIDE = 14.0
"""Half of a guide as it is shown, mm."""
LEAST = 0.3
"""What is shorter is a point, mm."""
DOT = 0.7
"""The radius of a point that a construction finds, mm."""
SIGN = 2.2
"""How far the sign of a pair reaches, mm."""


def _whole(pen: str) -> Rule:
    """Return the rule of a circle that is drawn whole."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        centre, radius = seen.arc(step.it, k)
        if finite(centre, radius) and radius > LEAST:
            yield circle(pen, centre, radius)

    return drawn


def draw_figure(on: Subject, made: Curvature, shown: LinkFigure, k: int) -> Drawing:
    """Return a construction in a position (index)."""
    seen, marks = on.seen((shown.view,), [k]), dict[Mark, Rule]()
    bresse, holding = made.bresse, made.holding
    if bresse is not None and shown is bresse.figure:
        held, results = bresse.held, [bresse.pole, bresse.rest, bresse.ball]
        marks = {bresse.inflection.arc: _whole("medium"), bresse.second.arc: _whole("dashed")}
    else:
        held = holding.held
        results = [holding.pole, *(one.centre for one in (*made.paths, *made.centres))]
    marks |= {one: dotted(DOT) for one in results if one is not None}
    manner = Manner({}, lambda seen, step: step.it in marks or usual(seen, step), marks)
    traces = figure(seen, manner)
    strokes = [*traces.staying, *_bodies(seen, shown.letters, held, k)]
    return traces.drawing(on, strokes, _letters(on, seen, k))


def _bodies(
    seen: Seen, letters: Mapping[str, Mark], held: tuple[Held, Held], k: int
) -> Iterator[Ink]:
    """The link, and what holds its points: cranks about their pivots, stones on guides."""
    spots = {letter: seen.point(mark, k) for letter, mark in letters.items()}
    if not finite(*spots.values()):
        return
    yield from body(rigid_figure([*spots.values()], "main"), "link", letters.values(), k)
    for one in held:
        at = spots[one.letter]
        if one.guide is not None:
            way = seen.line(one.guide, k)[1]
            turn = math.degrees(cmath.phase(way))
            strokes = [*guide(at - GUIDE * way, at + GUIDE * way), *slider(at, turn)]
            yield from body(strokes, "guide", [one.at], k)
        elif one.pivoted and one.centre is not None:
            centre = seen.point(one.centre, k)
            crank: list[Ink] = [line("main", centre, at), *fixed_pivot(centre)]
            yield from body(crank, "link", [one.at, one.centre], k)
        yield from body(turning_pair(at), "pair", [one.at], k)


def _letters(on: Subject, seen: Seen, k: int) -> Iterator[Wanted]:
    points = [step.it for step in seen.steps if step.it.kind is Point]
    named = [Named(seen.point(one, k), markup(one.name), (one.slot,), k) for one in points]
    yield from lettered(shared([one for one in named if finite(one.at)]), on.heights.point, SIGN)
