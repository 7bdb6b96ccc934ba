"""Special points that stand off any sheet: the lines that cross there are nearly parallel, or quite.

Rates in numbers are right as long as the lines are not quite parallel, but nobody draws plans by such a point.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.values import undefined
from graphic_tmm.chapters.kinematics.closings import SpecialClosing, with_plates
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.special_point import drawn_point
from graphic_tmm.chapters.kinematics.task import SPECIAL_POINTS, VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import FORMATS

SHEET = max(math.hypot(paper.width, paper.height) for paper in FORMATS.values())
"""From corner to corner of the largest sheet, mm: what is farther off is not drawn with the mechanism."""
FAR = said(
    "In position {listed} the lines of links {links} are parallel or nearly so: the special point {point}, "
    "where they cross, is off any sheet, and by hand no plan is drawn there; write a larger mu_l, or positions "
    "that are apart from it.",
    "In positions {listed} the lines of links {links} are parallel or nearly so: the special point {point}, "
    "where they cross, is off any sheet, and by hand no plan is drawn there; write a larger mu_l, or positions "
    "that are apart from them.",
)
"""Of legs that slide what is square to their guides is meant."""


def far_points(drawn: Drawn) -> Iterator[tuple[SpecialClosing, list[int]]]:
    """Yield each group whose special point is off any sheet in some positions, with these (indices)."""
    made = KINEMATICS_PLAN.on(drawn)
    if made.velocities is None or drawn.of(VELOCITIES) is None:
        return
    for closing in with_plates(made.positions.closings, SPECIAL_POINTS):
        if not drawn.construction.roles(SPECIAL_POINTS, closing.special):
            continue
        special = drawn_point(drawn.construction, closing)
        pins = [drawn.reading[closing.pin(leg)] for leg in closing.crossing]
        with np.errstate(all="ignore"):
            off = np.min([np.abs(drawn.reading[special.point] - pin)[0] for pin in pins], axis=0)
        laid = ~undefined(pins[0])[0]
        far = np.broadcast_to(laid & ~(off <= SHEET), (len(drawn.names),))
        if found := [k for k in drawn.row(VELOCITIES) if far[k] and k not in drawn.undrawn]:
            yield closing, found


def far_positions(drawn: Drawn, language: str) -> Iterator[str]:
    """Yield, as sentences, in which positions a special point is off any sheet."""
    for closing, found in far_points(drawn):
        listed = ", ".join(drawn.names[k] for k in found)
        yield speaking(language)(FAR, n=len(found), listed=listed, **_named(closing))


def refuse_far(drawn: Drawn, place: int) -> None:
    """Refuse to draw special points in a position in which one is off any sheet.

    Raises
    ------
    StructureError
        If one is; says which, and what to do.
    """
    for closing, found in far_points(drawn):
        if place in found:
            raise StructureError(
                said(
                    "position {at}: the lines of links {links} are parallel or nearly so, and the special "
                    "point {point}, where they cross, is off any sheet; name another position as main, write "
                    "a larger mu_l, or leave this view out",
                    at=drawn.names[place],
                    **_named(closing),
                ),
                "sheet",
                head=SPECIAL_POINTS,
            )


def _named(closing: SpecialClosing) -> dict[str, str]:
    links = (leg.link for leg in closing.crossing)
    return {"links": ", ".join(map(str, links)), "point": closing.special}
