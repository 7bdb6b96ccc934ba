"""A plate on three legs: moments of the whole group about Assur's special point give what holds the third leg.

The lines of what holds the other two legs cross there, so neither has a moment.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import meet, square
from graphic_tmm.board.operations.statics import reversed_
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force
from graphic_tmm.chapters.forces.operations import along_third
from graphic_tmm.chapters.forces.unknowns import (
    Slope,
    Slopes,
    Tangent,
    guide_pair,
    links_of,
    unknown_line,
)
from graphic_tmm.chapters.kinematics.closings import ClosingLeg, GuideLeg, PinLeg, PlateClosing


class Special(NamedTuple):
    """Assur's special point in the figure of a plate, the lines that cross there, the line of the third leg.

    ``forces``, ``couples``: what holds legs and is known when moments about it are taken; ``total``: their sum
    with the loads (N·m); ``third``: what that gives of the third leg.
    """

    point: Mark
    lines: tuple[Mark, Mark]
    line: Mark
    forces: tuple[Force, ...]
    couples: tuple[Couple, ...]
    total: Mark
    third: Tangent


def solve_third(
    figure: Detached,
    closing: PlateClosing,
    acting: Acting,
    slopes: Slopes,
    turning: Mapping[int, Mark | None],
    tangents: Mapping[int, Tangent],
) -> Special:
    """Find what holds the third leg of a plate along its line: nothing else turns about the special point.

    ``turning``: the moments that guides hold, by link; ``tangents``: components that are known, by link.
    """
    draft = figure.draft

    def line_of(leg: ClosingLeg) -> Mark:
        through, slope = figure.point(closing.at(leg)), _slope(leg, slopes)
        return figure.once(
            (leg, slope, leg.link in tangents),
            lambda: unknown_line(draft, leg, through, slopes, tangents),
        )

    first, second = (line_of(leg) for leg in closing.crossing)
    name = f"W{closing.group.plate}"
    point = figure.once(
        ("special", first, second),
        lambda: draft.draw(meet, name, first, second, free=True, why=why.SPECIAL_POINT_OF_FORCES),
    )
    figure.own(point)
    forces = tuple(
        _across(figure, leg, tangents[leg.link])
        for leg in closing.legs
        if isinstance(leg, PinLeg) and leg.link in tangents
    )
    couples = tuple(
        _held(figure, leg, couple)
        for leg in closing.legs
        if isinstance(leg, GuideLeg) and (couple := turning[leg.link]) is not None
    )
    links = (*closing.group.links, *closing.group.rods)
    known = [force for link in links for force in acting.forces.get(link, [])]
    turned = [couple for link in links for couple in acting.couples.get(link, [])]
    letter = f"ΣM_{{{name}}}"
    total = figure.sum(point, [*known, *forces], [*turned, *couples], letter)
    if total is None:
        total = draft.take(Number, letter, 0.0, "N·m")
    called, line = _letter(closing.third), line_of(closing.third)
    height = figure.arm(called, point, line)
    value = draft.draw(along_third, called, total, height, figure.mu, unit="N")
    given = Tangent(called, value, height)
    return Special(point, (first, second), line, forces, couples, total, given)


def _letter(leg: ClosingLeg) -> str:
    """Return the letter of what holds the third leg along its line: it is signed, the whole reaction is not."""
    raised = "n" if isinstance(leg, PinLeg) else "W"
    return f"R_{{{leg.body}{links_of(leg)[0]}}}^{{{raised}}}"


def _slope(leg: ClosingLeg, slopes: Slopes) -> Slope | None:
    return slopes.get(guide_pair(leg)) if isinstance(leg, GuideLeg) else None


def _across(figure: Detached, leg: PinLeg, tangent: Tangent) -> Force:
    """Return the tangential component of a leg that turns, at its pivot, as a force of the figure."""
    draft, at = figure.draft, figure.point(leg.pivot)
    line = figure.once(
        ("across", leg),
        lambda: draft.draw(
            square, f"({tangent.letter})", at, leg.line, sense=1, why=why.TANGENTIAL_LINE
        ),
    )
    figure.lines[line] = line
    return Force(tangent.letter, leg.link, leg.pivot, line, tangent.value)


def _held(figure: Detached, leg: GuideLeg, turning: Mark) -> Couple:
    """Return the couple by which a guide holds what turns its slider about the pin."""
    letter = f"M_{{{leg.body}{leg.link}}}"
    because = why.GUIDE_HOLDS
    return Couple(
        letter, leg.link, figure.draft.draw(reversed_, letter, turning, unit="N·m", why=because)
    )
