"""What the marks of the plan of positions make: links, mass centres, guides, and what slides on them.

A link is the rigid figure of its own points; a guide belongs to one link, the slider or stone on it to another.
Which is which is told by the mechanism and never by a letter.
"""

from __future__ import annotations

from collections.abc import Iterable

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Figure, Mark
from graphic_tmm.chapters.kinematics.bodies import Body, Closing, GuideLeg, nearest
from graphic_tmm.mechanism.guides import level
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Pair

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
    if centre is not None:
        draft.figure("centre", str(link.number), centre)


def tell_group(
    draft: Draft,
    mechanism: Mechanism,
    bodies: dict[int, Body],
    closing: Closing,
    side: Mark | None,
) -> None:
    """Tell the links of a group, its guides and what slides on them.

    A stone is told by a point of its link and the line it slides along, a guide by the same two; where the line
    may turn round against its link, by the side too; of a cylinder what is in it, by what tells its piston.
    """
    for leg in closing.legs:
        tell_link(draft, mechanism, bodies[leg.link])
    for leg in closing.legs:
        if not isinstance(leg, GuideLeg):
            continue
        pair = _pair(closing, leg)
        slider, owner = pair.links
        at = _stone(bodies, closing, leg, slider)
        filled = pair.slide.cylinder if pair.slide is not None else ""
        moving = "piston" if filled else "stone"
        kind = "slider" if owner == mechanism.frame.number else moving
        draft.figure(kind, str(slider), at, leg.line)
        if filled:
            draft.figure(filled, str(owner), at, leg.line)
        turning = () if side is None or not leg.inner else (side,)
        draft.figure("guide", str(owner), at, leg.line, *turning)


def _pair(closing: Closing, leg: GuideLeg) -> Pair:
    group = closing.group
    return group.inner if leg.inner else next(k.pair for k in group.legs if k.link == leg.link)


def _stone(bodies: dict[int, Body], closing: Closing, leg: GuideLeg, slider: int) -> Mark:
    """Return the point of the sliding link at which its slider or stone is drawn."""
    if slider == leg.link:
        return closing.point if leg.inner else closing.root
    if leg.inner:
        return closing.root
    pair, held, body = _pair(closing, leg), bodies[leg.link], bodies[leg.on]
    letter = next(k for k, mark in held.marks.items() if mark == closing.root)
    return body.marks[nearest(body, pair, level(pair, leg.link, held.own[letter]))]


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
