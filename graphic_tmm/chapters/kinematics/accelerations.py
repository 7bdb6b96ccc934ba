"""The plan of accelerations: normal, tangential and Coriolis segments, two legs a group, similarity.

Normal and Coriolis lengths are calculated from readings of the plan of velocities; their directions come
from the plan of positions, so that a vector of zero length needs no direction of its own.
"""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import (
    coriolis,
    normal,
    product,
    product_of_squares,
    rate,
    to_board,
)
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.kinematics import reasons as why
from graphic_tmm.chapters.kinematics.bodies import Closing, GuideLeg, PinLeg
from graphic_tmm.chapters.kinematics.images import Base, Hanging, Images, image_letter
from graphic_tmm.chapters.kinematics.motion import Motion, hang_group, known_image, measure_absolute
from graphic_tmm.chapters.kinematics.positions import Positions
from graphic_tmm.chapters.kinematics.velocities import crank_arm
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure

VIEW = "accelerations"


def draw_accelerations(
    draft: Draft,
    mechanism: Mechanism,
    structure: Structure,
    positions: Positions,
    velocities: Motion,
) -> Motion:
    """Draw the plan of accelerations of the whole mechanism."""
    draft.open(VIEW)
    pole = draft.take(Point, "π", 0j, role=roles.ACCELERATION)
    mu = draft.scale("μ_a", "(m/s²)/mm")
    draft.lay_out(pole)
    frame = positions.bodies[mechanism.frame.number]
    plan = Motion(Images(draft, pole, frame), mu)
    _crank(draft, mechanism, structure, positions, velocities, plan)
    for closing in positions.closings:
        _group(draft, positions, velocities, plan, closing)
    measure_absolute(draft, plan, positions)
    return plan


def _crank(
    draft: Draft,
    mechanism: Mechanism,
    structure: Structure,
    positions: Positions,
    velocities: Motion,
    plan: Motion,
) -> None:
    pole = plan.images.pole
    number, pivot, pin = structure.driver, structure.pivot, structure.pin
    body, letter = positions.bodies[number], image_letter(structure.pin)
    epsilon = mechanism.drive.acceleration
    arm = crank_arm(draft, positions, structure)
    normal_of = f"a_{{{pin}}}^{{n}}" if epsilon else f"a_{pin}"
    draft.say(f"{normal_of} = ω_{number}²·l_{{{pivot}{pin}}},  {pin} → {pivot}")
    omega = velocities.speed
    assert omega is not None
    because = why.NORMAL_OF_PIN if epsilon else why.GAIN_OF_PIN
    value = draft.draw(product_of_squares, normal_of, omega, arm, unit="m/s²", why=because)
    length = draft.draw(to_board, f"n_{{{letter}}}" if epsilon else f"π{letter}", value)
    inward = draft.draw(parallel, f"(π{letter})", pole, body.axis, sense=-1, why=why.TO_THE_PIVOT)
    if epsilon:
        end = draft.draw(lay_off, f"n{number}", inward, length, why=why.VECTOR)
        draft.say(f"a_{{{pin}}}^{{t}} = ε_{number}·l_{{{pivot}{pin}}},  ⊥ {pivot}{pin}")
        plan.rates[number] = draft.take(Number, f"ε_{number}", epsilon, "1/s²")
        name_t, gain = f"a_{{{pin}}}^{{t}}", plan.rates[number]
        value = draft.draw(product, name_t, gain, arm, unit="m/s²", why=why.TANGENTIAL_OF_PIN)
        length = draft.draw(to_board, f"t_{{{letter}}}", value)
        line = draft.draw(
            square, f"(t_{{{letter}}})", end, body.axis, sense=1, why=why.ACROSS_THE_CRANK
        )
        image = draft.draw(lay_off, letter, line, length, why=why.VECTOR)
    else:
        image = draft.draw(lay_off, letter, inward, length, why=why.VECTOR)
        plan.measured.add(image)
    base = Base(body.marks[pivot], body.marks[pin], pole, image)
    plan.images.hang(body, Hanging(base.A, pole, base), {pivot: pole, pin: image})
    plan.images.complete(body)


