"""The plan as recorded: the pin of the other driving link first, the crank pin last, then the scale."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    similar,
    square,
)
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Length, Point
from graphic_tmm.chapters.free_scale import words as why
from graphic_tmm.chapters.free_scale.formulas import scale_by_speed
from graphic_tmm.chapters.free_scale.task import ASKED, FREE_SCALE, FreeScaleTask
from graphic_tmm.chapters.kinematics import words as usual
from graphic_tmm.chapters.kinematics.closings import (
    ClosingLeg,
    GuideLeg,
    PinLeg,
    PlateClosing,
    on_three_legs,
)
from graphic_tmm.chapters.kinematics.motion import pin_image, reading_of
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.records import Scene

LENGTHS = (100.0, 80.0, 60.0, 50.0, 40.0, 30.0, 25.0, 20.0, 15.0, 10.0, 5.0, 2.0)
"""How long the first vector may be, mm: the longest with which all others fit."""
LONGEST = 110.0
"""So long the longest vector may be, mm."""


class Result(NamedTuple):
    """A velocity as it is read, of a pin (m/s); ``usual``: as read on the plan by the special point, mm."""

    point: str
    value: Mark
    usual: Mark


@dataclass(frozen=True)
class FreeScale:
    """A plan to a free scale in the position ``at`` (index): by ``link``; the first vector and its scale."""

    link: int
    at: int
    first: Mark
    mu: Mark
    results: tuple[Result, ...]


FREE_SCALE_PLAN: Recorded[FreeScale] = Recorded(FREE_SCALE)


class _Legs(NamedTuple):
    """The legs of a plate: which drives now, which turns about the crank pin, the other one."""

    driving: PinLeg
    hung: PinLeg
    other: ClosingLeg


def record(bench: Bench) -> FreeScale | None:
    """Draw the plan that is asked for.

    Raises
    ------
    StructureError
        If no plate has such legs, their pin all but stands, or a plan of velocities is turned.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    if bench.scene.turned:
        says = said("this plan is not turned by 90°, and that of velocities is: leave turned out")
        raise StructureError(says, "plans.turned", FREE_SCALE, head=FREE_SCALE)
    closing, legs = _chosen(plans, order)
    at = chosen((order.at,), bench.names, FREE_SCALE)[0] if order.at is not None else 0
    for view in (why.PLATE, FREE_SCALE):
        bench.rows[view] = (at,)
        bench.tell(view, (at,))
    return _draw(bench, plans, closing, legs, at)


def _draw(
    bench: Bench, plans: KinematicPlans, closing: PlateClosing, legs: _Legs, at: int
) -> FreeScale:
    draft, velocities = bench.draft, plans.velocities
    assert velocities is not None
    line = _line(draft, closing, legs)
    draft.open(FREE_SCALE)
    pole = draft.take(Point, "p", 0j, role=roles.VELOCITY)
    draft.lay_out(pole)
    f, c, b = (closing.image_of(leg) for leg in (legs.driving, legs.other, legs.hung))
    length, sense = _first(plans, closing, legs, bench.coordinates[at], bench.names[at])
    first = draft.take(Length, between(pole, f), length, "mm")
    way = draft.draw(
        square, f"({between(pole, f)})", pole, legs.driving.line, sense=sense, why=usual.ABOUT_FIXED
    )
    driven = draft.draw(lay_off, f, way, first, free=True, why=why.FREE)
    across = draft.draw(square, f"({f}{c})", driven, line, sense=1, why=usual.ABOUT_MOVING)
    other = draft.draw(
        meet, c, across, _way(draft, pole, legs.other, c), free=True, why=usual.BOTH_EQUATIONS
    )
    pins = (closing.pin(leg) for leg in (legs.driving, legs.other, legs.hung))
    hung = draft.draw(similar, b, driven, other, *pins, free=True)
    a = legs.hung.letter.lower()
    seen = draft.draw(square, f"({b}{a})", hung, legs.hung.line, sense=1, why=usual.ABOUT_MOVING)
    crank = plans.positions.bodies[legs.hung.body]
    own = draft.draw(
        square,
        f"({between(pole, a)})",
        pole,
        crank.axis,
        sense=plans.mechanism.drive.sense,
        why=usual.ABOUT_FIXED,
    )
    pin = draft.draw(meet, a, seen, own, free=True, why=usual.BOTH_EQUATIONS)
    read = draft.draw(measure_along, between(pole, a), pole, pin, own)
    speed = draft.uses(draft.uses(velocities.images.at(crank, legs.hung.pivot))[1])[0]
    mu = draft.draw(scale_by_speed, "μ_v", speed, read, unit="(m/s)/mm")
    results = []
    for leg, image in ((legs.driving, driven), (legs.other, other), (legs.hung, hung)):
        letter = closing.pin_letter(leg)
        segment = first
        if image != driven:
            segment = draft.draw(measure, between(pole, image.letter), pole, image)
        value = draft.draw(in_si, f"v_{letter}", segment, mu, unit="m/s")
        known = reading_of(draft, velocities, pin_image(velocities, closing, leg))
        assert known is not None
        results.append(Result(letter, value, known))
    return FreeScale(legs.driving.link, at, first, mu, tuple(results))


