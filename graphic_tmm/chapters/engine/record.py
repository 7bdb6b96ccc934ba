"""What is recorded of an engine: its plan; aside β, the book's formulas as a check, the works of T and of P."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.graphs import level_off
from graphic_tmm.board.operations.instruments import measure, measure_along, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.engine.formulas import (
    KGF,
    guide_pressure,
    in_kgf,
    mass_by_weight,
    mean_of_row,
    moment_of_rod,
    radial_force,
    rod_force,
    slope_of_rod,
    tangential_force,
    tipping_couple,
    work_of_gas,
    work_of_turn,
    works_apart,
)
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN, Engine, record
from graphic_tmm.chapters.engine.task import ASKED, CALCULATED, ENGINE, MASSES, WORKS_VIEW
from graphic_tmm.chapters.engine.transfer import Transfer, draw_transfer
from graphic_tmm.chapters.indicator.diagram import Side
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder, Machine, machine_of
from graphic_tmm.chapters.indicator.task import INDICATOR, Wish
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, FULL_TURN, VELOCITIES
from graphic_tmm.mechanism.records import Link
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside
from graphic_tmm.scene.records import Scene

WORKS = ("work_T", "work_P", "work_apart")
"""What the results of the works are called."""


class _Plan(NamedTuple):
    """What is measured on the plan (Length): A off and along the guide, rod, crank, A off and along Q at O."""

    height: Mark
    along: Mark
    rod: Mark
    crank: Mark
    arm: Mark
    part: Mark


class Aside(NamedTuple):
    """Marks (Number; angles in degrees).

    ``beta``: of the rod with the guide; ``checks``: N, Q, T, K and M by the formulas, by what they check;
    ``works``: of T and of P over a turn (J, or kgf·m) and by how much they differ, %. ``transfer``: the figure
    of all forces. ``parts``: what the masses of crosshead and rod come to where the whole is given (unit of the
    task), None where it is calculated of them anyway.
    """

    beta: Mark
    checks: Mapping[str, Mark]
    works: tuple[Mark, Mark, Mark]
    transfer: Transfer
    parts: Mark | None


BESIDE: Recorded[Aside] = Recorded(aside(ENGINE))


def record_beside(bench: Bench) -> Aside:
    """Calculate what the drawing of an engine's forces does not need."""
    made, draft, machine = ENGINE_PLAN.on(bench), bench.draft, machine_of(bench)
    transfer = draw_transfer(draft, made, machine)
    draft.open(CALCULATED)
    plan = _measure(draft, made, machine)
    checks = _checks(draft, made, plan)
    beta = draft.draw(slope_of_rod, "β", plan.height, plan.along)
    draft.open(MASSES)
    slider = machine.mechanism.by_number[INDICATOR_PLAN.on(bench).leg.link]
    parts = _sum_of_masses(draft, made, slider)
    draft.open(WORKS_VIEW)
    works = _works(draft, made, INDICATOR_PLAN.on(bench), machine.count)
    return Aside(beta, checks, works, transfer, parts)


def _measure(draft: Draft, made: Engine, machine: Machine) -> _Plan:
    """Measure the plan of positions; lengths are positive in the first half of a turn."""
    t, pivot = made.triangles, machine.positions.point(machine.pivot)
    sense = machine.mechanism.drive.sense
    across, rod = draft.uses(t.end_q)
    off = draft.draw(square, "(e)", pivot, rod, sense=-sense)
    return _Plan(
        draft.draw(measure_along, "h_A", t.at_a, t.at_b, across),
        draft.draw(measure_along, "x", t.at_b, t.at_a, draft.uses(t.end_p)[0]),
        draft.draw(measure, "AB", t.at_a, t.at_b),
        draft.draw(measure, "OA", pivot, t.at_a),
        draft.draw(measure_along, "e", pivot, t.at_a, off),
        draft.draw(measure_along, "k", t.at_a, pivot, rod),
    )