def _group(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, closing: Closing
) -> None:
    draft.say(f"II({closing.group.name})")
    lines = [
        _tangential_line(draft, velocities, plan, closing, leg)
        if isinstance(leg, PinLeg)
        else _relative_line(draft, velocities, plan, closing, leg)
        for leg in closing.legs
    ]
    point = draft.draw(
        meet, closing.image_letter, lines[1], lines[0], free=True, why=why.BOTH_EQUATIONS
    )
    for leg, line in zip(closing.legs, lines, strict=True):
        if isinstance(leg, PinLeg):
            _read_tangential(draft, plan, closing, leg, point, line)
        elif draft.uses(line)[0] == plan.images.pole:
            name = f"π{point.letter}"
            plan.readings[leg.link] = draft.draw(
                measure_along, name, plan.images.pole, point, line, why=why.ABSOLUTE_ACCELERATION
            )
            plan.measured.add(point)
        else:
            name = f"r_{{{known_image(plan, closing, leg).letter}{closing.image_letter}}}"
            draft.draw(measure_along, name, draft.uses(line)[0], point, line, why=why.RELATIVE_READ)
    hang_group(positions, plan, closing, point)


def _tangential_line(
    draft: Draft, velocities: Motion, plan: Motion, closing: Closing, leg: PinLeg
) -> Mark:
    """Lay off the normal segment from the pivot's image; draw the line of the tangential one."""
    name = _leg_name(closing, leg)
    start = known_image(plan, closing, leg)
    reading = velocities.readings[leg.link]
    length = draft.draw(normal, f"n_{{{name}}}", reading, leg.length)
    because = why.TO_THE_OTHER_POINT
    inward = draft.draw(
        parallel, f"(n_{{{name}}})", start, leg.line, sense=-1, role=roles.NORMAL, why=because
    )
    end = draft.draw(lay_off, f"n{leg.link}", inward, length, free=True, why=why.VECTOR)
    return draft.draw(square, f"(t_{{{name}}})", end, leg.line, sense=1, why=why.TANGENTIAL)


def _relative_line(
    draft: Draft, velocities: Motion, plan: Motion, closing: Closing, leg: GuideLeg
) -> Mark:
    """Lay off the Coriolis segment if what is slid on turns; draw the line of the relative acceleration."""
    letter = closing.image_letter
    start = known_image(plan, closing, leg)
    turning = velocities.rates.get(closing.legs[1].link if leg.inner else leg.body)
    if turning is not None:
        name, slid = f"{start.letter}{letter}", velocities.readings[leg.link]
        length = draft.draw(coriolis, f"k_{{{name}}}", turning, slid)
        across = draft.draw(
            square, f"(k_{{{name}}})", start, leg.line, sense=1, why=why.CORIOLIS_ACROSS
        )
        start = draft.draw(lay_off, f"k{leg.link}", across, length, free=True, why=why.VECTOR)
    because = why.ACCELERATION_ALONG if start == plan.images.pole else why.RELATIVE_ALONG
    return draft.draw(parallel, f"({start.letter}{letter})", start, leg.line, sense=1, why=because)


def _read_tangential(
    draft: Draft, plan: Motion, closing: Closing, leg: PinLeg, point: Mark, line: Mark
) -> None:
    start = draft.uses(line)[0]
    name, because = f"t_{{{_leg_name(closing, leg)}}}", why.TANGENTIAL_READ
    segment = draft.draw(measure_along, name, start, point, line, why=because)
    plan.rates[leg.link] = draft.draw(
        rate, f"ε_{leg.link}", segment, leg.length, unit="1/s²", why=why.EPSILON
    )


def _leg_name(closing: Closing, leg: PinLeg) -> str:
    return f"{image_letter(leg.letter)}{closing.image_letter}"
