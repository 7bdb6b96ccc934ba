"""The law of motion: moments and their work, the energy over the inertia, ω by rays, ε by subnormals, t.

Every graph stands over the same base. What is known at positions is known at the end of the base, too: a
second mark beside that of the row. Moments that depend on the position alone give the energy directly; the
energy–mass diagram then has its true origin, and a ray to the point of a position tells its speed.
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import STANDARD, Chart, integrated_scale
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Base
from graphic_tmm.board.operations.energetics import added, reduced_inertia
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graph_curves import open_graph
from graphic_tmm.board.operations.graphs import at_zero
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.flywheel.energy import draw_energies
from graphic_tmm.chapters.flywheel.plan import reduced_gas, reduced_loads
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder, Machine, machine_of
from graphic_tmm.chapters.kinematics.task import FULL_TURN
from graphic_tmm.chapters.motion_law import operations as op
from graphic_tmm.chapters.motion_law import words as why
from graphic_tmm.chapters.motion_law.by_motor import ByMotor, Inertia
from graphic_tmm.chapters.motion_law.over_angle import Both, at_end
from graphic_tmm.chapters.motion_law.task import (
    ASKED,
    ENERGY,
    MASS,
    MOMENT,
    MOTION_LAW,
    TIME,
    WORK,
    MotionLawTask,
)
from graphic_tmm.chapters.motor.operations import inertia_on_crank, pull_at_rest
from graphic_tmm.chapters.motor.operations_run import (
    run_up,
    run_up_end,
    steady_speed,
)
from graphic_tmm.chapters.motor.plan import DrawnMotor
from graphic_tmm.chapters.motor.record import MOTOR_PLAN
from graphic_tmm.chapters.motor.step import DrawnStep
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded


@dataclass(frozen=True)
class MotionLaw:
    """The law of motion as drawn: its charts, the points of the energy–mass diagram, where the motion ends.

    ``energy``: at positions and at the end of the base, if the machine comes so far (Length); ``omega``: 1/s
    there (Number). ``rest``: where the motion ends (Point on the graph of the energy); ``angle``, ``time``: how
    far and how long it goes until there (Number). ``rays``: those of the diagram, ``curve`` through its points.
    ``error``: by so much ω may be off, %. ``causes``: why there may be no motion, by what is then not known.
    """

    order: MotionLawTask
    base: Base
    turns: int
    cylinder: Cylinder | None
    charts: tuple[Chart, ...]
    inertia: Inertia
    points: Both
    curve: Mark
    rays: Both
    energy: Both
    omega: Both
    rest: Mark
    angle: Mark
    time: Mark
    motor: DrawnMotor | None
    step: DrawnStep | None
    run_up: Mark | None
    delta: Mark | None
    error: Mark | None
    flywheel: Mark | None
    causes: tuple[tuple[Mark, str], ...]


LAW_PLAN: Recorded[MotionLaw] = Recorded(MOTION_LAW)


def record(bench: Bench) -> MotionLaw | None:
    """Draw the law of motion that a scene asks for: by the gas of its cylinders, else by loads of the links."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    cylinder = INDICATOR_PLAN.of(bench) if order.indicator is not None else None
    others = FORCES_PLAN.of(bench), MOTOR_PLAN.of(bench)
    return draw_law(bench.draft, machine_of(bench), order, cylinder, *others)


def draw_law(
    draft: Draft,
    machine: Machine,
    order: MotionLawTask,
    cylinder: Cylinder | None,
    forces: Forces | None,
    motor: DrawnMotor | None,
) -> MotionLaw:
    """Draw everything from the reduced moment to the time.

    Raises
    ------
    StructureError
        If nothing has a mass, or nothing does work.
    """
    law = _Law(draft, machine, order)
    law.moments(cylinder, forces, driven=motor is not None)
    law.works()
    law.motor = motor
    law.inertias()
    law.energies()
    omega = law.rays()
    law.speeds(omega)
    law.accelerations()
    law.times()
    angle, time = law.rests()
    step = law.step()
    return MotionLaw(
        order,
        law.base,
        machine.turns,
        cylinder,
        (*(cylinder.charts if cylinder is not None else ()), *law.charts),
        law.inertia,
        law.points,
        law.curve,
        law.ray_lines,
        law.energy,
        omega,
        law.rest,
        angle,
        time,
        law.motor,
        step,
        law.run_up(),
        law.unevenness(omega),
        law.error(law.known.row),
        law.flywheel,
        tuple(law.causes),
    )


