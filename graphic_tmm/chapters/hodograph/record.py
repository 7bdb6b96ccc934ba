"""Hodographs as recorded: vectors carried to a pole, the curve through their ends, angles at it; analogues."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.operations.curve import french_curve, open_curve
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.hodograph import formulas as f
from graphic_tmm.chapters.hodograph import words as why
from graphic_tmm.chapters.hodograph.operations import equal_vector, off_tangent
from graphic_tmm.chapters.hodograph.task import ASKED, HODOGRAPH, HodographTask
from graphic_tmm.chapters.kinematics.bodies import sliding_points
from graphic_tmm.chapters.kinematics.motion import Motion, reading_of
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.records import Scene

SIGNS = {VELOCITIES: "v", ACCELERATIONS: "a"}
"""The letters of what the plans show."""


class Hodograph(NamedTuple):
    """The vectors of a point of a ``plan`` from one pole: ``end`` by positions, the ``curve`` through the ends.

    ``angle``: from its tangent to the acceleration (Angle), in a view of its own; None where there is no plan.
    """

    point: str
    plan: str
    view: str
    pole: Mark
    end: Mark
    curve: Mark
    mu: Mark
    angle: Mark | None


class Analogue(NamedTuple):
    """An analogue of a point: its ``image`` on a ``plan``, the vector there (Length), what it stands for (m).

    ``mu``: the scale of the plan as if ω_1 were 1, m/mm.
    """

    point: str
    plan: str
    image: Mark
    mu: Mark
    segment: Mark
    value: Mark


@dataclass(frozen=True)
class Hodographs:
    """What is drawn of the points; ``count``: how many positions make the row, ``closed``: a whole turn.

    ``held``: the positions (indices) that have plans of accelerations.
    """

    order: HodographTask
    curves: tuple[Hodograph, ...]
    analogues: tuple[Analogue, ...]
    held: tuple[int, ...]
    count: int
    closed: bool


HODOGRAPH_PLAN: Recorded[Hodographs] = Recorded(HODOGRAPH)


class _Ground(NamedTuple):
    """What hodographs are drawn on: the board, the plans, the images of the points on them.

    ``held``: the positions (indices) that the scene wants accelerations of, whether or not a sheet shows them.
    """

    bench: Bench
    plans: KinematicPlans
    images: dict[tuple[str, str], Mark]
    held: tuple[int, ...]


def record(bench: Bench) -> Hodographs | None:
    """Draw the hodographs that are asked for; tell the analogues.

    Raises
    ------
    StructureError
        If a point stands, the plan of velocities is turned, or plans of accelerations are wanted and not there.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    assert plans.velocities is not None
    wanted = bench.scene.row.accelerations if plans.accelerations is not None else ()
    held = chosen(wanted, bench.names, ACCELERATIONS)
    _refuse(bench, order, plans, held)
    images = {
        (plan, letter): _image(plans, motion, letter)
        for plan in SIGNS
        if (motion := plans.motion(plan)) is not None
        for letter in order.points
    }
    on = _Ground(bench, plans, images, held)
    shown = [VELOCITIES, *[ACCELERATIONS] * order.accelerations]
    curves = tuple(_draw(on, plan, letter) for plan in shown for letter in order.points)
    analogues = tuple(_analogues(on, order)) if order.analogues else ()
    return Hodographs(order, curves, analogues, held, plans.in_turn, plans.closed)


def _image(plans: KinematicPlans, motion: Motion, letter: str) -> Mark:
    """Return the image of a letter on a plan, as a point of the first moving link that has it."""
    frame, bodies = plans.mechanism.frame.number, plans.positions.bodies
    link = next((n for n, body in bodies.items() if n != frame and letter in body.marks), frame)
    image: Mark | None = motion.images.by_letter[link].get(letter)
    if image is None or image == motion.images.pole:
        says = said(
            "point {letter} stands still: it has no hodograph; name one that moves", letter=letter
        )
        raise StructureError(says, f"{HODOGRAPH}.points", head=HODOGRAPH)
    return image


