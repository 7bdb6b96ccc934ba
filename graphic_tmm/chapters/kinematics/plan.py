"""The plans of a mechanism: where the drive stands, positions, velocities, accelerations."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.curve import arc_through, french_curve, open_curve
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.assembly import Assembly, check_assembly
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.by_drive import ByDrive, Summed, draw_by_drive, draw_sums
from graphic_tmm.chapters.kinematics.drives import driven, follow
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair
from graphic_tmm.chapters.kinematics.fit import check_fit
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.positions import (
    draw_frame,
    draw_positions,
)
from graphic_tmm.chapters.kinematics.reaches import Reach, guides, reaches
from graphic_tmm.chapters.kinematics.row import draw_row, extreme_places, zero_of
from graphic_tmm.chapters.kinematics.rows import Further, Ground, draw_rows
from graphic_tmm.chapters.kinematics.sides import LAST, standing
from graphic_tmm.chapters.kinematics.survey import Survey, best, survey
from graphic_tmm.chapters.kinematics.task import (
    ACCELERATIONS,
    ASKED,
    BY_DRIVE,
    KINEMATICS,
    TURNS,
    VELOCITIES,
)
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Drive, Extreme, Mechanism, Row, Sweep
from graphic_tmm.mechanism.structure import Structure, dissect
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.records import Scales

INSIDE = 0.05
"""A stroke whose ends the scene does not name stops this share of it before the places where it locks."""
ALL = ("all",)
"""What is written for the positions of a row where none is left out."""


@dataclass(frozen=True)
class KinematicPlans:
    """The plans of a mechanism as recorded.

    ``tried``: the mechanism at any angles; ``mu_l``: the scale factor of lengths; ``accelerated``: the
    positions (indices) that get an acceleration plan, ``extremes``: those that are extreme positions;
    ``numbers``: where each position stands in the row, in intervals of it; ``count`` of the positions make the
    row, over so many ``turns``; ``rows``: what tables are asked to tell besides; ``closed``: whether the
    row comes back to where it began, ``ends``: where one that does not begins and ends,
    ``steps``: how far each position is from the first as that row goes, before it less than 0 (° or m).
    ``by_drive``: velocities as each drive causes them, where that is asked for, ``summed``: of each point.
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
    closed: bool = True
    ends: tuple[float, float] | None = None
    steps: np.ndarray | None = None
    by_drive: tuple[ByDrive, ...] = ()
    summed: tuple[Summed, ...] = ()

    def plan_of(self, link: int) -> Motion:
        """Return the plan of velocities as the drive of a link alone causes them."""
        return next(one.motion for one in self.by_drive if one.link == link)

    @property
    def apart(self) -> tuple[Motion, ...]:
        """The plans of velocities of single drives that are not that of all."""
        motions = (one.motion for one in self.by_drive)
        return tuple(motion for motion in motions if motion is not self.velocities)

    @property
    def in_turn(self) -> int:
        """How many positions a turn of the crank has."""
        return self.count // self.turns

    @property
    def repeated(self) -> tuple[int, ...]:
        """The positions (indices) of later turns: the mechanism stands there as it did in the first one."""
        return tuple(range(self.in_turn, self.count))

    @cached_property
    def pairs(self) -> tuple[DrivenPair, ...]:
        """What is driven, the drive of the row first."""
        return driven(self.mechanism, self.structure)

    @property
    def led(self) -> tuple[Mark, Mark]:
        """The mark that the drive leads, and the one that it is led about: the crank's pivot and its pin."""
        return self.pairs[0].led(self.positions)

    @property
    def arms(self) -> tuple[tuple[Mark, ...], ...]:
        """Pivot and pin of every crank."""
        found = (pair.arm_ends(self.positions) for pair in self.pairs)
        return tuple(ends for ends in found if ends)

    @property
    def sense(self) -> int:
        """Which way the drive goes: 1 counter-clockwise or outwards, −1 the other."""
        return self.mechanism.drive.sense

    @property
    def way(self) -> float:
        """How far the drive goes over the row, a whole turn of one that comes back (rad or m)."""
        if self.steps is None:
            return math.tau
        way = float(self.steps[self.count - 1])
        return math.radians(way) if self.tried.sweep.turns else way

    @cached_property
    def reaches(self) -> Mapping[Figure, Reach]:
        """How far every guide is used over the whole turn of the crank, m."""
        return dict(zip(self.guides, reaches(self.tried, self.ends), strict=True))

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
    _refuse_unknown_places(mechanism, row)
    _refuse_scales(scene.scales, mechanism.drive)
    tried = survey(mechanism, structure, zero_of(row))
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
    assembly = check_assembly(tried, row.reach)
    check_fit(tried)
    frame = draw_frame(draft, mechanism, structure)
    row = _filled(row, assembly)
    numbered = draw_row(draft, tried, frame, row)
    values = numbered.values
    bench.stand(
        numbered.names, (_within(tried.sweep, a) for a in np.ravel(values)), row.count, tried.sweep
    )
    at = follow(draft, tried.pairs, tried.zero, numbered.at)
    positions = draw_positions(draft, mechanism, structure, frame, at, tried.wound, tried.branch)
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
    closes = closed(row, tried.pairs) and not tried.rolls_on
    number, in_turn = mechanism.frame.number, row.count // turns
    _draw_trajectories(draft, positions, number, scene.trajectories, in_turn, closed=closes)
    velocities = accelerations = None
    called = bench.wanted | bench.needed.keys()
    by_drive, summed = tuple[ByDrive, ...](), tuple[Summed, ...]()
    if called & {VELOCITIES, ACCELERATIONS, BY_DRIVE}:
        velocities = draw_velocities(draft, mechanism, structure, positions, turned=scene.turned)
        if BY_DRIVE in called:
            drawn = draw_by_drive(draft, mechanism, positions, velocities, turned=scene.turned)
            by_drive = tuple(drawn)
        if BY_DRIVE in bench.wanted:
            _refuse_sums(mechanism)
            summed = draw_sums(draft, velocities, by_drive)
    gained = ACCELERATIONS in bench.wanted and mechanism.moves
    accelerated = chosen(row.accelerations, bench.names, ACCELERATIONS) if gained else ()
    wanted = accelerated or (ACCELERATIONS in bench.needed and mechanism.moves)
    if wanted and velocities is not None:
        accelerations = draw_accelerations(draft, mechanism, structure, positions, velocities)
        bench.rows[ACCELERATIONS] = accelerated
        bench.tell(ACCELERATIONS, accelerated)
    rows, quarters = ASKED.of(scene), mechanism.drive.sense * scene.turned
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
        numbered.numbers,
        row.count,
        turns,
        further,
        closes,
        (float(values.min()), float(values.max())) if row.open else None,
        None if closes else (values[0] - values[0, 0]) * _sense(values[0, : row.count]),
        by_drive,
        summed,
    )
    draft.given |= standing(made, values, carried=True)
    later = frozenset(made.repeated)
    of_first_turn = [k for k in range(len(bench.names)) if k not in later]
    bench.best = partial(best, tried, np.ravel(values), accelerated, of_first_turn)
    return made


