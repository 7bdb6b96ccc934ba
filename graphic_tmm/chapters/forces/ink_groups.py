"""A detached group in ink: its links in one position, loads at their points to scale, arms, reactions.

Loads are drawn to the scale of the group's polygon; what is not known yet, the reactions of the outer pairs,
only by direction.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Construction, Figure, Mark, Step
from graphic_tmm.board.values import Line
from graphic_tmm.chapters.forces.ink_polygons import LEAST, bar, spot
from graphic_tmm.chapters.forces.loads import VIEW, Couple, Force
from graphic_tmm.chapters.kinematics.ink_positions import HEAVY, PositionsInk
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.symbols.arrows import arrow, told_arrow
from graphic_tmm.paper.symbols.kinematic import round_arrow

SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
SHOWN = 18.0
"""Length of the arrow of a reaction that is not known yet, mm."""
ROUND = 9.0
"""Radius of the arrow of a couple, mm."""
NEARLY = 0.985
"""Arrows from one point whose directions agree so far (cosine) would lie on each other."""
MARGIN = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


class Reactive(NamedTuple):
    """A reaction to be found: its letter, the point where it acts, its vector on the polygon."""

    letter: str
    at: Mark
    tail: Mark
    head: Mark


class Detached(NamedTuple):
    """What a figure shows: its links, forces and couples on them, reactions, the scale of its forces (N/mm).

    ``circles``: friction circles, their pins and radii (m).
    """

    links: tuple[int, ...]
    forces: Sequence[Force]
    couples: Sequence[Couple]
    reactions: Sequence[Reactive]
    mu: float
    circles: Sequence[tuple[Mark, Mark]] = ()


def draw_group(
    construction: Construction,
    reading: Reading,
    reaches: Mapping[Figure, Reach],
    shown: Detached,
    index: int,
    name: str,
    title: str,
    mu_l: Mark,
    language: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return a detached group, or the driving link, in one position.

    ``language``: of the sheet.
    """
    ink = PositionsInk(construction, reading, reaches, [index])
    links = [str(number) for number in shown.links]
    strokes: list[Stroke | Bezier] = []
    for link in links:
        strokes += ink.lines(link, index, HEAVY)
    strokes += ink.symbols(links, index)
    drawing = _Loads(reading, index, shown.mu, language)
    for force in shown.forces:
        drawing.force(force)
    for reaction in shown.reactions:
        drawing.reaction(reaction)
    for couple in shown.couples:
        drawing.couple(couple, _middle(ink, couple, index))
    drawing.arms(construction, shown.forces)
    for pin, radius in shown.circles:
        rho = float(reading[radius][0, 0]) / float(reading[mu_l][0, 0])
        strokes.append(circle("thin", spot(reading, pin, index), rho))
    strokes += drawing.strokes
    wanted = [*ink.letters(links, index), *drawing.wanted]
    if not lettered:
        spots = [z for stroke in strokes if isinstance(stroke, Stroke) for z in _ends(stroke)]
        x, y = [z.real for z in spots], [z.imag for z in spots]
        cell = (min(x) - MARGIN, min(y) - MARGIN, max(x) + MARGIN, max(y) + MARGIN)
        return Drawing(name, title, cell=cell)
    smaller = [one._replace(size=SIZE) for one in wanted]
    labels = place(smaller, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(smaller, labels)], labels), labels)


def _ends(stroke: Stroke) -> Iterable[complex]:
    return (complex(x, y) for x, y, _ in stroke.path)


def _middle(ink: PositionsInk, couple: Couple, index: int) -> complex:
    """Return about where a couple is drawn: in the middle of its link, off its pins."""
    name = str(couple.link)
    pins = [*ink.spots(name, index), *(bar.foot for bar in ink.bars(name, index))]
    if len(pins) < 2:
        return pins[0] if pins else 0j
    far = max(((a, b) for a in pins for b in pins), key=lambda ends: abs(ends[1] - ends[0]))
    return far[0] + 0.5 * (far[1] - far[0])