class _Law(ByMotor):
    """The graphs while they are drawn, one after another."""

    energy: Both
    points: Both
    curve: Mark
    ray_lines: Both
    known: Both
    moment_read: Mark
    rest: Mark

    # ------------------------------------------------------------ what acts, and its work

    def moments(self, cylinder: Cylinder | None, forces: Forces | None, *, driven: bool) -> None:
        """Reduce what acts to the crank, draw its moment: positive where it drives.

        ``driven``: by a motor, which needs no load.
        """
        draft, machine, own = self.draft, self.machine, self.order.M
        moment: Mark | None = None
        if cylinder is not None:
            moment, _ = reduced_gas(draft, machine, cylinder, "resisting")
        elif not (own or driven) or (forces is not None and forces.loads.outer):
            moment = reduced_loads(draft, machine, forces, "resisting", MOTION_LAW)
        if own or moment is None:
            constant = draft.take(Number, "M_c", own, "N·m")
            moment = (
                constant
                if moment is None
                else draft.draw(added, "M_Σ", moment, constant, unit="N·m", why=why.MOMENTS)
            )
        assert moment is not None
        mu = draft.scale("μ_M", "(N·m)/mm")
        heights = draft.draw(to_board, "y_M", moment)
        self.moment_axes = graphs.draw_axes(draft, MOMENT, self.base, mu)
        self.moment_points = graphs.lay_ordinates(draft, self.moment_axes, heights, "k")
        self.moment_curve = graphs.taut(draft, self.moment_axes, self.moment_points)
        read = graphs.measure_ordinates(draft, self.moment_axes, self.moment_points.points, "M")
        self.moment_read = read
        self.chart(MOMENT, "M", "N·m", mu, read)

    def works(self) -> None:
        """Integrate the moment: the work of all forces since the first position."""
        draft, source = self.draft, self.moment_axes
        draft.open(WORK)
        scaled = integrated_scale(draft, "A", "J/mm", source.mu, self.base.mu, STANDARD, "H")
        axes = graphs.draw_axes(draft, WORK, self.base, scaled.mu)
        pole = graphs.set_pole(draft, source, scaled.distance)
        at = graphs.integrate(draft, source, self.moment_curve, axes, pole, "A")
        graphs.along_rays(draft, axes, at, pole.point, self.moment_points, source)
        self.work = self.read(axes, at, "A")
        self.work_axes, self.work_at, self.work_mu = axes, at, scaled.mu
        self.chart(WORK, "A", "J", scaled.mu, *self.work)

    # ------------------------------------------------------------ what moves, and its energy

    def inertias(self) -> None:
        """Lay off the reduced moments of inertia, from the true origin; calculate the first energy."""
        draft = self.draft
        draft.open(MASS)
        inertia = self._reduced()
        mu = draft.scale("μ_J", "(kg·m²)/mm")
        x = draft.draw(to_board, "x_J", inertia)
        draft.lay_out()
        origin = draft.take(Point, "O", 0j)
        along = draft.draw(ray, "(Ox)", origin, draft.direction(0.0))
        up = draft.draw(square, "(Oy)", origin, along, sense=1)
        feet = draft.draw(lay_off, "j", along, x, why=why.MASS_POINT)
        end = draft.draw(at_zero, at_end("j"), feet, why=why.SAME_PLACE)
        first_x = draft.draw(measure_along, "x_0", origin, end, along)
        read = draft.draw(measure_along, "J_r", origin, feet, along)
        if self.motor is not None and self.order.steady:
            used = self.by_motor(self.motor, read, mu)
            omega = draft.draw(steady_speed, "ω_0", *used, unit="1/s", row=self.row)
            self.causes += [(inertia, FULL_TURN), (omega, why.NOT_STEADY)]
        else:
            omega = draft.take(Number, "ω_0", self.order.start, "1/s")
        first = draft.draw(op.first_energy, "T_0", first_x, mu, omega, unit="J")
        self.inertia = Inertia(mu, origin, along, up, Both(feet, end), first_x, read, omega, first)
        self.chart(MASS, "J", "kg·m²", mu, read)

    def _reduced(self) -> Mark:
        """Calculate the reduced moment of inertia of links and of what turns with the crank."""
        draft, machine, order = self.draft, self.machine, self.order
        parts = []
        turning = order.J or (order.motor is not None and order.motor.J)
        if any(link.mass or link.inertia for link in machine.mechanism.links) or not turning:
            energies = draw_energies(draft, machine.mechanism, machine.velocities, MOTION_LAW)
            assert machine.velocities.speed is not None
            speed = machine.velocities.speed
            parts.append(
                draft.draw(reduced_inertia, "J_{red}", energies.total, speed, unit="kg·m²")
            )
        if order.J:
            parts.append(draft.take(Number, "J_c", order.J, "kg·m²"))
        if self.motor is not None and order.motor is not None and order.motor.J:
            rotor = draft.take(Number, "J_m", order.motor.J, "kg·m²")
            used = rotor, self.motor.ratio
            parts.append(draft.draw(inertia_on_crank, "J_{m1}", *used, unit="kg·m²"))
        if self.motor is not None and order.delta is not None:
            parts.append(self.sought(self.motor, parts, order.delta))
        whole = parts[0]
        for more in parts[1:]:
            whole = draft.draw(
                added, "J_Σ", whole, more, unit="kg·m²", role=roles.SUM, why=why.INERTIAS
            )
        return whole

    def energies(self) -> None:
        """Draw the kinetic energy, as far as the machine goes; mark where its motion ends."""
        draft = self.draft
        draft.open(ENERGY)
        mu = draft.scale("μ_T", "J/mm")
        known = self._known()
        if not (self.order.start or self.order.steady):
            first = draft.draw(
                op.moment_at, "M_1", self.moment_read, self.moment_axes.mu, unit="N·m"
            )
            if self.motor is not None:
                pull = draft.draw(
                    pull_at_rest, "M_p", self.motor.curve, self.motor.mu_M, unit="N·m"
                )
                first = draft.draw(added, "M_{1p}", first, pull, unit="N·m")
            known = known._replace(row=draft.draw(op.from_rest, "T_d", known.row, first, unit="J"))
        self.known = known
        heights = self.both(to_board, "y_T", (known.row, mu), (known.end, mu))
        axes = graphs.draw_axes(draft, ENERGY, self.base, mu)
        kept = draft.draw(op.until_rest, "y′", heights.row, row=self.row)
        last = draft.draw(op.reached, at_end("y′"), heights.end, kept, row=self.row)
        at = self.laid(axes, Both(kept, last), "g")
        curve = graphs.through(draft, axes, at, closed=False)
        self.rest = draft.draw(op.comes_to_rest, "z", curve)
        self.energy_axes, self.energy_at = axes, at
        self.energy = self.read(axes, at, "T")
        self.chart(ENERGY, "T", "J", mu, *self.energy)

    def _known(self) -> Both:
        """Calculate the kinetic energy: what the forces have done since the beginning, or step by step."""
        own = self.inertia
        if self.motor is None:
            rows, ends = ((own.first, work, self.work_mu) for work in self.work)
            return self.both(op.energy, "T", rows, ends, unit="J")
        used = self.by_motor(self.motor, own.read, own.mu, own.start)
        row = self.draft.draw(run_up, "T", *used, unit="J", row=self.row)
        used = self.by_motor(self.motor, own.read, own.mu, row)
        return Both(row, self.draft.draw(run_up_end, at_end("T"), *used, unit="J", row=self.row))

    def rays(self) -> Both:
        """Draw the rays of the energy–mass diagram; return the speeds that they tell."""
        draft, own, mu_T = self.draft, self.inertia, self.energy_axes.mu
        draft.open(MASS)
        lines = [
            draft.draw(square, f"({foot.letter})", foot, own.along, sense=1, why=why.MASS_POINT)
            for foot in own.feet
        ]
        row, end = zip(lines, self.energy, strict=True)
        self.points = self.both(lay_off, "e", row, end, why=why.MASS_POINT)
        self.curve = draft.draw(open_graph, "(e–e)", *self.points, row=self.row)
        row, end = ((own.origin, point) for point in self.points)
        self.ray_lines = self.both(join, "(Oe)", row, end, why=why.RAY)
        up = [
            draft.draw(measure_along, name, own.origin, point, own.up)
            for name, point in zip(("T′", at_end("T′")), self.points, strict=True)
        ]
        along = [
            draft.draw(measure_along, name, own.origin, point, own.along)
            for name, point in zip(("J′", at_end("J′")), self.points, strict=True)
        ]
        row, end = zip(up, along, strict=True)
        slope = self.both(op.slope_of_ray, "tan ψ", row, end)
        rows, ends = ((one, mu_T, own.mu) for one in slope)
        told = self.both(op.speed_of_ray, "ω′", rows, ends, unit="1/s")
        return told._replace(row=draft.draw(op.begins_with, "ω", told.row, own.start, unit="1/s"))

    # ------------------------------------------------------------ how it moves

    def rests(self) -> tuple[Mark, Mark]:
        """Measure how far the motion goes, calculate how long."""
        draft, axes, speed, energy = self.draft, self.time_axes, self.speed_axes, self.energy_axes
        draft.open(TIME)
        far = draft.draw(measure_along, "x_r", energy.origin, self.rest, energy.along)
        angle = draft.draw(in_si, "φ_r", far, self.base.mu, unit="rad")
        before = draft.draw(op.last_before, "τ_r", self.time_points.points, self.rest, row=self.row)
        fast = draft.draw(op.last_before, "w_r", self.speed.points, self.rest, row=self.row)
        near = draft.draw(measure_along, "x_b", axes.origin, before, axes.along)
        since = draft.draw(measure_along, "t_b", axes.origin, before, axes.up)
        first = draft.draw(measure_along, "ω_b", speed.origin, fast, speed.up)
        high = draft.draw(measure_along, "h_r", energy.origin, self.rest, energy.up)
        slope = draft.draw(op.slope_of_ray, "tan ψ_r", high, self.inertia.x)
        last = draft.draw(op.speed_of_ray, "ω_r", slope, energy.mu, self.inertia.mu, unit="1/s")
        ends = draft.draw(to_board, "y_r", last, speed.mu)
        used = (since, axes.mu, far, near, self.base.mu, first, ends, speed.mu)
        return angle, draft.draw(op.time_at_end, "t_r", *used, unit="s")
