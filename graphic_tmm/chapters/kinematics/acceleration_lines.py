"""Lines and segments of a plan of accelerations: what is known is laid off, what is not is read along lines."""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import coriolis, normal, rate, to_board
from graphic_tmm.board.operations.instruments import lay_off, measure_along, parallel, square
from graphic_tmm.board.record import Mark, between
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    ClosingLeg,
    GuideLeg,
    PinLeg,
    unheld,
)
from graphic_tmm.chapters.kinematics.motion import Motion, component, known_image, pivot_image


def free_line(
    draft: Draft, velocities: Motion, plan: Motion, closing: AnyClosing, leg: ClosingLeg
) -> Mark:
    """Lay off what is known of a leg; draw the line of what it leaves free."""
    match leg:
        case PinLeg():
            return tangential_line(draft, velocities, plan, closing.image_of(leg), leg)
        case GuideLeg():
            return _relative_line(draft, velocities, plan, closing, leg)
        case _:
            unheld(leg, plan.images.pole.view)


def tangential_line(
    draft: Draft, velocities: Motion, plan: Motion, point: str, leg: PinLeg
) -> Mark:
    """Lay off the normal segment from the pivot's image; draw the line of the tangential one.

    ``point``: the letter of the image that it leads to.
    """
    letter, start = f"n{leg.link}", pivot_image(plan, leg)
    if leg.rod:
        start = plan.ends[leg.link] = _rod_out(
            draft, velocities, plan, leg, start, point + leg.letter
        )
    if velocities.possible:
        segment = between(start, point)
        return draft.draw(square, f"({segment})", start, leg.line, sense=1, why=why.TANGENTIAL)
    segment, reading = between(start, letter), velocities.readings[leg.link]
    length = draft.draw(normal, segment, reading, leg.length)
    component(draft, length, "n", point, leg.letter)
    because = why.TO_THE_OTHER_POINT
    inward = draft.draw(
        parallel, f"({segment})", start, leg.line, sense=-1, role=roles.NORMAL, why=because
    )
    end = draft.draw(lay_off, letter, inward, length, free=True, why=why.VECTOR)
    segment = between(end, point)
    return draft.draw(square, f"({segment})", end, leg.line, sense=1, why=why.TANGENTIAL)


def _rod_out(
    draft: Draft, velocities: Motion, plan: Motion, leg: PinLeg, start: Mark, ends: str
) -> Mark:
    """Lay off the Coriolis acceleration of a rod and its own along the cylinder; return where both end.

    ``ends``: the letters of both pins.
    """
    gain, end = plan.speeds.get(leg.rod), start
    if not velocities.possible and leg.link in velocities.outs:
        end = _coriolis_of_rod(draft, velocities, leg, start, ends)
    if gain is None:
        return end
    segment = between(end, f"r{leg.link}")
    length = draft.draw(to_board, segment, gain)
    draft.figure(roles.COMPONENT, gain.letter, length)
    along = draft.draw(parallel, f"({segment})", end, leg.line, sense=1, why=why.ROD_GAIN)
    return draft.draw(lay_off, f"r{leg.link}", along, length, free=True, why=why.VECTOR)


def _coriolis_of_rod(draft: Draft, velocities: Motion, leg: PinLeg, start: Mark, ends: str) -> Mark:
    letter, out = f"k{leg.link}", velocities.outs[leg.link]
    segment = between(start, letter)
    length = draft.draw(coriolis, segment, velocities.rates[leg.link], out)
    component(draft, length, "k", ends)
    across = draft.draw(square, f"({segment})", start, leg.line, sense=1, why=why.ROD_CORIOLIS)
    return draft.draw(lay_off, letter, across, length, free=True, why=why.VECTOR)


def _relative_line(
    draft: Draft, velocities: Motion, plan: Motion, closing: AnyClosing, leg: GuideLeg
) -> Mark:
    """Lay off the Coriolis segment if what is slid on turns; draw the line of the relative acceleration."""
    start = known_image(plan, closing, leg)
    turning = velocities.rates.get(leg.on if leg.inner else leg.body)
    if turning is not None and not velocities.possible:
        letter, slid = f"k{leg.link}", velocities.readings[leg.link]
        segment = between(start, letter)
        length = draft.draw(coriolis, segment, turning, slid)
        component(draft, length, "k", closing.image_of(leg), _under(closing, leg, start))
        across = draft.draw(
            square, f"({segment})", start, leg.line, sense=1, why=why.CORIOLIS_ACROSS
        )
        start = draft.draw(lay_off, letter, across, length, free=True, why=why.VECTOR)
    because = why.ACCELERATION_ALONG if start == plan.images.pole else why.RELATIVE_ALONG
    segment = between(start, closing.image_of(leg))
    return draft.draw(parallel, f"({segment})", start, leg.line, sense=1, why=because)


def _under(closing: AnyClosing, leg: GuideLeg, image: Mark) -> str:
    """Return the letter of the point that the relative motion of a sliding leg is about."""
    return closing.pin_letter(leg) if leg.inner else image.name


def read_along(
    draft: Draft, plan: Motion, closing: AnyClosing, leg: ClosingLeg, point: Mark, line: Mark
) -> None:
    """Read what a leg leaves free, from where its line begins to the image of its inner end."""
    if isinstance(leg, PinLeg):
        read_tangential(draft, plan, leg, point, line)
    elif draft.uses(line)[0] == plan.images.pole:
        plan.readings[leg.link] = read_segment(draft, point, line, why.ABSOLUTE_ACCELERATION)
        plan.measured.add(point)
    else:
        length = read_segment(draft, point, line, why.RELATIVE_READ)
        under = _under(closing, leg, known_image(plan, closing, leg))
        component(draft, length, "r", point.name, under)


def read_tangential(draft: Draft, plan: Motion, leg: PinLeg, point: Mark, line: Mark) -> None:
    """Read the tangential component of a leg, and ε of its link by it."""
    segment = read_segment(draft, point, line, why.TANGENTIAL_READ)
    component(draft, segment, "t", point.name, leg.letter)
    plan.rates[leg.link] = draft.draw(
        rate, f"ε_{leg.link}", segment, leg.length, unit="1/s²", why=why.EPSILON
    )
    if leg.rod:
        plan.rates[leg.rod] = plan.rates[leg.link]


def read_segment(draft: Draft, point: Mark, line: Mark, because: str) -> Mark:
    """Measure from where a line begins to the point on it."""
    start = draft.uses(line)[0]
    return draft.draw(measure_along, between(start, point.letter), start, point, line, why=because)
