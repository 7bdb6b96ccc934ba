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
from graphic_tmm.chapters.cam.centre import Centre
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.flat import Convexity
from graphic_tmm.chapters.cam.operations import crest_of_curve, extreme_of_two, phase_end

PRESSURE, CURVATURE = "cam pressure", "cam curvature"
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
    """A diagram over the turn: its chart; points, curves and positions by stretch; its extremes."""

    axes: Axes
    chart: Chart
    points: tuple[Mark, ...]
    curves: tuple[Mark, ...]
    extremes: tuple[Extreme, ...]


def draw_pressure(draft: Draft, diagrams: Diagrams, centre: Centre) -> TurnDiagram:
    """Draw the pressure angle; its extremes are the highest of the rise and the lowest of the return."""
    board = draft.board
    board.open(PRESSURE)
    mu = draft.take(Number, "μ_α", DEGREES, "°/mm")
    axes = graphs.draw_axes(draft, PRESSURE, diagrams.base, mu)
    high = board.draw(f.on_protractor, "y_α", centre.pressure, mu)
    lines = board.draw(square, "(i)", axes.feet, axes.along, sense=1)
    spots = board.draw(lay_off, "p", lines, high)
    curves = _curves(draft, diagrams, [spots] * len(diagrams.stretches))
    _outline(draft, diagrams, axes, [spots] * len(curves), spots)
    extremes = []
    for phase in diagrams.turn.phases:
        own = [c for c, row in zip(curves, diagrams.stretches, strict=True) if row[0] is phase]
        point, y, angle = _extreme(draft, axes, own, phase.sign)
        name = "α_{max}" if phase.sign > 0 else "α_{min}"
        value = board.draw(f.off_protractor, name, y, mu, unit="°")
        extremes.append(Extreme(point, value, angle))
    reading = board.draw(measure_along, "α", axes.feet, spots, axes.up)
    chart = Chart(PRESSURE, "α", "°", mu, (reading,), False, DEGREES, ROOM)
    return TurnDiagram(axes, chart, (spots,) * len(curves), curves, tuple(extremes))


def draw_curvature(draft: Draft, diagrams: Diagrams, centre: Centre) -> TurnDiagram:
    """Draw the curvature of the theoretical profile; its extreme is the least radius of curvature (m)."""
    board = draft.board
    board.open(CURVATURE)
    mu = board.take(Number, "μ_κ", "(1/m)/mm")
    axes = graphs.draw_axes(draft, CURVATURE, diagrams.base, mu)
    heights = []
    for turning in centre.turning:
        kappa = board.draw(
            f.curvature_of_profile, board.free("κ"), turning, centre.pace, centre.mu, unit="1/m"
        )
        heights.append(board.draw(to_board, "y_κ", kappa, mu))
    points, curves, readings = _raised(draft, diagrams, axes, heights, "κ")
    circle = board.draw(
        f.curvature_of_profile,
        "κ",
        draft.take(Number, "1", 1.0),
        centre.pace,
        centre.mu,
        unit="1/m",
    )
    high = board.draw(to_board, "y_κ", circle, mu)
    _outline(draft, diagrams, axes, points, _level(draft, diagrams, axes, high))
    point, y, angle = _extreme(draft, axes, curves, 1)
    value = board.draw(f.least_radius, "ρ_{min}", y, mu, unit="m")
    chart = Chart(CURVATURE, "κ", "1/m", mu, readings, True, None, ROOM)
    return TurnDiagram(axes, chart, points, curves, (Extreme(point, value, angle),))


def draw_radii(draft: Draft, diagrams: Diagrams, of: Convexity) -> TurnDiagram:
    """Draw the radius of curvature of a cam with a flat face; its extreme is the least one (m)."""
    board = draft.board
    board.open(CURVATURE)
    mu = board.take(Number, "μ_ρ", "m/mm")
    axes = graphs.draw_axes(draft, CURVATURE, diagrams.base, mu)
    heights = [board.draw(rescaled, board.free("y_ρ"), radius, of.mu, mu) for radius in of.radii]
    points, curves, readings = _raised(draft, diagrams, axes, heights, "ρ")
    circle = board.draw(total, "ρ_d", of.radius, of.motion.S)
    high = board.draw(rescaled, "y_d", circle, of.mu, mu)
    _outline(draft, diagrams, axes, points, _level(draft, diagrams, axes, high))
    point, y, angle = _extreme(draft, axes, curves, -1)
    value = board.draw(in_si, "ρ_{min}", y, mu, unit="m")
    chart = Chart(CURVATURE, "ρ", "m", mu, readings, True, None, ROOM)
    return TurnDiagram(axes, chart, points, curves, (Extreme(point, value, angle),))