def _checks(draft: Draft, made: Engine, plan: _Plan) -> dict[str, Mark]:
    """Calculate by the formulas what the triangles gave."""
    force, of = made.values["P′"], made.order.unit
    height, along, rod, crank, arm, part = plan
    return {
        "N": draft.draw(guide_pressure, "N′", force, height, along, unit=of),
        "Q": draft.draw(rod_force, "Q′", force, rod, along, unit=of),
        "T": draft.draw(tangential_force, "T′", force, arm, crank, rod, along, unit=of),
        "K": draft.draw(radial_force, "K′", force, part, crank, rod, along, unit=of),
        "M": draft.draw(moment_of_rod, "M_Q", made.values["Q"], arm, draft.mu_l, unit=f"{of}·m"),
        "M′": draft.draw(tipping_couple, "M′", force, arm, rod, along, draft.mu_l, unit=f"{of}·m"),
    }


def _sum_of_masses(draft: Draft, made: Engine, slider: Link) -> Mark | None:
    """Add up the masses that go to and fro where their sum is given."""
    lumped = made.lumped
    if made.order.mass is None or slider.mass is None or lumped.at_slider is None:
        return None
    own = draft.take(Number, f"m_{slider.number}", slider.mass, "kg")
    whole = draft.draw(added, "m_Σ", own, lumped.at_slider, unit="kg")
    if made.order.unit != "kgf":
        return whole
    unit = draft.take(Number, "", KGF, "N/kgf")
    return draft.draw(mass_by_weight, "m′", whole, unit, unit="kgf·s²/m")


def _works(draft: Draft, made: Engine, cylinder: Cylinder, count: int) -> tuple[Mark, Mark, Mark]:
    """Calculate the work of T by the area below the graph of M, that of P by the indicator diagrams."""
    axes, curve = made.turning
    top = draft.draw(level_off, "h", curve, axes.feet, axes.after)
    height = draft.draw(measure_along, "y_h", axes.feet, top, axes.up)
    of = axes.mu.unit.removesuffix("/mm").strip("()")
    part = draft.draw(in_si, "M_h", height, axes.mu, unit=of)
    mean = draft.draw(mean_of_row, "M_m", part, unit=of, row=count)
    turning = draft.draw(work_of_turn, "A_T", mean, unit=of)
    stroke = draft.draw(in_si, "S", cylinder.indicator.stroke, draft.mu_l, unit="m")
    found = (_work(draft, cylinder, side, stroke) for side in cylinder.indicator.sides)
    gas, *others = (work for work in found if work is not None)
    for one in others:
        gas = draft.draw(added, "A_P" if made.order.unit == "N" else "A_P′", gas, one, unit="J")
    if made.order.unit == "kgf":
        gas = draft.draw(in_kgf, "A_P", gas, draft.take(Number, "", KGF, "N/kgf"), unit=of)
    return turning, gas, draft.draw(works_apart, "Δ_A", turning, gas, unit="%")


def _work(draft: Draft, cylinder: Cylinder, side: Side, stroke: Mark) -> Mark | None:
    """Calculate the work that the gas of one side does in a turn, by its mean pressure; None if none."""
    if side.mean is None:
        return None
    letter = side.force.letter[-1]
    sign = draft.take(Number, f"σ_{letter}", _sense(draft, cylinder, side))
    uses = (sign, side.mean, draft.uses(side.force)[1], stroke)
    return draft.draw(work_of_gas, f"A_{letter}", *uses, unit="J")


def _sense(draft: Draft, cylinder: Cylinder, side: Side) -> float:
    """Return +1 where the gas of a side drives over a turn, −1 where it resists.

    The planimeter tells no sign, so it is by how the diagram is gone round, chosen before the log is run:
    driving gas is high on the way out on the side of the cover, on the way back on that of the shaft.
    """
    given = {**draft.given, draft.mu_l: 1.0, cylinder.indicator.chart.mu: 1.0}
    knots = execute(draft.board.construction(), given, [side.curve])[side.curve].knots[0]
    around = float(np.sum((np.conj(knots) * np.roll(knots, -1)).imag))
    return float(np.sign(-around if side.name == "cover" else around))


def _needs(scene: Scene) -> dict[str, object]:
    order = ASKED.of(scene)
    assert order is not None
    wish = Wish(2, ENGINE, order.indicator)
    return {VELOCITIES: True, ACCELERATIONS: True, INDICATOR: wish}


PLAN = Plan(
    needs=_needs,
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.values["M"],),
    remedy=FULL_TURN,
)