def _line(draft: Draft, closing: PlateClosing, legs: _Legs) -> Mark:
    """Draw the line of the pins of the leg that drives and of the other."""
    draft.open(why.PLATE)
    ends = closing.pin(legs.driving), closing.pin(legs.other)
    draft.lay_out(ends[0], draft.mu_l)
    letters = "".join(map(closing.pin_letter, (legs.driving, legs.other)))
    return draft.draw(join, f"({letters})", *ends, why=usual.OF_THE_PLATE)


def _way(draft: Draft, pole: Mark, leg: ClosingLeg, image: str) -> Mark:
    """Draw the line of the velocity that a leg on the frame leaves its pin."""
    op = parallel if isinstance(leg, GuideLeg) else square
    return draft.draw(
        op, f"({between(pole, image)})", pole, leg.line, sense=1, why=usual.ABOUT_FIXED
    )


def _first(
    plans: KinematicPlans, closing: PlateClosing, legs: _Legs, coordinate: float | None, name: str
) -> tuple[float, int]:
    """Return how long the first vector is laid off, mm, and which way: so that the crank goes its own way.

    Who draws by hand chooses, and chooses again where the plan is too large or the crank goes back.
    """
    tried = plans.tried
    pole, images = tried.velocities.images.pole, tried.velocities.images.by_letter
    marks = [images[closing.plate][letter] for letter in closing.pins]
    marks.append(tried.velocities.driven[legs.hung.body][1])
    rate = tried.velocities.rates.get(legs.driving.link)
    if coordinate is None or rate is None:
        return LENGTHS[0], 1
    reading = tried.at(np.array([[coordinate]]), [pole, *marks, rate])
    with np.errstate(all="ignore"):
        speeds = [abs(complex((reading[mark] - reading[pole])[0, 0])) for mark in marks]
        if not np.isfinite(speeds).all():
            return LENGTHS[0], 1
        own = speeds[closing.legs.index(legs.driving)]
        ratio = max(speeds) / own if own > 0.0 else np.inf
    if ratio * LENGTHS[-1] > LONGEST:
        raise StructureError(
            said(
                "position {at}: the pin of link {n} all but stands, so it drives badly; name another link or "
                "position",
                at=name,
                n=legs.driving.link,
            ),
            f"{FREE_SCALE}.at",
            head=FREE_SCALE,
        )
    length = next((one for one in LENGTHS if one * ratio <= LONGEST), LENGTHS[0])
    return length, -1 if float(reading[rate].flat[0]) < 0.0 else 1


def _chosen(plans: KinematicPlans, order: FreeScaleTask) -> tuple[PlateClosing, _Legs]:
    """Return the plate that is asked for, and its legs."""
    found = [*_plates(plans)]
    for closing, legs in found:
        if order.link in (None, legs.driving.link):
            return closing, legs
    says: Said = said(
        "no plate hangs by one leg on the crank pin and by two on the frame, one of which could drive: leave "
        "[free_scale] out"
    )
    if found:
        listed = ", ".join(str(legs.driving.link) for _, legs in found)
        says = said(
            "link {n} is no leg that could drive a plate from the frame; there are {listed}",
            n=order.link,
            listed=listed,
        )
    raise StructureError(says, f"{FREE_SCALE}.link" if found else FREE_SCALE, head=FREE_SCALE)


def _plates(plans: KinematicPlans) -> Iterator[tuple[PlateClosing, _Legs]]:
    """Yield plates with legs that could drive, the last leg first: one on the crank pin, two on the frame."""
    crank, frame = plans.pairs[0], plans.mechanism.frame.number
    if not crank.sweep.turns:
        return
    for closing in on_three_legs(plans.positions.closings, FREE_SCALE):
        hung = [leg for leg in closing.legs if leg.body == crank.link]
        standing = [leg for leg in closing.legs if leg.body == frame and not _along(leg)]
        if len(hung) == 1 and len(standing) == 2 and _turns(hung[0]):
            for driving in reversed(standing):
                if isinstance(driving, PinLeg) and _turns(driving) and isinstance(hung[0], PinLeg):
                    other = next(leg for leg in standing if leg != driving)
                    if hung[0].pivot in crank.arm_ends(plans.positions):
                        yield closing, _Legs(driving, hung[0], other)


def _turns(leg: ClosingLeg) -> bool:
    return isinstance(leg, PinLeg) and not leg.rod


def _along(leg: ClosingLeg) -> bool:
    """Whether a leg slides along the plate, or is longer at times."""
    return leg.inner if isinstance(leg, GuideLeg) else bool(leg.rod)


def _needs(scene: Scene) -> dict[str, bool]:
    return {VELOCITIES: True} if ASKED.of(scene) is not None else {}


PLAN = Plan(needs=_needs, record=record)
