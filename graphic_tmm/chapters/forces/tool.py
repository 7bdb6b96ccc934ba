"""An unknown force at a tool: the lever gives it by one division, then groups are solved with it as a load.

What drives has its own load among the given ones, so the groups must leave it with nothing to balance it.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.operations.instruments import parallel
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.given_loads import line_of
from graphic_tmm.chapters.forces.lever import Carried, Lever
from graphic_tmm.chapters.forces.loads import VIEW, Force, Ground, point_of
from graphic_tmm.chapters.forces.operations import advantage, unknown_on_lever
from graphic_tmm.chapters.forces.task import Unknown
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said


class Sought(NamedTuple):
    """An unknown force before it is found: its letter, link, point and line, the image of its point."""

    letter: str
    link: int
    point: Mark
    line: Mark
    image: Mark


class Tool(NamedTuple):
    """The force at the tool, N: on its link, on the lever, with its arm there (Length).

    ``advantage``: how many times the force at what drives it is.
    """

    force: Force
    carried: Carried
    arm: Mark
    advantage: Mark


def letter_of(unknown: Unknown) -> str:
    """Return the letter of an unknown force, with that of its point: P_{B}."""
    return f"P_{{{unknown.point}}}"


def draw_line(ground: Ground, unknown: Unknown) -> Sought:
    """Draw the line of action of an unknown force.

    Raises
    ------
    StructureError
        If its point stands still, or several drives are to be balanced.
    """
    if len(ground.pairs) > 1:
        raise StructureError(
            said(
                "one unknown force balances a mechanism of one drive, here are {n}: leave unknown out",
                n=len(ground.pairs),
            ),
            "forces.unknown",
            head="unknown",
        )
    point, image = point_of(ground, unknown.link, unknown.point)
    if image == ground.velocities.images.pole:
        raise StructureError(
            said("{point} stands still: no force there moves anything", point=unknown.point),
            "forces.unknown",
            head="unknown",
        )
    ground.draft.open(VIEW)
    letter = ground.draft.board.free(letter_of(unknown))
    line = line_of(ground, unknown.direction, point, letter)
    return Sought(letter, unknown.link, point, line, image)


def draw_tool(ground: Ground, sought: Sought, lever: Lever) -> Tool:
    """Find an unknown force on the lever of all known loads."""
    draft, (letter, link, point, line, image) = ground.draft, sought
    draft.open(lever.pole.view)
    images = dict.fromkeys(ground.velocities.images.by_letter[link].values())
    end = dict(zip(images, lever.images[link], strict=True))[image]
    because = why.FORCE_ON_LEVER
    along = draft.draw(parallel, f"({letter})", end, line, sense=1, why=because)
    name = letter.removeprefix("P_")
    height = draft.draw(arm, f"h_{name}", lever.pole, along)
    value = draft.draw(unknown_on_lever, letter, lever.total, height, unit="N")
    gain = draft.draw(advantage, "i_P", lever.segment, height)
    force = Force(letter, link, point, line, value, image)
    return Tool(force, Carried(letter, end, along, value), height, gain)
