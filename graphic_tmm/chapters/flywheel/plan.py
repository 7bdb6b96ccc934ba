"""The flywheel: reduced moment, works by graphical integration, the energy of the flywheel, its inertia.

ΔT is what the driving forces have done more than the resisting ones; less the energy of the links it is that of
the flywheel. The highest and the lowest point of its curve, carried to the ordinate axis, give the segment cd.
The curves of A and ΔT are drawn with their tangents, the rays from the pole; that of the flywheel's energy is
the difference of two curves: so it turns where the moments balance, between the positions, not at one of them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import Chart, integrated_scale
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes, Base, Boundaries, Pole
from graphic_tmm.board.operations.energetics import (
    added,
    flywheel_inertia,
    irregularity,
    moment_of_drive,
    moment_of_resistance,
    reduced_moment,
)
from graphic_tmm.board.operations.formulas import cycle_per_mm, to_board, turn_per_mm
from graphic_tmm.board.operations.graphs import highest, lowest
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.flywheel import words as why
from graphic_tmm.chapters.flywheel.energy import (
    Energies,
    EnergyMass,
    Surplus,
    draw_energies,
    draw_energy_mass,
)
from graphic_tmm.chapters.flywheel.rim import DrawnRim, draw_rim
from graphic_tmm.chapters.flywheel.task import ASKED, FLYWHEEL, VIEWS, FlywheelTask
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.indicator.diagram import letter_of
from graphic_tmm.chapters.indicator.plan import (
    INDICATOR_PLAN,
    Cylinder,
    Machine,
    machine_of,
)
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.declare import bound_of


@dataclass(frozen=True)
class Flywheel:
    """The flywheel as drawn: its cylinders, charts, energies, the inertia found, rim, second method.

    ``moment``: the reduced moment that varies (N·m), ``axes`` of its graph, ``constant``: the other one, marked
    on its axis (Point). ``works``: the points of the integrated side and of the straight one; ``sides``: its
    curve and its line; ``segment``: cd (Length). ``delta``, ``inertia``: δ and J of the flywheel, of which one
    is given. ``cylinder``: whose gas drives or resists; of several, ``parts`` are the readings of the moment of
    each (Length). ``energies``: those of the links, None where there are none.
    """

    order: FlywheelTask
    base: Base
    moment: Mark
    axes: Axes
    constant: Mark
    cylinder: Cylinder | None
    parts: tuple[Mark, ...]
    charts: tuple[Chart, ...]
    energies: Energies | None
    works: tuple[Boundaries, Mark]
    sides: tuple[Mark, Mark]
    segment: Mark
    delta: Mark
    inertia: Mark
    energy_mass: EnergyMass | None
    rim: DrawnRim | None


FLYWHEEL_PLAN: Recorded[Flywheel] = Recorded(FLYWHEEL)


def record(bench: Bench) -> Flywheel | None:
    """Draw what the scene asks of a flywheel: by the gas of its cylinder, else by the loads of the links."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    cylinder = INDICATOR_PLAN.of(bench) if order.indicator is not None else None
    return draw_flywheel(bench.draft, machine_of(bench), order, cylinder, FORCES_PLAN.of(bench))


