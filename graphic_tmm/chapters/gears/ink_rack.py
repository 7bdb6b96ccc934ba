"""A rack in ink: its teeth and lines, the flank that works, where a flank stands as contact begins and ends."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.line import ActionLine, RackLines
from graphic_tmm.chapters.gears.outline import BESIDE, hatched, spot
from graphic_tmm.chapters.gears.toothed_rack import TEETH, RackSide, RackTeeth
from graphic_tmm.paper.drawing import Ink, Wanted, arc, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.mark_rules import dotted, leaving, straight
from graphic_tmm.paper.seen import Rule
from graphic_tmm.paper.symbols.kinematic import arrowhead

DOT = 0.6
"""Radius of a point of the construction, mm."""
OVER = 14.0
"""How far the lines go on beside the teeth, mm."""
ARROW, ABOVE = 20.0, 6.0
"""Length of the arrow of the velocity, and how far above the roots it stands, mm."""
BAND = 60
"""Points of the flank between which its band is hatched."""


class RackInk:
    """The numbers of a rack while it is inked."""

    def __init__(self, reading: Reading, made: RackTeeth, lines: RackLines) -> None:
        self.reading, self.made, self.lines = reading, made, lines
        self.pitch = self.at(made.left.tip, 1) - self.at(made.left.tip, 0)
        self.ends = (self._edge(made.left, 0, -1), self._edge(made.right, TEETH - 1, 1))

    @property
    def arrow(self) -> complex:
        """The point of the arrow of the velocity."""
        return self.ends[1] + 1j * ABOVE

    def at(self, mark: Mark, k: int = 0) -> complex:
        """Where a point of a row stands."""
        return complex(self.reading[mark][0, k])

    def height(self, mark: Mark) -> float:
        """How high a line of the rack stands."""
        return float(self.reading[mark].at[0, 0].imag)

    def _edge(self, side: RackSide, k: int, sense: int) -> complex:
        return self.at(side.root, k) + sense * BESIDE * self.pitch

    def tooth(self, k: int, by: complex = 0j) -> Iterator[Ink]:
        """Yield a tooth, moved, without the roots beside it."""
        tips = [self.at(side.tip, k) + by for side in (self.made.left, self.made.right)]
        for side, tip in zip((self.made.left, self.made.right), tips, strict=True):
            start, centre, root = (
                self.at(mark, k) + by for mark in (side.start, side.centre, side.root)
            )
            yield line("main", tip, start)
            if abs(start - centre) > 1e-9:
                low, turn = (
                    cmath.phase(start - centre),
                    cmath.phase((root - centre) / (start - centre)),
                )
                yield arc(
                    "main", centre, abs(start - centre), math.degrees(low), math.degrees(turn)
                )
        yield line("main", *tips)

    def gap(self, k: int, by: complex = 0j) -> Iterator[Ink]:
        """Yield the root between a tooth, moved, and the one to its right."""
        start, end = self.at(self.made.right.root, k), self.at(self.made.left.root, k) + self.pitch
        if (end - start).real > 1e-9:
            yield line("main", start + by, end + by)

    def toothed(self, low: int, high: int) -> Iterator[Ink]:
        """Yield as many teeth as that, counted from the middle one, each with the root to its right."""
        for n in range(low, high):
            yield from self.tooth(1, n * self.pitch)
            yield from self.gap(1, n * self.pitch)


def rack_rules(ink: RackInk, own: ActionLine) -> dict[Mark, Rule]:
    """What stays of the construction of a rack, by mark."""
    made, lines, (left, right) = ink.made, ink.lines, ink.ends
    pens = {lines.tip: "thin", lines.root: "thin", lines.datum: "centre", lines.rolling: "centre"}
    if abs(ink.height(lines.datum) - ink.height(lines.rolling)) < 1e-9:
        del pens[lines.datum]
    rules: dict[Mark, Rule] = {
        mark: straight(
            pen,
            complex(left.real - OVER, ink.height(mark)),
            complex(right.real + OVER, ink.height(mark)),
        )
        for mark, pen in pens.items()
    }
    engaged, pole = made.engaged, spot(ink.reading, own.pole)
    flank = [ink.at(mark, 1) - pole for mark in (made.left.tip, made.left.start)]
    for mark, crossing in zip((engaged.entering, engaged.leaving), engaged.arc, strict=True):
        rules[crossing] = dotted(DOT)
        rules[mark] = leaving(line("dashed", *(ink.at(crossing) + z for z in flank)))
    rules[engaged.length] = straight("medium", *(ink.at(mark) for mark in engaged.arc))
    return rules


def rack_bodies(ink: RackInk) -> Iterator[Ink]:
    """The teeth, the part of the flank through P that works, the arrow of the velocity."""
    made, (left, right) = ink.made, ink.ends
    teeth = [one for k in range(TEETH) for one in ink.tooth(k)]
    teeth += [one for k in range(TEETH - 1) for one in ink.gap(k)]
    outer = ((left, ink.at(made.left.root, 0)), (ink.at(made.right.root, TEETH - 1), right))
    teeth += [line("main", *ends) for ends in outer]
    yield from body(teeth, "tooth", [*made.left.marks, *made.right.marks])
    upper, lower = (ink.at(mark) for mark in made.working[::-1])
    band = hatched([complex(z) for z in np.linspace(upper, lower, BAND)])
    yield from body(band, "hatching", [made.flank, *made.working])
    tip = ink.arrow
    arrow = [line("main", tip - ARROW, tip), *arrowhead(tip, 1 + 0j)]
    yield from body(arrow, "sense", [made.flank])


def rack_letters(ink: RackInk, heights: Heights) -> Iterator[Wanted]:
    """The letters of the lines by their distances from the axis, of the arc of engagement, of the velocity."""
    lines, size = ink.lines, heights.number
    edge = ink.ends[1].real + OVER
    for mark, text in ((lines.tip, "H_{a}"), (lines.datum, "H"), (lines.root, "H_{f}")):
        yield Wanted(text, complex(edge, ink.height(mark)), size, 0.5, 1 + 0j, (mark.slot,))
    for mark in ink.made.engaged.arc:
        yield Wanted(mark.letter, ink.at(mark), size, 1.0, 1j, (mark.slot,))
    yield Wanted("v", ink.arrow, heights.point, 1.0, 1 + 0.5j, (ink.made.flank.slot,))
