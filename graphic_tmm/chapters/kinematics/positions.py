"""The plan of positions: what is driven, then the groups in the order of attachment, all five kinds.

What the other plans need of a group, its closing point and two legs, is left in its `Closing`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import ray
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    Positions,
    anchor,
    draw_points,
    stand,
)
from graphic_tmm.chapters.kinematics.closings import AnyClosing
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.chapters.kinematics.dyads import Ground, Site, close
from graphic_tmm.chapters.kinematics.figures import tell_group, tell_link
from graphic_tmm.chapters.kinematics.passive import draw_passive
from graphic_tmm.chapters.kinematics.special_groups import close_special
from graphic_tmm.chapters.kinematics.tracings import Branch, Tracing
from graphic_tmm.chapters.kinematics.wheels import Wheels, Wound
from graphic_tmm.mechanism import records
from graphic_tmm.mechanism.groups import AssurGroup, Group, Pair, untreated
from graphic_tmm.mechanism.structure import Structure
from graphic_tmm.mechanism.wheels import Rolling

VIEW = "positions"
Branches = Callable[[Wheels, Tracing], Branch]
"""Which of its places a plate keeps, from what is drawn before it."""


def draw_frame(draft: Draft, mechanism: records.Mechanism, structure: Structure) -> Body:
    """Open the plan, take μ_l, and draw the fixed pivots from the crank's pivot on, or the frame's first."""
    draft.open(VIEW)
    draft.mu_l = draft.scale("μ_l", "m/mm")
    frame, pivot = mechanism.frame, structure.origin
    origin = draft.take(Point, pivot, 0j)
    draft.lay_out(origin)

    name = _axis_name(mechanism, pivot)

    def axis() -> Mark:
        return draft.draw(ray, name, origin, draft.direction(0.0), why=why.FRAME_AXIS)

    body = Body(frame, frame.points[pivot], 0.0, axis)
    stand(body, pivot, origin, frame.points[pivot])
    draw_points(draft, body, pivot)
    draft.figure("frame", str(frame.number), *body.marks.values())
    return body


def _axis_name(mechanism: records.Mechanism, pivot: str) -> str:
    """Return what the x axis of the plan is called: not as a guide that does not lie on it."""
    start = mechanism.frame.points[pivot]
    slides = (slide for link in mechanism.drawn for slide in link.slides)
    others = (slide.guide for slide in slides if slide.guide.name == "x")
    apart = any(one.angle % 360.0 or one.through.imag != start.imag for one in others)
    return f"({pivot}x)" if apart else "(x)"


def draw_positions(
    draft: Draft,
    mechanism: records.Mechanism,
    structure: Structure,
    frame: Body,
    row: Sequence[Mark],
    wound: Wound | None = None,
    branches: Branches | None = None,
) -> Positions:
    """Draw what is driven and the groups one after another; ``row``: where each drive stands.

    ``wound``: how angles go on that wheels roll by; ``branches``: which of its places each plate keeps.
    """
    draft.open(VIEW)
    bodies = {frame.link.number: frame}
    wheels = Wheels(draft, mechanism, bodies, wound)
    lengths = dict[int, Mark]()
    for pair, at in zip(driven(mechanism, structure), row, strict=True):
        pair.stand(draft, bodies, at)
        wheels.drive(pair, at)
        if pair.driven.telescopes:
            lengths[pair.link] = at
        else:
            tell_link(draft, mechanism, bodies[pair.link])
    links = (frame.link, *mechanism.drawn)
    letters = frozenset(letter for link in links for letter in link.points)
    sides, closings = wheels.sides, wheels.closings
    for group in structure.attached:
        if isinstance(group, Rolling):
            draft.say(group.note)
            wheels.stand(group)
            tell_link(draft, mechanism, bodies[group.link])
            continue
        draft.say(group.formula)
        rods = tuple(mechanism.by_number[rod] for rod in group.rods)
        side: Mark | None = None
        closing: AnyClosing
        if not isinstance(group, Group):
            ground = Ground(draft, bodies, letters, lengths, rods)
            assert branches is not None
            follow = partial(branches, wheels)
            closing = close_special(ground, group, mechanism.by_number, follow)
        else:
            sides |= _take_side(draft, mechanism, group)
            first, second = (mechanism.by_number[leg.link] for leg in group.legs)
            side = sides.get(group.name)
            links = first, second
            closing = close(Site(draft, bodies, letters, lengths, rods, group, links, side))
        closings.append(closing)
        for number in (*(leg.link for leg in group.legs), *group.rods, *group.rest):
            body = bodies[number]
            draw_points(draft, body, anchor(body))
        tell_group(draft, mechanism, bodies, closing, side)
    passive = draw_passive(draft, mechanism, bodies)
    drawn = tuple(wheels.drawn)
    return Positions(bodies, tuple(closings), sides, tuple(row), passive, drawn)


def side_record(mechanism: records.Mechanism, group: AssurGroup) -> records.Side | None:
    """Return the side a scene gives to a group of kinds 1–3, for legs in the group's order; None if absent."""
    if not isinstance(group, Group):
        return None
    pair = _sliding(group)
    if group.kind == 1:
        given = [mechanism.by_number[leg.link].side for leg in group.legs]
        side = next((s for s in given if s is not None), None)
        if side is not None and side.left_of == (group.legs[1].pair.name, group.legs[0].pair.name):
            return records.Side(-side.sign, side.left_of, side.flips_at)
        return side
    return pair.slide.side if pair is not None and pair.slide is not None else None


def _sliding(group: Group) -> Pair | None:
    """Return the sliding pair that has the side of a group; None where it has none, or its link has it."""
    match group.kind:
        case 1 | 4 | 5:
            return None
        case 2:
            return group.legs[1].pair
        case 3:
            return group.inner
        case _:
            untreated(group.kind, group, VIEW)


def _take_side(draft: Draft, mechanism: records.Mechanism, group: Group) -> dict[str, Mark]:
    side = side_record(mechanism, group)
    if side is None:
        return {}
    return {group.name: draft.take(Side, f"±{group.name}", float(side.sign))}
