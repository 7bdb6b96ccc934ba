"""The plans of a mechanism: where the crank stands, positions, velocities, accelerations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.assembly import Assembly, check_assembly
from graphic_tmm.chapters.kinematics.fit import check_fit
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.positions import (
    Positions,
    draw_frame,
    draw_positions,
)
from graphic_tmm.chapters.kinematics.reaches import Reach, guides, reaches
from graphic_tmm.chapters.kinematics.row import draw_row, extreme_places
from graphic_tmm.chapters.kinematics.rows import Further, Ground, draw_rows
from graphic_tmm.chapters.kinematics.sides import LAST, standing
from graphic_tmm.chapters.kinematics.survey import Survey, best, survey
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, ASKED, KINEMATICS, TURNS, VELOCITIES
from graphic_tmm.chapters.kinematics.velocities import crank_arm, draw_velocities
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Drive, Mechanism, Row
from graphic_tmm.mechanism.structure import Structure, dissect
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

ALL = ("all",)
"""What is written for the positions of a row where none is left out."""


@dataclass(frozen=True)
class KinematicPlans:
    """The plans of a mechanism as recorded.

    ``tried``: the mechanism at any angles; ``mu_l``: the scale factor of lengths; ``accelerated``: the
    positions (indices) that get an acceleration plan, ``extremes``: those that are extreme positions;
    ``numbers``: where each position stands in the row, in intervals of it; ``count`` of the positions make the
    closed row, over so many ``turns``; ``rows``: what tables are asked to tell besides.
    """

    mechanism: Mechanism
    structure: Structure
    assembly: Assembly
    tried: Survey
    mu_l: Mark
    positions: Positions
    velocities: Motion | None
    accelerations: Motion | None
    accelerated: tuple[int, ...]
    extremes: tuple[int, ...]
    guides: tuple[Figure, ...]
    numbers: np.ndarray
    count: int
    turns: int = 1
    rows: tuple[Further, ...] = ()

    @property
    def in_turn(self) -> int:
        """How many positions a turn of the crank has."""
        return self.count // self.turns

    @property
    def repeated(self) -> tuple[int, ...]:
        """The positions (indices) of later turns: the mechanism stands there as it did in the first one."""
        return tuple(range(self.in_turn, self.count))

    @property
    def crank(self) -> tuple[Mark, Mark]:
        """The pivot of the crank and its pin."""
        body = self.positions.bodies[self.structure.driver]
        return body.marks[self.structure.pivot], body.marks[self.structure.pin]

    @property
    def sense(self) -> int:
        """Which way the crank turns: 1 counter-clockwise, −1 clockwise."""
        return 1 if self.mechanism.drive.speed > 0 else -1

    @cached_property
    def reaches(self) -> Mapping[Figure, Reach]:
        """How far every guide is used over the whole turn of the crank, m."""
        return dict(zip(self.guides, reaches(self.tried), strict=True))

    def motion(self, plan: str) -> Motion | None:
        """Return the plan of velocities or of accelerations, if there is one."""
        return {VELOCITIES: self.velocities, ACCELERATIONS: self.accelerations}.get(plan)


KINEMATICS_PLAN: Recorded[KinematicPlans] = Recorded(KINEMATICS)


def record(bench: Bench) -> KinematicPlans:
    """Record the plans of a mechanism; a plan that is not asked for records no step.

    Raises
    ------
    StructureError
        If the mechanism cannot be drawn, or a position or point is named that does not exist.
    """
    scene, draft = bench.scene, bench.draft
    turns: int = bench.needed.get(TURNS, 1)
    mechanism, row = scene.mechanism, _over(scene.row, turns)
    assert mechanism is not None
    structure = dissect(mechanism)
    tried = survey(mechanism, structure)
    if turns > 1 and tried.returning_late:
        raise StructureError(
            said(
                "its links come back only after two turns (group {group} flips an odd number of times in one): "
                "a cycle of several turns is drawn of mechanisms that come back after each",
                group=tried.returning_late[0],
            ),
            "indicator.strokes",
            head="positions",
        )
    assembly = check_assembly(tried)
    check_fit(tried)
    frame = draw_frame(draft, mechanism, structure)
    numbered = draw_row(draft, tried, frame, row)
    angles = numbered.angles
    bench.stand(numbered.names, (_angle(a) for a in np.ravel(angles)), row.count)
    positions = draw_positions(draft, mechanism, structure, frame, numbered.phi)
    if scene.trajectories and tried.returning_late:
        raise StructureError(
            said(
                "no path closes after one turn, group {group} flips an odd number of "
                "times in it: leave trajectories out",
                group=tried.returning_late[0],
            ),
            "plans.trajectories",
            head="trajectories",
        )
    _draw_trajectories(draft, positions, scene.trajectories, row.count // turns)
    velocities = accelerations = None
    called = bench.wanted | bench.needed.keys()
    if VELOCITIES in called or ACCELERATIONS in called:
        velocities = draw_velocities(draft, mechanism, structure, positions, turned=scene.turned)
    gained = ACCELERATIONS in bench.wanted
    accelerated = chosen(row.accelerations, bench.names, ACCELERATIONS) if gained else ()
    if (accelerated or ACCELERATIONS in bench.needed) and velocities is not None:
        accelerations = draw_accelerations(draft, mechanism, structure, positions, velocities)
        bench.rows[ACCELERATIONS] = accelerated
        bench.tell(ACCELERATIONS, accelerated)
    rows, quarters = ASKED.of(scene), (1 if mechanism.drive.speed > 0 else -1) * scene.turned
    ground = Ground(draft, mechanism, structure, positions, velocities, accelerations, quarters)
    further = draw_rows(ground, rows) if rows is not None else ()
    made = KinematicPlans(
        mechanism,
        structure,
        assembly,
        tried,
        draft.mu_l,
        positions,
        velocities,
        accelerations,
        accelerated,
        extreme_places(row),
        guides(draft.board.construction()),
        _numbers(angles, row, mechanism.drive),
        row.count,
        turns,
        further,
    )
    draft.given |= standing(made, angles, carried=True)
    later = frozenset(made.repeated)
    of_first_turn = [k for k in range(len(bench.names)) if k not in later]
    bench.best = partial(best, tried, np.ravel(angles), accelerated, of_first_turn)
    return made


def _over(row: Row, turns: int) -> Row:
    """Return a row over several turns of the crank, as many positions in each."""
    return replace(row, count=row.count * turns, turns=turns)


def crank_length(bench: Bench, made: KinematicPlans) -> Mark:
    """Return the crank's real length (m) on a board; taken once."""
    return crank_arm(bench.draft, made.positions, made.structure)


