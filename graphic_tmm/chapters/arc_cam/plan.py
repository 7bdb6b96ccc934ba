"""A cam given by arcs: its contour, the follower in all positions, the diagrams of its motion by chords."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from graphic_tmm.board import graphs
from graphic_tmm.board.charts import STANDARD, Chart, derived_scale
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base, Boundaries
from graphic_tmm.board.operations.formulas import rescaled
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard_length
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam.contour import Contour, draw_contour
from graphic_tmm.chapters.arc_cam.follower import Follower, draw_follower
from graphic_tmm.chapters.arc_cam.geometry import SAME, Lie, lie
from graphic_tmm.chapters.arc_cam.task import ARC_CAM, ASKED, CHANGES, ArcTask
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

VIEWS = {"S": "arc cam S", "V": "arc cam dS", "A": "arc cam ddS"}
LETTERS = {"S": "S", "V": "S′", "A": "S″"}
ROOM = 50.0
"""Room for the highest ordinate of a diagram, mm."""
REACH = 130.0
"""Room for the contour with its follower about it, mm."""


@dataclass(frozen=True)
class ArcCam:
    """A cam given by arcs as drawn. ``sense``: 1 if it turns counter-clockwise, −1 clockwise.

    ``angles``: of the cam (degrees) in all positions, the row first; ``charts``: S, dS/dφ, d²S/dφ², by the
    keys of `VIEWS`.
    """

    order: ArcTask
    sense: int
    lie: Lie
    angles: tuple[float, ...]
    contour: Contour
    follower: Follower
    base: Base
    charts: dict[str, Chart]


ARC_CAM_PLAN: Recorded[ArcCam] = Recorded(ARC_CAM)


def record(bench: Bench) -> ArcCam | None:
    """Draw the cam that the scene asks for, at a share of its usual size where there is one."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    made = draw_arc_cam(bench.draft, order, bench.sizes.get(ARC_CAM, 1.0))
    names = [*map(str, range(order.parts + 1)), *_changes(made.lie, order.parts)]
    bench.stand(names, made.angles, order.parts)
    return made


def draw_arc_cam(draft: Draft, order: ArcTask, size: float = 1.0) -> ArcCam:
    """Draw a cam given by arcs; ``size``: what share of the usual room it takes.

    Raises
    ------
    TaskError
        If the arcs do not touch, or the follower does not reach them.
    """
    where, sense = lie(order), 1 if order.turns == "counterclockwise" else -1
    mu = order.mu_l or standard_length(reach_of(order), size * REACH)
    contour = draw_contour(draft, order, mu, sense, where.changes[0])
    numbers = np.array([*range(order.parts + 1), *_changes(where, order.parts).values()])
    follower = draw_follower(draft, order, contour, where, numbers, sense)
    draft.open(VIEWS["S"])
    length = draft.take(Length, "L", order.length * size, "mm")
    mu_phi = draft.draw(f.work_per_mm, "μ_φ", follower.work, length, unit="rad/mm")
    base = graphs.lay_base(draft, length, mu_phi, order.parts, numbers[None, :])
    charts = _diagrams(draft, order, follower, base)
    angles = tuple(float(n) * where.work / order.parts for n in numbers)
    return ArcCam(order, sense, where, angles, contour, follower, base, charts)


def reach_of(order: ArcTask) -> float:
    """Return how far the contour with its follower reaches from the cam's centre, m."""
    high = order.distance + order.nose + 2.0 * order.roller
    return max(high, order.centres or 0.0)


def _changes(where: Lie, parts: int) -> dict[str, float]:
    """Return the numbers, by name, at which the follower goes onto the nose and off it, off the row."""
    found: dict[str, float] = {}
    for name, angle in zip(CHANGES, where.changes[1:3], strict=True):
        number = (angle - where.changes[0]) * parts / where.work
        known = (*found.values(), round(number))
        if not any(abs(number - one) < SAME for one in known):
            found[name] = number
    return found


def _diagrams(draft: Draft, order: ArcTask, follower: Follower, base: Base) -> dict[str, Chart]:
    """Lay S off over the turn and differentiate it twice by chords."""
    rocks = order.rocks
    unit = "rad" if rocks else "m"
    draft.open(VIEWS["S"])
    mu = draft.scale("μ_S", f"{unit}/mm")
    if rocks:
        length = draft.draw(f.swing_on_board, "y_S", follower.travel)
    else:
        length = draft.draw(rescaled, "y_S", follower.travel, mu)
    axes = graphs.draw_axes(draft, VIEWS["S"], base, mu)
    at = graphs.lay_ordinates(draft, axes, length, "s")
    graphs.through(draft, axes, at)
    charts = {"S": _chart(draft, "S", axes, at, unit)}
    for which, letter in (("V", "v"), ("A", "a")):
        draft.open(VIEWS[which])
        symbol = f"{{{LETTERS[which]}}}"
        scaled = derived_scale(draft, symbol, f"{unit}/mm", axes.mu, base.mu, STANDARD)
        to = graphs.draw_axes(draft, VIEWS[which], base, scaled.mu)
        pole = graphs.set_pole(draft, to, scaled.distance)
        middles = graphs.by_chords(draft, axes, at, to, pole, f"{letter}′")
        curve = graphs.through(draft, to, middles)
        at, axes = graphs.on_curve(draft, to, curve, letter), to
        charts[which] = _chart(draft, which, axes, at, unit)
    return charts


def _chart(draft: Draft, which: str, axes: Axes, at: Boundaries, unit: str) -> Chart:
    draft.open(axes.view)
    ordinate = graphs.measure_ordinates(draft, axes, at.points, LETTERS[which])
    return Chart(axes.view, LETTERS[which], unit, axes.mu, (ordinate,), True, None, ROOM)


def marks(made: ArcCam) -> dict[str, Mark]:
    """Return what the diagrams give, by the names of columns: the ordinates read (Length)."""
    names = {"S": "S", "V": "dS", "A": "ddS"}
    return {names[which]: chart.ordinates[0] for which, chart in made.charts.items()}
