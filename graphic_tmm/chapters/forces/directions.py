"""Directions of loads that turn with the links: of two letters or of a guide on the plan of positions."""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import join, ray
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.kinds import Along
from graphic_tmm.chapters.kinematics.bodies import Positions, incline_by
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Guide, Mechanism
from graphic_tmm.scene.letters import split


def two_letters(line: str, known: frozenset[str]) -> tuple[str, str] | None:
    """Return the letters that a line is named by, from the first to the second; None where it is a guide."""
    pair = split(line)
    return pair if pair is not None and known.issuperset(pair) else None


def all_letters(mechanism: Mechanism) -> frozenset[str]:
    """Return the letters of all points of a mechanism, the frame's among them."""
    return frozenset(letter for link in mechanism.by_number.values() for letter in link.points)


def owner_of(line: str, mechanism: Mechanism) -> tuple[int, Guide]:
    """Return the guide of a name and the number of the link that bears it.

    Raises
    ------
    StructureError
        If no link bears it, or more than one.
    """
    found = [
        (number, guide)
        for number, link in mechanism.by_number.items()
        for guide in link.guides
        if guide.name == line
    ]
    if len(found) != 1:
        raise StructureError(
            said(
                "{line} is neither two letters nor the guide of one link: name two letters, along AC",
                line=line,
            ),
            "direction",
        )
    return found[0]


def draw_along(
    draft: Draft, positions: Positions, mechanism: Mechanism, along: Along, point: Mark, letter: str
) -> Mark:
    """Draw through a point the line of action of a load whose direction turns with the links.

    Raises
    ------
    StructureError
        If there is no such line on the plan.
    """
    pair, because = two_letters(along.line, all_letters(mechanism)), why.TURNING_LINE
    if pair is not None:
        start, end = (positions.point(one) for one in pair)
        if point == start and along.by % 360.0 == 0.0:
            return draft.draw(join, f"({letter})", start, end, why=because)
        line = draft.draw(join, f"({along.line})", start, end, why=because)
        return incline_by(draft, letter, point, line, along.by, because)
    number, guide = owner_of(along.line, mechanism)
    body, angle = positions.bodies[number], guide.angle + along.by
    if number == mechanism.frame.number:
        return draft.draw(ray, f"({letter})", point, draft.direction(angle), why=why.GIVEN_LINE)
    return incline_by(draft, letter, point, body.axis, angle - body.angle, because)
