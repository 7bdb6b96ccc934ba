"""The plan of velocities, direct or turned by 90°: two legs a group, then images by similarity.

In the turned plan every line is drawn square to its direction in the direct one, turned so that pa lies
along OA. Relative segments are measured along their lines, with a sign: the sense of ω is its sign.
"""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import product, rate, to_board
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, parallel, square
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Closing,
    ClosingLeg,
    GuideLeg,
    PinLeg,
    dyads,
    unheld,
)
from graphic_tmm.chapters.kinematics.motion import (
    Base,
    Hanging,
    Images,
    Motion,
    hang_group,
    hang_passive,
    image_letter,
    known_image,
    measure_absolute,
    passive_legs,
)
from graphic_tmm.chapters.kinematics.positions import Positions
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure

VIEW = "velocities"


class _Turn:
    """How lines of this plan are drawn from lines of the plan of positions."""

    def __init__(self, draft: Draft, turned: bool, sense: int) -> None:
        self.draft, self.turned, self.sense = draft, turned, sense

    def across(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of a velocity square to a link (in the turned plan: along it).

        ``fixed``: the link turns about a pivot that stands still.
        """
        if self.turned:
            because = why.ABOUT_FIXED_TURNED if fixed else why.ABOUT_MOVING_TURNED
            return self.draft.draw(parallel, name, through, to, sense=self.sense, why=because)
        because = why.ABOUT_FIXED if fixed else why.ABOUT_MOVING
        return self.draft.draw(square, name, through, to, sense=1, why=because)

    def along(self, name: str, through: Mark, to: Mark, fixed: bool) -> Mark:
        """Draw the line of a velocity along a guide (in the turned plan: square to it).

        ``fixed``: the guide stands still.
        """
        if self.turned:
            because = why.ON_FIXED_GUIDE_TURNED if fixed else why.ON_MOVING_GUIDE_TURNED
            return self.draft.draw(square, name, through, to, sense=-self.sense, why=because)
        because = why.ON_FIXED_GUIDE if fixed else why.ON_MOVING_GUIDE
        return self.draft.draw(parallel, name, through, to, sense=1, why=because)


def draw_velocities(
    draft: Draft, mechanism: Mechanism, structure: Structure, positions: Positions, *, turned: bool
) -> Motion:
    """Draw the plan of velocities of the whole mechanism."""
    draft.open(VIEW)
    pole = draft.take(Point, "p", 0j, role=roles.VELOCITY)
    mu = draft.scale("μ_v", "(m/s)/mm")
    draft.lay_out(pole)
    frame = positions.bodies[mechanism.frame.number]
    plan = Motion(Images(draft, pole, frame), mu)
    turn = _Turn(draft, turned, 1 if mechanism.drive.speed > 0 else -1)
    _crank(draft, mechanism, structure, positions, plan, turn)
    for closing in dyads(positions.closings, VIEW):
        _group(draft, positions, plan, turn, closing)
    hang_passive(positions, plan)
    for leg, start, point in passive_legs(positions, plan):
        fixed = start == pole
        line = turn.across(f"({between(start, point.letter)})", start, leg.line, fixed)
        _read(draft, plan, leg, start, point, line)
    measure_absolute(draft, plan, positions)
    return plan


def _crank(
    draft: Draft,
    mechanism: Mechanism,
    structure: Structure,
    positions: Positions,
    plan: Motion,
    turn: _Turn,
) -> None:
    pole = plan.images.pole
    number, pivot, pin = structure.driver, structure.pivot, structure.pin
    body = positions.bodies[number]
    speed = mechanism.drive.speed
    draft.say(f"v_{pin} = ω_{number}·l_{{{pivot}{pin}}},  v_{pin} ⊥ {pivot}{pin}")
    omega = draft.take(Number, f"ω_{number}", abs(speed), "1/s")
    plan.speed = omega
    arm = crank_arm(draft, positions, structure)
    velocity = draft.draw(product, f"v_{pin}", omega, arm, unit="m/s", why=why.SPEED_OF_PIN)
    segment = between(pole, image_letter(pin))
    length = draft.draw(to_board, segment, velocity)
    if turn.turned:
        op, sense, because = parallel, 1, why.VELOCITY_OF_PIN_TURNED
    else:
        op, sense, because = square, turn.sense, why.VELOCITY_OF_PIN
    line = draft.draw(op, f"({segment})", pole, body.axis, sense=sense, why=because)
    image = draft.draw(lay_off, image_letter(pin), line, length, why=why.VECTOR)
    plan.measured.add(image)
    base = Base(body.marks[pivot], body.marks[pin], pole, image)
    plan.images.hang(body, Hanging(base.A, pole, base), {pivot: pole, pin: image})
    plan.images.complete(body)
    plan.rates[number] = omega if speed > 0 else draft.take(Number, f"(−ω_{number})", speed, "1/s")


def crank_arm(draft: Draft, positions: Positions, structure: Structure) -> Mark:
    """Return the mark of the crank's real length l_OA, m."""
    drawn = positions.bodies[structure.driver].marks[structure.pin]
    length = draft.uses(drawn)[1]
    return draft.uses(length)[0]


def _group(draft: Draft, positions: Positions, plan: Motion, turn: _Turn, closing: Closing) -> None:
    letter = closing.image_letter
    draft.say(f"II({closing.group.name})")
    starts, lines = [], []
    for leg in closing.legs:
        start = known_image(plan, closing, leg)
        match leg:
            case PinLeg():
                draw = turn.across
            case GuideLeg():
                draw = turn.along
            case _:
                unheld(leg, VIEW)
        starts.append(start)
        fixed = start == plan.images.pole
        lines.append(draw(f"({between(start, letter)})", start, leg.line, fixed))
    point = draft.draw(meet, letter, lines[1], lines[0], free=True, why=why.BOTH_EQUATIONS)
    for leg, start, line in zip(closing.legs, starts, lines, strict=True):
        _read(draft, plan, leg, start, point, line)
    hang_group(positions, plan, closing, point)


def _read(
    draft: Draft, plan: Motion, leg: ClosingLeg, start: Mark, point: Mark, line: Mark
) -> None:
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
