"""The forces of an engine's crank mechanism: P, P_in, P', N, Q, T, K, M as force triangles in every position.

The mass of the rod is shared between the crank pin and the crosshead, so that the rod carries its load along
itself: P' at B is the sum of Q along the rod and of N, the pressure on the guide; Q carried to A is the sum of
T along the tangent of the crank circle and K along the crank. Forces are positive towards the crank.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import in_si, to_board, turn_per_mm
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.operations.statics import moment_on_arm
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.engine import words as why
from graphic_tmm.chapters.engine.formulas import (
    KGF,
    against_acceleration,
    couple_of,
    in_kgf,
    towards_crank,
)
from graphic_tmm.chapters.engine.masses import Harmonics, Lumped, draw_harmonics, lump
from graphic_tmm.chapters.engine.task import ASKED, ENGINE, VIEW, EngineTask
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder, Machine, machine_of
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg, dyads
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

ROOM = 55.0
"""Room for the highest ordinate of a diagram, mm."""
DIAGRAMS = ("P", "N", "Q", "T", "K", "M")
POINTS = {"P_in": "f", "M": "z"}
"""The points of a quantity on its diagram, where its small letter stands for something else."""


class Triangles(NamedTuple):
    """The force triangles of every position: at B its vertices behind P' and behind Q; at A behind Q and T."""

    at_b: Mark
    end_p: Mark
    end_q: Mark
    at_a: Mark
    end_qa: Mark
    end_t: Mark


@dataclass(frozen=True)
class Engine:
    """The forces as drawn; ``values``: the marks of P, P_in, P′, N, Q, T, K (force unit), M, NOB (times metre).

    ``acceleration``: of B towards the crank (m/s²), from the plan; ``curves``: the letters on each diagram;
    ``guide``: the line that B slides along; ``turning``: the axes of the diagram of M, and its curve.
    """

    order: EngineTask
    lumped: Lumped
    harmonics: Harmonics
    acceleration: Mark
    values: dict[str, Mark]
    triangles: Triangles
    mu: Mark
    charts: tuple[Chart, ...]
    curves: dict[str, tuple[str, ...]]
    guide: Mark
    turning: tuple[Axes, Mark]


ENGINE_PLAN: Recorded[Engine] = Recorded(ENGINE)


def record(bench: Bench) -> Engine | None:
    """Draw what the scene asks of an engine's crank mechanism."""
    order, cylinder = ASKED.of(bench.scene), INDICATOR_PLAN.of(bench)
    if order is None:
        return None
    accelerations = KINEMATICS_PLAN.on(bench).accelerations
    assert accelerations is not None
    assert cylinder is not None
    return draw_engine(bench.draft, machine_of(bench), accelerations, cylinder, order)


class _Legs(NamedTuple):
    rod: PinLeg
    slider: GuideLeg


def draw_engine(
    draft: Draft,
    machine: Machine,
    accelerations: Motion,
    cylinder: Cylinder,
    order: EngineTask,
) -> Engine:
    """Draw the forces of the crank mechanism over the turn.

    Raises
    ------
    StructureError
        If the rod does not join the crank pin to the slider's point.
    """
    legs = _legs(machine, cylinder, order)
    draft.open(VIEW)
    lumped = lump(draft, machine.mechanism.by_number[legs.rod.link], legs, machine, order)
    unit = None
    if order.unit == "kgf":
        unit = draft.take(Number, "", KGF, "N/kgf")

    def in_task_unit(letter: str, force: Mark) -> Mark:
        """Return a force in the unit of the task."""
        if unit is None:
            return force
        return draft.draw(in_kgf, letter, force, unit, unit="kgf")

    sign = draft.take(Number, "σ", cylinder.outward)
    reading = accelerations.readings[legs.slider.link]
    acceleration = draft.draw(towards_crank, "a_B", sign, reading, unit="m/s²")
    exact = draft.draw(against_acceleration, "P_{in}", lumped.mass, acceleration, unit="N")
    harmonics = draw_harmonics(draft, machine, lumped.mass, legs, cylinder.outward, in_task_unit)
    draft.open(VIEW)
    values = {
        "P": in_task_unit("P", cylinder.indicator.force),
        "P_in": in_task_unit("P_{in}", exact),
    }
    used = harmonics.force if order.series else values["P_in"]
    values["P′"] = draft.draw(added, "P′", values["P"], used, unit=order.unit, why=why.TOGETHER)
    triangles, mu = _triangles(draft, machine, legs, cylinder.outward, values, order.unit)
    charts, curves, turning = _diagrams(draft, machine, values, order)
    found = (acceleration, values, triangles, mu, charts, curves, legs.slider.line, turning)
    return Engine(order, lumped, harmonics, *found)


def _legs(machine: Machine, cylinder: Cylinder, order: EngineTask) -> _Legs:
    crank = machine.mechanism.drive.link
    for closing in dyads(machine.positions.closings, "engine"):
        first, second = closing.legs
        joined = cylinder.leg in (first, second) and closing.letter == order.point
        if joined and isinstance(first, PinLeg) and first.body == crank:
            assert isinstance(second, GuideLeg)
            return _Legs(first, second)
    raise StructureError(
        said(
            "no connecting rod joins the crank to {point}: these forces are those of a crank, a "
            "rod and a slider on the frame",
            point=order.point,
        ),
        "engine.point",
        head="engine",
    )