def draw_flywheel(
    draft: Draft,
    machine: Machine,
    order: FlywheelTask,
    cylinder: Cylinder | None,
    forces: Forces | None,
) -> Flywheel:
    """Draw everything that leads to the moment of inertia of a flywheel.

    ``cylinder``: whose gas drives or resists; else the loads of ``forces`` do.

    Raises
    ------
    StructureError
        If δ (or J) or H is not positive, masses or loads are missing.
    """
    refuse(order)
    velocities = machine.velocities
    draft.open(VIEWS["moment"])
    length = draft.take(Length, "L", order.base, "mm", roles.BASE)
    mu_phi = angle_per_mm(draft, length, machine.turns)
    base = graphs.lay_base(draft, length, mu_phi, machine.count, machine.numbers[None, :])
    apart: tuple[Mark, ...] = ()
    if cylinder is not None:
        moment, apart = reduced_gas(draft, machine, cylinder, order.constant)
    else:
        moment = reduced_loads(draft, machine, forces, order.constant)
    mu_M = draft.scale("μ_M", "(N·m)/mm")
    heights = draft.draw(to_board, "y_M", moment)
    axes = graphs.draw_axes(draft, VIEWS["moment"], base, mu_M)
    at = graphs.lay_ordinates(draft, axes, heights, "k")
    curve = graphs.taut(draft, axes, at)
    reading = graphs.measure_ordinates(draft, axes, at.points, "M")
    parts = _parts(draft, axes, cylinder, apart) if cylinder is not None else ()
    read = (reading, *parts)
    chart = Chart(VIEWS["moment"], "M", "N·m", mu_M, read, True, order.mu_M, None)
    done = draw_works(draft, axes, at, curve, order)
    energies, gained, own, charts = _energies(draft, machine, axes, at, done)
    energy_axes = gained.axes
    segment = draw_segment(draft, energy_axes, own)
    assert velocities.speed is not None
    delta, inertia = draw_aim(draft, order, segment, velocities.speed)
    rim = None
    if order.rim is not None:
        rim = draw_rim(draft, inertia, velocities.speed, machine.mechanism.drive.speed, order.rim)
    second = None
    if order.tangents is not None:
        second = draw_energy_mass(
            draft, energies, done.surplus, gained, delta, velocities.speed, order.tangents
        )
    more = (second.chart,) if second is not None else ()
    first = cylinder.charts if cylinder is not None else ()
    found = (*first, chart, *charts, *more)
    works = (done.points, done.straight)
    return Flywheel(
        order,
        base,
        moment,
        axes,
        done.constant,
        cylinder,
        parts,
        found,
        energies,
        works,
        done.sides,
        segment,
        delta,
        inertia,
        second,
        rim,
    )


def angle_per_mm(draft: Draft, length: Mark, turns: int) -> Mark:
    """Calculate the scale of a base that stands for a cycle of so many turns."""
    if turns == 1:
        return draft.draw(turn_per_mm, "μ_φ", length, unit="rad/mm")
    told = draft.take(Number, "n_t", float(turns))
    return draft.draw(cycle_per_mm, "μ_φ", told, length, unit="rad/mm")


def refuse(order: FlywheelTask, section: str = "flywheel") -> None:
    """Refuse a δ, a J or a pole distance that is not positive."""
    if order.J is None:
        bound_of(FlywheelTask, "delta").refuse(section, "delta", order.delta)
    else:
        bound_of(FlywheelTask, "J").refuse(section, "J", order.J)
    pole = order.A.pole
    if pole is not None and not pole > 0.0:
        raise StructureError(
            said("the pole distance H = {pole:g} mm is not greater than 0", pole=pole),
            f"{section}.H",
            head=section,
        )


def draw_aim(draft: Draft, order: FlywheelTask, segment: Mark, omega: Mark) -> tuple[Mark, Mark]:
    """Return δ and the flywheel's J: the one that is given, and the other that follows from cd."""
    if order.J is None:
        delta = draft.take(Number, "δ", order.delta)
        return delta, draft.draw(flywheel_inertia, "J_F", segment, delta, omega, unit="kg·m²")
    inertia = draft.take(Number, "J_F", order.J, "kg·m²")
    return draft.draw(irregularity, "δ", segment, inertia, omega), inertia


def reduced_gas(
    draft: Draft, machine: Machine, cylinder: Cylinder, constant: str
) -> tuple[Mark, tuple[Mark, ...]]:
    """Calculate the reduced moment of the gas, and those of several cylinders, of which it is the sum.

    The gas pushes the piston from the cover towards the crank. It drives; with a constant driving moment it is
    the resistance of the gas that is told, of a compressor.
    """
    moments = [_of_cylinder(draft, machine, one, constant) for one in cylinder.every]
    total = moments[0]
    for k, more in enumerate(moments[1:], 2):
        name = "M_r" if k == len(moments) else "ΣM"
        total = draft.draw(
            added, name, total, more, unit="N·m", role=roles.SUM, why=why.CYLINDERS_SUM
        )
    return total, tuple(moments) if len(moments) > 1 else ()


