"""The diagram of specific sliding in ink: two curves over the line of action, what its ends and P have."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.outline import controls, spot
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.gears.rows import STATIONS
from graphic_tmm.chapters.gears.sliding import VIEW
from graphic_tmm.language.numbers import number
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 12.0
"""How far an axis goes on behind what stands on it, mm."""
DOT, TICK = 0.5, 1.0
"""Radius of a point, half a tick on the axis, mm."""
SIZE, NUMBER, SMALL = 5.0, 3.5, 2.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""
ROOM = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


class _Ink:
    """The numbers of the diagram while it is inked; the origin is N1."""

    def __init__(self, reading: Reading, made: Gear) -> None:
        self.reading, self.sliding = reading, made.sliding
        self.mu = float(reading[made.sliding.chart.mu][0, 0])
        self.end = self.at(made.sliding.end)
        self.low = -made.sliding.floor / self.mu
        self.high = 1.0 / self.mu

    def at(self, mark: Mark) -> complex:
        return spot(self.reading, mark)

    def row(self, mark: Mark, count: int) -> list[complex]:
        return [complex(z) for z in self.reading[mark][0, :count]]

    def inside(self, z: complex) -> bool:
        """Whether a point stands on the paper of the diagram."""
        return cmath.isfinite(z) and self.low - 1e-6 <= z.imag <= self.high + 1e-6


def draw_sliding_ink(
    reading: Reading, made: Gear, language: str, title: str, *, lettered: bool = True
) -> Drawing:
    """Return the diagram; ``language`` writes the figures beside its ordinate axis.

    Further stations whose sliding lies below the lowest ordinate of the diagram have no point on it.
    """
    ink = _Ink(reading, made)
    strokes: list[Stroke | Bezier] = [*_axes(ink), *_ordinates(ink)]
    for branch in made.sliding.branches:
        whole = controls(reading, branch.curve)
        if whole:
            strokes.append(Bezier("main", whole, branch.curve.name))
    strokes += _dots(ink, made)
    wanted = list(_letters(ink, language))
    if not lettered:
        cell = (-ROOM - OVER, ink.low - ROOM, ink.end.real + OVER + ROOM, ink.high + OVER + ROOM)
        return Drawing(VIEW, title, tuple(strokes), cell=cell)
    labels = place(wanted, strokes)
    return Drawing(VIEW, title, interrupt([*strokes, *leaders(wanted, labels)], labels), labels)


def _axes(ink: _Ink) -> Iterator[Stroke]:
    """The base with its arrow, the ordinate in N1 with ticks, the asymptotes in N2 and at ϑ = 1."""
    right, top = ink.end + OVER, 1j * (ink.high + OVER)
    yield line("thin", 0j, right)
    yield line("thin", 1j * ink.low, top)
    yield from arrowhead(right, 1 + 0j, pen="thin")
    yield from arrowhead(top, 1j, pen="thin")
    yield line("dashed", ink.end + 1j * ink.low, ink.end + 1j * ink.high)
    yield line("dashed", 1j * ink.high, ink.end + 1j * ink.high)
    for value in _figures(ink):
        height = 1j * value / ink.mu
        yield line("thin", height - TICK, height + TICK)


def _figures(ink: _Ink) -> list[int]:
    """Whole ordinates, as many as stand 4 mm apart at least."""
    step = next(k for k in (1, 2, 5, 10) if k / ink.mu >= 4.0 or k == 10)
    return [1, *range(-step, -int(ink.sliding.floor) - 1, -step)]


def _ordinates(ink: _Ink) -> Iterator[Stroke]:
    """The ordinates in a and b up to both curves."""
    for stations in ink.sliding.ends:
        foot = ink.at(stations.feet)
        spots = [z for z in map(ink.at, stations.points) if ink.inside(z)]
        for z in spots:
            yield line("thin", foot, z)


def _dots(ink: _Ink, made: Gear) -> Iterator[Stroke]:
    """The points laid off."""
    sliding = made.sliding
    rows = [(branch.points, STATIONS) for branch in sliding.branches]
    rows += [(mark, 1) for one in (*sliding.ends, sliding.pole) for mark in one.points]
    if sliding.further is not None:
        rows += [(mark, len(made.order.stations)) for mark in sliding.further.points]
    for mark, count in rows:
        for z in ink.row(mark, count):
            if ink.inside(z):
                yield circle("main", z, DOT, filled=True)


def _letters(ink: _Ink, language: str) -> Iterator[Wanted]:
    """The letters of the base, of the curves, the figures of the ordinate axis."""
    yield Wanted("ϑ", 1j * (ink.high + OVER), SIZE, 1.5, -1 + 0j)
    yield Wanted("x", ink.end + OVER, SIZE, 1.5, -1j)
    yield Wanted("N_{1}", 0j, SIZE, 1.0, -1 - 0.6j)
    yield Wanted("N_{2}", ink.end, SIZE, 1.0, 1 - 1j)
    for k, branch in enumerate(ink.sliding.branches):
        steep = ink.row(branch.points, STATIONS)[1]
        yield Wanted(f"ϑ_{{{k + 1}}}", steep, SIZE, 1.0, 1 - 2 * k + 0j)
    for name, stations in (("a", ink.sliding.ends[0]), ("b", ink.sliding.ends[1])):
        foot = ink.at(stations.feet)
        if (
            -1e-6 <= foot.real <= ink.end.real + 1e-6
        ):  # else it interferes: no sliding is known there
            yield Wanted(name, foot, SIZE, 1.0, 1 - 1j)
    yield Wanted("P", ink.at(ink.sliding.pole.feet), SIZE, 1.0, -1j)
    for value in _figures(ink):
        yield Wanted(number(float(value), language), 1j * value / ink.mu, SMALL, TICK, -1 + 0j)
