"""Diagrams over the turn of a finished cam: its pressure angle, and how sharply its profile is curved.

Their extremes are those of the smooth curves, not of the positions; the angle of the cam belongs to each.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from graphic_tmm.board import graphs
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes
from graphic_tmm.board.operations.formulas import in_si, rescaled, to_board, total
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import formulas_drum
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.centre import Centre, Convexity
from graphic_tmm.chapters.cam.course import read_place
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.flat_rocker import FaceRegion
from graphic_tmm.chapters.cam.operations import (
    crest_of_curve,
    extreme_of_two,
    farther_from_axis,
    phase_end,
)

PRESSURE, CURVATURE, CONTACT = "cam pressure", "cam curvature", "cam contact"
DEGREES = 1.0
"""Degrees of the pressure angle per mm of its diagram."""
ROOM = 40.0
"""Room for the largest curvature, or radius of curvature, mm."""


@dataclass(frozen=True)
class Extreme:
    """An extreme of a diagram: its point, its value (Angle, or Number in SI), the cam's angle there (Angle)."""

    point: Mark
    value: Mark
    angle: Mark


@dataclass(frozen=True)
class TurnDiagram:
    """A diagram over the turn: its chart; points, curves and positions by stretch; its extremes.

    ``rest``: of the dwells, at all positions (Number, SI); None where it is zero, or nobody asks for it.
    """

    axes: Axes
    chart: Chart
    points: tuple[Mark, ...]
    curves: tuple[Mark, ...]
    extremes: tuple[Extreme, ...]
    rest: Mark | None = None


def draw_pressure(draft: Draft, diagrams: Diagrams, centre: Centre) -> TurnDiagram:
    """Draw the pressure angle; its extremes are the highest of the rise and the lowest of the return."""
    draft.open(PRESSURE)
    mu = draft.take(Number, "μ_α", DEGREES, "°/mm")
    axes = graphs.draw_axes(draft, PRESSURE, diagrams.base, mu)
    high = draft.draw(f.on_protractor, "y_α", centre.pressure)
    lines = draft.draw(square, "(i)", axes.feet, axes.along, sense=1, why=why.ANGLE_AT)
    spots = draft.draw(lay_off, "p", lines, high, why=why.ANGLE_AT)
    curves = _curves(draft, diagrams, [spots] * len(diagrams.stretches))
    _outline(draft, diagrams, axes, [spots] * len(curves), spots)
    extremes = []
    for phase in diagrams.turn.ways:
        rows = zip(curves, diagrams.stretches, strict=True)
        own = [curve for curve, (of, _, _) in rows if of.sign == phase.sign]
        point, y, angle = _extreme(draft, axes, own, phase.sign)
        name = "α_{max}" if phase.sign > 0 else "α_{min}"
        value = draft.draw(f.off_protractor, name, y, unit="°")
        extremes.append(Extreme(point, value, angle))
    reading = draft.draw(measure_along, "α", axes.feet, spots, axes.up, why=why.DIAGRAM_READ)
    chart = Chart(PRESSURE, "α", "°", mu, (reading,), False, DEGREES, ROOM)
    return TurnDiagram(axes, chart, (spots,) * len(curves), curves, tuple(extremes))


def draw_curvature(
    draft: Draft, diagrams: Diagrams, centre: Centre, *, groove: bool, straight: bool
) -> TurnDiagram:
    """Draw the curvature of the theoretical profile; its extreme is the least radius of curvature (m).

    Of a ``groove`` hollows count too; ``straight``: dwells are, as on a developed drum.
    """
    draft.open(CURVATURE)
    mu = draft.scale("μ_κ", "(1/m)/mm")
    axes = graphs.draw_axes(draft, CURVATURE, diagrams.base, mu)
    heights = []
    for turning in centre.turning:
        kappa = draft.draw(f.curvature_of_profile, "κ", turning, centre.pace, unit="1/m")
        heights.append(draft.draw(to_board, "y_κ", kappa))
    points, curves, readings = _raised(draft, diagrams, axes, heights, "κ")
    level = axes.feet
    if not straight:
        one = draft.take(Number, "1", 1.0)
        circle = draft.draw(f.curvature_of_profile, "κ", one, centre.pace, unit="1/m")
        level = _level(draft, diagrams, axes, draft.draw(to_board, "y_κ", circle))
    _outline(draft, diagrams, axes, points, level)
    point, y, angle = _extreme(draft, axes, curves, 0 if groove else 1)
    radius = formulas_drum.sharpest_bend if groove else f.least_radius
    value = draft.draw(radius, "ρ_{min}", y, unit="m")
    chart = Chart(CURVATURE, "κ", "1/m", mu, readings, True, None, ROOM)
    return TurnDiagram(axes, chart, points, curves, (Extreme(point, value, angle),))