def _parts(
    draft: Draft, axes: Axes, cylinder: Cylinder, moments: tuple[Mark, ...]
) -> tuple[Mark, ...]:
    """Draw the graphs of the moments of several cylinders below that of their sum; return their readings."""
    readings = []
    for one, moment in zip(cylinder.every, moments, strict=False):
        height = draft.draw(to_board, f"y_{{M{one.tag}}}", moment)
        at = graphs.lay_ordinates(draft, axes, height, f"k{one.tag}")
        graphs.taut(draft, axes, at, role=roles.PART)
        readings.append(graphs.measure_ordinates(draft, axes, at.points, letter_of("M", one.tag)))
    return tuple(readings)


def _of_cylinder(draft: Draft, machine: Machine, cylinder: Cylinder, constant: str) -> Mark:
    """Calculate the reduced moment of the gas of a cylinder."""
    velocities = machine.velocities
    # of a piston that slides on a swinging cylinder the reading is that of the cylinder against it
    outward = cylinder.outward if cylinder.swings is None else -cylinder.outward
    way = outward if constant == "resisting" else -outward
    sign = draft.take(Number, "σ", way)
    pin = velocities.images.by_letter[machine.mechanism.drive.link][machine.pin]
    drawn = draft.uses(pin)[1]
    speed = velocities.readings[cylinder.leg.link]
    force = cylinder.indicator.force
    name = letter_of("M", cylinder.tag) if cylinder.tag else "M_r"
    return draft.draw(reduced_moment, name, sign, force, speed, drawn, machine.arm, unit="N·m")


def reduced_loads(
    draft: Draft, machine: Machine, forces: Forces | None, constant: str, section: str = FLYWHEEL
) -> Mark:
    """Reduce the loads to the crank by their moments on the lever; inertia belongs to the energies.

    The moment of a force on the lever has the sign of its power where the crank turns counter-clockwise.
    """
    if forces is None:
        raise StructureError(
            said("nothing drives or resists: give an [indicator], or loads and [forces]"),
            section,
            head=section,
        )
    moments = forces.first.lever.moments
    found = [one.value for load in forces.loads.outer for one in moments if one.load == load]
    if not found:
        raise StructureError(
            said("no load does work: give gravity or a [[load]] besides inertia"),
            section,
            head=section,
        )
    total = found[0]
    for more in found[1:]:
        total = draft.draw(
            added, "ΣM", total, more, unit="N·mm", role=roles.SUM, why=why.MOMENTS_SUM
        )
    drives, clockwise = constant == "resisting", machine.mechanism.drive.speed < 0
    formula = moment_of_drive if drives != clockwise else moment_of_resistance
    because = why.CLOCKWISE[drives] if clockwise else ""
    used = total, machine.arm, forces.first.lever.segment
    return draft.draw(formula, "M_r", *used, unit="N·m", why=because)


class Works(NamedTuple):
    """The works as drawn: their axes, points of the integrated side and of the straight one.

    ``sides``: the curve and the straight line. ``surplus``: ΔT read off (Length). ``pole``: from where the rays
    to the ordinates of the moment have the slopes of ΔT. ``constant``: the constant moment, on its axis.
    """

    axes: Axes
    points: Boundaries
    straight: Mark
    sides: tuple[Mark, Mark]
    surplus: Mark
    pole: Mark
    constant: Mark
    chart: Chart


def draw_works(
    draft: Draft, source: Axes, at: Boundaries, curve: Mark, order: FlywheelTask
) -> Works:
    """Integrate the moment, close it with a straight line, read off by how much the driving work is ahead."""
    draft.open(VIEWS["work"])
    scaled = integrated_scale(draft, "A", "J/mm", source.mu, source.base.mu, order.A, "H")
    axes = graphs.draw_axes(draft, VIEWS["work"], source.base, scaled.mu)
    pole = graphs.set_pole(draft, source, scaled.distance)
    found = graphs.integrate(draft, source, curve, axes, pole, "A", mean=order.integration, at=at)
    curve_of_work = graphs.along_rays(draft, axes, found, pole.point, at, source)
    straight = draft.draw(
        join, "(A′)", axes.origin, found.end, role=roles.STRAIGHT, why=why.STRAIGHT
    )
    lines = draft.draw(square, "(i)", axes.feet, axes.along, sense=1, why=why.STRAIGHT_AT)
    other = draft.draw(meet, "A′", straight, lines, why=why.STRAIGHT_AT)
    ahead = order.constant == "resisting"
    ends = (other, found.points) if ahead else (found.points, other)
    surplus = draft.draw(measure_along, "ΔT", *ends, axes.up, why=why.SURPLUS)
    level, constant = _level_pole(draft, source, pole, straight, ahead=ahead)
    rest = (scaled.chosen, order.A.mu, None, None, (found.points, found.end))
    chart = Chart(VIEWS["work"], "A", "J", scaled.mu, (surplus,), *rest)
    return Works(axes, found, other, (curve_of_work, straight), surplus, level, constant, chart)


