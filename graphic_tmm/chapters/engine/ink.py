"""An engine's force triangles on the crank mechanism, and the rotating vectors of its inertia force."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

from graphic_tmm.board.operations.instruments import lay_off, measure_along
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.engine.plan import Engine
from graphic_tmm.chapters.engine.task import HARMONICS, VIEW
from graphic_tmm.chapters.forces.ink_polygons import LEAST
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import straight
from graphic_tmm.paper.rules import drawn_line, segment
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, pole, slider, turning_pair

REACH = 8.0
"""How far the axis of the rotating vectors goes on behind them, mm."""


class _Force:
    """A vector of a force: its step, its ends, its letter."""

    def __init__(self, step: Step, start: Mark, end: Mark, letter: str) -> None:
        self.step, self.start, self.end, self.letter = step, start, end, letter


def draw_triangles(on: Subject, made: Engine, pivot: Mark, index: int, mu: float) -> Drawing:
    """Return the mechanism of one position with the triangles P′ = Q + N at B and Q = K + T at A.

    ``mu``: of the forces, N/mm.
    """
    seen = on.seen((VIEW,), (index,))
    forces, t = _forces(seen, made), made.triangles
    o, a, b = (seen.point(mark, index) for mark in (pivot, t.at_a, t.at_b))
    traces = figure(seen, _manner(seen, forces, mu, made.order.unit))
    way = seen.line(made.guide, 0)[1]
    angle = math.degrees(cmath.phase(way))
    strokes = [
        *body(segment("thin", o, a), "link", [pivot, t.at_a], index),
        *body(segment("thin", a, b), "link", [t.at_a, t.at_b], index),
        *body(fixed_pivot(o), "pivot", [pivot]),
        *body(slider(b, angle, pin=False), "guide", [t.at_b], index),
        *body([*turning_pair(a)], "pair", [t.at_a], index),
        *body([*turning_pair(b)], "pair", [t.at_b], index),
        *traces.staying,
    ]
    pins = ((pivot, o, 0j), (t.at_a, a, a - o), (t.at_b, b, 1j * way))
    wanted = [
        Wanted(markup(mark.letter), spot, on.heights.point, 2.2, toward, (mark.slot,), index)
        for mark, spot, toward in pins
        if finite(spot)
    ]
    wanted += _vector_names(seen, forces, index, on.heights.number)
    return traces.drawing(on, strokes, wanted)._replace(position=index)


def _vector_names(
    seen: Seen, forces: dict[Mark, _Force], index: int, size: float
) -> Iterator[Wanted]:
    """The letters of the vectors, outside their triangles: each nearer to its own than to another."""
    ends = {
        mark: (seen.point(one.start, index), seen.point(one.end, index))
        for mark, one in forces.items()
    }
    there = {
        mark: (start, end)
        for mark, (start, end) in ends.items()
        if finite(start, end) and abs(end - start) >= LEAST
    }
    for mark, own in there.items():
        force = forces[mark]
        others = tuple(line for other, line in there.items() if other != mark)
        letter = f"\\bar{{{force.letter[0]}}}{force.letter[1:]}"
        middle, of = sum(own) / 2, (force.step.it.slot,)
        out = outwards(own, others)
        yield Wanted(letter, middle, size, 0.8, out, of, index, own, others)


def outwards(own: tuple[complex, complex], others: Sequence[tuple[complex, complex]]) -> complex:
    """Return the way square to a vector off the others that share an end with it; else to its left."""
    left = 1j * (own[1] - own[0])
    joined = [z for line in others if _meet(own, line) for z in line]
    aside = sum(((z - own[0]) * left.conjugate()).real for z in joined)
    return -left if aside > 1e-9 * abs(left) else left


def _meet(one: tuple[complex, complex], other: tuple[complex, complex]) -> bool:
    return any(abs(a - b) < LEAST for a in one for b in other)


def _forces(seen: Seen, made: Engine) -> dict[Mark, _Force]:
    """Return the vectors by the mark of the step that laid them off or measured them."""
    t = made.triangles
    ends = {t.end_p: (t.at_b, "P′"), t.end_qa: (t.at_a, "Q")}
    found = {
        mark: _Force(seen.by_mark[mark], start, mark, letter)
        for mark, (start, letter) in ends.items()
    }
    measured: dict[tuple[Mark, ...], str] = {
        (t.end_q, t.end_p): "N",
        (t.at_b, t.end_q): "Q",
        (t.at_a, t.end_t): "T",
        (t.end_t, t.end_qa): "K",
    }
    for step in seen.steps:
        letter = measured.get(step.uses[:2]) if step.op is measure_along else None
        if letter is not None:
            found[step.it] = _Force(step, step.uses[0], step.uses[1], letter)
    return found


def _manner(seen: Seen, forces: dict[Mark, _Force], mu: float, unit: str) -> Manner:
    """Return how the triangles are inked: as vectors; the lines that they were found by do not stay."""

    def vector(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        one = forces[step.it]
        start, end = seen.point(one.start, k), seen.point(one.end, k)
        if finite(start, end) and abs(end - start) >= LEAST:
            yield from told_arrow(start, end, "over", one.letter, mu, unit)

    rules = {lay_off.name: vector, measure_along.name: vector}
    return Manner(rules, lambda _, step: step.it in forces)


def draw_rotating(on: Subject, made: Engine, index: int, mu: float) -> Drawing:
    """Return the rotating vectors of first and second order in one position with their projections.

    ``mu``: of the forces, N/mm.
    """
    seen, found, heights = on.seen((HARMONICS,), (index,)), made.harmonics, on.heights
    centre = seen.point(found.origin, index)
    ends = [seen.point(mark, index) for mark in found.ends]
    traces = figure(seen, _turning(seen, made, index, mu))
    strokes = [*traces.staying, *body(pole(centre), "pole", [found.origin])]
    for mark, end in zip(found.ends, ends, strict=True):
        if finite(end) and abs(end - centre) >= LEAST:
            strokes += body([circle("thin", centre, abs(end - centre))], "path", [mark])
    wanted = [Wanted("O", centre, heights.point, 1.2, -1j, (found.origin.slot,))]
    for mark, end, letter in zip(found.ends, ends, ("m·ω^{2}·R", "m·ω^{2}·R·λ"), strict=True):
        if finite(end) and abs(end - centre) >= LEAST:
            toward, of = end - centre, (mark.slot,)
            wanted.append(Wanted(letter, end, heights.number, 1.0, toward, of, index))
    orders = dict(zip(found.ends, ("I", "II"), strict=True))
    feet = [
        Named(_foot(seen, step, index), orders[step.uses[1]], (step.it.slot,), index)
        for step in seen.steps
        if step.op is measure_along
    ]
    feet = [one for one in shared(feet) if abs(one.at - centre) >= LEAST]
    wanted += [one._replace(toward=-1j) for one in lettered(feet, heights.number)]
    return traces.drawing(on, strokes, wanted)


def _foot(seen: Seen, step: Step, k: int) -> complex:
    """Return the projection of what was measured along an axis."""
    start, end = (seen.point(mark, k) for mark in step.uses[:2])
    _, along = seen.line(step.uses[2], k)
    return start + along * ((end - start) * along.conjugate()).real


def _turning(seen: Seen, made: Engine, index: int, mu: float) -> Manner:
    """Return how the rotating vectors are inked: with the perpendiculars to the axis that project them."""
    found = made.harmonics
    centre = seen.point(found.origin, index)
    ends = [abs(seen.point(mark, index) - centre) for mark in found.ends]
    reach = max((size for size in ends if finite(size)), default=0.0) + REACH

    def vector(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        end = seen.point(step.it, k)
        if finite(end) and abs(end - centre) >= LEAST:
            yield from told_arrow(centre, end, "main", step.it.name, mu, "N")

    def projected(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield from segment("thin", seen.point(step.uses[1], k), _foot(seen, step, k))

    def stays(_: Seen, step: Step) -> bool:
        return step.it == found.axis or step.op in (lay_off, measure_along)

    at, along = seen.line(found.axis, index)
    axis = straight("centre", at - along * reach, at + along * reach)
    rules: dict[str, Rule] = {s.op.name: drawn_line for s in seen.steps if s.it.kind is Line}
    rules |= {lay_off.name: vector, measure_along.name: projected}
    return Manner(rules, stays, {found.axis: axis})
