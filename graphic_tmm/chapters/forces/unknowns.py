"""What holds a leg of a group: of which links, along which line; what moments give of it."""

from __future__ import annotations

from collections.abc import Container, Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import parallel, square
from graphic_tmm.board.operations.statics import at_friction_angle
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Pair
from graphic_tmm.chapters.forces.loads import Force
from graphic_tmm.chapters.kinematics.closings import ClosingLeg, GuideLeg, PinLeg, unheld


class Slope(NamedTuple):
    """How a sliding pair's reaction leans off the normal: f, the normal part in the pass before, the speed.

    ``normal`` and ``segment`` are those of the first link of the pair against the second; ``pin``: the crank
    pin's speed on the same plan.
    """

    f: Mark
    normal: Mark
    segment: Mark
    pin: Mark


Slopes = Mapping[Pair, Slope]
"""Friction along guides by pair (link, body); of an inner guide by (link 3, link 2)."""


class Tangent(NamedTuple):
    """A component that a sum of moments gives: its letter, its value (N), its arm (Length).

    ``side``: the ends of its side of the polygon.
    """

    letter: str
    value: Mark
    arm: Mark
    side: tuple[Mark, Mark] | None = None


class Hinged(NamedTuple):
    """A leg about whose inner end moments are taken: of which links; what these bear beside their loads."""

    leg: ClosingLeg
    pin: Mark
    links: tuple[int, ...]
    forces: tuple[Force, ...] = ()


def links_of(leg: ClosingLeg) -> tuple[int, ...]:
    """Return the links of a leg, from what holds it to the closing point: a cylinder and its rod are two."""
    return leg.links if isinstance(leg, PinLeg) else (leg.link,)


def closing_letter(leg: ClosingLeg, tangents: Container[int]) -> str:
    """Return the letter of what holds a leg along its known line; beside a tangential one it is normal."""
    return f"R_{{{leg.body}{links_of(leg)[0]}}}" + ("^{n}" if leg.link in tangents else "")


def unknown_line(
    draft: Draft,
    leg: ClosingLeg,
    through: Mark,
    slopes: Slopes,
    tangents: Container[int],
) -> Mark:
    """Draw the line of an unknown force: along a link, or square to a guide but for the angle of friction."""
    match leg:
        case PinLeg():
            letter, along = f"({closing_letter(leg, tangents)})", leg.line
            return draft.draw(parallel, letter, through, along, sense=1, why=why.NORMAL_UNKNOWN)
        case GuideLeg():
            pair = guide_pair(leg)
            letter = f"(R_{{{pair[1]}{pair[0]}}})"
            if pair in slopes:
                return draft.draw(at_friction_angle, letter, through, leg.line, *slopes[pair])
            return draft.draw(square, letter, through, leg.line, sense=1, why=why.GUIDE_UNKNOWN)
        case _:
            unheld(leg, "forces")


def guide_pair(leg: GuideLeg) -> Pair:
    """Return whose reaction a guide's line shows: link and body; of the inner guide rocker and stone."""
    return (leg.on, leg.link) if leg.inner else (leg.link, leg.body)