class _Loads:
    """Arrows and arms while they are drawn; arrows from one point do not lie on each other."""

    def __init__(self, reading: Reading, index: int, mu: float, language: str) -> None:
        self.reading, self.index, self.mu, self.language = reading, index, mu, language
        self.strokes: list[Stroke] = []
        self.wanted: list[Wanted] = []
        self.taken: list[tuple[complex, complex]] = []

    def line_of(self, mark: Mark) -> tuple[complex, complex]:
        value: Line = self.reading[mark]
        at, along = (complex(p[0, self.index if p.shape[1] > 1 else 0]) for p in value)
        return at, along

    def named(self, letter: str) -> str:
        """Return what a letter of the log is called in the language of the sheet."""
        return symbol(letter, self.language)

    def free(self, at: complex, way: complex) -> bool:
        """Whether no arrow goes from a place in that direction yet."""
        return not any(
            abs(z - at) < LEAST and (way * d.conjugate()).real > NEARLY for z, d in self.taken
        )

    def put(self, at: complex, vector: complex, letter: str, pen: str, *, told: bool) -> None:
        """Draw an arrow from its point, or to it where another goes there already."""
        if not abs(vector) >= LEAST:
            return
        way = vector / abs(vector)
        start = at
        if not self.free(at, way) and self.free(at, -way):
            start = at - vector
        self.taken.append((at, way if start == at else -way))
        if told:
            self.strokes += told_arrow(start, start + vector, pen, letter, self.mu, "N")
        else:
            self.strokes += arrow(start, start + vector, pen)
        end = start + vector if start == at else start
        self.wanted.append(Wanted(bar(self.named(letter)), end, SIZE, 1.5, end - at))

    def force(self, force: Force) -> None:
        """A load, to scale, at its point."""
        at, along = self.line_of(force.line)
        value = spot(self.reading, force.value, self.index).real
        self.put(at, along * value / self.mu, force.letter, "over", told=True)

    def reaction(self, reaction: Reactive) -> None:
        """A reaction by its direction only."""
        tail, head = (spot(self.reading, m, self.index) for m in (reaction.tail, reaction.head))
        if abs(head - tail) >= LEAST:
            way = (head - tail) / abs(head - tail) * SHOWN
            at = spot(self.reading, reaction.at, self.index)
            self.put(at, way, reaction.letter, "thin", told=False)

    def couple(self, couple: Couple, at: complex) -> None:
        """A couple as a round arrow."""
        value = spot(self.reading, couple.value, self.index).real
        if not math.isfinite(value) or value == 0.0:
            return
        sweep = math.copysign(210.0, value)
        self.strokes += round_arrow(at, ROUND, 120.0 if value > 0 else 60.0, sweep)
        top = at + ROUND * 1j
        self.wanted.append(Wanted(markup(self.named(couple.letter)), top, SIZE, 2.0, 1j))

    def displaced(self, centre: Mark, step: Step) -> None:
        """How far a force that stands for a force and a couple lies off the mass centre."""
        a, b = spot(self.reading, centre, self.index), spot(self.reading, step.it, self.index)
        if abs(b - a) >= LEAST:
            self.strokes.append(line("thin", a, b))
            letter = markup(self.named(step.uses[1].name))
            self.wanted.append(Wanted(letter, (a + b) / 2, 2.5, 0.8, 1j * (b - a)))

    def arms(self, construction: Construction, forces: Sequence[Force]) -> None:
        """The arms that were measured about the group's point, with the lines of action drawn on to them."""
        lines = {force.line for force in forces}
        points = {force.point for force in forces if force.image is None}
        steps = {step.it: step for step in construction.steps}
        for step in construction.steps:
            if step.it in points and step.it.view == VIEW:
                self.displaced(steps[step.uses[0]].uses[0], step)
            if step.op is not arm or step.uses[1] not in lines:
                continue
            about = spot(self.reading, step.uses[0], self.index)
            at, along = self.line_of(step.uses[1])
            reach = ((about - at) * along.conjugate()).real
            foot = at + reach * along
            if not abs(foot - about) >= 2.0 or along == 0:  # also where it is not there
                continue
            further = foot + along * math.copysign(3.0, reach)
            self.strokes.append(line("thin", at, further))
            self.strokes.append(line("thin", about, foot))
            letter = markup(self.named(step.it.name))
            middle = (about + foot) / 2
            self.wanted.append(Wanted(letter, middle, 2.5, 0.8, 1j * (foot - about)))