def _sense(values: np.ndarray) -> float:
    """Return which way the coordinates of a row go: 1 or −1."""
    return float(np.copysign(1.0, values[-1] - values[0]))


def _over(row: Row, turns: int) -> Row:
    """Return a row over several turns of the crank, as many positions in each."""
    return replace(row, count=row.count * turns, turns=turns)


def crank_length(bench: Bench, made: KinematicPlans) -> Mark:
    """Return the crank's real length (m) on a board; taken once."""
    crank = made.pairs[0]
    assert isinstance(crank, Crank)
    return crank.real_arm(bench.draft, made.positions)


def closed(row: Row, pairs: Sequence[DrivenPair]) -> bool:
    """Whether a row comes back to where it began: after a whole turn of the first drive and of all others."""
    first, *further = pairs
    if not first.sweep.closed or row.ends is not None or row.places:
        return False
    ratios = (one.speed_ratio(first) for one in further)
    return all(one.sweep.closed for one in further) and all(ratio.is_integer() for ratio in ratios)


def _refuse_sums(mechanism: Mechanism) -> None:
    """Refuse to add up the velocities of several drives where one drives, or nothing moves."""
    if not mechanism.further or mechanism.at_rest:
        raise StructureError(
            said('"velocities by drive" adds up what several drives that move cause: leave it out'),
            "sheet",
            head=BY_DRIVE,
        )


