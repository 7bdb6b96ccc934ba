"""What the log tells of bodies for their ink: points of links, guides, and what slides on them."""

from __future__ import annotations

from collections.abc import Iterable

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.bodies import Body, nearest
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    GuideLeg,
    PinLeg,
    legs_of,
    pair_of,
)
from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.guides import level
from graphic_tmm.mechanism.records import Mechanism

SLIDING = ("slider", "stone", "piston")
"""What slides: on a guide of the frame, on one of a moving link, in a cylinder."""
CONTENTS = ("oil", "gas")
"""What is told of a guide that is a cylinder: what presses on its piston."""


def tell_link(draft: Draft, mechanism: Mechanism, body: Body) -> None:
    """Tell the points of a link, and its mass centre apart from them unless that is a turning pair."""
    link, joined = body.link, mechanism.pins
    own = {letter: body.marks[letter] for letter in link.points}
    centre = None
    if link.centre is not None and link.centre not in joined:
        centre = own.pop(link.centre, None)
    draft.figure("link", str(link.number), *own.values())
    for arm in link.arms:
        draft.figure("arm", str(link.number), *(own[k] for k in arm.letters if k in own))
    if centre is not None:
        draft.figure("centre", str(link.number), centre)


def tell_group(
    draft: Draft,
    mechanism: Mechanism,
    bodies: dict[int, Body],
    closing: AnyClosing,
    side: Mark | None,
) -> None:
    """Tell the links of a group, its guides and what slides on them.

    A stone is told by a point of its link and the line it slides along, a guide by the same two; where the line
    may turn round against its link, by the side too; of a cylinder what is in it, by what tells its piston.
    """
    for _, leg in legs_of([closing], "positions"):
        tell_link(draft, mechanism, bodies[leg.link])
        if isinstance(leg, PinLeg) and leg.rod:
            tell_link(draft, mechanism, bodies[leg.rod])
    for number in closing.group.rest:
        tell_link(draft, mechanism, bodies[number])
    for leg in closing.legs:
        if isinstance(leg, PinLeg):
            if leg.rod:
                _tell_rod(draft, bodies, closing, leg)
            continue
        pair = pair_of(closing, leg)
        at = _stone(bodies, closing, leg, pair.links[0])
        turning = () if side is None or not leg.inner else (side,)
        tell_slide(draft, mechanism, pair, at, leg.line, *turning)


def _tell_rod(draft: Draft, bodies: dict[int, Body], closing: AnyClosing, leg: PinLeg) -> None:
    """Tell a rod that is driven out of its cylinder: by its pin and the line of both."""
    rod = bodies[leg.rod]
    (slide,) = rod.link.slides
    pin = next(mark for mark in (leg.pivot, closing.pin(leg)) if mark in rod.marks.values())
    draft.figure("piston", str(leg.rod), pin, leg.line)
    draft.figure(slide.cylinder or CONTENTS[0], str(leg.link), pin, leg.line)
    draft.figure("guide", str(leg.link), pin, leg.line)


def tell_slide(
    draft: Draft, mechanism: Mechanism, pair: Pair, at: Mark, line: Mark, *turning: Mark
) -> None:
    """Tell what slides, at a point on a line, and its guide, with the side that turns it round."""
    slider, owner = pair.links
    filled = pair.slide.cylinder if pair.slide is not None else ""
    kind = "slider" if owner == mechanism.frame.number else "piston" if filled else "stone"
    draft.figure(kind, str(slider), at, line)
    if filled:
        draft.figure(filled, str(owner), at, line)
    draft.figure("guide", str(owner), at, line, *turning)


def _stone(bodies: dict[int, Body], closing: AnyClosing, leg: GuideLeg, slider: int) -> Mark:
    """Return the point of the sliding link at which its slider or stone is drawn."""
    if slider == leg.link:
        return closing.pin(leg) if leg.inner else closing.slid(leg)
    pair, held, body = pair_of(closing, leg), bodies[leg.link], bodies[leg.on]
    letter = next((k for k, mark in held.marks.items() if mark == closing.slid(leg)), None)
    if letter is None:
        return closing.slid(leg)
    return body.marks[
        nearest(body.link.number, body.own, pair, level(pair, leg.link, held.own[letter]))
    ]


def rigid(figures: Iterable[Figure], name: str) -> tuple[Mark, ...]:
    """Return the marks that make the rigid figure of a link: its points, and where its stones stand."""
    found = [
        mark
        for figure in figures
        if figure.name == name
        for mark in dict.fromkeys(SLIDING, figure.marks[:1]).get(
            figure.kind, figure.marks if figure.kind in ("link", "frame") else ()
        )
    ]
    return tuple(dict.fromkeys(found))
