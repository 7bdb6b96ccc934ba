"""Both plans as recorded: accelerations with ε = 0 of a plate, velocities with the pivots held, their sum."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import rate
from graphic_tmm.board.operations.instruments import (
    coincide,
    lay_off,
    measure_along,
    meet,
    parallel,
    similar,
    square,
)
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Length, Point, Reals
from graphic_tmm.chapters.kinematics import words as usual
from graphic_tmm.chapters.kinematics.acceleration_lines import tangential_line
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import PinLeg, SpecialClosing, SquareClosing
from graphic_tmm.chapters.kinematics.formulas import normal_at
from graphic_tmm.chapters.kinematics.motion import (
    Base,
    Hanging,
    Images,
    Motion,
    component,
    hang_leg,
    pin_image,
    pivot_image,
    reading_of,
)
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.kinematics.special_groups import special_accelerations
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.substitution import words as why
from graphic_tmm.chapters.substitution.formulas import closing_part, with_closing_part
from graphic_tmm.chapters.substitution.task import ASKED, SUBSTITUTION
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.records import Scene

LONGEST = 100.0
"""So long the longest vector of the plan with the pivots held may be, mm."""
FIRST = 60.0
"""So long its first vector is at the most, mm."""


class Pin(NamedTuple):
    """The acceleration of a pin as it is read on both plans (mm): by the special point, by substitution."""

    letter: str
    special: Mark
    substituted: Mark


@dataclass(frozen=True)
class Substitution:
    """Accelerations by substitution, shown in the position ``at`` (index), of ``closing``.

    ``first``: the first vector with the pivots held; ``gap``: what is closed. ``usual``: the plan by the
    special point.
    """

    closing: SquareClosing
    at: int
    motion: Motion
    usual: Motion
    first: Mark
    gap: Mark
    pins: tuple[Pin, ...]


SUBSTITUTION_PLAN: Recorded[Substitution] = Recorded(SUBSTITUTION)


def record(bench: Bench) -> Substitution | None:
    """Draw the plans that are asked for.

    Raises
    ------
    StructureError
        If there is no group of class IV, or nothing moves.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans, draft = KINEMATICS_PLAN.on(bench), bench.draft
    closing = _chosen(plans)
    velocities, usual_plan = plans.velocities, plans.accelerations
    assert velocities is not None
    assert usual_plan is not None
    at = (plans.accelerated or (0,))[0]
    if order.at is not None:
        at = chosen((order.at,), bench.names, SUBSTITUTION)[0]
    for view in (why.HELD, SUBSTITUTION):
        bench.rows[view] = (at,)
        bench.tell(view, (at,))
    held = _held(draft, closing, _lengths(plans, closing, bench.coordinates))
    gaps = list[Mark]()

    def way(
        draft: Draft, positions: Positions, v: Motion, plan: Motion, one: SpecialClosing
    ) -> None:
        if one.group.name == closing.group.name:
            gaps.append(_substituted(draft, positions, v, plan, closing, held))
        else:
            special_accelerations(draft, positions, v, plan, one)

    motion = draw_accelerations(
        draft,
        plans.mechanism,
        plans.structure,
        plans.positions,
        velocities,
        view=SUBSTITUTION,
        mu=usual_plan.mu,
        way=way,
    )
    pins = tuple(_pins(draft, closing, usual_plan, motion))
    return Substitution(closing, at, motion, usual_plan, held.first, gaps[0], pins)


class _Held(NamedTuple):
    """Velocities with the pivots held, mm: of the pins of both plates, how the ends of the last link part."""

    first: Mark
    second: Mark
    parting: Mark


