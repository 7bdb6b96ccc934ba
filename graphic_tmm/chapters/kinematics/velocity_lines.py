"""Lines of a plan of velocities, direct or turned by 90°, drawn from lines of the plan of positions."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import rate, to_board
from graphic_tmm.board.operations.instruments import lay_off, measure_along, parallel, square
from graphic_tmm.board.record import Mark, between
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.closings import ClosingLeg, GuideLeg, PinLeg, unheld
from graphic_tmm.chapters.kinematics.motion import Motion, component


class VelocityLines(NamedTuple):
    """How lines of a plan are drawn; ``sense``: of the drive, by which a turned plan is turned."""

    draft: Draft
    turned: bool
    sense: int

    def across(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of a velocity square to a link (in the turned plan: along it).

        ``fixed``: the link turns about a pivot that stands still.
        """
        if self.turned:
            because = why.ABOUT_FIXED_TURNED if fixed else why.ABOUT_MOVING_TURNED
            return self.draft.draw(parallel, name, through, to, sense=self.sense, why=because)
        because = why.ABOUT_FIXED if fixed else why.ABOUT_MOVING
        return self.draft.draw(square, name, through, to, sense=1, why=because)

    def with_cylinder(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of what is left of a rod's velocity: square to it (in the turned plan: along it)."""
        if self.turned:
            sense, because = self.sense, why.ROD_TURNS_TURNED
            return self.draft.draw(parallel, name, through, to, sense=sense, why=because)
        return self.draft.draw(square, name, through, to, sense=1, why=why.ROD_TURNS)

    def out(self, name: str, through: Mark, to: Mark) -> Mark:
        """Draw the line of the velocity of a rod seen from its cylinder (in the turned plan: square to it)."""
        if self.turned:
            return self.draft.draw(
                square, name, through, to, sense=-self.sense, why=why.ROD_OUT_TURNED
            )
        return self.draft.draw(parallel, name, through, to, sense=1, why=why.ROD_OUT)

    def along(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of a velocity along a guide (in the turned plan: square to it).

        ``fixed``: the guide stands still.
        """
        if self.turned:
            because = why.ON_FIXED_GUIDE_TURNED if fixed else why.ON_MOVING_GUIDE_TURNED
            return self.draft.draw(square, name, through, to, sense=-self.sense, why=because)
        because = why.ON_FIXED_GUIDE if fixed else why.ON_MOVING_GUIDE
        return self.draft.draw(parallel, name, through, to, sense=1, why=because)


def leg_line(
    draft: Draft, plan: Motion, turn: VelocityLines, leg: ClosingLeg, start: Mark, letter: str
) -> Mark:
    """Draw the line of the velocity that a leg leaves free, towards an image; of a rod behind its own."""
    match leg:
        case PinLeg():
            draw = turn.across
            if leg.rod in plan.speeds:
                start, draw = _rod_out(draft, plan, turn, leg, start), turn.with_cylinder
        case GuideLeg():
            draw = turn.along
        case _:
            unheld(leg, plan.images.pole.view)
    return draw(f"({between(start, letter)})", start, leg.line, start == plan.images.pole)


def stands(plan: Motion, leg: ClosingLeg, start: Mark) -> bool:
    """Whether what holds a leg stands, and nothing drives it: its drives are held."""
    if start != plan.images.pole:
        return False
    match leg:
        case PinLeg():
            return leg.rod not in plan.speeds
        case GuideLeg():
            return leg.inner or not plan.images.turns(leg.body)
        case _:
            unheld(leg, plan.images.pole.view)


def _rod_out(draft: Draft, plan: Motion, turn: VelocityLines, leg: PinLeg, start: Mark) -> Mark:
    """Lay off the velocity of a rod seen from its cylinder; return its end, from which the leg turns."""
    speed, letter = plan.speeds[leg.rod], f"k{leg.link}"
    segment = between(start, letter)
    length = draft.draw(to_board, segment, speed)
    draft.figure(roles.COMPONENT, speed.letter, length)
    line = turn.out(f"({segment})", start, leg.line)
    end = draft.draw(lay_off, letter, line, length, free=True, why=why.VECTOR)
    plan.ends[leg.link], plan.outs[leg.link] = end, length
    plan.driven[leg.rod] = start, end
    return end


def read_leg(
    draft: Draft, plan: Motion, leg: ClosingLeg, start: Mark, point: Mark, line: Mark
) -> None:
    """Read the segment that a leg leaves free, from where its line begins; of what turns, ω."""
    name, fixed = between(start, point.letter), start == plan.images.pole
    because = why.ABSOLUTE_VELOCITY if fixed else why.RELATIVE_VELOCITY
    segment = draft.draw(measure_along, name, start, point, line, why=because)
    plan.readings[leg.link] = segment
    if fixed:
        plan.measured.add(point)
    if isinstance(leg, PinLeg):
        plan.rates[leg.link] = draft.draw(
            rate, f"ω_{leg.link}", segment, leg.length, unit="1/s", why=why.OMEGA
        )
        if leg.link in plan.outs:
            component(draft, segment, "t", point.name, leg.letter, of="v")
        if leg.rod:
            plan.rates[leg.rod] = plan.rates[leg.link]
