"""How one tooth was drawn: the tangents rolled on the base circle, the thickness laid off, the fillet.

Of the steps of the meshing those are shown that led to the flank and the fillet of this tooth.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.gears.line import VIEW
from graphic_tmm.chapters.gears.outline import (
    RULES,
    spot,
    tooth_outline,
)
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, line
from graphic_tmm.paper.figure import body, figure, showing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.mark_rules import curve, dotted, reached
from graphic_tmm.paper.seen import Rule, Seen, Subject, finite
from graphic_tmm.paper.symbols.kinematic import arrowhead

NAME = "gear-rolling"
DOT = 0.5
"""Radius of a point, mm."""
OVER = 8.0
"""How far the circles and the axis of the tooth go on, mm."""
EVERY, APART = (1, 2, 5, 10), 1.2
"""Of feet that stand too close every second, fifth … is numbered: so far apart, of the height of a number."""
HEAD = 3.0
"""Length of an arrowhead on an arc, mm."""


def draw_rolling_ink(on: Subject, made: Gear, k: int) -> Drawing:
    """Return the construction of the tooth of wheel ``k`` (0 or 1) whose flank passes the pitch point."""
    ink = _Rolling(on, made, k)
    traces = figure(ink.seen, showing(ink.rules(), RULES))
    teeth = tooth_outline(on.reading, ink.tooth, ink.centre)
    strokes = (*traces.staying, *teeth, *ink.thickness())
    roll = made.wheels[k].roll
    positions = ((n, str(n + roll.first)) for n in range(roll.count))
    return traces.drawing(on, strokes, ink.letters(on.heights), (), positions)


class _Rolling:
    """The numbers of one wheel while its tooth is inked."""

    def __init__(self, on: Subject, made: Gear, k: int) -> None:
        self.reading, self.made, self.wheel, self.k = on.reading, made, made.wheels[k], k
        own, self.tooth = self.wheel, self.wheel.teeth[1]
        self.centre, self.pole = self.at(own.circles.centre), self.at(made.line.pole)
        self.limit, self.origin = self.at(made.line.limits[k]), self.at(own.origin)
        by_mark = {step.it: step for step in on.construction.steps}
        bent = self.tooth.right.fillet
        self.bends = by_mark[bent].uses[0] if bent else None
        self.string = by_mark[own.origin].uses[2]
        self.feet = self.row(own.feet, own.roll.count)
        self.points = self.row(own.points, own.roll.count)
        self.last_bend = self.at(self.tooth.right.start)
        if self.bends:
            self.last_bend = self.row(self.bends, made.rows.fillet)[-1]
        led = _leading(by_mark, tuple(m for m in (own.flank, bent, own.axis) if m))
        led |= {self.string, own.circles.tip, own.circles.root}
        steps = tuple(step for step in on.construction.steps if step.it in led)
        log = on.construction._replace(steps=steps)
        self.seen = on._replace(construction=log).seen((VIEW,), range(made.rows.axis))

    @property
    def far(self) -> complex:
        """Where the left flank crosses the pitch circle."""
        start, middle = self.at(self.wheel.at_pitch), self.at(self.wheel.middle)
        axis = (middle - self.centre) / abs(middle - self.centre)
        return self.centre + ((start - self.centre) / axis).conjugate() * axis

    def at(self, mark: Mark) -> complex:
        return spot(self.reading, mark)

    def row(self, mark: Mark, count: int) -> list[complex]:
        return [complex(z) for z in self.reading[mark][0, :count]]

    def rules(self) -> dict[Mark, Rule]:
        """What stays: circles, rolled tangents and the involute, the normals of the fillet, the axis."""
        wheel, line_ = self.wheel, self.made.line
        dot, reach = dotted(DOT), reached(DOT)
        rules: dict[Mark, Rule] = {mark: self._circle(low, high, pen)
                                   for mark, pen, _, low, high in self.spans()}  # fmt: skip
        shown = (line_.pole, line_.limits[self.k], wheel.origin, wheel.feet)
        rules |= dict.fromkeys((*shown, wheel.at_pitch, wheel.middle), dot)
        rules |= dict.fromkeys((m for m in (wheel.points, self.bends) if m), reach)
        rules |= {self.string: self._first, wheel.flank: curve("thin"), wheel.axis: self._axis}
        return rules

    def _first(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The string through the pitch point."""
        yield line("medium", self.limit, self.pole)

    def _axis(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """The axis of the tooth."""
        _, way = seen.line(step.it, k)
        low, high = (self.radius(m) for m in (self.wheel.circles.root, self.wheel.circles.tip))
        if finite(way):
            yield line(
                "centre", self.centre + (low - OVER) * way, self.centre + (high + OVER) * way
            )

    def _circle(self, low: float, high: float, pen: str) -> Rule:
        """A circle, as far as the construction stands on it."""

        def circle_(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
            yield arc(pen, self.centre, self.radius(step.it), low, high - low)

        return circle_

    def spans(self) -> Iterator[tuple[Mark, str, str, float, float]]:
        """The circles with their pens and letters: from where to where (degrees) they are drawn."""
        own, i = self.wheel.circles, self.wheel.sizes.number
        tooth = [self.at(side.tip) for side in (self.tooth.right, self.tooth.left)]
        tooth += [self.at(self.wheel.at_pitch), self.far, self.last_bend, self.pole]
        base = [*self.feet, self.origin, self.limit]
        for mark, pen, letter, spots in (
            (own.tip, "thin", f"r_{{a{i}}}", tooth),
            (own.pitch, "centre", f"r_{{{i}}}", tooth),
            (own.base, "thin", f"r_{{b{i}}}", [*base, *tooth]),
            (own.root, "thin", f"r_{{f{i}}}", tooth),
        ):
            turns = [cmath.phase((z - self.centre) / (self.pole - self.centre)) for z in spots]
            beyond, zero = OVER / self.radius(mark), cmath.phase(self.pole - self.centre)
            low, high = zero + min(turns) - beyond, zero + max(turns) + beyond
            yield mark, pen, letter, math.degrees(low), math.degrees(high)

    def radius(self, mark: Mark) -> float:
        return float(self.reading[mark].radius[0, 0])

    def thickness(self) -> Iterator[Ink]:
        """The arc that was laid off on the pitch circle, with arrows at its ends."""
        ends = (self.at(self.wheel.at_pitch) - self.centre, self.far - self.centre)
        start, turn = cmath.phase(ends[0]), cmath.phase(ends[1] / ends[0])
        made = [arc("thin", self.centre, abs(ends[0]), math.degrees(start), math.degrees(turn))]
        for end, sense in zip(ends, (-1j, 1j), strict=True):
            made += arrowhead(self.centre + end, sense * end, pen="thin", length=HEAD)
        yield from body(made, "dimension", [self.wheel.at_pitch, self.wheel.middle])

    def letters(self, heights: Heights) -> Iterator[Wanted]:
        """The numbers of the feet, the letters of the points and of the circles."""
        point, small, wheel = heights.point, heights.number, self.wheel
        limit = self.made.line.limits[self.k]
        for mark, size, toward in (
            (self.made.line.pole, point, self.pole - self.limit),
            (limit, point, self.centre - self.limit),
            (wheel.origin, small, self.centre - self.origin),
            (wheel.at_pitch, small, 0j),
            (wheel.middle, small, 0j),
        ):
            yield Wanted(mark.letter, self.at(mark), size, 1.0, toward, (mark.slot,))
        quarter = (self.at(wheel.middle) + self.far) / 2
        of = (wheel.at_pitch.slot, wheel.middle.slot)
        yield Wanted(f"s_{{{wheel.sizes.number}}}", quarter, small, 1.0, quarter - self.centre, of)
        every = self.every(small)
        for n, (foot, end) in enumerate(zip(self.feet, self.points, strict=True)):
            if (n + wheel.roll.first) % every:
                continue
            text, toward = str(n + wheel.roll.first), foot - end + 2 * (self.centre - foot) / 3
            yield Wanted(text, foot, small, DOT, toward, (wheel.feet.slot,), n)
        for mark, _, text, low, _ in self.spans():
            end = self.centre + cmath.rect(self.radius(mark), math.radians(low))
            yield Wanted(text, end, small, 0.5, -1j * (end - self.centre), (mark.slot,))

    def every(self, height: float) -> int:
        """Every how many-th foot has room for its number."""
        steps = [abs(b - a) for a, b in pairwise(self.feet)]
        least = min((step for step in steps if step > 0.0), default=height * APART)
        return next((n for n in EVERY if n * least >= APART * height), EVERY[-1])


def _leading(by_mark: dict[Mark, Step], ends: tuple[Mark, ...]) -> set[Mark]:
    """Return the marks that led to some, and these."""
    found: set[Mark] = set()
    left = list(ends)
    while left:
        mark = left.pop()
        if mark not in found:
            found.add(mark)
            left += by_mark[mark].uses if mark in by_mark else ()
    return found
