"""The chart of shifts in ink: the region in which a pair can mesh, its limits, the shifts that are taken."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.board.scales import standard
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.gears.shift_chart import Chart, Limit, chart_of
from graphic_tmm.language.numbers import number
from graphic_tmm.paper.axes import base_figures, tick_figures
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.graph_rules import TICK
from graphic_tmm.paper.seen import Subject

NAME = "gear-shifts"
ROOM = 140.0
"""Room for the longer side of the chart, mm."""
APART = 12.0
"""How far figures of an axis stand apart at least, mm."""
DOT = 0.8
"""Radius of the point of the shifts that are taken, mm."""
STEPS = (0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0)


INSIDE = 0.1
"""How far shifts that are taken stand within the edge at least."""


def _parts(shifts: complex) -> tuple[float, float]:
    """Return x1 and x2."""
    return shifts.real, shifts.imag


class _Ink:
    """The chart while it is inked: places on the sheet, mm, from its lower left corner."""

    def __init__(self, on: Subject, made: Gear, chart: Chart) -> None:
        self.on, self.chart = on, chart
        self.shifts = tuple(wheel.x for wheel in made.sizes.wheels)
        self.taken = complex(*(float(on.reading[mark][0, 0]) for mark in self.shifts))
        # shifts that are taken beside the region are shown, too
        x, y = (
            (min(low, at - INSIDE), max(high, at + INSIDE))
            for low, high, at in zip(
                _parts(chart.low), _parts(chart.high), _parts(self.taken), strict=True
            )
        )
        self.low, self.high = complex(x[0], y[0]), complex(x[1], y[1])
        size = self.high - self.low
        self.mu = standard(max(size.real, size.imag), ROOM)
        self.corner = self.at(self.high)

    def at(self, shifts: complex) -> complex:
        return (shifts - self.low) / self.mu

    def ticks(self, low: float, high: float) -> Iterator[tuple[float, str]]:
        """Where whole steps of a shift stand along their axis, mm, and what is written there."""
        step = next((one for one in STEPS if one / self.mu >= APART), STEPS[-1])
        for k in range(math.ceil(low / step), math.floor(high / step) + 1):
            yield (k * step - low) / self.mu, number(round(k * step, 9), self.on.language)


def draw_shifts_ink(on: Subject, made: Gear) -> Drawing | None:
    """Return the chart, read by the figures of its axes; None where no shifts give a pair that can mesh."""
    chart = chart_of(made.order)
    if chart is None:
        return None
    ink = _Ink(on, made, chart)
    low, high, size = ink.low, ink.high, on.heights.number
    across, up = list(ink.ticks(low.real, high.real)), list(ink.ticks(low.imag, high.imag))
    frame = [*_frame(ink), *(line("thin", x - 1j * TICK, x + 1j * TICK) for x, _ in across)]
    frame += [line("thin", 1j * y - TICK, 1j * y + TICK) for y, _ in up]
    strokes = [*frame, *_curves(ink), *_taken(ink)]
    figures = (*base_figures(across, (), size), *tick_figures(up, size))
    wanted = tuple(_letters(ink))
    return Drawing(NAME, on.title, tuple(strokes), figures, wanted=wanted, role=NAME)


def _frame(ink: _Ink) -> Iterator[Ink]:
    """The edge of what is shown, and the lines on which one of the shifts is 0."""
    right, top = ink.corner.real, 1j * ink.corner.imag
    yield line("thin", 0j, right, ink.corner, top, closed=True)
    zero = ink.at(0j)
    if 0.0 < zero.real < right:
        yield line("centre", zero.real, zero.real + top)
    if 0.0 < zero.imag < top.imag:
        yield line("centre", 1j * zero.imag, 1j * zero.imag + right)


def _curves(ink: _Ink) -> Iterator[Ink]:
    for limit in ink.chart.limits:
        for path in limit.lines:
            yield line("main" if limit.bounds else "thin", *map(ink.at, path))


def _taken(ink: _Ink) -> Iterator[Ink]:
    """The shifts that are taken, with lines to both axes."""
    at = ink.at(ink.taken)
    yield line("dashed", at.real, at, 1j * at.imag)
    yield circle("main", at, DOT, filled=True)


def _letters(ink: _Ink) -> Iterator[Wanted]:
    size, small, (first, second) = ink.on.heights.point, ink.on.heights.number, ink.shifts
    yield Wanted(first.name, ink.corner.real + 0j, size, 1.5, 1 + 0j, (first.slot,))
    yield Wanted(second.name, 1j * ink.corner.imag, size, 1.5, 1j, (second.slot,))
    yield Wanted("K", ink.at(ink.taken), size, DOT)
    for limit in ink.chart.limits:
        path = max(limit.lines, key=_length, default=())
        if _length(path) / ink.mu < APART:
            continue
        middle = ink.at(path[len(path) // 2])
        corners = tuple(map(ink.at, path))
        yield Wanted(_called(limit, ink.on.language), middle, small, 1.0, line=corners)


def _length(path: tuple[complex, ...]) -> float:
    return sum(abs(b - a) for a, b in pairwise(path))


def _called(limit: Limit, language: str) -> str:
    """Return what is equal along a line: s_{a1} = 0, ε_α = 1,2."""
    least = limit.least
    figure = number(least, language) if isinstance(least, float) else least.name
    return f"{limit.value.name} = {figure}"
