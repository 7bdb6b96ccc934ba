"""Plans of two plates that two links join (class IV) by Assur's special point, where the lines of both cross.

There both plates are equally fast, so each is joined to the point as a link is. Their accelerations there
differ by a vector that is known along both of the lines.
"""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, parallel, square
from graphic_tmm.board.record import Mark, between
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.acceleration_lines import (
    free_line,
    read_along,
    read_tangential,
    tangential_line,
)
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import PinLeg, SquareClosing
from graphic_tmm.chapters.kinematics.formulas import apart_along
from graphic_tmm.chapters.kinematics.motion import (
    Base,
    Hanging,
    Motion,
    component,
    hang_leg,
    hold,
    pin_image,
    pivot_image,
)
from graphic_tmm.chapters.kinematics.special_point import SpecialPoint, special_point
from graphic_tmm.chapters.kinematics.task import SPECIAL_POINTS, VELOCITIES
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines, leg_line, read_leg, stands


def square_velocities(
    draft: Draft, positions: Positions, plan: Motion, turn: VelocityLines, closing: SquareClosing
) -> None:
    """Draw the velocities of two plates that links join, and of these."""
    group, pole = closing.group, plan.images.pole
    known = [pivot_image(plan, leg) for leg in closing.legs]
    alone = pole.view != VELOCITIES
    if alone and all(stands(plan, *one) for one in zip(closing.legs, known, strict=True)):
        plan.closed[group.name] = pole
        for number in group.links:
            hold(plan, positions.bodies[number])
        return
    special = special_point(draft, closing)
    draft.say(group.formula)
    image = closing.special.lower()
    lines = [
        leg_line(draft, plan, turn, leg, start, image)
        for leg, start in zip(special.legs, known, strict=True)
    ]
    at = draft.draw(meet, image, lines[1], lines[0], free=True, why=why.EQUALLY_FAST)
    for leg, start, line in zip(special.legs, known, lines, strict=True):
        read_leg(draft, plan, leg, start, at, line)
        _hang_plate(positions, plan, special, leg, at)
    for leg in closing.joining:
        start, end = pivot_image(plan, leg), pin_image(plan, closing, leg)
        line = turn.across(f"({between(start, end.letter)})", start, leg.line, start == pole)
        read_leg(draft, plan, leg, start, end, line)
        hang_leg(positions, plan, closing, leg, end)
    plan.closed[group.name] = pin_image(plan, closing, closing.legs[1])


def square_accelerations(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, closing: SquareClosing
) -> None:
    """Draw the accelerations of two plates that links join, and of these."""
    special = special_point(draft, closing)
    draft.say(closing.group.formula)
    first, second = special.legs
    names = [f"w{leg.link}" for leg in special.legs]
    own = tangential_line(draft, velocities, plan, names[0], first)
    line = own
    if not velocities.possible:
        start = _apart(draft, velocities, closing, special, draft.uses(own)[0])
        segment = between(start, names[1])
        line = draft.draw(square, f"({segment})", start, first.line, sense=1, why=why.TANGENTIAL)
    other = tangential_line(draft, velocities, plan, names[1], second)
    end = draft.draw(meet, names[1], other, line, free=True, why=why.BOTH_EQUATIONS)
    read_tangential(draft, plan, first, end, line)
    read_tangential(draft, plan, second, end, other)
    at = end
    if not velocities.possible:
        part = draft.uses(plan.rates[first.link])[0]
        at = draft.draw(lay_off, names[0], own, part, free=True, why=why.SAME_TANGENTIAL)
    _hang_plate(positions, plan, special, first, at)
    _hang_plate(positions, plan, special, second, end)
    for leg in closing.joining:
        free = free_line(draft, velocities, plan, closing, leg)
        point = pin_image(plan, closing, leg)
        read_along(draft, plan, closing, leg, point, free)
        hang_leg(positions, plan, closing, leg, point)
    plan.closed[closing.group.name] = pin_image(plan, closing, closing.legs[1])


def _apart(
    draft: Draft, velocities: Motion, closing: SquareClosing, special: SpecialPoint, start: Mark
) -> Mark:
    """Lay off by what the point of the second plate differs from that of the first; return where it ends."""
    first, second = (leg.link for leg in special.legs)
    across = list[Mark]()
    for leg in closing.joining:
        pin = closing.pin(leg)
        view = draft.view
        draft.open(SPECIAL_POINTS)
        lengths = [
            draft.draw(
                measure_along,
                f"{letter}{closing.special}",
                mark,
                special.point,
                leg.line,
                why=why.OF_THE_PLATE,
            )
            for letter, mark in ((leg.letter, leg.pivot), (closing.pin_letter(leg), pin))
        ]
        draft.open(view)
        letter, of = f"m{leg.link}", velocities.rates
        segment = between(start, letter)
        length = draft.draw(
            apart_along,
            segment,
            of[first],
            lengths[0],
            of[leg.link],
            leg.length,
            of[second],
            lengths[1],
        )
        component(draft, length, leg.letter + closing.pin_letter(leg), f"w{second}", f"w{first}")
        way = draft.draw(parallel, f"({segment})", start, leg.line, sense=1, why=why.ALONG_THE_LINK)
        foot = draft.draw(lay_off, letter, way, length, free=True, why=why.VECTOR)
        name = f"m{first}{second}"
        across.append(
            draft.draw(
                square, f"({between(foot, name)})", foot, leg.line, sense=1, why=why.REST_ACROSS
            )
        )
    return draft.draw(meet, name, across[1], across[0], free=True, why=why.BOTH_PARTS)


def _hang_plate(
    positions: Positions, plan: Motion, special: SpecialPoint, leg: PinLeg, at: Mark
) -> None:
    """Enter a plate into the plan's images: by its pivot and the special point."""
    start, body = pivot_image(plan, leg), positions.bodies[leg.link]
    base = Base(leg.pivot, special.point, start, at)
    plan.images.hang(body, Hanging(leg.pivot, start, base), {leg.letter: start})
    plan.images.complete(body)