def draw_radii(draft: Draft, diagrams: Diagrams, of: Convexity | FaceRegion) -> TurnDiagram:
    """Draw the radius of curvature of a cam with a flat face; its extreme is the least one (m)."""
    draft.open(CURVATURE)
    mu = draft.scale("μ_ρ", "m/mm")
    axes = graphs.draw_axes(draft, CURVATURE, diagrams.base, mu)
    heights = [draft.draw(rescaled, "y_ρ", radius, mu) for radius in of.radii]
    points, curves, readings = _raised(draft, diagrams, axes, heights, "ρ")
    circle = (
        of.rest if isinstance(of, FaceRegion) else draft.draw(total, "ρ_d", of.radius, of.motion.S)
    )
    high = draft.draw(rescaled, "y_d", circle, of.mu, mu)
    _outline(draft, diagrams, axes, points, _level(draft, diagrams, axes, high))
    point, y, angle = _extreme(draft, axes, curves, -1)
    value = draft.draw(in_si, "ρ_{min}", y, unit="m")
    chart = Chart(CURVATURE, "ρ", "m", mu, readings, True, None, ROOM)
    return TurnDiagram(axes, chart, points, curves, (Extreme(point, value, angle),))


def draw_contact(draft: Draft, diagrams: Diagrams, distance: Mark) -> tuple[TurnDiagram, Mark]:
    """Draw how far the contact stands from its foot on a face; its extremes are the farthest and the nearest.

    Return also the length of face between them (Number, m).

    ``distance``: as read on the profile (Length).
    """
    draft.open(CONTACT)
    mu = draft.scale("μ_x", "m/mm")
    axes = graphs.draw_axes(draft, CONTACT, diagrams.base, mu)
    high = draft.draw(rescaled, "y_x", distance, mu)
    lines = draft.draw(square, "(i)", axes.feet, axes.along, sense=1, why=why.ANGLE_AT)
    spots = draft.draw(lay_off, "x", lines, high, why=why.ANGLE_AT)
    curves = _curves(draft, diagrams, [spots] * len(diagrams.stretches))
    _outline(draft, diagrams, axes, [spots] * len(curves), spots)
    extremes = []
    for name, above in (("x_{max}", 1), ("x_{min}", -1)):
        point, y, angle = _extreme(draft, axes, curves, above)
        extremes.append(Extreme(point, draft.draw(in_si, name, y, unit="m"), angle))
    reading = draft.draw(measure_along, "x", axes.feet, spots, axes.up, why=why.DIAGRAM_READ)
    chart = Chart(CONTACT, "x", "m", mu, (reading,), True, None, ROOM)
    drawn = TurnDiagram(axes, chart, (spots,) * len(curves), curves, tuple(extremes))
    length = draft.draw(f.face_length, "l_f", *(one.value for one in extremes), unit="m")
    return drawn, length


def draw_values(
    draft: Draft,
    diagrams: Diagrams,
    view: str,
    letter: str,
    unit: str,
    values: Sequence[Mark],
    rest: Mark | None = None,
    sought: Sequence[tuple[str, int]] = (("max", 1), ("min", -1)),
) -> TurnDiagram:
    """Draw a quantity over the turn; its extremes are the highest and the lowest, if they are ``sought``.

    ``values``: by stretch, ``rest``: of the dwells at all positions (Number); None where it is zero.
    """
    draft.open(view)
    mu = draft.scale(f"μ_{letter}", f"{unit}/mm")
    axes = graphs.draw_axes(draft, view, diagrams.base, mu)
    heights = [draft.draw(to_board, f"y_{letter}", value) for value in values]
    points, curves, readings = _raised(draft, diagrams, axes, heights, letter)
    level = axes.feet
    if rest is not None:
        level = _level(draft, diagrams, axes, draft.draw(to_board, "y_d", rest))
    _outline(draft, diagrams, axes, points, level)
    extremes = []
    for name, above in sought:
        point, y, angle = _extreme(draft, axes, curves, above)
        value = draft.draw(in_si, f"{letter}_{{{name}}}", y, unit=unit)
        extremes.append(Extreme(point, value, angle))
    chart = Chart(view, letter, unit, mu, readings, True, None, ROOM)
    return TurnDiagram(axes, chart, points, curves, tuple(extremes), rest)


