"""A whole project on one board: where the crank stands, then the plans that the scene asks for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.record import Construction, Figure, Mark
from graphic_tmm.chapters.diagrams.plan import Kinematic, draw_kinematic
from graphic_tmm.chapters.diagrams.task import KinematicOrder
from graphic_tmm.chapters.engine.plan import Engine, draw_engine
from graphic_tmm.chapters.engine.task import EngineOrder
from graphic_tmm.chapters.flywheel.plan import Flywheel, draw_flywheel
from graphic_tmm.chapters.flywheel.task import FlywheelOrder
from graphic_tmm.chapters.forces.driving import Driver
from graphic_tmm.chapters.forces.loads import Ground
from graphic_tmm.chapters.forces.plan import Forces, draw_forces
from graphic_tmm.chapters.forces.task import ForcesOrder
from graphic_tmm.chapters.indicator.cylinder import Cylinder, Machine, draw_cylinder
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.assembly import Assembly, check_assembly
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.positions import (
    Positions,
    draw_frame,
    draw_positions,
    side_record,
    side_values,
)
from graphic_tmm.chapters.kinematics.reaches import Reach, guides, reaches
from graphic_tmm.chapters.kinematics.row import draw_row
from graphic_tmm.chapters.kinematics.survey import Survey, survey
from graphic_tmm.chapters.kinematics.velocities import crank_arm, draw_velocities
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.records import Drive, Mechanism, Row, Side
from graphic_tmm.mechanism.structure import Structure, dissect

LAST = 12
"""Decimals of an angle in degrees that are not rounding."""


@dataclass(frozen=True)
class Project:
    """The log of a project and what is given on it but for the scale factors.

    ``names`` and ``angles`` (degrees) run along the position axis; ``accelerated`` holds the indices of the
    positions that get an acceleration plan; ``count`` of the positions make the closed row.
    """

    mechanism: Mechanism
    structure: Structure
    assembly: Assembly
    tried: Survey
    construction: Construction
    given: dict[Mark, object]
    mu_l: Mark
    names: tuple[str, ...]
    angles: tuple[float, ...]
    accelerated: tuple[int, ...]
    positions: Positions
    velocities: Motion | None
    accelerations: Motion | None
    count: int
    kinematic: Kinematic | None = None
    flywheel: Flywheel | None = None
    forces: Forces | None = None
    forced: tuple[int, ...] = ()
    engine: Engine | None = None
    cylinder: Cylinder | None = None

    @cached_property
    def reaches(self) -> dict[Figure, Reach]:
        """How far every guide is used over the whole turn of the crank, m."""
        return dict(zip(guides(self.construction), reaches(self.tried), strict=True))

    @property
    def charts(self) -> tuple[Chart, ...]:
        """The graphs on axes, in the order in which they stand one below the other."""
        found = tuple(self.kinematic.charts.values()) if self.kinematic is not None else ()
        if self.cylinder is not None:
            found = (*found, self.cylinder.indicator.chart)
        for made in (self.flywheel, self.engine):
            found = (*found, *(made.charts if made is not None else ()))
        return tuple({chart.view: chart for chart in found}.values())

    def scale(self, plan: str) -> Mark:
        """Return the mark of a plan's μ."""
        view = self.construction.view(plan)
        assert view is not None
        assert view.scale is not None
        return view.scale

    def marks(self, plan: str) -> list[Mark]:
        """Return the marks of the steps drawn in a view, in order."""
        return [step.it for step in self.construction.steps if step.it.view == plan]


def draw_project(
    mechanism: Mechanism,
    row: Row,
    *,
    turned: bool = False,
    trajectories: Sequence[str] = (),
    plans: Sequence[str] = ("positions", "velocities", "accelerations"),
    diagrams: KinematicOrder | None = None,
    flywheel: FlywheelOrder | None = None,
    forces: ForcesOrder | None = None,
    engine: EngineOrder | None = None,
) -> Project:
    """Record the plans of a mechanism; a plan that is not asked for records no step.

    Raises
    ------
    StructureError
        If the mechanism cannot be drawn, or a position or point is named that does not exist.
    """
    structure = dissect(mechanism)
    tried = survey(mechanism, structure)
    assembly = check_assembly(tried)
    draft = Draft()
    frame = draw_frame(draft, mechanism, structure)
    numbered = draw_row(draft, tried, frame, row)
    positions = draw_positions(draft, mechanism, structure, frame, numbered.phi)
    if trajectories and tried.returning_late:
        raise StructureError(
            f"trajectories: no path closes after one turn, group {tried.returning_late[0]} flips an odd "
            "number of times in it: leave trajectories out",
            "plans.trajectories",
        )
    _draw_trajectories(draft, positions, trajectories, row.count)
    velocities = accelerations = None
    machinery = flywheel or forces or engine
    if "velocities" in plans or "accelerations" in plans or diagrams or machinery:
        velocities = draw_velocities(draft, mechanism, structure, positions, turned=turned)
    accelerated = _places(row.accelerations, numbered.names) if "accelerations" in plans else ()
    inertia = engine is not None or (forces is not None and forces.inertia)
    if (accelerated or inertia) and velocities is not None:
        accelerations = draw_accelerations(draft, mechanism, structure, positions, velocities)
    kinematic = None
    if diagrams is not None:
        assert velocities is not None
        kinematic = draw_kinematic(
            draft,
            positions,
            velocities,
            accelerations,
            diagrams,
            mechanism.frame.number,
            _numbers(numbered.angles, row.count, mechanism.drive),
            row.count,
        )
    statics, made, driving, cylinder = None, None, None, None
    if velocities is not None and machinery:
        numbers = _numbers(numbered.angles, row.count, mechanism.drive)
        arm = crank_arm(draft, positions, structure)
        machine = Machine(
            mechanism,
            positions,
            velocities,
            structure.pivot,
            structure.pin,
            arm,
            numbers,
            row.count,
        )
        orders = (forces, flywheel, engine)
        statics, made, driving, cylinder = _machine(draft, machine, accelerations, turned, *orders)
    given = dict(draft.given)
    for group in structure.groups:
        side = side_record(mechanism, group)
        if group.name in positions.sides and side is not None:
            given[positions.sides[group.name]] = _sides(side, numbered.angles, mechanism.drive)
    assert draft.mu_l is not None
    return Project(
        mechanism,
        structure,
        assembly,
        tried,
        draft.board.construction(),
        given,
        draft.mu_l,
        numbered.names,
        tuple(_angle(a) for a in np.ravel(numbered.angles)),
        accelerated,
        positions,
        velocities,
        accelerations,
        row.count,
        kinematic,
        made,
        statics,
        _places(forces.positions, numbered.names, "forces") if forces is not None else (),
        driving,
        cylinder,
    )


