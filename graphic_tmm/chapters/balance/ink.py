"""The balance of a mechanism in ink: the polar diagram, the mechanism with its counterweights."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.balance.counterweights import Weight
from graphic_tmm.chapters.balance.plan import Balance
from graphic_tmm.chapters.balance.task import FORCE
from graphic_tmm.chapters.forces.detached import Side
from graphic_tmm.chapters.forces.ink_polygons import LEAST, bar
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.mark_rules import curve
from graphic_tmm.paper.rules import laid_off, segment
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import told_arrow
from graphic_tmm.paper.symbols.kinematic import pole

DOT = 0.6
"""The radius of the dot at the end of a shaking force, mm."""
WEIGHT = 2.4
"""The radius of the sign of a counterweight, mm."""
SMALL = 3.0
"""A polar diagram that reaches no farther from its pole is a point, mm: its caption tells what is left."""
PENS = ("main", "dashed")
"""The hodographs without and with counterweights."""


def _ray(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The shaking force as measured, thin from the pole."""
    yield from segment("thin", *(seen.point(end, k) for end in step.uses))


def draw_polar(
    on: Subject, made: Balance, names: Sequence[str], places: Sequence[int], at: int
) -> Drawing:
    """Return the polar diagram; ``places``: the positions (indices) that are drawn.

    ``at``: the position (index) whose polygon stays.
    """
    seen = on.seen((FORCE,), places)
    heads = {head: letter for letter, _, head in made.sides}
    mu = seen.fixed_number(made.mu)

    def side(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """A side of the polygon: an arrow in the position that stays."""
        if k != at or step.it not in heads:
            return
        start, end = seen.line(step.uses[0], k)[0], seen.point(step.it, k)
        if finite(start, end) and abs(end - start) >= LEAST:
            yield from told_arrow(start, end, "medium", heads[step.it], mu, "N")

    marks: dict[Mark, Rule] = {}
    for one, pen in zip(made.wholes, PENS, strict=False):
        marks |= {one.length: _ray, one.curve: curve(pen)}
    stays = {*marks, *heads}
    manner = Manner({lay_off.name: side}, lambda seen, step: step.it in stays, marks)
    traces = figure(seen, manner)
    traces.rubbed += tuple(_rubbed_sides(seen, heads, at))
    strokes = [*traces.staying, *body(pole(0j), "pole", [made.pole])]
    return traces.drawing(on, strokes, _letters(on, made, seen, names, at))


def _rubbed_sides(seen: Seen, heads: Mapping[Mark, str], at: int) -> Iterator[Ink]:
    """The sides of the polygons in all other positions: rubbed out once their ends are joined to the pole."""
    for step in seen.steps:
        for k in seen.positions if step.it in heads else ():
            if k != at:
                for stroke in laid_off(seen, step, k):
                    yield stroke._replace(of=(step.it.slot,), position=k)


def _letters(
    on: Subject, made: Balance, seen: Seen, names: Sequence[str], at: int
) -> Iterator[Wanted]:
    high = on.heights
    for k, one in enumerate(made.wholes):
        if seen.fixed_number(one.top) < SMALL:
            continue  # the diagram has shrunk to a point: there is nothing to number
        spots = [
            Named(seen.point(one.end, p), f"{names[p]}{'′' * k}", (one.length.slot,), p)
            for p in seen.positions
        ]
        yield from lettered(shared(spots, LEAST), high.number, away_from=0j)
    yield Wanted("o", 0j, high.point, 1.0, of=(made.pole.slot,))
    yield from _side_letters(on, seen, made.sides, at)


def _side_letters(on: Subject, seen: Seen, sides: Sequence[Side], k: int) -> Iterator[Wanted]:
    for letter, tail, head in sides:
        a, b = seen.point(tail, k), seen.point(head, k)
        if finite(a, b) and abs(b - a) >= LEAST:
            out, text = 1j * (b - a) / abs(b - a), bar(symbol(letter, on.language))
            at = (a + b) / 2
            yield Wanted(text, at, on.heights.point, 1.0, out, (head.slot,), position=k)


def weight_strokes(seen: Seen, weights: Sequence[Weight], k: int) -> Iterator[Ink]:
    """Yield the counterweights in a position: each a filled circle, and the arm from its pivot."""
    for one in weights:
        pivot, at = seen.point(one.pivot, k), seen.point(one.at, k)
        if finite(pivot, at) and seen.number(one.mass, k) > 0.0:
            strokes = [line("main", pivot, at), circle("main", at, WEIGHT, filled=True)]
            yield from body(strokes, "counterweight", [one.pivot, one.at], k)


def weight_letters(on: Subject, seen: Seen, weights: Sequence[Weight], k: int) -> Iterator[Wanted]:
    """Yield the letters of the counterweights in a position."""
    for one in weights:
        at = seen.point(one.at, k)
        if finite(at) and seen.number(one.mass, k) > 0.0:
            text = markup(one.at.letter)
            yield Wanted(text, at, on.heights.point, WEIGHT, of=(one.at.slot,), position=k)


def pull_letters(on: Subject, seen: Seen, made: Balance, k: int) -> Iterator[Wanted]:
    """Yield the letters of the inertia forces at the points that they act at, in a position."""
    for one in made.pulls:
        at, _ = seen.line(one.line, k)
        if finite(at):
            text = bar(symbol(one.letter, on.language))
            yield Wanted(text, at, on.heights.point, 1.0, of=(one.line.slot,), position=k)
