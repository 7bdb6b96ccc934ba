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
from graphic_tmm.chapters.kinematics.motion import Motion, reading_of
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

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
    """An analogue of a point: the vector on its ``plan`` (Length), what it stands for (Number, m)."""

    point: str
    plan: str
    segment: Mark
    value: Mark


@dataclass(frozen=True)
class Hodographs:
    """What is drawn of the points; ``count``: how many positions make the row, ``closed``: a whole turn.

    ``images``: of each point on its plan, by plan and letter.
    """

    order: HodographTask
    curves: tuple[Hodograph, ...]
    analogues: tuple[Analogue, ...]
    images: dict[tuple[str, str], Mark]
    count: int
    closed: bool


HODOGRAPH_PLAN: Recorded[Hodographs] = Recorded(HODOGRAPH)


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
    _refuse(bench, order, plans)
    images = {
        (plan, letter): _image(plans, motion, letter)
        for plan in SIGNS
        if (motion := plans.motion(plan)) is not None
        for letter in order.points
    }
    wanted = [VELOCITIES, *[ACCELERATIONS] * order.accelerations]
    curves = tuple(_draw(bench, plans, images, p, k) for p in wanted for k in order.points)
    analogues = tuple(_analogues(bench, plans, order, images)) if order.analogues else ()
    return Hodographs(order, curves, analogues, images, plans.in_turn, plans.closed)


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


def _refuse(bench: Bench, order: HodographTask, plans: KinematicPlans) -> None:
    drive, pair, key = plans.mechanism.drive, plans.pairs[0], HODOGRAPH
    every = plans.accelerated == tuple(range(len(bench.names)))
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


def _draw(
    bench: Bench, plans: KinematicPlans, images: dict[tuple[str, str], Mark], plan: str, letter: str
) -> Hodograph:
    """Draw the hodograph of a point on one of the plans."""
    draft, motion = bench.draft, plans.motion(plan)
    assert motion is not None
    sign, row = SIGNS[plan], plans.in_turn
    view = f"{HODOGRAPH} {sign} {letter}"
    draft.open(view)
    pole = draft.take(Point, motion.images.pole.letter, 0j)
    draft.lay_out(pole, motion.mu)
    image = images[plan, letter]
    end = draft.draw(equal_vector, image.name, pole, motion.images.pole, image, free=True)
    op = french_curve if plans.closed else open_curve
    curve = draft.draw(op, f"({end.letter}–{end.letter})", end, row=row, why=why.CURVE)
    angle, against = None, plans.accelerations
    if plan == VELOCITIES and against is not None and plans.accelerated:
        view_of_angle = f"{view} tangents"
        draft.open(view_of_angle)
        angle = draft.draw(
            off_tangent, f"δ_{{{letter}}}", curve, end, against.images.pole,
            images[ACCELERATIONS, letter], unit="°", row=row,
        )  # fmt: skip
        bench.rows[view_of_angle] = plans.accelerated
        bench.tell(view_of_angle, plans.accelerated)
    return Hodograph(letter, plan, view, pole, end, curve, motion.mu, angle)


def _analogues(
    bench: Bench, plans: KinematicPlans, order: HodographTask, images: dict[tuple[str, str], Mark]
) -> Iterator[Analogue]:
    """Yield the analogues of all points, from the readings of the plans."""
    draft = bench.draft
    assert plans.velocities is not None
    omega = plans.velocities.speed
    assert omega is not None
    for plan, op, prime in (
        (VELOCITIES, f.scale_of_first_analogue, "′"),
        (ACCELERATIONS, f.scale_of_second_analogue, "″"),
    ):
        motion = plans.motion(plan)
        if motion is None or (plan == ACCELERATIONS and not plans.accelerated):
            continue
        view = view_of_analogues(plan)
        draft.open(view)
        mu = draft.draw(op, f"μ_{{s{prime}}}", motion.mu, omega, unit="m/mm")
        for letter in order.points:
            segment = reading_of(draft, motion, images[plan, letter])
            assert segment is not None
            value = draft.draw(in_si, f"s{prime}_{{{letter}}}", segment, mu, unit="m")
            yield Analogue(letter, plan, segment, value)
        if plan == ACCELERATIONS:
            bench.rows[view] = plans.accelerated
            bench.tell(view, plans.accelerated)


def view_of_analogues(plan: str) -> str:
    """Return the view in which the analogues of a plan's vectors are calculated."""
    return f"{why.ANALOGUES} {SIGNS[plan]}"
