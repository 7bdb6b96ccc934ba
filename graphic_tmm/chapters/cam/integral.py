"""A law given by its acceleration diagram: integrated twice against a pole, its scale found from the stroke.

The diagram is drawn with its largest ordinate as high as there is room; what it rises to by two integrations is
the stroke, and from that follow the scales, the last one first.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base, Pole, erect_axes
from graphic_tmm.board.operations.formulas import rescaled, scale_of_derivative
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.graphs import arrival, erect, following, succession
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    place,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number, Reals
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam.course import along_base, take_place
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import Ground, uprights
from graphic_tmm.chapters.cam.operations import in_turn
from graphic_tmm.chapters.cam.phases import Phase, Turn
from graphic_tmm.chapters.cam.refusals import HIGH, SLACK
from graphic_tmm.chapters.cam.task import CamTask

NAMES = {"A": "acceleration", "V": "velocity", "S": "displacement"}


@dataclass(frozen=True)
class Integral:
    """A phase integrated: for each diagram its scale and the ordinates of each stretch (Length).

    ``corners``: the corners of the acceleration diagram as drawn (Point, one value each).
    """

    phase: Phase
    views: dict[str, str]
    scales: dict[str, Mark]
    ordinates: dict[str, tuple[Mark, ...]]
    corners: tuple[Mark, ...]


class _Row(NamedTuple):
    """What the three views of an integration share."""

    turn: Turn
    phase: Phase
    base: Base


def draw_integral(
    draft: Draft,
    base: Base,
    turn: Turn,
    phase: Phase,
    stroke: Mark,
    order: CamTask,
) -> Integral:
    """Integrate the acceleration diagram of a phase twice, about the poles of the order."""
    poles, letters = order.poles, order.letters
    row = _Row(turn, phase, base)
    views = {which: f"cam {phase.called} {name}" for which, name in NAMES.items()}
    draft.open(views["A"])
    first, corners, middles, accelerations = _accelerations(draft, row, views["A"])
    speeds = erect_axes(draft, views["V"], row.base, row.base.mu)
    points, last, pole_A = _succession(draft, row, (first, speeds), middles, poles[0], "v")
    draft.open(views["V"])
    velocity = draft.draw(measure_along, "V", speeds.feet, points, speeds.up)
    ways = erect_axes(draft, views["S"], row.base, row.base.mu)
    middles = _on_curves(draft, row, speeds, points, last)
    spots, end, pole_V = _succession(draft, row, (speeds, ways), middles, poles[1], "d")
    draft.open(views["S"])
    displacement = draft.draw(measure_along, letters["S"], ways.feet, spots, ways.up)
    for ends in phase.stretches:
        draft.draw(graph_of_stretch, "(s–s)", spots, first=ends[0], last=ends[1])
    high = draft.draw(measure_along, "h", ways.end, end, ways.up)
    unit = order.scale_unit("S")
    mu_S = draft.draw(f.scale_of_stroke, f"μ_{letters['S']}", stroke, high, unit=unit)
    scale_V = (mu_S, base.mu, pole_V.distance)
    mu_V = draft.draw(
        scale_of_derivative, f"μ_{{{letters['V']}}}", *scale_V, unit=order.scale_unit("V")
    )
    scale_A = (mu_V, base.mu, pole_A.distance)
    mu_A = draft.draw(
        scale_of_derivative, f"μ_{{{letters['A']}}}", *scale_A, unit=order.scale_unit("A")
    )
    scales = {"S": mu_S, "V": mu_V, "A": mu_A}
    for which, axes in (("S", ways), ("V", speeds), ("A", first)):
        _settle(draft, axes, scales[which])
    ordinates = {"S": (displacement,), "V": (velocity,), "A": accelerations}
    return Integral(phase, views, scales, ordinates, corners)


def lay_integral(
    draft: Draft, ground: Ground, integral: Integral, which: str, height: Mark
) -> tuple[Mark, ...]:
    """Lay the ordinates of an integrated phase off on a diagram, one mark for each stretch.

    ``height``: the stroke on the diagram of S (Length).
    """
    found = []
    own, back = integral.ordinates[which], ground.of.sign < 0
    for k in range(len(ground.feet)):
        long = draft.draw(rescaled, f"y_{which}", own[min(k, len(own) - 1)], ground.mu)
        if back and which == "S":
            long = draft.draw(f.rest_of_stroke, f"y_{which}", height, long)
        over = uprights(draft, ground, k, up=not back or which == "S")
        found.append(draft.draw(lay_off, which.lower(), over, long, free=True))
    return tuple(found)


def _settle(draft: Draft, axes: Axes, mu: Mark) -> None:
    """Tell the scale of axes, now that it is known."""
    base = axes.base
    draft.open(axes.view)
    draft.lay_out(None, mu)
    marks = (axes.origin, axes.along, axes.up, axes.feet, axes.end, axes.middles)
    draft.figure("axes", axes.view, *marks, mu, base.mu, base.length)


def _accelerations(
    draft: Draft, row: _Row, view: str
) -> tuple[Axes, tuple[Mark, ...], Mark, tuple[Mark, ...]]:
    """Draw the diagram that is given: axes, corners, points over the middles, ordinates of the stretches."""
    (turn, phase, base) = row
    axes = erect_axes(draft, view, row.base, row.base.mu)
    most = max(abs(value) for _, value in phase.law.points)
    points = [(share, HIGH * value / most) for share, value in phase.law.points]
    corners = []
    factor = _accepted(draft, phase)
    for share, value in points:
        at = take_place(draft, base, "c", phase.start + share * phase.extent)
        x = along_base(draft, base, "x_c", at)
        if factor is None or value >= 0.0:
            y = draft.take(Length, "y_c", value, "mm")
        else:
            read = draft.take(Length, "y′_c", value / phase.changed.factor, "mm")
            y = draft.draw(f.evened, "y_c", factor, read)
        corners.append(draft.draw(place, "c", axes.along, x, y, free=True))
    draft.figure("outline", "diagram", axes.origin, *corners, axes.end)
    parts = draft.take(Number, "N", float(phase.parts))
    halves = np.arange(0.5, phase.parts)
    whole = turn.over((phase.first, phase.last - 1), halves)
    heights = _ordinates(draft, turn, points, parts, whole, phase.parts)
    middles = _over_middles(draft, row, axes, [(heights, (phase.first, phase.last))])
    readings = []
    for ends in phase.stretches:
        own = turn.over(ends, np.arange(ends[0], ends[1] + 1.0) - phase.first)
        readings.append(_ordinates(draft, turn, points, parts, own, phase.parts))
    return axes, tuple(corners), middles, tuple(readings)


def _accepted(draft: Draft, phase: Phase) -> Mark | None:
    """Take the factor (Number) that makes both areas equal; None where they are."""
    factor = phase.changed.factor
    return None if factor == 1.0 else draft.take(Number, "k_A", factor)


def _over_middles(
    draft: Draft, row: _Row, axes: Axes, heights: list[tuple[Mark, tuple[int, int]]]
) -> Mark:
    """Lay off ordinates over the middles of the intervals; off the stretches given there is none: zero."""
    whole = draft.take(Length, "0", 0.0, "mm")
    for height, (first, last) in heights:
        at = draft.take(Number, "σ", row.turn.inside(first, last - 1))
        whole = draft.draw(in_turn, "h", height, whole, at)
    over = draft.draw(square, "(m)", axes.middles, axes.along, sense=1)
    return draft.draw(lay_off, "h", over, whole, free=True)


def _on_curves(draft: Draft, row: _Row, axes: Axes, points: Mark, end: Mark) -> Mark:
    """Draw the smooth curve of every stretch and mark over the middles the mean ordinate of each interval."""
    heights = []
    draft.open(axes.view)
    after = draft.draw(following, "v+1", points, end, row=row.base.intervals)
    ends = [draft.draw(measure_along, "v", axes.origin, z, axes.up) for z in (points, after)]
    angles = np.array(row.turn.angles)
    for first, last in row.phase.stretches:
        curve = draft.draw(graph_of_stretch, "(v–v)", points, first=first, last=last)
        own = (angles[first:last] + angles[first + 1 : last + 1]) / 2.0
        at = take_place(draft, row.base, "m", row.turn.over((first, last - 1), own))
        x = along_base(draft, row.base, "x_m", at)
        foot = draft.draw(lay_off, "m", axes.along, x, free=True)
        spots = draft.draw(erect, "w", curve, foot, free=True)
        middle = draft.draw(measure_along, "w", foot, spots, axes.up)
        mean = draft.draw(f.mean_of_strip, "w_m", ends[0], middle, ends[1])
        heights.append((mean, (first, last)))
    return _over_middles(draft, row, axes, heights)


def _succession(
    draft: Draft, row: _Row, axes: tuple[Axes, Axes], middles: Mark, distance: float, letter: str
) -> tuple[Mark, Mark, Pole]:
    """Integrate from the first axes to the second; return the points, the end and the pole."""
    (source, to), count = axes, row.base.intervals
    draft.open(source.view)
    pole = graphs.set_pole(
        draft, source, draft.take(Length, "H", distance, "mm", roles.POLE_DISTANCE)
    )
    levels = draft.draw(parallel, f"({middles.letter})", middles, source.along)
    cuts = draft.draw(meet, "h_y", source.up, levels, free=True)
    rays = draft.draw(join, "(P)", pole.point, cuts)
    draft.open(to.view)
    points = draft.draw(succession, letter, to.origin, rays, to.feet, to.end, row=count)
    last = draft.draw(arrival, f"{letter}_N", to.origin, rays, to.feet, to.end, row=count)
    return points, last, pole


def _ordinates(
    draft: Draft,
    turn: Turn,
    points: list[tuple[float, float]],
    parts: Mark,
    numbers: Reals,
    count: int,
) -> Mark:
    """Read the straight lines of a diagram at given numbers of the division (1, position).

    On which line a position stands is a choice that is made before the log runs; at a corner, on the line that
    reaches farther into the stretch of the numbers.
    """
    shares = numbers[0] / count
    middle = np.nanmean(shares)
    segments = [(a[0], b[0], a[1], b[1]) for a, b in pairwise(points) if b[0] - a[0] > SLACK]
    rows = np.full((4, turn.positions), np.nan)
    for i in np.flatnonzero(np.isfinite(shares)):
        u = float(shares[i])
        fits = [s for s in segments if s[0] - SLACK <= u <= s[1] + SLACK]
        rows[:, i] = min(fits, key=lambda s: abs((s[0] + s[1]) / 2.0 - middle))
    number = draft.take(Number, "n", numbers)
    share = draft.draw(law.share_of_parts, "u", number, parts)
    start, end = (draft.take(Number, x, rows[k : k + 1]) for k, x in ((0, "u_a"), (1, "u_b")))
    low, high = (draft.take(Length, x, rows[k : k + 1], "mm") for k, x in ((2, "y_a"), (3, "y_b")))
    return draft.draw(f.on_chord, "y", share, start, end, low, high)