def chosen(wanted: tuple[str, ...], names: tuple[str, ...], section: str) -> tuple[int, ...]:
    """Return the indices of the positions that a section names, or of all.

    Raises
    ------
    StructureError
        If there is no such position.
    """
    if wanted == ALL:
        return tuple(range(len(names)))
    missing = [name for name in wanted if name not in names]
    if missing:
        raise StructureError(
            said(
                "there is no position {missing}; there are {known}",
                missing=", ".join(missing),
                known=", ".join(names),
            ),
            "drive.accelerations" if section == "accelerations" else f"{section}.positions",
            head=section,
        )
    return tuple(sorted(names.index(name) for name in set(wanted)))


def _numbers(angles: np.ndarray, row: Row, drive: Drive) -> np.ndarray:
    """Return where each position stands in the row, in intervals of it; extras stand between."""
    travelled = (angles[0] - angles[0, 0]) * (1.0 if drive.speed > 0 else -1.0)
    numbers = (np.round(travelled, LAST) % 360.0) * row.count / (360.0 * row.turns)
    numbers[: row.count] = np.arange(row.count)
    return np.asarray(numbers)


def _angle(degrees: float) -> float:
    """Return an angle in [0, 360), free of the last bits."""
    return round(float(degrees), LAST) % 360.0 + 0.0


def _draw_trajectories(
    draft: Draft, positions: Positions, letters: Sequence[str], count: int
) -> None:
    for letter in letters:
        if not any(letter in body.marks for body in positions.bodies.values()):
            raise StructureError(
                said("there is no point {letter} on the plan", letter=letter),
                "plans.trajectories",
                head="trajectories",
            )
        draft.draw(french_curve, f"({letter}–{letter})", positions.point(letter), row=count)