def _numbers(angles: np.ndarray, count: int, drive: Drive) -> np.ndarray:
    """Return where each position stands in the row, in intervals of it; extras stand between."""
    travelled = (angles[0] - angles[0, 0]) * (1.0 if drive.speed > 0 else -1.0)
    numbers = (np.round(travelled, LAST) % 360.0) * count / 360.0
    numbers[:count] = np.arange(count)
    return np.asarray(numbers)


def _angle(degrees: float) -> float:
    """Return an angle in [0, 360), free of the last bits."""
    return round(float(degrees), LAST) % 360.0 + 0.0


def _sides(side: Side, angles: np.ndarray, drive: Drive) -> object:
    """Return the side in every position, carried on from the zero position in the sense of the drive.

    With an odd number of flips (a pin that passes over another once a turn) the mechanism comes back to
    its zero position only after two turns; the one turn drawn then ends on the other side.
    """
    if len(side.flips_at or ()) % 2 == 0:
        return side_values(side, angles)
    sense = 1.0 if drive.speed > 0 else -1.0
    start = angles[0, 0]
    travelled = np.round((angles - start) * sense, LAST) % 360.0
    flips = np.round((np.asarray(side.flips_at, dtype=np.float64) - start) * sense, LAST) % 360.0
    passed = (flips[:, None, None] <= travelled[None]) & (travelled[None] > 0.0)
    if sense > 0:
        passed &= flips[:, None, None] > 0.0
    return side_values(side, start) * np.where(passed.sum(axis=0) % 2 == 0, 1.0, -1.0)


def _places(
    wanted: tuple[str, ...], names: tuple[str, ...], section: str = "accelerations"
) -> tuple[int, ...]:
    if wanted == ("all",):
        return tuple(range(len(names)))
    missing = [name for name in wanted if name not in names]
    if missing:
        raise StructureError(
            f"{section}: there is no position {', '.join(missing)}; there are {', '.join(names)}",
            "drive.accelerations" if section == "accelerations" else f"{section}.positions",
        )
    return tuple(sorted(names.index(name) for name in set(wanted)))


def _machine(
    draft: Draft,
    machine: Machine,
    accelerations: Motion | None,
    turned: bool,
    forces: ForcesOrder | None,
    flywheel: FlywheelOrder | None,
    engine: EngineOrder | None,
) -> tuple[Forces | None, Flywheel | None, Engine | None, Cylinder | None]:
    """Draw what belongs to a machine: its cylinder, its forces, its flywheel, its crank mechanism."""
    cylinder, statics, made, driving = None, None, None, None
    gas = flywheel.indicator if flywheel is not None else None
    gas = gas or (forces.gas if forces is not None else None)
    gas = gas or (engine.indicator if engine is not None else None)
    if gas is not None:
        cylinder = draw_cylinder(draft, machine, gas, "indicator")
    if forces is not None:
        on_piston = cylinder if forces.gas is not None else None
        ground = _ground(draft, machine, accelerations, turned)
        statics = draw_forces(ground, _driver(draft, machine), forces, machine.arm, on_piston)
    if flywheel is not None:
        by_gas = cylinder if flywheel.indicator is not None else None
        made = draw_flywheel(draft, machine, flywheel, by_gas, statics)
    if engine is not None:
        assert accelerations is not None
        assert cylinder is not None
        driving = draw_engine(draft, machine, accelerations, cylinder, engine)
    return statics, made, driving, cylinder


def _ground(draft: Draft, machine: Machine, accelerations: Motion | None, turned: bool) -> Ground:
    drive, velocities = machine.mechanism.drive, machine.velocities
    image = velocities.images.by_letter[drive.link][machine.pin]
    sense = 1 if drive.speed > 0 else -1
    return Ground(
        draft,
        machine.mechanism,
        machine.positions,
        velocities,
        accelerations,
        sense if turned else 0,
        draft.board.uses(image)[1],
        machine.numbers,
        machine.count,
    )


def _driver(draft: Draft, machine: Machine) -> Driver:
    body = machine.positions.bodies[machine.mechanism.drive.link]
    pin = body.marks[machine.pin]
    return Driver(body, body.marks[machine.pivot], pin, draft.board.uses(pin)[1])


def _draw_trajectories(
    draft: Draft, positions: Positions, letters: Sequence[str], count: int
) -> None:
    for letter in letters:
        if not any(letter in body.marks for body in positions.bodies.values()):
            raise StructureError(
                f"trajectories: there is no point {letter} on the plan", "plans.trajectories"
            )
        name = draft.board.free(f"({letter}–{letter})")
        draft.board.draw(french_curve, name, positions.point(letter), row=count)
