"""The plan of positions in ink: one position in heavy lines, the others thin; trajectories, numbers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from graphic_tmm.board.curve import bezier
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import TALLY, Construction, Figure, Mark
from graphic_tmm.board.values import Curve, Point
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, circle, line
from graphic_tmm.paper.ink_plans import TOGETHER, markup
from graphic_tmm.paper.placing import Wanted, interrupt, leaders, place
from graphic_tmm.paper.symbols import (
    GROUND_LENGTH,
    fixed_pivot,
    guide,
    round_arrow,
    slider,
    stone,
    turning_pair,
)

PLAN = "positions"
SIZE = 5.0
NUMBER_SIZE = 3.5
OVERRUN = 12.0
"""How far a guide goes on behind the outermost places of its slider, mm."""
CENTRE_RADIUS = 0.9
"""A mass centre is a small circle, mm."""
SWEEP = 70.0
"""The arrow of ω1 goes over so many degrees."""
MARGIN = 7.0
"""Room that letters take about a plan before they have their places, mm."""
THROUGH = 9.0
"""How far a rocker goes on behind its stone, mm."""


def draw_positions_ink(
    construction: Construction,
    reading: Reading,
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

    ``main``: the index of the position drawn heavy; ``skipped``: those that cannot be drawn; ``crank``: the
    marks of its pivot and pin; ``sense``: of its rotation.
    """
    ink = PositionsInk(construction, reading, [i for i in range(len(names)) if i not in skipped])
    figures = [f for f in construction.figures if f.view == PLAN]
    strokes: list[Stroke | Bezier] = []
    strokes += ink.guides(figures)
    strokes += ink.crank_circle(crank)
    strokes += ink.trajectories()
    for index in ink.places:
        if index != main:
            for figure in figures:
                strokes += ink.link(figure, index, "thin")
    for figure in figures:
        strokes += ink.link(figure, main, "rod")
    for figure in figures:
        strokes += ink.symbols(figure, main)
    strokes += ink.pivots(figures)
    pivot, pin = (ink.at(mark, main) for mark in crank)
    reach = min(10.0, 0.6 * abs(pin - pivot))
    bearing = float(np.degrees(np.angle(pin - pivot)))
    strokes += round_arrow(pivot, reach, clear_start(reach, bearing, sense), sense * SWEEP)
    wanted = [*ink.letters(figures, main), *ink.numbers(crank, names, main)]
    if not lettered:
        taken = [spot for one in wanted for spot in (one.at - MARGIN, one.at + MARGIN)]
        taken += [one.at + MARGIN * 1j * way for one in wanted for way in (-1, 1)]
        return Drawing(PLAN, title, (*strokes, line("thin", *taken)))
    labels = place(wanted, strokes)
    return Drawing(PLAN, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def draw_position_ink(
    construction: Construction,
    reading: Reading,
    index: int,
    name: str,
    title: str,
    upon: Sequence[Stroke] = (),
) -> Drawing:
    """Return the plan of one position by itself.

    ``upon``: what is drawn over the plan; letters stay clear of it.
    """
    ink = PositionsInk(construction, reading, [index])
    figures = [f for f in construction.figures if f.view == PLAN]
    strokes: list[Stroke | Bezier] = [*ink.guides(figures)]
    for figure in figures:
        strokes += ink.link(figure, index, "rod")
    for figure in figures:
        strokes += ink.symbols(figure, index)
    strokes += [*ink.pivots(figures), *upon]
    wanted = ink.letters(figures, index)
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


class PositionsInk:
    """The log and its numbers while they are inked."""

    def __init__(self, construction: Construction, reading: Reading, places: list[int]) -> None:
        self.construction, self.reading, self.places = construction, reading, places

    def at(self, mark: Mark, index: int) -> complex:
        """Return where a point is in one position."""
        row = self.reading[mark][0]
        return complex(row[index if row.size > 1 else 0])

    def along(self, mark: Mark, index: int) -> complex:
        """Return the direction of a line in one position."""
        row = self.reading[mark].along[0]
        return complex(row[index if row.size > 1 else 0])

    def link(self, figure: Figure, index: int, pen: str) -> list[Stroke]:
        """A link between its pins: a line, or the outline of a link with pins out of line."""
        if figure.kind == "slot":
            start, end, path = figure.marks
            reach = self.along(path, index) * THROUGH
            ends = sorted(
                (self.at(start, index), self.at(end, index)),
                key=lambda z: (z * reach.conjugate()).real,
            )
            return [line(pen, ends[0] - reach, ends[1] + reach)]
        if figure.kind != "link":
            return []
        spots = [self.at(m, index) for m in figure.marks if m.kind is Point and not _centre(m)]
        if len(spots) < 2:
            return []
        hull = shapely.MultiPoint([(z.real, z.imag) for z in spots]).convex_hull
        if isinstance(hull, shapely.Polygon) and hull.area > 1e-3 * hull.length**2:
            return [line(pen, *(complex(*xy) for xy in hull.exterior.coords[:-1]), closed=True)]
        far = max(((a, b) for a in spots for b in spots), key=lambda ends: abs(ends[1] - ends[0]))
        if abs(far[1] - far[0]) <= TOGETHER:
            return []
        return [line(pen, *(self.behind_stone(z, far, index) for z in far))]

    def behind_stone(self, end: complex, far: tuple[complex, complex], index: int) -> complex:
        """The end of a link, or a place a little behind it where a stone on it stands there."""
        stones = (f.marks for f in self.construction.figures if f.kind == "stone")
        run = far[1] - far[0] if end == far[1] else far[0] - far[1]
        for pin, path in stones:
            on_line = abs((run * self.along(path, index).conjugate()).imag) < 1e-6 * abs(run)
            if on_line and abs(self.at(pin, index) - end) < TOGETHER:
                return end + run / abs(run) * THROUGH
        return end

    def symbols(self, figure: Figure, index: int) -> list[Stroke]:
        """Sliders, stones and turning pairs of the main position."""
        if figure.kind in ("slider", "stone"):
            pin, path = figure.marks
            angle = float(np.degrees(np.angle(self.along(path, index))))
            if figure.kind == "slider":
                return list(slider(self.at(pin, index), angle))
            return list(stone(self.at(pin, index), angle))
        if figure.kind == "link":
            pins = [m for m in figure.marks if m.kind is Point]
            return self.ties(pins, index) + [
                stroke
                for mark in pins
                for stroke in (
                    (circle("joint", self.at(mark, index), CENTRE_RADIUS),)
                    if _centre(mark)
                    else turning_pair(self.at(mark, index))
                )
            ]
        return []

    def ties(self, marks: Sequence[Mark], index: int) -> list[Stroke]:
        """Thin lines that tie a mass centre off the line of its link to the link's pins."""
        pins = [self.at(m, index) for m in marks if not _centre(m)]
        if len(pins) < 2:
            return []
        hull = shapely.MultiPoint([(z.real, z.imag) for z in pins]).convex_hull
        free = [
            spot
            for spot in (self.at(m, index) for m in marks if _centre(m))
            if hull.distance(shapely.Point(spot.real, spot.imag)) > 2 * CENTRE_RADIUS
        ]
        return [line("thin", pin, spot) for spot in free for pin in pins[:2]]

    def pivots(self, figures: Sequence[Figure]) -> list[Stroke]:
        """The fixed pivots."""
        frame = next(f for f in figures if f.kind == "frame")
        used = {mark for f in figures if f.kind == "link" for mark in f.marks}
        return [s for m in frame.marks if m in used for s in fixed_pivot(self.at(m, 0))]

    def guides(self, figures: Sequence[Figure]) -> list[Stroke]:
        """The fixed guides, over the travel of their sliders, hatched on the far side."""
        strokes: list[Stroke] = []
        for figure in figures:
            if figure.kind != "slider":
                continue
            pin, path = figure.marks
            along = self.along(path, 0)
            spots = [self.at(pin, i) for i in self.places]
            low = min(spots, key=lambda z: (z * along.conjugate()).real)
            high = max(spots, key=lambda z: (z * along.conjugate()).real)
            strokes += guide(low - OVERRUN * along, high + OVERRUN * along)
        return strokes

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

    def letters(self, figures: Sequence[Figure], main: int) -> list[Wanted]:
        """The letters of the main position; points at one place share a label."""
        marks = list(dict.fromkeys(m for f in figures for m in f.marks if m.kind is Point))
        spots: list[tuple[complex, list[str]]] = []
        for mark in marks:
            if mark.letter.endswith(("′", TALLY)):
                continue
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


def _centre(mark: Mark) -> bool:
    """Whether a point is a mass centre by its letter: S, S2 ..."""
    return mark.name[0] == "S" and (len(mark.name) == 1 or mark.name[1:].isdigit())