def _raised(
    draft: Draft, diagrams: Diagrams, axes: Axes, heights: Sequence[Mark], letter: str
) -> tuple[tuple[Mark, ...], tuple[Mark, ...], tuple[Mark, ...]]:
    """Lay off the ordinates of every stretch; return points, curves and readings."""
    lines = draft.draw(square, "(i)", axes.feet, axes.along, sense=1, why=why.ANGLE_AT)
    points = [
        draft.draw(lay_off, letter, lines, high, free=True, why=why.ANGLE_AT) for high in heights
    ]
    readings = [
        draft.draw(measure_along, f"{letter}_{k}", axes.feet, spots, axes.up)
        for k, spots in enumerate(points, 1)
    ]
    return tuple(points), _curves(draft, diagrams, points), tuple(readings)


def _level(draft: Draft, diagrams: Diagrams, axes: Axes, high: Mark) -> Mark:
    """Lay off the ordinates of the dwells over their ends; ``high``: of all positions (Length)."""
    turn = diagrams.turn
    ends = np.full((1, turn.positions), np.nan)
    for at in (at for phase in turn.phases for at in (phase.first, phase.last)):
        ends[0, at] = turn.angles[at]
    angles = draft.take(Angle, "φ_d", ends, "°")
    x = draft.draw(f.along_turn, "x_d", angles, axes.base.length)
    foot = draft.draw(lay_off, "n", axes.along, x, free=True)
    line = draft.draw(square, "(n)", foot, axes.along, sense=1)
    return draft.draw(lay_off, "d", line, high, free=True)


def _outline(
    draft: Draft, diagrams: Diagrams, axes: Axes, points: Sequence[Mark], level: Mark
) -> None:
    """Tell what is drawn besides the curves: the dwells at their level, the jumps between stretches."""
    turn = diagrams.turn
    rows = diagrams.stretches

    def end(spots: Mark, at: int) -> Mark:
        return draft.draw(phase_end, f"{spots.letter}_e", spots, at=at, free=True)

    for (spots, (_, _, last)), (after, (_, first, _)) in pairwise(zip(points, rows, strict=True)):
        dwell = [end(level, at) for at in (last, first)] if first > last else []
        draft.figure("outline", "between", end(spots, last), *dwell, end(after, first))
    last = turn.phases[-1].last
    low = end(level, last)
    across = draft.draw(parallel, "(d)", low, axes.along)
    over = draft.draw(square, f"({axes.end.name})", axes.end, axes.along, sense=1)
    far = draft.draw(meet, "d_N", over, across, free=True)
    draft.figure("outline", "lower dwell", end(points[-1], last), low, far)
    begin = [draft.draw(meet, "d_0", axes.up, across)] if turn.phases[0].start > 0.0 else []
    draft.figure("outline", "start", *begin, end(level, 0), end(points[0], 0))


def _curves(draft: Draft, diagrams: Diagrams, points: Sequence[Mark]) -> tuple[Mark, ...]:
    return tuple(
        draft.draw(graph_of_stretch, f"({own.letter}–{own.letter})", own, first=first, last=last)
        for own, (_, first, last) in zip(points, diagrams.stretches, strict=True)
    )


def _extreme(
    draft: Draft, axes: Axes, curves: Sequence[Mark], above: int
) -> tuple[Mark, Mark, Mark]:
    """Return the extreme point of some curves, its ordinate (Length) and the angle of the cam (Angle).

    ``above``: 1 for the highest, −1 for the lowest, 0 for the one farther from the axis.
    """
    if above == 0:
        ends = [_top(draft, curves, way, letter) for way, letter in ((1, "h"), (-1, "l"))]
        return _placed(draft, axes, draft.draw(farther_from_axis, "k", *ends, free=True))
    return _placed(draft, axes, _top(draft, curves, above))


def _top(draft: Draft, curves: Sequence[Mark], above: int, name: str = "k") -> Mark:
    letters = [f"{name}_{k}" for k in range(1, len(curves) + 1)] if len(curves) > 1 else [name]
    tops = [
        draft.draw(crest_of_curve, letter, curve, above=above, free=True)
        for letter, curve in zip(letters, curves, strict=True)
    ]
    point = tops[0]
    for k, other in enumerate(tops[1:], 2):
        own = name if other is tops[-1] else f"{name}_{k}′"
        point = draft.draw(extreme_of_two, own, point, other, above=above, free=True)
    return point


def _placed(draft: Draft, axes: Axes, point: Mark) -> tuple[Mark, Mark, Mark]:
    y = draft.draw(measure_along, "y_k", axes.origin, point, axes.up, why=why.EXTREME_READ)
    x = draft.draw(measure_along, "x_k", axes.origin, point, axes.along, why=why.EXTREME_READ)
    return point, y, read_place(draft, axes.base, x)