def _held(draft: Draft, closing: SquareClosing, lengths: Reals) -> _Held:
    """Draw the plan of velocities with the pivots held and the last joining link away."""
    (own, other), (link, last) = closing.legs, closing.joining
    draft.open(why.HELD)
    pole = draft.take(Point, "p", 0j)
    draft.lay_out(pole)
    b, c, e, f = (_small(letter) for letter in _letters(closing))
    first = draft.take(Length, between(pole, b), lengths[None, :], "mm")
    way = draft.draw(
        square, f"({between(pole, b)})", pole, own.line, sense=1, why=usual.ABOUT_FIXED
    )
    driven = draft.draw(lay_off, b, way, first, free=True, why=why.FREE)
    across = draft.draw(square, f"({b}{c})", driven, link.line, sense=1, why=usual.ABOUT_MOVING)
    turns = draft.draw(
        square, f"({between(pole, c)})", pole, other.line, sense=1, why=usual.ABOUT_FIXED
    )
    end = draft.draw(meet, c, across, turns, free=True, why=usual.BOTH_EQUATIONS)
    B, C = closing.pin(own), closing.pin(other)
    one = draft.draw(similar, e, pole, driven, own.pivot, B, last.pivot, free=True)
    two = draft.draw(similar, f, pole, end, other.pivot, C, closing.pin(last), free=True)
    second = draft.draw(measure_along, between(pole, c), pole, end, turns)
    parting = draft.draw(measure_along, f"{e}{f}", one, two, last.line, why=why.PARTING)
    return _Held(first, second, parting)


def _substituted(
    draft: Draft,
    positions: Positions,
    velocities: Motion,
    plan: Motion,
    closing: SquareClosing,
    held: _Held,
) -> Mark:
    """Draw accelerations with ε = 0 of the first plate, then those that close; return the gap."""
    (own, other), (link, last) = closing.legs, closing.joining
    draft.say(closing.group.formula)
    b, c, e, f = (_small(letter) for letter in _letters(closing))
    tangent, past = (
        _across(draft, velocities, plan, leg, to) for leg, to in ((own, b), (other, c))
    )
    start = draft.uses(tangent)[0]
    known, fixed = pivot_image(plan, own), pivot_image(plan, other)
    zero = draft.draw(coincide, f"{b}0", start, free=True, why=why.WITHOUT_EPSILON)
    B, C = closing.pin(own), closing.pin(other)
    one = draft.draw(similar, f"{e}0", known, zero, own.pivot, B, last.pivot, free=True)
    trial = _trial(draft, plan, positions, own, {link.letter: zero, last.letter: one})
    line = tangential_line(draft, velocities, trial, f"{c}0", link)
    other_zero = draft.draw(meet, f"{c}0", line, past, free=True, why=usual.BOTH_EQUATIONS)
    F = closing.pin(last)
    two = draft.draw(similar, f"{f}0", fixed, other_zero, other.pivot, C, F, free=True)
    due = draft.uses(tangential_line(draft, velocities, trial, f"{f}0", last))[0]
    gap = draft.draw(measure_along, between(due, f"{f}0"), due, two, last.line, why=why.GAP)
    part = draft.draw(closing_part, f"{start.letter}{b}", gap, held.parting, held.first)
    image = draft.draw(lay_off, b, tangent, part, free=True, why=why.ADDED)
    begin = draft.uses(past)[0]
    before = draft.draw(measure_along, between(begin, f"{c}0"), begin, other_zero, past)
    whole = draft.draw(
        with_closing_part, f"{begin.letter}{c}", before, gap, held.parting, held.second
    )
    end = draft.draw(lay_off, c, past, whole, free=True, why=why.ADDED)
    for leg, root, at, tangential in ((own, known, image, part), (other, fixed, end, whole)):
        component(draft, tangential, "t", at.name, leg.letter)
        plan.rates[leg.link] = draft.draw(
            rate, f"ε_{leg.link}", tangential, leg.length, unit="1/s²", why=usual.EPSILON
        )
        pin, letter = closing.pin(leg), closing.pin_letter(leg)
        base = Base(leg.pivot, pin, root, at)
        body = positions.bodies[leg.link]
        plan.images.hang(body, Hanging(leg.pivot, root, base), {leg.letter: root, letter: at})
        plan.images.complete(body)
    for leg in closing.joining:
        begin, point = pivot_image(plan, leg), pin_image(plan, closing, leg)
        segment = between(begin, point.letter)
        line = draft.draw(square, f"({segment})", begin, leg.line, sense=1, why=usual.TANGENTIAL)
        read = draft.draw(measure_along, segment, begin, point, line, why=usual.TANGENTIAL_READ)
        component(draft, read, "t", point.name, leg.letter)
        plan.rates[leg.link] = draft.draw(
            rate, f"ε_{leg.link}", read, leg.length, unit="1/s²", why=usual.EPSILON
        )
        hang_leg(positions, plan, closing, leg, point)
    plan.closed[closing.group.name] = pin_image(plan, closing, closing.legs[1])
    return gap


