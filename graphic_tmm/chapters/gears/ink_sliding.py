"""The diagram of specific sliding in ink: two curves over the line of action, what its ends and P have."""

from __future__ import annotations

import cmath
from collections.abc import Iterator

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.gears.outline import RULES, controls, spot
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.gears.sliding import VIEW, Stations
from graphic_tmm.chapters.gears.teeth import STATIONS
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import tick_figures
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import added, figure, showing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.seen import Rule, Seen, Subject
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 12.0
"""How far an axis goes on behind what stands on it, mm."""
DOT, TICK = 0.5, 1.0
"""Radius of a point, half a tick on the axis, mm."""


class _Ink:
    """The numbers of the diagram while it is inked; the origin is N1."""

    def __init__(self, seen: Seen, made: Gear) -> None:
        self.seen, self.sliding = seen, made.sliding
        self.mu = seen.number(made.sliding.chart.mu, 0)
        self.end = self.at(made.sliding.end)
        self.low = -made.sliding.floor / self.mu
        self.high = 1.0 / self.mu
        self.open = made.sizes.ring is not None or made.rack is not None

    def at(self, mark: Mark) -> complex:
        return spot(self.seen.reading, mark)

    def inside(self, z: complex) -> bool:
        """Whether a point stands on the paper of the diagram."""
        return cmath.isfinite(z) and self.low - 1e-6 <= z.imag <= self.high + 1e-6

    @property
    def stations(self) -> Iterator[Stations]:
        """The ends of the working line, the pitch point, what the task names."""
        yield from (*self.sliding.ends.values(), self.sliding.pole)
        if self.sliding.further is not None:
            yield self.sliding.further


def draw_sliding_ink(on: Subject, made: Gear) -> Drawing:
    """Return the diagram.

    Further stations whose sliding lies below the lowest ordinate of the diagram have no point on it.
    """
    ink = _Ink(on.seen((VIEW,), range(made.rows.axis)), made)
    traces = figure(ink.seen, showing(_rules(ink), RULES))
    strokes = (*traces.staying, *added(_axes(ink), "axis"))
    ticks = [(value / ink.mu, number(float(value), on.language)) for value in _figures(ink)]
    figures = tick_figures(ticks, on.heights.number)
    return traces.drawing(on, strokes, _letters(ink, on.language, on.heights), figures)


def _rules(ink: _Ink) -> dict[Mark, Rule]:
    """What stays of the diagram: its curves, the points laid off, the ordinates in a and b."""

    def visible_ink(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        z = seen.point(step.it, k)
        if ink.inside(z):
            yield circle("main", z, DOT, filled=True)

    def raised(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        z = seen.point(step.it, k)
        if ink.inside(z):
            yield line("thin", complex(z.real), z)
        yield from visible_ink(seen, step, k)

    def curve(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        whole = controls(seen.reading, step.it)
        if whole:
            yield Bezier("main", whole, step.it.name)

    rules: dict[Mark, Rule] = {}
    for branch in ink.sliding.branches:
        rules |= {branch.points: visible_ink, branch.curve: curve}
    for stations in ink.stations:
        ends = stations in ink.sliding.ends.values()
        rules |= dict.fromkeys(stations.points, raised if ends else visible_ink)
    return rules


def _axes(ink: _Ink) -> Iterator[Ink]:
    """The base with its arrow, the ordinate in N1 with ticks, the asymptotes in N2 and at ϑ = 1."""
    right, top = ink.end + OVER, 1j * (ink.high + OVER)
    yield line("thin", 0j, right)
    yield line("thin", 1j * ink.low, top)
    yield from arrowhead(right, 1 + 0j, pen="thin")
    yield from arrowhead(top, 1j, pen="thin")
    if not ink.open:
        yield line("dashed", ink.end + 1j * ink.low, ink.end + 1j * ink.high)
    yield line("dashed", 1j * ink.high, ink.end + 1j * ink.high)
    for value in _figures(ink):
        height = 1j * value / ink.mu
        yield line("thin", height - TICK, height + TICK)


def _figures(ink: _Ink) -> list[int]:
    """Whole ordinates, as many as stand 4 mm apart at least."""
    step = next(k for k in (1, 2, 5, 10) if k / ink.mu >= 4.0 or k == 10)
    return [1, *range(-step, -int(ink.sliding.floor) - 1, -step)]


def _letters(ink: _Ink, language: str, heights: Heights) -> Iterator[Wanted]:
    """The letters of the base and of the curves."""
    point = heights.point
    yield Wanted("ϑ", 1j * (ink.high + OVER), point, 1.5, -1 + 0j)
    yield Wanted(f"x, {unit('mm', language)}", ink.end + OVER, point, 1.5, 1j + 0.5)
    yield Wanted("N_{1}", 0j, point, 1.0, -1 - 0.6j)
    if not ink.open:
        yield Wanted("N_{2}", ink.end, point, 1.0, 1 - 1j, (ink.sliding.end.slot,))
    for k, branch in enumerate(ink.sliding.branches):
        steep = complex(ink.seen.reading[branch.points][0, :STATIONS][1])
        yield Wanted(f"ϑ_{{{k + 1}}}", steep, point, 1.0, 1 - 2 * k + 0j, (branch.curve.slot,))
    for stations in ink.sliding.ends.values():
        foot = stations.feet
        yield Wanted(foot.name, ink.at(foot), point, 1.0, 1 - 1j, (foot.slot,))
    pole = ink.sliding.pole.feet
    yield Wanted(pole.name, ink.at(pole), point, 1.0, -1j, (pole.slot,))
