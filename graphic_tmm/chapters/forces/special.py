"""Assur's special point in a detached group: what holds two links along their lines has no moment about it.

Of a plate on three legs moments of the whole group about it give what holds the third leg. Of two plates that
two links join, the lines of these cross there: each plate is held like a link whose inner pin it is.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import join, meet, square
from graphic_tmm.board.operations.statics import reversed_
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.loads import Acting, Couple, Force
from graphic_tmm.chapters.forces.operations import along_third
from graphic_tmm.chapters.forces.unknowns import (
    Hinged,
    Slope,
    Slopes,
    Tangent,
    guide_pair,
    links_of,
    unknown_line,
)
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    ClosingLeg,
    GuideLeg,
    PinLeg,
    PlateClosing,
    SpecialClosing,
    SquareClosing,
)


class Third(NamedTuple):
    """What moments about the special point give of the third leg of a plate, and the line of that leg.

    ``total``: the sum of moments (N·m).
    """

    line: Mark
    total: Mark
    given: Tangent


class Special(NamedTuple):
    """Assur's special point in the figure of a group, the legs whose lines cross there, all lines through it.

    ``forces``, ``couples``: what is known when moments about it are taken, beside the loads; ``third``: of a
    plate on three legs, what these give of the third.
    """

    point: Mark
    crossing: tuple[ClosingLeg, ClosingLeg]
    lines: tuple[Mark, ...]
    forces: tuple[Force, ...]
    couples: tuple[Couple, ...] = ()
    third: Third | None = None


def solve_special(
    figure: Detached,
    closing: AnyClosing,
    acting: Acting,
    slopes: Slopes,
    turning: Mapping[int, Mark | None],
    tangents: Mapping[int, Tangent],
) -> tuple[Special | None, tuple[Hinged, ...]]:
    """Find what the special point of a group gives; of two plates, these as hinged there."""
    match closing:
        case PlateClosing():
            return solve_third(figure, closing, acting, slopes, turning, tangents), ()
        case SquareClosing():
            return hinge_plates(figure, closing, slopes, tangents)
        case _:
            return None, ()


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
    because = why.SPECIAL_POINT_OF_FORCES
    point, lines = _crossing(figure, closing, slopes, tangents, because)
    forces = tuple(
        _across(figure, leg, tangents[leg.link])
        for leg in closing.legs
        if isinstance(leg, PinLeg) and leg.link in tangents
    )
    couples = tuple(
        _held(figure, closing.plate, leg, couple)
        for leg in closing.legs
        if isinstance(leg, GuideLeg) and (couple := turning[leg.link]) is not None
    )
    stones = [leg.link for leg in closing.legs if leg.inner]
    links = [k for k in (*closing.group.links, *closing.group.rods) if k not in stones]
    known = [force for link in links for force in acting.forces.get(link, [])]
    turned = [couple for link in links for couple in acting.couples.get(link, [])]
    letter = f"ΣM_{{{point.letter}}}"
    total = figure.sum(point, [*known, *forces], [*turned, *couples], letter)
    if total is None:
        total = draft.take(Number, letter, 0.0, "N·m")
    called, line = _letter(closing), _line(figure, closing, closing.third, slopes, tangents)
    height = figure.arm(called, point, line)
    value = draft.draw(along_third, called, total, height, figure.mu, unit="N")
    third = Third(line, total, Tangent(called, value, height))
    return Special(point, closing.crossing, lines, forces, couples, third)


def hinge_plates(
    figure: Detached, closing: SquareClosing, slopes: Slopes, tangents: Mapping[int, Tangent]
) -> tuple[Special, tuple[Hinged, Hinged]]:
    """Find where the lines of the links cross that join two plates; return these as hinged there.

    What holds the links across is known, by link: the first plate bears it, the second one with the links.
    """
    draft, (first, _) = figure.draft, closing.legs
    point, lines = _crossing(figure, closing, slopes, tangents, why.POINT_OF_PLATES)
    across = [
        _across(figure, one, tangents[one.link]) for one in closing.joining if one.link in tangents
    ]
    for force in across:
        figure.arm(force.letter, point, force.line)
    back = [_reversed(figure, first.link, force) for force in across]

    def arm(leg: PinLeg) -> Mark:
        ends = figure.point(leg.pivot), point
        return figure.once(
            ("arm", leg, point),
            lambda: draft.draw(
                join, f"({leg.letter}{point.letter})", *ends, why=why.TO_SPECIAL_POINT
            ),
        )

    arms = [arm(leg) for leg in closing.legs]
    one, other = (
        leg._replace(line=line, length=figure.length(leg.pivot, point))
        for leg, line in zip(closing.legs, arms, strict=True)
    )
    rest = tuple(sorted({*closing.group.links} - {first.link}))
    special = Special(point, closing.crossing, (*lines, *arms), (*across, *back))
    return special, (
        Hinged(one, point, (first.link,), tuple(back)),
        Hinged(other, point, rest, tuple(across)),
    )


def _crossing(
    figure: Detached,
    closing: SpecialClosing,
    slopes: Slopes,
    tangents: Mapping[int, Tangent],
    because: str,
) -> tuple[Mark, tuple[Mark, Mark]]:
    """Return the special point in a figure, and the lines that cross there."""
    first, second = (_line(figure, closing, leg, slopes, tangents) for leg in closing.crossing)
    point = figure.once(
        ("special", first, second),
        lambda: figure.draft.draw(meet, closing.special, first, second, free=True, why=because),
    )
    return figure.own(point), (first, second)


def _line(
    figure: Detached,
    closing: SpecialClosing,
    leg: ClosingLeg,
    slopes: Slopes,
    tangents: Mapping[int, Tangent],
) -> Mark:
    """Return the line of what holds a leg where that is known in direction only."""
    through, slope = figure.point(closing.at(leg)), _slope(leg, slopes)
    return figure.once(
        (leg, slope, leg.link in tangents),
        lambda: unknown_line(figure.draft, leg, through, slopes, tangents),
    )


def _letter(closing: PlateClosing) -> str:
    """Return the letter of what holds the third leg along its line: it is signed, the whole reaction is not.

    Of a leg that slides along the plate it is what that does to the plate.
    """
    leg = closing.third
    if leg.inner:
        return f"R_{{{leg.link}{closing.plate}}}^{{W}}"
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


def _reversed(figure: Detached, plate: int, force: Force) -> Force:
    """Return what a link does to the plate that holds it across."""
    letter = f"R_{{{force.link}{plate}}}^{{t}}"
    value = figure.draft.draw(reversed_, letter, force.value, unit="N", why=why.ON_THE_PLATE)
    return force._replace(letter=letter, link=plate, value=value)


def _held(figure: Detached, plate: int, leg: GuideLeg, turning: Mark) -> Couple:
    """Return the couple by which a guide holds what turns its slider about the pin.

    Of a leg that slides along the plate it is the plate that bears it.
    """
    draft, because = figure.draft, why.GUIDE_HOLDS
    holder = plate if leg.inner else leg.body
    letter = f"M_{{{holder}{leg.link}}}"
    couple = draft.draw(reversed_, letter, turning, unit="N·m", why=because)
    if not leg.inner:
        return Couple(letter, leg.link, couple)
    letter, because = f"M_{{{leg.link}{plate}}}", why.COUPLE_ON_THE_PLATE
    return Couple(letter, plate, draft.draw(reversed_, letter, couple, unit="N·m", why=because))