def _refuse_unknown_places(mechanism: Mechanism, row: Row) -> None:
    """Refuse several drives where the zero or the speed of the first does not tell where the others stand."""
    drive = mechanism.drive
    if not mechanism.further:
        return
    says, key = None, "speed"
    if drive.slides and row.ends is None and not row.places:
        says = said("several drives begin where the first does: write from and to in its [[drive]]")
        key = "from"
    elif isinstance(row.zero, Extreme):
        says = said(
            "where a point is extreme hangs on all drives, which begin where the first does: give zero as "
            "an angle"
        )
        key = "zero"
    elif drive.rates or drive.gains:
        says = said(
            "several drives go in the ratio of their speeds: give the first one speed, not a list"
        )
    elif not drive.speed and not mechanism.at_rest:
        says = said(
            "the first drive stands while others go: put one that goes first, or draw all at rest"
        )
    if says is not None:
        raise StructureError(says, f"drive.{key}", head="drive")


def _refuse_scales(wanted: Scales, drive: Drive) -> None:
    """Refuse lengths in mm, and a scale factor, by which a drive shows nothing."""
    says, key = None, "mu_v"
    if wanted.mu_v_is_mu_l_omega and drive.rates:
        says = said("μ_v = μ_l·ω₁ holds for one ω₁; the speed is listed by positions: write mu_v")
    elif wanted.mu_v_is_mu_l_omega and (drive.slides or drive.rack):
        says = said("μ_v = μ_l·ω₁ holds where a speed ω₁ is given; write mu_v")
    elif wanted.OA and drive.slides:
        says, key = said("the drive slides, it has no crank as long as that; write mu_l"), "OA"
    elif wanted.pi_a and (drive.slides or not drive.speed) and not drive.acceleration:
        says, key = said("the drive has no acceleration that long; write mu_a"), "pi_a"
    elif wanted.pa and drive.rates:
        says, key = (
            said("the speed is listed by positions, no length shows them all; write mu_v"),
            "pa",
        )
    elif wanted.pi_a and (drive.rates or drive.gains):
        says = said("the acceleration of the drive changes with its position; write mu_a")
        key = "pi_a"
    if says is not None:
        raise StructureError(says, f"scales.{key}", head="scales")


def _filled(row: Row, assembly: Assembly) -> Row:
    """Return a row with its ends: where a drive slides and the scene names none, those of its stroke."""
    if assembly.sweep.turns or row.ends is not None or row.places:
        return row
    sweep = assembly.sweep
    low, high = max(assembly.ranges or ((sweep.low, sweep.high),), key=lambda one: one[1] - one[0])
    off = INSIDE * (high - low) if assembly.ranges else 0.0
    return replace(row, ends=(low + off, high - off))


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


def _within(sweep: Sweep, value: float) -> float:
    """Return a coordinate within its sweep, free of the last bits."""
    return sweep.within(round(float(value), LAST)) + 0.0


def _draw_trajectories(
    draft: Draft,
    positions: Positions,
    frame: int,
    letters: Sequence[str],
    count: int,
    *,
    closed: bool,
) -> None:
    for letter in letters:
        if not any(letter in body.marks for body in positions.bodies.values()):
            raise StructureError(
                said("there is no point {letter} on the plan", letter=letter),
                "plans.trajectories",
                head="trajectories",
            )
        name, point = f"({letter}–{letter})", positions.point(letter)
        pivot = positions.pivot_of(letter, frame)
        if pivot is not None:
            draft.draw(arc_through, name, pivot, point, turn=count if closed else 0)
            continue
        draft.draw(french_curve if closed else open_curve, name, point, row=count)
