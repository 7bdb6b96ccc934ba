"""Zhukovsky's lever in ink: the turned plan with all its points, forces at their images, couples, arms.

The plan, the lines of action and the arms are to scale; the arrows of forces are not.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from graphic_tmm.board.operations.instruments import parallel, square
from graphic_tmm.board.operations.statics import arm, carry
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.forces.ink_arrows import (
    LEAST,
    Arrows,
    ArrowText,
    action,
    arm_shows,
    drawn_arm,
    drawn_on,
    length_of,
    pricks,
    turning,
)
from graphic_tmm.chapters.forces.ink_polygons import bar
from graphic_tmm.chapters.forces.lever import Carried, Lever
from graphic_tmm.chapters.forces.tool import Tool
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.arithmetic import larger, smaller
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import pole

TOGETHER = 1.0
"""Arms whose feet are nearer than this, mm, lie on one another, and share a letter."""


def draw_lever_ink(
    on: Subject,
    lever: Lever,
    index: int,
    decimals: int,
    helping: bool = True,
    tool: Tool | None = None,
) -> Drawing:
    """Return the lever in one position, with the force at a ``tool`` if that balances it.

    ``decimals``: to how many the ruler tells a length. Not ``helping``: without what is rubbed out.
    """
    seen = on.seen((lever.pole.view,), [index])
    carried = (*lever.forces, *([tool.carried] if tool else []))
    lines = {force.line for force in carried}
    rules = {carry.name: _ray, parallel.name: drawn_on, square.name: drawn_on, arm.name: drawn_arm}

    def stays(seen: Seen, step: Step) -> bool:
        return step.it.kind is Point or arm_shows(seen, step, index)

    traces = figure(seen, Manner(rules, stays), helping=helping)
    ink = _Loads(seen, lever, index, on, carried)
    for force, arm_ in zip(carried, ink.measured(carried), strict=True):
        _, along = seen.line(force.line, index)
        own = (force.point.slot, force.line.slot, force.value.slot)
        pen = "rod" if tool and force is tool.carried else "over"
        ink.force(force.letter, force.point, along, force.value, own, arm_, pen)
    way = seen.point(lever.pin, index) - seen.point(lever.pole, index)
    if tool is None and abs(way) >= LEAST:  # it acts square to the segment of the crank pin
        of, at = (lever.pin.slot, lever.force.slot), 1j * way / abs(way)
        ink.force(lever.force.name, lever.pin, at, lever.force, of, lever.segment, "rod")
    ink.couples()
    sides = _sides(seen, lever, index)
    strokes = (*traces.staying, *sides, *ink.arrows.strokes)
    strokes += tuple(body(pole(seen.point(lever.pole, index)), "pole", [lever.pole]))
    if helping:
        traces.rubbed += pricks(seen, (*strokes, *traces.rubbed), index)
    letters = _letters(seen, lever, index, on.heights)
    wanted = (*letters, *ink.arrows.wanted, *ink.arms(lines, decimals))
    return traces.drawing(on, strokes, wanted)._replace(position=index)


def _ray(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
    """The vector from the pole to an image."""
    a, b = seen.point(step.uses[0], k), seen.point(step.it, k)
    if finite(a, b) and abs(b - a) >= LEAST:
        yield line("medium", a, b)


def _sides(seen: Seen, lever: Lever, k: int) -> Iterator[Ink]:
    """The images of the links: lines between the images of each."""
    at_pole, done = seen.point(lever.pole, k), set[frozenset[Mark]]()
    for marks in lever.images.values():
        for pair in combinations(marks, 2):
            ends = [seen.point(mark, k) for mark in pair]
            apart = [abs(ends[0] - ends[1]), *(abs(z - at_pole) for z in ends)]
            if frozenset(pair) not in done and smaller(*apart) >= LEAST:
                yield from body([line("medium", *ends)], "link", pair, k)
            done.add(frozenset(pair))


def _letters(seen: Seen, lever: Lever, k: int, high: Heights) -> list[Wanted]:
    marks = [lever.pole, *(step.it for step in seen.steps if step.op is carry)]
    named = [Named(seen.point(m, k), markup(m.name), (m.slot,), k) for m in marks]
    return lettered(shared(named), high.point, away_from=seen.point(lever.pole, k))


class _Loads:
    """What acts on the lever in one position while it is drawn."""

    def __init__(
        self, seen: Seen, lever: Lever, index: int, on: Subject, carried: tuple[Carried, ...]
    ) -> None:
        self.seen, self.lever, self.index = seen, lever, index
        self.language, self.high = on.language, on.heights
        self.arrows = Arrows(index, on.heights.point)
        sizes = [seen.number(mark, index) for mark in (*(f.value for f in carried), lever.force)]
        self.largest = larger(0.0, *(abs(size) for size in sizes if finite(size)))

    def force(
        self,
        letter: str,
        point: Mark,
        along: complex,
        value: Mark,
        of: tuple[int, ...],
        arm: Mark,
        pen: str = "over",
    ) -> None:
        """An arrow at its image."""
        size = self.seen.number(value, self.index)
        arms = turning(self.seen.number(arm, self.index), size)
        told = ArrowText(letter, abs(size), "N", of, arms)
        way = -along if size < 0 else along
        called = bar(symbol(letter, self.language))
        at, length = self.seen.point(point, self.index), length_of(size, self.largest)
        self.arrows.put(at, way, length, called, told, pen)

    def measured(self, carried: tuple[Carried, ...]) -> list[Mark]:
        """Return the arms of the forces, in their order."""
        arms = {step.uses[1]: step.it for step in self.seen.steps if step.op is arm}
        return [arms[force.line] for force in carried]

    def couples(self) -> None:
        """The converted couples, each at the segment by which it was converted."""
        segments: dict[tuple[Mark, Mark], list[tuple[str, ArrowText]]] = {}
        for one in self.lever.couples:
            value = self.seen.number(one.value, self.index)
            told = ArrowText(one.letter, value, "N·mm", (one.value.slot,))
            called = markup(symbol(one.letter, self.language))
            segments.setdefault(one.ends, []).append((called, told))
        for ends, found in segments.items():
            start, end = (self.seen.point(mark, self.index) for mark in ends)
            self.arrows.couples(start, end, found)

    def arms(self, lines: set[Mark], decimals: int) -> Iterator[Wanted]:
        """The letters and the mm of the arms; those on one another share a line of lettering."""
        feet: list[tuple[complex, complex, list[Step]]] = []
        for step in self.seen.steps:
            if step.op is not arm or step.uses[1] not in lines:
                continue
            if not arm_shows(self.seen, step, self.index):
                continue
            about, _, foot = action(self.seen, step, self.index)
            near = next((steps for _, z, steps in feet if abs(z - foot) < TOGETHER), None)
            if near is None:
                feet.append((about, foot, [step]))
            else:
                near.append(step)
        for about, foot, steps in feet:
            names = [markup(symbol(step.it.name, self.language)) for step in steps]
            mm = abs(self.seen.number(steps[0].it, self.index))
            text = " = ".join([*names, fixed(mm, decimals, self.language)])
            of = tuple(step.it.slot for step in steps)
            at, way = (about + foot) / 2, 1j * (foot - about)
            yield Wanted(text, at, self.high.number, 0.8, way, of, self.index)