def _across(draft: Draft, velocities: Motion, plan: Motion, leg: PinLeg, image: str) -> Mark:
    """Lay off the normal segment of a plate's pin by ω of the plate; draw the line of the tangential one."""
    start = pivot_image(plan, leg)
    if not velocities.possible:
        letter = f"n{leg.link}"
        segment = between(start, letter)
        length = draft.draw(normal_at, segment, velocities.rates[leg.link], leg.length)
        component(draft, length, "n", image, leg.letter)
        inward = draft.draw(
            parallel, f"({segment})", start, leg.line, sense=-1, why=usual.TO_THE_OTHER_POINT
        )
        start = draft.draw(lay_off, letter, inward, length, free=True, why=usual.VECTOR)
    name = f"({between(start, image)})"
    return draft.draw(square, name, start, leg.line, sense=1, why=usual.TANGENTIAL)


def _trial(
    draft: Draft, plan: Motion, positions: Positions, own: PinLeg, known: dict[str, Mark]
) -> Motion:
    """Return a plan on which the first plate has the images that it has with ε = 0."""
    images = Images(draft, plan.images.pole, positions.bodies[own.link])
    images.hanging = dict(plan.images.hanging)
    images.by_letter = {**plan.images.by_letter, own.link: known}
    return replace(plan, images=images, readings={}, rates={}, measured=set())


def _lengths(plans: KinematicPlans, closing: SquareClosing, at: tuple[float | None, ...]) -> Reals:
    """Return how long the first vector is in each position, mm: so that none is longer than `LONGEST`."""
    small = next(
        one for one in plans.tried.positions.closings if one.group.name == closing.group.name
    )
    assert isinstance(small, SquareClosing)
    (own, other), (link, last) = small.legs, small.joining
    marks = [own.pivot, other.pivot, link.pivot, small.pin(link), last.pivot, small.pin(last)]
    reading = plans.tried.at(np.array([[np.nan if x is None else x for x in at]]), marks)
    A, D, B, C, E, F = (np.asarray(reading[mark])[0] for mark in marks)
    with np.errstate(all="ignore"):
        turn = ((B - A) * (B - C).conjugate()).imag / ((C - D) * (B - C).conjugate()).imag
        arms = np.abs([B - A, E - A, turn * (C - D), turn * (F - D)])
        length = np.minimum(FIRST, LONGEST * arms[0] / arms.max(axis=0))
    return np.where(np.isfinite(length) & (length > 0.0), length, FIRST)


def _small(letter: str) -> str:
    return letter.lower()


def _letters(closing: SquareClosing) -> tuple[str, str, str, str]:
    """Return the letters of the pins: both of the first joining link, both of the last."""
    own, other = closing.legs
    last = closing.joining[1]
    return (
        closing.pin_letter(own),
        closing.pin_letter(other),
        last.letter,
        closing.pin_letter(last),
    )


def _pins(draft: Draft, closing: SquareClosing, usual_plan: Motion, own: Motion) -> Iterator[Pin]:
    """Yield the pins of the links that join the plates, as read on both plans."""

    def read(plan: Motion) -> Iterator[Mark]:
        for leg in closing.joining:
            for image in (pivot_image(plan, leg), pin_image(plan, closing, leg)):
                length = reading_of(draft, plan, image)
                assert length is not None
                yield length

    letters = (name for leg in closing.joining for name in (leg.letter, closing.pin_letter(leg)))
    yield from map(Pin, letters, read(usual_plan), read(own))


def _chosen(plans: KinematicPlans) -> SquareClosing:
    """Return the first group of class IV."""
    for closing in plans.positions.closings:
        if isinstance(closing, SquareClosing):
            return closing
    raise StructureError(
        said("there are no two plates that two links join (class IV): leave [substitution] out"),
        SUBSTITUTION,
        head=SUBSTITUTION,
    )


def _needs(scene: Scene) -> dict[str, bool]:
    return {VELOCITIES: True, ACCELERATIONS: True} if ASKED.of(scene) is not None else {}


PLAN = Plan(needs=_needs, record=record)
