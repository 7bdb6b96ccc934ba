"""A flywheel by moments given over a cycle: the moment, works by graphical integration, ΔT, δ or J, the rim.

There are no links, so there is no energy of theirs to be taken off: what the driving moment has done more than
the resisting one, ΔT, is the energy of the flywheel.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base, Boundaries
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.cycle.task import ASKED, CYCLE, CycleTask
from graphic_tmm.chapters.flywheel.plan import (
    Flywheel,
    Works,
    angle_per_mm,
    draw_aim,
    draw_segment,
    draw_works,
    refuse,
)
from graphic_tmm.chapters.flywheel.rim import draw_rim
from graphic_tmm.chapters.flywheel.task import VIEWS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import DECIMALS, Bench
from graphic_tmm.scene.chapter import Recorded


class Cycle(NamedTuple):
    """The flywheel as drawn, and the mean angular velocity of its shaft (1/s)."""

    order: CycleTask
    flywheel: Flywheel
    speed: Mark


CYCLE_PLAN: Recorded[Cycle] = Recorded(CYCLE)


def record(bench: Bench) -> Cycle | None:
    """Draw the flywheel that a scene asks for by moments over a cycle."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    step = 360.0 * order.turns / order.positions
    angles = [round(step * k, DECIMALS) for k in range(order.positions)]
    bench.stand((str(k) for k in range(order.positions)), angles, order.positions)
    return draw_cycle(bench.draft, order, angles)


def draw_cycle(draft: Draft, order: CycleTask, angles: list[float]) -> Cycle:
    """Draw the graphs over the cycle, and calculate the flywheel; ``angles``: of the positions, degrees.

    Raises
    ------
    StructureError
        If no moment is given, or δ, J or H is not positive.
    """
    refuse(order.flywheel, "cycle")
    if not order.moments:
        raise StructureError(
            said("no moment is given over the cycle; write [[moment]] with its points"),
            "cycle",
            head="cycle",
        )
    base, moment, axes, at, chart, curve = _moment(draft, order, angles)
    done = draw_works(draft, axes, at, curve, order.flywheel)
    surplus, own, energy = _energy(draft, axes, at, done)
    segment = draw_segment(draft, surplus, own)
    speed = draft.take(Number, "ω_1", abs(order.speed), "1/s")
    delta, inertia = draw_aim(draft, order.flywheel, segment, speed)
    rim, asked = None, order.flywheel.rim
    if asked is not None:
        rim = draw_rim(draft, inertia, speed, order.speed, asked, "cycle")
    made = Flywheel(
        order=order.flywheel,
        base=base,
        moment=moment,
        axes=axes,
        constant=done.constant,
        cylinder=None,
        parts=(),
        charts=(chart, done.chart, energy),
        energies=None,
        works=(done.points, done.straight),
        sides=done.sides,
        segment=segment,
        delta=delta,
        inertia=inertia,
        energy_mass=None,
        rim=rim,
    )
    return Cycle(order, made, speed)


def _moment(
    draft: Draft, order: CycleTask, angles: list[float]
) -> tuple[Base, Mark, Axes, Boundaries, Chart, Mark]:
    """Lay off the sum of the moments over the cycle."""
    draft.open(VIEWS["moment"])
    length = draft.take(Length, "L", order.flywheel.base, "mm", roles.BASE)
    mu_phi = angle_per_mm(draft, length, order.turns)
    count = order.positions
    base = graphs.lay_base(draft, length, mu_phi, count, np.arange(float(count))[None, :])
    moment, *others = (
        draft.take(Number, letter, np.array([[one.at(angle) for angle in angles]]), "N·m")
        for letter, one in zip(_letters(len(order.moments)), order.moments, strict=True)
    )
    for part in others:
        moment = draft.draw(added, "ΣM", moment, part, unit="N·m", role=roles.SUM)
    mu = draft.scale("μ_M", "(N·m)/mm")
    heights = draft.draw(to_board, "y_M", moment)
    axes = graphs.draw_axes(draft, VIEWS["moment"], base, mu)
    at = graphs.lay_ordinates(draft, axes, heights, "k")
    curve = graphs.taut(draft, axes, at)
    read = graphs.measure_ordinates(draft, axes, at.points, "M")
    chart = Chart(VIEWS["moment"], "M", "N·m", mu, (read,), True, order.flywheel.mu_M, None)
    return base, moment, axes, at, chart, curve


def _letters(count: int) -> list[str]:
    return [f"M_{k}" for k in range(1, count + 1)] if count > 1 else ["M"]


def _energy(draft: Draft, source: Axes, at: Boundaries, done: Works) -> tuple[Axes, Mark, Chart]:
    """Draw ΔT, which the flywheel has alone, on level axes of its own."""
    axes = graphs.draw_axes(draft, VIEWS["energy"], done.axes.base, done.axes.mu)
    gained = graphs.lay_ordinates(draft, axes, done.surplus, "g")
    own = graphs.along_rays(draft, axes, gained, done.pole, at, source)
    read = graphs.measure_ordinates(draft, axes, gained.points, "ΔT")
    chart = done.chart._replace(view=VIEWS["energy"], symbol="T", ordinates=(read,), figure=())
    return axes, own, chart