def _refuse(
    bench: Bench, order: HodographTask, plans: KinematicPlans, held: tuple[int, ...]
) -> None:
    drive, pair, key = plans.mechanism.drive, plans.pairs[0], HODOGRAPH
    every = set(held) >= set(range(plans.in_turn))
    says: Said | None = None
    if bench.scene.turned:
        says = said(
            "its tangents are held against the plan of accelerations, and this one of velocities is turned: "
            "leave turned out"
        )
        key = "plans.turned"
    elif order.accelerations and not every:
        says = said(
            "the hodograph of accelerations needs a plan of them in every position: write "
            'accelerations = "all" in [drive]'
        )
        key = f"{HODOGRAPH}.accelerations"
    elif order.analogues and (not pair.sweep.turns or plans.mechanism.further):
        says = said("analogues are by the turn of one crank that drives: leave analogues out")
        key = f"{HODOGRAPH}.analogues"
    elif order.analogues and (drive.rates or drive.gains or drive.acceleration):
        says = said(
            "a/ω² is the second analogue only where the crank turns evenly: leave its acceleration out, or "
            "analogues"
        )
        key = f"{HODOGRAPH}.analogues"
    elif order.analogues and plans.mechanism.at_rest:
        says = said("the crank stands: give it a speed, or leave analogues out")
        key = f"{HODOGRAPH}.analogues"
    if says is not None:
        raise StructureError(says, key, HODOGRAPH, head=HODOGRAPH)


def _draw(on: _Ground, plan: str, letter: str) -> Hodograph:
    """Draw the hodograph of a point on one of the plans."""
    draft, plans, motion = on.bench.draft, on.plans, on.plans.motion(plan)
    assert motion is not None
    view, row, image = f"{HODOGRAPH} {SIGNS[plan]} {letter}", plans.in_turn, on.images[plan, letter]
    draft.open(view)
    pole = draft.take(Point, motion.images.pole.letter, 0j)
    draft.lay_out(pole, motion.mu)
    length = reading_of(draft, motion, image)
    assert length is not None
    vector = motion.images.pole, image, length
    end = draft.draw(equal_vector, image.name, pole, *vector, free=True)
    op = french_curve if plans.closed else open_curve
    curve = draft.draw(op, f"({end.letter}–{end.letter})", end, row=row, why=why.CURVE)
    angle, against = None, plans.accelerations
    drive = plans.mechanism.drive
    alike = bool(drive.rates) or not drive.acceleration
    if plan == VELOCITIES and against and on.held and alike and not _straight(plans, letter):
        _at_some(on, f"{view} tangents")
        known = against.images.pole, on.images[ACCELERATIONS, letter]
        angle = draft.draw(off_tangent, f"δ_{{{letter}}}", curve, end, *known, unit="°", row=row)
    return Hodograph(letter, plan, view, pole, end, curve, motion.mu, angle)


def _straight(plans: KinematicPlans, letter: str) -> bool:
    """Whether a point slides on the frame: its hodograph is a straight line, whose tangent tells nothing."""
    positions, frame = plans.positions, plans.mechanism.frame.number
    there = sliding_points(positions.closings, positions.bodies, frame, HODOGRAPH)
    return letter in [point for point, _ in there]


def _at_some(on: _Ground, view: str) -> None:
    """Open a view that is drawn where there are accelerations."""
    on.bench.draft.open(view)
    on.bench.rows[view] = on.held
    on.bench.tell(view, on.held)


def _analogues(on: _Ground, order: HodographTask) -> Iterator[Analogue]:
    """Yield the analogues of all points, from the readings of the plans."""
    draft, velocities, accelerations = on.bench.draft, on.plans.velocities, on.plans.accelerations
    assert velocities is not None
    assert velocities.speed is not None
    ways = [(VELOCITIES, velocities, f.scale_of_first_analogue, "′")]
    if accelerations is not None and on.held:
        ways.append((ACCELERATIONS, accelerations, f.scale_of_second_analogue, "″"))
    for plan, motion, op, prime in ways:
        view = view_of_analogues(plan)
        draft.open(view)
        if plan == ACCELERATIONS:
            _at_some(on, view)
        mu = draft.draw(op, f"μ{prime}", motion.mu, velocities.speed, unit="m/mm")
        for letter in order.points:
            image = on.images[plan, letter]
            segment = reading_of(draft, motion, image)
            assert segment is not None
            value = draft.draw(in_si, f"s{prime}_{{{letter}}}", segment, mu, unit="m")
            yield Analogue(letter, plan, image, mu, segment, value)


def view_of_analogues(plan: str) -> str:
    """Return the view in which the analogues of a plan's vectors are calculated."""
    return f"{why.ANALOGUES} {SIGNS[plan]}"


def _needs(scene: Scene) -> dict[str, bool]:
    """Return the plans whose vectors are carried, or are held against: also where no sheet shows them."""
    if ASKED.of(scene) is None:
        return {}
    return {VELOCITIES: True, **({ACCELERATIONS: True} if scene.row.accelerations else {})}


PLAN = Plan(needs=_needs, record=record)
