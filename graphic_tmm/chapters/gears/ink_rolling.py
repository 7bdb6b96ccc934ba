"""How one tooth was drawn: the tangents rolled on the base circle, the thickness laid off, the fillet."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.chapters.gears.outline import controls, spot, tooth_outline
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, arc, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.symbols.kinematic import arrowhead

NAME = "gear-rolling"
DOT = 0.5
"""Radius of a point, mm."""
OVER = 8.0
"""How far the circles and the axis of the tooth go on, mm."""
HEAD = 3.0
"""Length of an arrowhead on an arc, mm."""
SIZE, NUMBER, SMALL = 5.0, 3.5, 2.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
ROOM = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


def draw_rolling_ink(
    construction: Construction,
    reading: Reading,
    made: Gear,
    k: int,
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the construction of the tooth of wheel ``k`` (0 or 1) whose flank passes the pitch point."""
    name = f"{NAME}-{k + 1}"
    ink = _Rolling(construction, reading, made, k)
    strokes: list[Stroke | Bezier] = [*ink.circles(), *ink.tangents(), *ink.fillet()]
    strokes += [
        *ink.axis(),
        *ink.thickness(),
        *tooth_outline(reading, ink.tooth, ink.centre),
        *ink.dots(),
    ]
    if not lettered:
        left, low, right, top = bounds(Drawing(name, title, tuple(strokes)))
        cell = (left - ROOM, low - ROOM, right + ROOM, top + ROOM)
        return Drawing(name, title, tuple(strokes), cell=cell)
    wanted = list(ink.letters())
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


class _Rolling:
    """The numbers of one wheel while its tooth is inked."""

    def __init__(self, construction: Construction, reading: Reading, made: Gear, k: int) -> None:
        self.reading, self.made, self.wheel, self.k = reading, made, made.wheels[k], k
        own, self.tooth = self.wheel, self.wheel.teeth[1]
        self.centre, self.pole = self.at(own.circles.centre), self.at(made.line.pole)
        self.limit, self.origin = self.at(made.line.limits[k]), self.at(own.origin)
        self.feet = self.row(own.feet, own.roll.count)
        self.points = self.row(own.points, own.roll.count)
        fillet = construction.step(self.tooth.right.fillet)
        assert fillet is not None
        bends = construction.step(fillet.uses[0])
        assert bends is not None
        assert bends.op is lay_off
        self.bends = self.row(bends.it, made.rows.fillet)
        self.touching = [complex(z) for z in reading[bends.uses[0]].at[0, : made.rows.fillet]]

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

    def spans(self) -> Iterator[tuple[Mark, str, str, float, float]]:
        """The circles with their pens and letters: from where to where (degrees) they are drawn."""
        own, i = self.wheel.circles, self.wheel.sizes.number
        tooth = [self.at(side.tip) for side in (self.tooth.right, self.tooth.left)]
        tooth += [self.at(self.wheel.at_pitch), self.far, self.bends[-1], self.pole]
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

    def circles(self) -> Iterator[Stroke]:
        """The circles, as far as the construction stands on them."""
        for mark, pen, _, low, high in self.spans():
            yield arc(pen, self.centre, self.radius(mark), low, high - low)

    def tangents(self) -> Iterator[Stroke | Bezier]:
        """The tangents from their feet to the involute, that through the pitch point, the whole curve."""
        for foot, end in zip(self.feet, self.points, strict=True):
            if abs(end - foot) > DOT:
                yield line("thin", foot, end)
        yield line("medium", self.limit, self.pole)
        whole = controls(self.reading, self.wheel.flank)
        if whole:
            yield Bezier("thin", whole, self.wheel.flank.name)

    def fillet(self) -> Iterator[Stroke]:
        """The normals from where the rack's pitch line touches to the fillet."""
        for foot, end in zip(self.touching, self.bends, strict=True):
            if abs(end - foot) > DOT:
                yield line("thin", foot, end)

    def axis(self) -> Iterator[Stroke]:
        """The axis of the tooth."""
        middle = self.at(self.wheel.middle)
        way = (middle - self.centre) / abs(middle - self.centre)
        low, high = (self.radius(m) for m in (self.wheel.circles.root, self.wheel.circles.tip))
        yield line("centre", self.centre + (low - OVER) * way, self.centre + (high + OVER) * way)

    def thickness(self) -> Iterator[Stroke]:
        """The arc that was laid off on the pitch circle, with arrows at its ends."""
        ends = (self.at(self.wheel.at_pitch) - self.centre, self.far - self.centre)
        start, turn = cmath.phase(ends[0]), cmath.phase(ends[1] / ends[0])
        yield arc("thin", self.centre, abs(ends[0]), math.degrees(start), math.degrees(turn))
        for end, sense in zip(ends, (-1j, 1j), strict=True):
            yield from arrowhead(self.centre + end, sense * end, pen="thin", length=HEAD)

    def dots(self) -> Iterator[Stroke]:
        """The points: feet, those of the involute and of the fillet, those that are lettered."""
        named = (self.wheel.at_pitch, self.wheel.middle)
        spots = [*self.feet, *self.points, *self.bends, self.limit, self.pole, self.origin]
        for z in (*spots, *(self.at(mark) for mark in named)):
            if cmath.isfinite(z):
                yield circle("main", z, DOT, filled=True)

    def letters(self) -> Iterator[Wanted]:
        """The numbers of the feet, the letters of the points and of the circles."""
        i = self.wheel.sizes.number
        yield Wanted("P", self.pole, SIZE, 1.0, self.pole - self.limit)
        yield Wanted(f"N_{{{i}}}", self.limit, SIZE, 1.0, self.centre - self.limit)
        yield Wanted(f"B_{{0{i}}}", self.origin, NUMBER, 1.0, self.centre - self.origin)
        yield Wanted(f"D_{{{i}}}", self.at(self.wheel.at_pitch), NUMBER, 1.0)
        middle = self.at(self.wheel.middle)
        yield Wanted(f"M_{{{i}}}", middle, NUMBER, 1.0)
        quarter = (middle + self.far) / 2
        yield Wanted(f"s_{{{i}}}", quarter, NUMBER, 1.0, quarter - self.centre)
        for n, (foot, end) in enumerate(
            zip(self.feet, self.points, strict=True), self.wheel.roll.first
        ):
            yield Wanted(str(n), foot, SMALL, DOT, foot - end + 2 * (self.centre - foot) / 3)
        for mark, _, text, low, _ in self.spans():
            end = self.centre + cmath.rect(self.radius(mark), math.radians(low))
            yield Wanted(text, end, NUMBER, 0.5, -1j * (end - self.centre))
