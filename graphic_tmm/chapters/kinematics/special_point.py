"""Plans of a plate on three legs by Assur's special point, where the lines of two of its legs cross.

As a point of the plate it moves square to both legs at once, so its image is where two known lines meet; then
the plate is joined to the third leg as two links are. The line of a leg that slides is square to its guide.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Construction, Mark, between
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.acceleration_lines import (
    free_line,
    read_along,
    read_tangential,
    tangential_line,
)
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    Closing,
    ClosingLeg,
    PinLeg,
    PlateClosing,
    SpecialClosing,
    SquareClosing,
)
from graphic_tmm.chapters.kinematics.formulas import normal_at
from graphic_tmm.chapters.kinematics.motion import (
    Base,
    Hanging,
    Motion,
    component,
    hang_leg,
    hold,
    known_image,
    pin_image,
)
from graphic_tmm.chapters.kinematics.task import SPECIAL_POINTS, VELOCITIES
from graphic_tmm.chapters.kinematics.velocity_lines import VelocityLines, leg_line, read_leg, stands


class SpecialPoint(NamedTuple):
    """Assur's special point: the lines that cross there; as links the plates that have it.

    Of a plate on three legs the ``legs`` are that from the point to the third pin; of two plates that links
    join, those from the pivots to the point.
    """

    point: Mark
    lines: tuple[Mark, Mark]
    legs: tuple[PinLeg, ...]

    @property
    def leg(self) -> PinLeg:
        """The first of these legs."""
        return self.legs[0]


def special_point(draft: Draft, closing: SpecialClosing) -> SpecialPoint:
    """Draw the special point of a group; once on a board."""
    view = draft.view
    draft.open(SPECIAL_POINTS)
    name, log = closing.special, draft.board.construction()
    if log.view(SPECIAL_POINTS) is None:
        draft.lay_out(closing.point, draft.mu_l)
    if not log.roles(SPECIAL_POINTS, name):
        lines = [_line(draft, closing, leg) for leg in closing.crossing]
        point = draft.draw(meet, name, *lines, role=name, why=why.SPECIAL_POINT)
        ends = [(name, point, closing.letter, closing.point)]
        if isinstance(closing, SquareClosing):
            ends = [(leg.letter, leg.pivot, name, point) for leg in closing.legs]
        for letter, start, other, end in ends:
            letters = f"{letter}{other}"
            draft.draw(join, f"({letters})", start, end, role=name, why=why.OF_THE_PLATE)
            draft.draw(measure, letters, start, end, role=name, why=why.OF_THE_PLATE)
        log = draft.board.construction()
    draft.open(view)
    return drawn_point(log, closing)


def drawn_point(log: Construction, closing: SpecialClosing) -> SpecialPoint:
    """Return the special point of a group from the log."""
    name = closing.special
    point, *drawn = log.roles(SPECIAL_POINTS, name)
    step = log.step(point)
    assert step is not None
    first, second = step.uses
    if isinstance(closing, SquareClosing):
        legs: tuple[PinLeg, ...] = closing.legs
    else:
        legs = (PinLeg(closing.plate, closing.plate, name, point, drawn[0], drawn[1]),)
    longer = zip(legs, drawn[::2], drawn[1::2], strict=True)
    found = tuple(leg._replace(line=line, length=length) for leg, line, length in longer)
    return SpecialPoint(point, (first, second), found)


def crossing_legs(log: Construction, closing: AnyClosing) -> list[tuple[ClosingLeg, ClosingLeg]]:
    """Return the legs, two by two, whose lines of velocities meet; of a plate by its special point, too."""
    if isinstance(closing, Closing):
        return [closing.legs]
    special = drawn_point(log, closing)
    if isinstance(closing, SquareClosing):
        return [closing.crossing, (special.legs[0], special.legs[1])]
    return [closing.crossing, (special.leg, closing.third)]


def held_along(log: Construction, closing: AnyClosing) -> tuple[ClosingLeg, ...]:
    """Return the legs along whose lines a group without loads is held: joined plates by the special point."""
    return drawn_point(log, closing).legs if isinstance(closing, SquareClosing) else closing.legs


def _line(draft: Draft, closing: SpecialClosing, leg: ClosingLeg) -> Mark:
    """Return the line of a leg, on which the special point lies: its own, or square to its guide."""
    if isinstance(leg, PinLeg):
        return leg.line
    name = f"(n_{closing.pin_letter(leg)})"
    return draft.draw(square, name, closing.pin(leg), leg.line, sense=1, why=why.GUIDE_NORMAL)


def plate_velocities(
    draft: Draft, positions: Positions, plan: Motion, turn: VelocityLines, closing: PlateClosing
) -> None:
    """Draw the velocities of a plate on three legs, and of these."""
    group, pole = closing.group, plan.images.pole
    known = [known_image(plan, closing, leg) for leg in closing.legs]
    alone = plan.images.pole.view != VELOCITIES
    if alone and all(stands(plan, *one) for one in zip(closing.legs, known, strict=True)):
        plan.closed[group.name] = pole
        for number in (*group.links, *group.rods):
            hold(plan, positions.bodies[number])
        return
    special = special_point(draft, closing)
    draft.say(group.formula)
    image, third = special.leg.letter.lower(), closing.third
    lines = [
        leg_line(draft, plan, turn, leg, known_image(plan, closing, leg), image)
        for leg in closing.crossing
    ]
    at = draft.draw(meet, image, lines[1], lines[0], free=True, why=why.SPECIAL_VELOCITY)
    letter = closing.image_of(third)
    across = turn.across(f"({between(at, letter)})", at, special.leg.line, False)
    free = leg_line(draft, plan, turn, third, known_image(plan, closing, third), letter)
    point = draft.draw(meet, letter, free, across, free=True, why=why.BOTH_EQUATIONS)
    read_leg(draft, plan, special.leg, at, point, across)
    _hang_plate(positions, plan, closing, special, at, point)
    for leg, line in zip((*closing.crossing, third), (*lines, free), strict=True):
        pin = pin_image(plan, closing, leg)
        read_leg(draft, plan, leg, draft.uses(line)[0], pin, line)
        hang_leg(positions, plan, closing, leg, pin)


def plate_accelerations(
    draft: Draft, positions: Positions, velocities: Motion, plan: Motion, closing: PlateClosing
) -> None:
    """Draw the accelerations of a plate on three legs, and of these."""
    special = special_point(draft, closing)
    draft.say(closing.group.formula)
    image, third = special.leg.letter.lower(), closing.third
    free = [free_line(draft, velocities, plan, closing, leg) for leg in closing.crossing]
    lines = [
        _beyond(draft, velocities, closing, special, k, line, image) for k, line in enumerate(free)
    ]
    at = draft.draw(meet, image, lines[1], lines[0], free=True, why=why.SPECIAL_ACCELERATION)
    body = positions.bodies[closing.group.plate]
    plan.images.hang(body, Hanging(special.point, at, None), {special.leg.letter: at})
    across = tangential_line(draft, velocities, plan, closing.image_of(third), special.leg)
    free.append(free_line(draft, velocities, plan, closing, third))
    point = draft.draw(
        meet, closing.image_of(third), free[2], across, free=True, why=why.BOTH_EQUATIONS
    )
    read_tangential(draft, plan, special.leg, point, across)
    _hang_plate(positions, plan, closing, special, at, point)
    for leg, line in zip((*closing.crossing, third), free, strict=True):
        pin = pin_image(plan, closing, leg)
        read_along(draft, plan, closing, leg, pin, line)
        hang_leg(positions, plan, closing, leg, pin)


def _beyond(
    draft: Draft,
    velocities: Motion,
    closing: PlateClosing,
    special: SpecialPoint,
    k: int,
    free: Mark,
    image: str,
) -> Mark:
    """Lay off what the special point has besides a pin along the line of both; draw the line left free."""
    leg, line, start = closing.crossing[k], special.lines[k], draft.uses(free)[0]
    if not velocities.possible:
        letter, pin = f"n{closing.group.plate}{closing.image_of(leg)}", closing.pin_letter(leg)
        view = draft.view
        draft.open(SPECIAL_POINTS)
        apart = draft.draw(
            measure_along,
            f"{pin}{special.leg.letter}",
            closing.pin(leg),
            special.point,
            line,
            why=why.OF_THE_PLATE,
        )
        draft.open(view)
        segment = between(start, letter)
        omega = velocities.rates[closing.group.plate]
        length = draft.draw(normal_at, segment, omega, apart)
        component(draft, length, "n", image, pin)
        inward = draft.draw(
            parallel, f"({segment})", start, line, sense=-1, why=why.TO_THE_OTHER_POINT
        )
        start = draft.draw(lay_off, letter, inward, length, free=True, why=why.VECTOR)
    name, because = f"({between(start, image)})", why.TANGENTIAL
    return draft.draw(square, name, start, line, sense=1, why=because)


def _hang_plate(
    positions: Positions,
    plan: Motion,
    closing: PlateClosing,
    special: SpecialPoint,
    at: Mark,
    point: Mark,
) -> None:
    """Enter the plate into the plan's images: by its special point and the pin on its third leg."""
    plan.closed[closing.group.name] = point
    base = Base(special.point, closing.point, at, point)
    body = positions.bodies[closing.group.plate]
    plan.images.hang(body, Hanging(special.point, at, base), {closing.letter: point})
    plan.images.complete(body)
