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
    rate,
    to_board,
)
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, parallel, square
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Closing,
    ClosingLeg,
    GuideLeg,
    Meshed,
    PinLeg,
    Positions,
    unheld,
)
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.motion import (
    Images,
    Motion,
    component,
    hang_group,
    hang_passive,
    hang_wheel,
    known_image,
    measure_absolute,
    passive_legs,
    pivot_image,
)
from graphic_tmm.chapters.kinematics.wheels import attached
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
    for pair in driven(mechanism, structure):
        if pair.held:
            pair.hold(positions, plan)
        else:
            pair.acceleration(draft, positions, velocities, plan)
    for one in attached(positions, VIEW):
        if isinstance(one, Meshed):
            _wheel(draft, positions, velocities, plan, one)
        else:
            _group(draft, positions, velocities, plan, one)
    hang_passive(positions, plan)
    for leg, _, point in passive_legs(positions, plan):
        line = _tangential_line(draft, velocities, plan, point.letter, leg)
        _read_tangential(draft, plan, leg, point, line)
    measure_absolute(draft, plan, positions)
    return plan


def _wheel(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, wheel: Meshed
) -> None:
    """Draw a wheel's pitch point: over the other's along the line of centres, and about its own centre.

    Of a belt the ends of its run differ across it only; where that turns with an arm, it is as a link.
    """
    draft.say(wheel.rolling.note)
    on, leg, span = wheel.rolling.on, wheel.leg, wheel.span
    if span:
        letter, start = wheel.letter, pivot_image(plan, span)
    else:
        letter = f"{wheel.letter}{leg.link}"
        start = plan.images.of(on, wheel.pitch, wheel.rolling.letter, f"{wheel.letter}{on}")
    across = _tangential_line(draft, velocities, plan, letter, leg)
    turns = span is not None and span.link in velocities.readings
    if span and turns:
        along = _tangential_line(draft, velocities, plan, letter, span)
    else:
        name, because = f"({between(start, letter)})", why.RIM_APART if span else why.ROLLING_APART
        along = draft.draw(parallel, name, start, leg.line, sense=1, why=because)
    point = draft.draw(meet, letter, along, across, free=True, why=why.BOTH_EQUATIONS)
    if span and turns:
        component(draft, _read(draft, point, along, why.TANGENTIAL_READ), "t", letter, span.letter)
    elif start != plan.images.pole:
        component(draft, _read(draft, point, along, why.RELATIVE_READ), "r", letter, start.name)
    _read_tangential(draft, plan, leg, point, across)
    hang_wheel(positions, plan, wheel, pivot_image(plan, leg), point)


def _group(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, closing: Closing
) -> None:
    draft.say(f"II({closing.group.name})")
    lines = [_line(draft, velocities, plan, closing, leg) for leg in closing.legs]
    point = draft.draw(
        meet, closing.image_letter, lines[1], lines[0], free=True, why=why.BOTH_EQUATIONS
    )
    for leg, line in zip(closing.legs, lines, strict=True):
        if isinstance(leg, PinLeg):
            _read_tangential(draft, plan, leg, point, line)
        elif draft.uses(line)[0] == plan.images.pole:
            plan.readings[leg.link] = _read(draft, point, line, why.ABSOLUTE_ACCELERATION)
            plan.measured.add(point)
        else:
            length = _read(draft, point, line, why.RELATIVE_READ)
            component(draft, length, "r", point.name, known_image(plan, closing, leg).name)
    hang_group(positions, plan, closing, point)


def _line(
    draft: Draft, velocities: Motion, plan: Motion, closing: Closing, leg: ClosingLeg
) -> Mark:
    match leg:
        case PinLeg():
            return _tangential_line(draft, velocities, plan, closing.image_letter, leg)
        case GuideLeg():
            return _relative_line(draft, velocities, plan, closing, leg)
        case _:
            unheld(leg, VIEW)


def _tangential_line(
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
    draft: Draft, velocities: Motion, plan: Motion, closing: Closing, leg: GuideLeg
) -> Mark:
    """Lay off the Coriolis segment if what is slid on turns; draw the line of the relative acceleration."""
    start = known_image(plan, closing, leg)
    turning = velocities.rates.get(closing.legs[1].link if leg.inner else leg.body)
    if turning is not None and not velocities.possible:
        letter, slid = f"k{leg.link}", velocities.readings[leg.link]
        segment = between(start, letter)
        length = draft.draw(coriolis, segment, turning, slid)
        component(draft, length, "k", closing.image_letter, start.name)
        across = draft.draw(
            square, f"({segment})", start, leg.line, sense=1, why=why.CORIOLIS_ACROSS
        )
        start = draft.draw(lay_off, letter, across, length, free=True, why=why.VECTOR)
    because = why.ACCELERATION_ALONG if start == plan.images.pole else why.RELATIVE_ALONG
    segment = between(start, closing.image_letter)
    return draft.draw(parallel, f"({segment})", start, leg.line, sense=1, why=because)


def _read_tangential(draft: Draft, plan: Motion, leg: PinLeg, point: Mark, line: Mark) -> None:
    segment = _read(draft, point, line, why.TANGENTIAL_READ)
    component(draft, segment, "t", point.name, leg.letter)
    plan.rates[leg.link] = draft.draw(
        rate, f"ε_{leg.link}", segment, leg.length, unit="1/s²", why=why.EPSILON
    )
    if leg.rod:
        plan.rates[leg.rod] = plan.rates[leg.link]


def _read(draft: Draft, point: Mark, line: Mark, because: str) -> Mark:
    """Measure from where a line begins to the point on it."""
    start = draft.uses(line)[0]
    return draft.draw(measure_along, between(start, point.letter), start, point, line, why=because)
