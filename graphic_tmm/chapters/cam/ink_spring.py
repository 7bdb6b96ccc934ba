"""The line of the spring over the inertia force in ink: wanted forces over S, pole, F_0 and F at the stroke."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam.ink_rules import OVER, CamInk, arrow_axis, dots, numbered
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.spring import VIEW
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import added, body, figure, showing
from graphic_tmm.paper.mark_rules import curve, straight
from graphic_tmm.paper.seen import Rule, Subject, finite

BEYOND = 8.0
"""How far the line of the spring goes on behind the stroke, mm."""


class SpringNames(NamedTuple):
    """What is lettered: positions, the axes, the forces at both ends of the stroke with their values."""

    positions: Sequence[str]
    out: str
    up: str
    least: str
    most: str


def draw_spring_ink(on: Subject, cam: Cam, names: SpringNames) -> Drawing:
    """Return the wanted forces over the displacement with the line of the spring."""
    spring = cam.spring
    assert spring is not None
    ink = CamInk(on, cam, VIEW)
    ends = [ink.fixed_place(mark) for mark in spring.ends]
    pole = ink.fixed_place(spring.pole) if spring.pole is not None else ends[0]
    rules: dict[Mark, Rule] = dict.fromkeys(spring.curves, curve("medium"))
    for mark, (_, first, last) in zip(spring.points, cam.diagrams.stretches, strict=True):
        rules[mark] = partial(dots, first, last)
    if finite(*ends, pole):
        way = (ends[1] - ends[0]) / abs(ends[1] - ends[0])
        rules[spring.line] = straight("main", pole, ends[1] + BEYOND * way)
    traces = figure(ink, showing(rules))
    rows = np.array([ink.all(mark) for mark in spring.points])
    heights = [float(np.nanmin(rows.imag)), float(np.nanmax(rows.imag)), 0.0]
    heights += [one.imag for one in ends if finite(one)]
    corners = min(0.0, pole.real if finite(pole) else 0.0), ends[1].real, min(heights), max(heights)
    strokes = [*traces.staying, *added(_axes(*corners), "axis"), *_bodies(ink, ends, pole)]
    letters = [*_letters(ink, names, ends, pole, corners)]
    return traces.drawing(on, strokes, letters, (), enumerate(names.positions))


def _axes(left: float, right: float, low: float, high: float) -> Iterator[Ink]:
    yield from arrow_axis(complex(left - OVER), complex(right + 2.0 * OVER))
    yield from arrow_axis(complex(0.0, low - OVER), complex(0.0, high + OVER))
    yield line("thin", complex(right, low), complex(right, high))


def _bodies(ink: CamInk, ends: Sequence[complex], pole: complex) -> Iterator[Ink]:
    """The forces of the spring at both ends of the stroke, the pole."""
    spring = ink.cam.spring
    assert spring is not None
    for mark, spot in zip(spring.ends, ends, strict=True):
        if finite(spot):
            yield from body([circle("main", spot, 0.7, filled=True)], "point", [mark])
    if spring.pole is not None and finite(pole):
        yield from body([circle("joint", pole, 1.0)], "pole", [spring.pole])


def _letters(
    ink: CamInk,
    names: SpringNames,
    ends: Sequence[complex],
    pole: complex,
    corners: tuple[float, float, float, float],
) -> Iterator[Wanted]:
    """The letters of axes, pole and forces, the numbers of the positions."""
    spring, (_, right, _, high) = ink.cam.spring, corners
    assert spring is not None
    point, small = ink.heights.point, ink.heights.number
    yield Wanted(names.out, complex(right + 2.0 * OVER), point, 1.5, -1j)
    yield Wanted(names.up, complex(0.0, high + OVER), point, 1.5, -1 + 0j)
    if spring.pole is not None and finite(pole):
        yield Wanted("K", pole, small, 1.4, -1j, (spring.pole.slot,))
    texts = zip((names.least, names.most), spring.ends, ends, (-1.0, 1.0), strict=True)
    for text, mark, spot, side in texts:
        if finite(spot):
            yield Wanted(text, spot, small, 1.0, side + 0.6j, (mark.slot,))
    for mark, (_, first, last) in zip(spring.points, ink.cam.diagrams.stretches, strict=True):
        row = np.arange(len(ink.positions))
        own = np.where((row >= first) & (row <= last), ink.all(mark), np.nan)
        yield from numbered(ink, names.positions, mark, own, np.full(own.shape, -1j))
