"""Counterweights on the board: where they stand on their links, their accelerations."""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import incline, lay_off, measure
from graphic_tmm.board.record import Mark, between
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.balance import words as why
from graphic_tmm.chapters.balance.task import BALANCE, COUNTERWEIGHTS, OPPOSITE, Counterweight
from graphic_tmm.chapters.kinematics.bodies import incline_by
from graphic_tmm.chapters.kinematics.closings import PinLeg, dyads
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.plan import KinematicPlans
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench

LETTERS = "KQWUVXYZ"
"""What the mass centre of a counterweight is called, with the number of its link: the first that is free."""


class Arm(NamedTuple):
    """How a link turns: the letter that it turns about, and that of its pin; "" where a guide is in its place.

    ``body``: the number of the link on which it turns.
    """

    pivot: str
    pin: str
    body: int


class Weight(NamedTuple):
    """A counterweight as drawn: on which link, its tag in letters, its mass (kg), its radius (m).

    ``at``: its mass centre on the plan of positions; ``pivot``: what it stands at that radius from.
    """

    link: int
    tag: str
    mass: Mark
    radius: Mark
    pivot: Mark
    at: Mark


def arms_of(plans: KinematicPlans) -> dict[int, Arm]:
    """Return how links turn, by number, those that are driven first; links that only slide are not there."""
    frame = plans.mechanism.frame.number
    found = {
        pair.link: Arm(pair.pivot, pair.pin, frame)
        for pair in plans.pairs
        if isinstance(pair, Crank)
    }
    for closing in dyads(plans.positions.closings, BALANCE):
        for leg in closing.legs:
            if isinstance(leg, PinLeg) and not leg.rod:
                own = plans.positions.bodies[leg.link].marks.items()
                pin = next((letter for letter, mark in own if mark == closing.point), "")
                found[leg.link] = Arm(leg.letter, pin, leg.body)
    return found


def arm_of(plans: KinematicPlans, link: int) -> Arm:
    """Return how a link turns; StructureError if it does not."""
    arms = arms_of(plans)
    if link not in arms:
        says = said(
            "link {link} does not turn about a pin: a counterweight stands on one of links {links}",
            link=link,
            links=", ".join(map(str, arms)),
        )
        raise StructureError(says, f"{COUNTERWEIGHTS[:-1]}.link", head=BALANCE)
    return arms[link]


def draw_given(bench: Bench, plans: KinematicPlans, one: Counterweight) -> Weight:
    """Draw a counterweight that is given on its link in all positions.

    Raises
    ------
    StructureError
        If the link does not turn about a pin.
    """
    draft, arm, body = bench.draft, arm_of(plans, one.link), plans.positions.bodies[one.link]
    assert one.mass is not None
    assert one.radius is not None
    draft.open(COUNTERWEIGHTS)
    own = body.link.points
    way = math.degrees(cmath.phase(own[arm.pin] - own[arm.pivot])) if arm.pin else body.angle
    angle = way - body.angle + (OPPOSITE if one.angle is None else one.angle)
    mass = draft.take(Number, f"m_{{c{one.link}}}", one.mass, "kg")
    radius = draft.take(Number, f"r_{{c{one.link}}}", one.radius, "m")
    return draw_weight(bench, plans, one.link, (mass, radius, angle))


def draw_weight(
    bench: Bench, plans: KinematicPlans, link: int, of: tuple[Mark, Mark, Mark | float]
) -> Weight:
    """Draw a counterweight in all positions; ``of``: its mass, its radius, its angle from the link's axis."""
    draft, body, (mass, radius, angle) = bench.draft, plans.positions.bodies[link], of
    draft.open(COUNTERWEIGHTS)
    pivot = body.marks[arm_of(plans, link).pivot]
    known = {one for other in plans.mechanism.by_number.values() for one in other.points}
    letter = next(name for k in LETTERS if (name := f"{k}{link}") not in known)
    name = f"{pivot.letter}{letter}"
    if isinstance(angle, float):
        line = incline_by(draft, name, pivot, body.axis, angle, why.COUNTERWEIGHT_LINE)
    else:
        uses = (pivot, body.axis, angle)
        line = draft.draw(incline, f"({name})", *uses, why=why.COUNTERWEIGHT_LINE)
    length = draft.draw(to_board, name, radius, draft.mu_l)
    at = draft.draw(lay_off, letter, line, length, free=True, why=why.COUNTERWEIGHT_AT)
    return Weight(link, str(link), mass, radius, pivot, at)


def image_of(bench: Bench, plans: KinematicPlans, weight: Weight) -> Mark:
    """Draw the image of a counterweight's mass centre on the plan of accelerations, and measure its way."""
    draft, plan = bench.draft, plans.accelerations
    assert plan is not None
    draft.open(ACCELERATIONS)
    # no letter of a scene reads so: none of the link's own points is taken for it
    end = plan.images.of(
        weight.link, weight.at, f"counterweight {weight.tag}", weight.at.letter.lower()
    )
    if end != plan.images.pole:
        name = between(plan.images.pole, end.letter)
        draft.draw(measure, name, plan.images.pole, end, why=why.COUNTERWEIGHT_GAINS)
    return end