def _raised(
    draft: Draft, diagrams: Diagrams, axes: Axes, heights: Sequence[Mark], letter: str
) -> tuple[tuple[Mark, ...], tuple[Mark, ...], tuple[Mark, ...]]:
    """Lay off the ordinates of every stretch; return points, curves and readings."""
    board = draft.board
    lines = board.draw(square, "(i)", axes.feet, axes.along, sense=1)
    points = [board.draw(lay_off, board.free(letter), lines, high) for high in heights]
    readings = [
        board.draw(measure_along, f"{letter}_{k}", axes.feet, spots, axes.up)
        for k, spots in enumerate(points, 1)
    ]
    return tuple(points), _curves(draft, diagrams, points), tuple(readings)


def _level(draft: Draft, diagrams: Diagrams, axes: Axes, high: Mark) -> Mark:
    """Lay off the ordinates of the dwells over their ends; ``high``: of all positions (Length)."""
    board, turn = draft.board, diagrams.turn
    ends = np.full((1, turn.positions), np.nan)
    for at in (0, turn.rise.last, turn.fall.first, turn.fall.last):
        ends[0, at] = turn.angles[at]
    angles = draft.take(Angle, board.free("φ_d"), ends, "°")
    x = board.draw(f.along_turn, "x_d", angles, axes.base.length)
    foot = board.draw(lay_off, board.free("n"), axes.along, x)
    line = board.draw(square, "(n)", foot, axes.along, sense=1)
    return board.draw(lay_off, board.free("d"), line, high)


def _outline(
    draft: Draft, diagrams: Diagrams, axes: Axes, points: Sequence[Mark], level: Mark
) -> None:
    """Tell what is drawn besides the curves: the dwells at their level, the jumps between stretches."""
    board, turn = draft.board, diagrams.turn
    rows = diagrams.stretches

    def end(spots: Mark, at: int) -> Mark:
        return board.draw(phase_end, board.free(f"{spots.letter}_e"), spots, at=at)

    for (spots, (_, _, last)), (after, (_, first, _)) in pairwise(zip(points, rows, strict=True)):
        dwell = [end(level, at) for at in (last, first)] if first > last else []
        board.figure("outline", "between", end(spots, last), *dwell, end(after, first))
    low = end(level, turn.fall.last)
    across = board.draw(parallel, "(d)", low, axes.along)
    over = board.draw(square, f"({axes.end.name})", axes.end, axes.along, sense=1)
    far = board.draw(meet, board.free("d_N"), over, across)
    board.figure("outline", "lower dwell", end(points[-1], turn.fall.last), low, far)
    board.figure("outline", "start", end(level, 0), end(points[0], 0))


def _curves(draft: Draft, diagrams: Diagrams, points: Sequence[Mark]) -> tuple[Mark, ...]:
    return tuple(
        draft.board.draw(
            graph_of_stretch, f"({own.letter}–{own.letter})", own, first=first, last=last
        )
        for own, (_, first, last) in zip(points, diagrams.stretches, strict=True)
    )


def _extreme(
    draft: Draft, axes: Axes, curves: Sequence[Mark], above: int
) -> tuple[Mark, Mark, Mark]:
    """Return the extreme point of some curves, its ordinate (Length) and the angle of the cam (Angle)."""
    board = draft.board
    letters = [f"k_{k}" for k in range(1, len(curves) + 1)] if len(curves) > 1 else ["k"]
    tops = [
        board.draw(crest_of_curve, board.free(letter), curve, above=above)
        for letter, curve in zip(letters, curves, strict=True)
    ]
    point = tops[0]
    for other in tops[1:]:
        point = board.draw(extreme_of_two, board.free("k"), point, other, above=above)
    y = board.draw(measure_along, board.free("y_k"), axes.origin, point, axes.up)
    x = board.draw(measure_along, board.free("x_k"), axes.origin, point, axes.along)
    angle = board.draw(f.angle_of_turn, board.free("φ_k"), x, axes.base.length, unit="°")
    return point, y, angle
