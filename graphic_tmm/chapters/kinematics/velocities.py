"""The plan of velocities, direct or turned by 90°: two legs a group, then images by similarity.

In the turned plan every line is drawn square to its direction in the direct one, turned so that pa lies
along OA. Relative segments are measured along their lines, with a sign: the sense of ω is its sign.
"""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import coincide, measure, measure_along, meet
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import Meshed, Positions
from graphic_tmm.chapters.kinematics.closings import (
    Closing,
    PinLeg,
)
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.motion import (
    Images,
    Motion,
    hang_group,
    hang_passive,
    hang_wheel,
    hold,
    known_image,
    measure_absolute,
    passive_legs,
    pivot_image,
)
from graphic_tmm.chapters.kinematics.special_groups import special_velocities
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines, leg_line, read_leg, stands
from graphic_tmm.chapters.kinematics.wheels import attached
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure

VIEW = "velocities"


def draw_velocities(
    draft: Draft,
    mechanism: Mechanism,
    structure: Structure,
    positions: Positions,
    *,
    turned: bool,
    view: str = VIEW,
) -> Motion:
    """Draw the plan of velocities of the whole mechanism."""
    draft.open(view)
    pole = draft.take(Point, "p", 0j, role=roles.VELOCITY)
    mu = draft.scale("μ_v", "(m/s)/mm")
    draft.lay_out(pole)
    frame = positions.bodies[mechanism.frame.number]
    plan = Motion(Images(draft, pole, frame), mu, possible=mechanism.at_rest)
    turn = VelocityLines(draft, turned, mechanism.drive.sense)
    for pair in driven(mechanism, structure):
        if pair.held:
            pair.hold(positions, plan)
        else:
            pair.velocity(positions, plan, turn)
    for one in attached(positions, VIEW):
        if isinstance(one, Meshed):
            _wheel(draft, positions, plan, turn, one)
        elif isinstance(one, Closing):
            _group(draft, positions, plan, turn, one)
        else:
            special_velocities(draft, positions, plan, turn, one)
    hang_passive(positions, plan)
    for leg, start, point in passive_legs(positions, plan):
        fixed = start == pole
        line = turn.across(f"({between(start, point.letter)})", start, leg.line, fixed)
        read_leg(draft, plan, leg, start, point, line)
    measure_absolute(draft, plan, positions)
    return plan


def _wheel(
    draft: Draft, positions: Positions, plan: Motion, turn: VelocityLines, wheel: Meshed
) -> None:
    """Read the velocity of the pitch point, common to both wheels, about the centre of the one that rolls.

    Of a belt that joins wheels about pivots of the frame both ends of its run are equally fast.
    """
    rolling, leg, span, pole = wheel.rolling, wheel.leg, wheel.span, plan.images.pole
    start, letter, pin = pivot_image(plan, leg), rolling.letter, rolling.pin
    if span and plan.images.turns(rolling.arm):
        _on_arm(draft, positions, plan, turn, wheel, span)
        return
    point = letter if start == pole else f"{letter}{pin}"
    about = f"ω_{leg.link}·l_{{{pin}{letter}}}" if start == pole else f"v_{pin} + v_{{{point}}}"
    equal = f"v_{{{span.letter}}} = " if span else ""
    draft.say(f"{equal}v_{{{letter}}} = {about},  v_{{{point}}} ⊥ {pin}{letter}")
    if span:
        far = pivot_image(plan, span)
        image = draft.draw(coincide, wheel.letter, far, free=True, why=why.EQUAL_RIMS)
    else:
        image = plan.images.of(rolling.on, wheel.pitch, letter, wheel.letter)
    if image == pole:
        image = draft.draw(coincide, wheel.letter, pole, free=True, why=why.STANDING_WHEEL)
    elif start != pole:
        draft.draw(measure, between(pole, image.letter), pole, image, why=why.ABSOLUTE_VELOCITY)
        plan.measured.add(image)
    line = turn.across(f"({between(start, image.letter)})", start, leg.line, start == pole)
    read_leg(draft, plan, leg, start, image, line)
    hang_wheel(positions, plan, wheel, start, image)


def _on_arm(
    draft: Draft,
    positions: Positions,
    plan: Motion,
    turn: VelocityLines,
    wheel: Meshed,
    span: PinLeg,
) -> None:
    """Draw the velocity of the end of a belt's run: about its other end, and about the centre of the wheel."""
    draft.say(wheel.rolling.note)
    lines = list[Mark]()
    for leg in (span, wheel.leg):
        start = pivot_image(plan, leg)
        name = f"({between(start, wheel.letter)})"
        lines.append(turn.across(name, start, leg.line, start == plan.images.pole))
    image = draft.draw(meet, wheel.letter, *lines, free=True, why=why.BOTH_EQUATIONS)
    far, start = (pivot_image(plan, leg) for leg in (span, wheel.leg))
    plan.readings[span.link] = draft.draw(
        measure_along,
        between(far, image.letter),
        far,
        image,
        lines[0],
        why=why.RELATIVE_VELOCITY,
    )
    read_leg(draft, plan, wheel.leg, start, image, lines[1])
    hang_wheel(positions, plan, wheel, start, image)


def _group(
    draft: Draft, positions: Positions, plan: Motion, turn: VelocityLines, closing: Closing
) -> None:
    letter, starts, lines = closing.image_letter, [], []
    known = [known_image(plan, closing, leg) for leg in closing.legs]
    # no plan of accelerations goes by that of one drive
    alone = plan.images.pole.view != VIEW
    if alone and all(stands(plan, *one) for one in zip(closing.legs, known, strict=True)):
        plan.closed[closing.group.name] = plan.images.pole
        for number in (*closing.group.links, *closing.group.rods):
            hold(plan, positions.bodies[number])
        return
    draft.say(f"II({closing.group.name})")
    for leg, start in zip(closing.legs, known, strict=True):
        line = leg_line(draft, plan, turn, leg, start, letter)
        starts.append(draft.uses(line)[0])
        lines.append(line)
    point = draft.draw(meet, letter, lines[1], lines[0], free=True, why=why.BOTH_EQUATIONS)
    for leg, start, line in zip(closing.legs, starts, lines, strict=True):
        read_leg(draft, plan, leg, start, point, line)
    hang_group(positions, plan, closing, point)
