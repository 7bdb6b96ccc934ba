"""The plan of positions in ink: one position in heavy lines, the others thin; trajectories, numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Construction, Figure, Mark
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.kinematics.ink_links import LinksInk
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, circle, line
from graphic_tmm.paper.finish import TOGETHER
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.lettering.indices import (
    markup,
)
from graphic_tmm.paper.symbols.kinematic import GROUND_LENGTH, fixed_pivot, round_arrow

PLAN = "positions"
SIZE = 5.0
"""Sizes of lettering, mm (ГОСТ 2.304)."""
NUMBER_SIZE = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
SWEEP = 70.0
"""The arrow of ω1 goes over so many degrees."""
MARGIN = 7.0
"""Room that letters take about a plan before they have their places, mm."""
HEAVY, THIN = ("rod", "main"), ("thin", "thin")
"""Pens of rods and of guides: in the main position a rod runs over what slides, a guide under it."""


def draw_positions_ink(
    construction: Construction,
    reading: Reading,
    reaches: Mapping[Figure, Reach],
    *,
    main: int,
    names: Sequence[str],
    skipped: Sequence[int],
    crank: tuple[Mark, Mark],
    sense: int,
    title: str,
    lettered: bool = True,
) -> Drawing:
    """Return the plan of positions.

    ``reaches``: how far each guide is used, mm; ``main``: the index of the position drawn heavy; ``skipped``:
    those that cannot be drawn; ``crank``: the marks of its pivot and pin; ``sense``: of its rotation.
    """
    places = [i for i in range(len(names)) if i not in skipped]
    ink = PositionsInk(construction, reading, reaches, places)
    strokes: list[Stroke | Bezier] = []
    strokes += ink.guides()
    strokes += ink.crank_circle(crank)
    strokes += ink.trajectories()
    for index in ink.places:
        if index != main:
            strokes += ink.thin(index)
    strokes += ink.heavy(main)
    pivot, pin = (ink.at(mark, main) for mark in crank)
    reach = min(10.0, 0.6 * abs(pin - pivot))
    bearing = float(np.degrees(np.angle(pin - pivot)))
    strokes += round_arrow(pivot, reach, clear_start(reach, bearing, sense), sense * SWEEP)
    wanted = [*ink.letters((ink.frame.name, *ink.names), main), *ink.numbers(crank, names, main)]
    if not lettered:
        taken = [spot for one in wanted for spot in (one.at - MARGIN, one.at + MARGIN)]
        taken += [one.at + MARGIN * 1j * way for one in wanted for way in (-1, 1)]
        return Drawing(PLAN, title, (*strokes, line("thin", *taken)))
    labels = place(wanted, strokes)
    return Drawing(PLAN, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def draw_position_ink(
    construction: Construction,
    reading: Reading,
    reaches: Mapping[Figure, Reach],
    index: int,
    name: str,
    title: str,
    upon: Sequence[Stroke] = (),
) -> Drawing:
    """Return the plan of one position by itself.

    ``upon``: what is drawn over the plan; letters stay clear of it.
    """
    ink = PositionsInk(construction, reading, reaches, [index])
    strokes: list[Stroke | Bezier] = [*ink.guides(), *ink.heavy(index), *upon]
    wanted = ink.letters((ink.frame.name, *ink.names), index)
    labels = place(wanted, strokes)
    return Drawing(name, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def clear_start(reach: float, bearing: float, sense: int) -> float:
    """Return where the arrow of ω1 begins (degrees): ahead of the crank, clear of the foot of its pivot."""
    starts = [bearing + sense * ahead for ahead in range(20, 341 - int(SWEEP), 10)]

    def clear(start: float) -> bool:
        turns = np.radians(start + sense * np.linspace(-5.0, SWEEP + 5.0, 15))
        x, y = reach * np.cos(turns), reach * np.sin(turns)
        below = (np.abs(x) < GROUND_LENGTH / 2 + 1.0) & (y < 0.0)
        return not below.any()

    return next((start for start in starts if clear(start)), starts[0])


class PositionsInk(LinksInk):
    """The plan of positions while it is inked: the links in their ``places``, and what stands about them."""

    def __init__(
        self,
        construction: Construction,
        reading: Reading,
        reaches: Mapping[Figure, Reach],
        places: list[int],
    ) -> None:
        super().__init__(construction, reading, reaches)
        self.places = places

    def heavy(self, index: int) -> list[Stroke]:
        """The whole mechanism in one position: links, what slides, pivots."""
        strokes = [s for name in self.names for s in self.lines(name, index, HEAVY)]
        strokes += self.symbols(self.names, index)
        return strokes + self.pivots()

    def thin(self, index: int) -> list[Stroke]:
        """The whole mechanism in another position, in thin lines."""
        return [
            stroke
            for name in self.names
            for stroke in (*self.lines(name, index, THIN), *self.notches(name, index))
        ]

    def pivots(self) -> list[Stroke]:
        """The points of the frame: the fixed pivots, and others as what they are."""
        made: list[Stroke] = []
        for mark in self.frame.marks:
            at = self.at(mark, 0)
            made += fixed_pivot(at) if mark in self.joined else self.point(mark, at)
        return made

    def crank_circle(self, crank: tuple[Mark, Mark]) -> list[Stroke]:
        """The circle on which the crank pin moves."""
        pivot, pin = (self.at(mark, self.places[0]) for mark in crank)
        return [circle("thin", pivot, abs(pin - pivot))]

    def trajectories(self) -> list[Bezier]:
        """The curves drawn with the French curve."""
        found = []
        for step in self.construction.steps:
            if step.it.view == PLAN and step.it.kind is Curve:
                for controls in bezier(self.reading[step.it]):
                    found.append(Bezier("thin", tuple(complex(z) for z in controls), step.it.name))
        return found

    def letters(self, names: Sequence[str], main: int) -> list[Wanted]:
        """The letters of links in the main position; points at one place share a label."""
        told = [f for name in names for f in self.of(name, "frame", "link", "centre")]
        spots: list[tuple[complex, list[str]]] = []
        for mark in dict.fromkeys(m for f in told for m in f.marks):
            spot = self.at(mark, main)
            near = next((names for z, names in spots if abs(z - spot) < TOGETHER), None)
            if near is None:
                spots.append((spot, [mark.name]))
            else:
                near.append(mark.name)
        return [Wanted(", ".join(map(markup, names)), z, SIZE, 2.2) for z, names in spots]

    def numbers(self, crank: tuple[Mark, Mark], names: Sequence[str], main: int) -> list[Wanted]:
        """The numbers of the positions, outside the circle of the crank pin."""
        wanted = []
        for index in self.places:
            pivot, pin = (self.at(mark, index) for mark in crank)
            wanted.append(Wanted(names[index], pin, NUMBER_SIZE, 1.2, pin - pivot))
        return wanted