def _level_pole(
    draft: Draft, source: Axes, pole: Pole, straight: Mark, *, ahead: bool
) -> tuple[Mark, Mark]:
    """Draw the constant moment; mark the pole on its level: from there the straight side is level.

    Returns the pole and the constant moment.
    ``ahead``: the integrated side counts upwards; else the pole stands right of the axis.
    """
    draft.open(source.view)
    slope = draft.draw(parallel, "(PM)", pole.point, straight, sense=1, why=why.CONSTANT_RAY)
    name = "M_c" if ahead else "M_d"
    constant = draft.draw(meet, name, source.up, slope, role=roles.MEAN, why=why.CONSTANT)
    sense = -1 if ahead else 1
    level = draft.draw(
        parallel,
        f"({name})",
        constant,
        source.along,
        sense=sense,
        role=roles.STRAIGHT,
        why=why.LEVEL,
    )
    found = draft.draw(lay_off, "P′", level, pole.distance, role=roles.LEVEL_POLE, why=why.LEVEL)
    return found, constant


def _energies(
    draft: Draft, machine: Machine, source: Axes, at: Boundaries, done: Works
) -> tuple[Energies, Surplus, Mark, tuple[Chart, ...]]:
    """Draw ΔT, the energy of the links and, their difference, that of the flywheel on axes of their own.

    Returns the energies, ΔT, the curve of the flywheel's energy, the charts. ``source``, ``at``: the moment.
    """
    work = done.axes
    draft.open(VIEWS["energy"])
    energies = draw_energies(draft, machine.mechanism, machine.velocities)
    heights = draft.draw(to_board, "y_T", energies.total, work.mu)
    axes = graphs.draw_axes(draft, VIEWS["energy"], work.base, work.mu)
    gained = graphs.lay_ordinates(draft, axes, done.surplus, "g")
    ahead = graphs.along_rays(draft, axes, gained, done.pole, at, source)
    links = graphs.lay_ordinates(draft, axes, heights, "l")
    carried = graphs.through(draft, axes, links)
    rest = draft.draw(
        measure_along, "y_F", links.points, gained.points, axes.up, why=why.OF_FLYWHEEL
    )
    own = graphs.lay_ordinates(draft, axes, rest, "f")
    curve = graphs.difference(draft, axes, own, ahead, carried)
    readings = [
        graphs.measure_ordinates(draft, axes, points.points, letter)
        for points, letter in ((gained, "ΔT"), (links, "T_L"), (own, "T_F"))
    ]
    energy = done.chart._replace(
        view=VIEWS["energy"], symbol="T", ordinates=tuple(readings), figure=()
    )
    return energies, Surplus(axes, ahead), curve, (done.chart, energy)


def draw_segment(draft: Draft, axes: Axes, own: Mark) -> Mark:
    """Carry the highest and the lowest point of the flywheel's energy to the ordinate axis; measure cd."""
    ends = []
    for op, name in ((highest, "c"), (lowest, "d")):
        top = draft.draw(op, f"{name}′", own, axes.origin, axes.end)
        level = draft.draw(parallel, f"({name})", top, axes.along, sense=1, why=why.EXTREME_LEVEL)
        ends.append(
            draft.draw(meet, name, axes.up, level, role=roles.EXTREME, why=why.EXTREME_LEVEL)
        )
    return draft.draw(measure_along, "cd", ends[1], ends[0], axes.up, why=why.CD)
