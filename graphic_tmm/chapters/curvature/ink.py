"""The constructions of curvature in ink, in one position."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.curvature.bobillier import Holding
from graphic_tmm.chapters.curvature.link_figure import Held, LinkFigure
from graphic_tmm.chapters.curvature.record import Curvature
from graphic_tmm.chapters.kinematics.ink_links import rigid_figure
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import dotted
from graphic_tmm.paper.rules import stays as usual
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, guide, slider, turning_pair

GUIDE, TANGENT = 14.0, 24.0
"""Half of a guide and of the tangent of the centrodes as they are shown, mm."""
RADII, SMALL = (15.0, 19.0), 2.0
"""Of the arcs that show equal angles, mm; a smaller angle is not shown, degrees."""
LEAST, DOT, SIGN = 0.3, 0.7, 2.2
"""A circle that is a point, the radius of a point that is found, how far the sign of a pair reaches, mm."""


def _whole(pen: str) -> Rule:
    """Return the rule of a circle that is drawn whole."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        centre, radius = seen.arc(step.it, k)
        if finite(centre, radius) and radius > LEAST:
            yield circle(pen, centre, radius)

    return drawn


def _through(half: float) -> Rule:
    """Return the rule of a line that is shown about where it begins; ``half``: of its length, mm."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        at, along = seen.line(step.it, k)
        if finite(at, along):
            yield line("thin", at - half * along, at + half * along)

    return drawn


def draw_figure(on: Subject, made: Curvature, shown: LinkFigure, k: int) -> Drawing:
    """Return a construction in a position (index)."""
    seen, holding = on.seen((shown.view,), [k]), made.holding
    pens = zip(shown.circles, ("medium", "dashed"), strict=False)
    marks = {one.arc: _whole(pen) for one, pen in pens}
    marks |= {mark: dotted(DOT) for mark in shown.results}
    angles: list[tuple[float, float]] = []
    if shown is made.figure:
        marks |= {one: dotted(DOT) for one in made.centres}
        marks[holding.tangent] = _through(TANGENT)
        angles = [*_equal(seen, holding, k)]
    manner = Manner({}, lambda seen, step: step.it in marks or usual(seen, step), marks)
    traces, pole = figure(seen, manner), seen.point(holding.pole, k)
    strokes = [*traces.staying, *_bodies(seen, shown.letters, shown.held, k)]
    wanted, of = [*_letters(on, seen, k)], (holding.tangent.slot,)
    for radius, (start, sweep) in zip(RADII, angles, strict=False):
        way = cmath.rect(1.0, math.radians(start + sweep / 2.0))
        bow = [arc("thin", pole, radius, start, sweep)]
        strokes += body(bow, "angle", [holding.tangent], k)
        at = pole + radius * way
        wanted.append(Wanted("δ", at, on.heights.number, 0.5, way, of, k))
    if angles:
        at, along = seen.line(holding.tangent, k)
        wanted.append(Wanted("t", at + TANGENT * along, on.heights.point, 0.5, along, of, k))
    return traces.drawing(on, strokes, wanted)


def _equal(seen: Seen, holding: Holding, k: int) -> Iterator[tuple[float, float]]:
    """Yield the equal angles of Bobillier, where each begins and how far it goes, degrees."""
    pole, (a, b) = seen.point(holding.pole, k), holding.held
    first, second = (seen.point(one.at, k) - pole for one in (a, b))
    axis, tangent = (seen.line(one, k)[1] for one in (holding.axis, holding.tangent))
    for start, end in ((first, axis), (second, tangent)):
        if finite(start, end) and 0 not in (start, end):
            turn = math.degrees(cmath.phase(end / start))
            turn -= 180.0 * round(turn / 180.0)
            if abs(turn) >= SMALL:
                yield math.degrees(cmath.phase(start)), turn


def _bodies(seen: Seen, letters: Mapping[str, Mark], held: Sequence[Held], k: int) -> Iterator[Ink]:
    """The link, and what holds its points: cranks about their pivots, stones on guides."""
    spots = {letter: seen.point(mark, k) for letter, mark in letters.items()}
    if not finite(*spots.values()):
        return
    yield from body(rigid_figure([*spots.values()], "main"), "link", letters.values(), k)
    for letter in sorted(letters.keys() - {one.point for one in held}):
        dot = [circle("main", spots[letter], DOT, filled=True)]
        yield from body(dot, "point", [letters[letter]], k)
    for one in held:
        at = spots[one.point]
        if one.guide is not None:
            way = seen.line(one.guide, k)[1]
            turn = math.degrees(cmath.phase(way))
            strokes = [*guide(at - GUIDE * way, at + GUIDE * way), *slider(at, turn)]
            yield from body(strokes, "guide", [one.at], k)
        elif one.pivot is not None and one.centre is not None:
            centre = seen.point(one.centre, k)
            crank: list[Ink] = [line("main", centre, at), *fixed_pivot(centre)]
            yield from body(crank, "link", [one.at, one.centre], k)
        yield from body(turning_pair(at), "pair", [one.at], k)


def _letters(on: Subject, seen: Seen, k: int) -> Iterator[Wanted]:
    points = [step.it for step in seen.steps if step.it.kind is Point]
    named = [Named(seen.point(one, k), markup(one.name), (one.slot,), k) for one in points]
    yield from lettered(shared([one for one in named if finite(one.at)]), on.heights.point, SIGN)