def _triangles(
    draft: Draft,
    machine: Machine,
    legs: _Legs,
    outward: float,
    values: dict[str, Mark],
    unit: str,
) -> tuple[Triangles, Mark]:
    """Draw both triangles at their points on the plan; read N, Q, T and K; calculate M and N·OB."""
    at_b, at_a = machine.positions.point(_pin(machine, legs)), legs.rod.pivot
    pivot = machine.positions.point(machine.pivot)
    crank = machine.positions.bodies[machine.mechanism.drive.link].axis
    mu = draft.scale("μ_F", f"{unit}/mm")
    draft.lay_out()
    inward = draft.draw(
        parallel, "(P′)", at_b, legs.slider.line, sense=-1 if outward > 0 else 1, why=why.P_LINE
    )
    end_p = draft.draw(
        lay_off, "1", inward, draft.draw(to_board, "y_P′", values["P′"]), why=why.P_LINE
    )
    sense = machine.mechanism.drive.sense
    across = draft.draw(square, "(N)", end_p, inward, sense=sense, why=why.N_LINE)
    rod = draft.draw(parallel, "(Q)", at_b, legs.rod.line, sense=-1, why=why.Q_LINE)
    end_q = draft.draw(meet, "2", across, rod, why=why.P_RESOLVED)
    length_n = draft.draw(measure_along, "y_N", end_q, end_p, across, why=why.FORCE_READ)
    length_q = draft.draw(measure_along, "y_Q", at_b, end_q, rod, why=why.FORCE_READ)
    carried = draft.draw(parallel, "(Q′)", at_a, legs.rod.line, sense=-1, why=why.Q_CARRIED)
    end_qa = draft.draw(lay_off, "3", carried, length_q, why=why.Q_CARRIED)
    tangent = draft.draw(square, "(T)", at_a, crank, sense=sense, why=why.T_LINE)
    along = draft.draw(parallel, "(K)", end_qa, crank, sense=-1, why=why.K_LINE)
    end_t = draft.draw(meet, "4", tangent, along, why=why.Q_RESOLVED)
    length_t = draft.draw(measure_along, "y_T", at_a, end_t, tangent, why=why.FORCE_READ)
    length_k = draft.draw(measure_along, "y_K", end_t, end_qa, along, why=why.FORCE_READ)
    for name, length in (("N", length_n), ("Q", length_q), ("T", length_t), ("K", length_k)):
        values[name] = draft.draw(in_si, name, length, unit=unit)
    moment = f"{unit}·m"
    values["M"] = draft.draw(moment_on_arm, "M", values["T"], machine.arm, unit=moment)
    distance = draft.draw(
        measure, f"{machine.pivot}{_pin(machine, legs)}", pivot, at_b, why=why.DISTANCE
    )
    values["NOB"] = draft.draw(couple_of, "N·OB", values["N"], distance, unit=moment)
    return Triangles(at_b, end_p, end_q, at_a, end_qa, end_t), mu


def _pin(machine: Machine, legs: _Legs) -> str:
    return next(c.letter for c in machine.positions.closings if legs.rod in c.legs)


def ordinate(symbol: str, letter: str) -> str:
    """Return the letter of an ordinate that stands for a quantity: y_{Pin} of P_in."""
    return f"{symbol}_{{{letter.replace('_', '')}}}"


def _diagrams(
    draft: Draft, machine: Machine, values: dict[str, Mark], order: EngineTask
) -> tuple[tuple[Chart, ...], dict[str, tuple[str, ...]], tuple[Axes, Mark]]:
    """Draw the diagrams over the turn: P, P_in and P′ on one, then N, Q, T, K and M, the last one told."""
    length = draft.take(Length, "L", order.base, "mm", roles.BASE)
    mu_phi = draft.draw(turn_per_mm, "μ_φ", length, unit="rad/mm")
    base = graphs.lay_base(draft, length, mu_phi, machine.count, machine.numbers[None, :])
    charts: list[Chart] = []
    curves: dict[str, tuple[str, ...]] = {}
    for symbol in DIAGRAMS:
        view = f"engine {symbol}"
        unit = order.unit if symbol != "M" else f"{order.unit}·m"
        letters = ("P", "P_in", "P′") if symbol == "P" else (symbol,)
        draft.open(view)
        mu = draft.scale(f"μ_{symbol}", f"({unit})/mm" if symbol == "M" else f"{unit}/mm")
        axes = graphs.draw_axes(draft, view, base, mu)
        found = []
        for letter in letters:
            heights = draft.draw(to_board, ordinate("h", letter), values[letter])
            at = graphs.lay_ordinates(draft, axes, heights, POINTS.get(letter, letter.lower()))
            # the links' own inertia is smooth, what the gas has a part in is not
            draw_curve = graphs.through if letter == "P_in" else graphs.taut
            curve = draw_curve(draft, axes, at)
            found.append(graphs.measure_ordinates(draft, axes, at.points, ordinate("y", letter)))
        charts.append(Chart(view, symbol, unit, mu, tuple(found), True, None, ROOM))
        curves[view] = letters
    return tuple(charts), curves, (axes, curve)
