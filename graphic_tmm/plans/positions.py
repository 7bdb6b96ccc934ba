"""The plan of positions: the crank, then the groups in the order of attachment, all five kinds.

Each group is closed where two loci meet: arcs (kind 1), an arc and a guide (2), a tangent (3), two guides
(4, 5). What the other plans need of it, the closing point and two legs, is left in `Closing`.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.operations import (
    cross,
    cut,
    directed,
    join,
    lay_off,
    measure,
    meet,
    parallel,
    ray,
    rocker_line,
    strike,
    tangent,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point, Side
from graphic_tmm.mechanism import records
from graphic_tmm.mechanism.guides import direction, level, turn
from graphic_tmm.mechanism.structure import Group, Leg, Pair, Structure
from graphic_tmm.plans.bodies import (
    Body,
    Closing,
    GuideLeg,
    PinLeg,
    draw_guide,
    draw_points,
    incline_by,
    stand,
)
from graphic_tmm.plans.draft import ROUNDING, Draft

VIEW = "positions"


@dataclass(frozen=True)
class Positions:
    """The plan of positions as drawn: bodies by number, groups' closings, the side marks of the groups."""

    bodies: dict[int, Body]
    closings: tuple[Closing, ...]
    sides: dict[str, Mark]
    phi: Mark

    def point(self, letter: str) -> Mark:
        """Return the mark of a letter, on whichever link it stands."""
        return next(body.marks[letter] for body in self.bodies.values() if letter in body.marks)


def draw_frame(draft: Draft, mechanism: records.Mechanism, structure: Structure) -> Body:
    """Open the plan, take μ_l, and draw the fixed pivots from the crank's pivot on."""
    draft.board.open(VIEW)
    draft.mu_l = draft.board.take(Number, "μ_l", "m/mm")
    frame, pivot = mechanism.frame, structure.pivot
    origin = draft.take(Point, pivot, 0j)
    draft.board.lay_out(origin, draft.mu_l)

    def axis() -> Mark:
        return draft.board.draw(ray, "(x)", origin, draft.angle("0°", 0.0))

    body = Body(frame, frame.points[pivot], 0.0, axis)
    stand(body, pivot, origin, frame.points[pivot])
    draw_points(draft, body, pivot)
    draft.board.figure("frame", str(frame.number), *body.marks.values())
    return body


def draw_positions(
    draft: Draft, mechanism: records.Mechanism, structure: Structure, frame: Body, phi: Mark
) -> Positions:
    """Draw the crank at the angle ``phi`` and the groups one after another."""
    draft.board.open(VIEW)
    bodies = {frame.link.number: frame}
    bodies[structure.driver] = _crank(draft, mechanism, structure, frame, phi)
    sides: dict[str, Mark] = {}
    closings = []
    for group in structure.groups:
        draft.board.say(f"II({group.name})")
        sides |= _take_side(draft, mechanism, group)
        closing = _KINDS[group.kind](draft, mechanism, group, bodies, sides.get(group.name))
        closings.append(closing)
        for leg in group.legs:
            body = bodies[leg.link]
            draw_points(draft, body, _anchor(body))
        _tell_figures(draft, bodies, closing, frame.link.number)
    return Positions(bodies, tuple(closings), sides, phi)


def _tell_figures(draft: Draft, bodies: dict[int, Body], closing: Closing, frame: int) -> None:
    """Tell which marks make the bodies of a group: links, sliders, stones."""
    for leg in closing.legs:
        marks = dict.fromkeys(bodies[leg.link].marks.values())
        if isinstance(leg, PinLeg):
            marks[closing.point] = None
        draft.board.figure("link", str(leg.link), *marks)
        if isinstance(leg, GuideLeg):
            on = "slider" if leg.body == frame and not leg.inner else "stone"
            at = closing.point if leg.inner else closing.root
            draft.board.figure(on, str(leg.link), at, leg.line)
    if closing.group.kind == 5:
        stone, yoke = closing.legs
        draft.board.figure("slot", str(yoke.link), closing.root, closing.point, stone.line)


def _anchor(body: Body) -> str:
    return next((k for k, own in body.own.items() if own == body.at), str(body.link.number))


def _crank(
    draft: Draft, mechanism: records.Mechanism, structure: Structure, frame: Body, phi: Mark
) -> Body:
    link, pivot, pin = mechanism.by_number[structure.driver], structure.pivot, structure.pin
    arm = link.points[pin] - link.points[pivot]
    line = draft.board.draw(ray, f"({pivot}{pin})", frame.marks[pivot], phi)
    body = Body(link, link.points[pivot], math.degrees(cmath.phase(arm)), lambda: line)
    stand(body, pivot, frame.marks[pivot], link.points[pivot])
    length = draft.length(f"{pivot}{pin}", abs(arm))
    stand(body, pin, draft.board.draw(lay_off, pin, line, length), link.points[pin])
    draw_points(draft, body, pivot)
    draft.board.figure("link", str(link.number), *body.marks.values())
    return body


def side_record(mechanism: records.Mechanism, group: Group) -> records.Side | None:
    """Return the side a scene gives to a group of kinds 1–3, for legs in the group's order; None if absent."""
    if group.kind == 1:
        given = [mechanism.by_number[leg.link].side for leg in group.legs]
        side = next((s for s in given if s is not None), None)
        if side is not None and side.left_of == (group.legs[1].pair.name, group.legs[0].pair.name):
            return records.Side(-side.sign, side.left_of, side.flips_at)
        return side
    pair = group.legs[1].pair if group.kind == 2 else group.inner
    return pair.slide.side if pair.slide is not None else None


def _take_side(draft: Draft, mechanism: records.Mechanism, group: Group) -> dict[str, Mark]:
    side = side_record(mechanism, group)
    if group.kind > 3 or side is None:
        return {}
    return {group.name: draft.take(Side, f"±{group.name}", float(side.sign))}


def side_values(side: records.Side, degrees: object) -> object:
    """Return the sign at crank angles (degrees): constant, or changed at each of ``flips_at``.

    The scene's sign is the one just behind the angle 0°; in the range from 0° to the next flip.
    """
    if not side.flips_at:
        return float(side.sign)
    angles = np.asarray(degrees, dtype=np.float64) % 360.0
    flips = np.sort(np.asarray(side.flips_at, dtype=np.float64) % 360.0)
    flips = flips[flips > 0.0]
    return side.sign * np.where(np.searchsorted(flips, angles, side="right") % 2 == 0, 1.0, -1.0)


def _pivot(bodies: dict[int, Body], leg: Leg) -> Mark:
    return bodies[leg.body].marks[leg.pair.name]


def _swung(draft: Draft, bodies: dict[int, Body], link: records.Link, leg: Leg, pin: str) -> Mark:
    """Strike the arc of the inner pin about the outer pivot of a leg."""
    outer = leg.pair.name
    length = draft.length(f"{outer}{pin}", abs(link.points[pin] - link.points[outer]))
    return draft.board.draw(
        strike, draft.board.free(f"({outer}; {outer}{pin})"), _pivot(bodies, leg), length
    )


def _pinned(
    draft: Draft, bodies: dict[int, Body], link: records.Link, leg: Leg, pin: str, mark: Mark
) -> Mark:
    """Enter a link that turns about an outer pivot and whose inner pin has been found; return its line."""
    outer, pivot = leg.pair.name, _pivot(bodies, leg)
    line = draft.board.draw(join, f"({outer}{pin})", pivot, mark)
    arm = link.points[pin] - link.points[outer]
    body = Body(link, link.points[outer], math.degrees(cmath.phase(arm)), lambda: line)
    stand(body, outer, pivot, link.points[outer])
    stand(body, pin, mark, link.points[pin])
    bodies[link.number] = body
    return line


def _sliding(
    draft: Draft,
    bodies: dict[int, Body],
    link: records.Link,
    pair: Pair,
    pin: str,
    mark: Mark,
    line: Mark,
    side: Mark | None = None,
) -> None:
    """Enter a link that lies along ``line`` (in the sense ``side``) with a point of it at ``mark``."""
    name = f"({link.number})"

    def axis() -> Mark:
        if side is not None:
            return draft.board.draw(directed, name, mark, line, side)
        return draft.board.draw(parallel, name, mark, line)

    own = link.points.get(pin, 0j)
    body = Body(link, own, direction(pair, link.number), axis)
    stand(body, pin, mark, own)
    bodies[link.number] = body


def _guide_leg(
    draft: Draft,
    mechanism: records.Mechanism,
    bodies: dict[int, Body],
    leg: Leg,
    own: complex,
    name: str,
) -> Mark:
    """Draw the path of a point (own axes of the leg's link) along the guide of its outer sliding pair."""
    return draw_guide(draft, bodies[leg.body], leg.pair, level(leg.pair, leg.link, own), name)


def _rrr(
    draft: Draft,
    mechanism: records.Mechanism,
    group: Group,
    bodies: dict[int, Body],
    side: Mark | None,
) -> Closing:
    assert side is not None
    pin = group.inner.name
    links = [mechanism.by_number[leg.link] for leg in group.legs]
    arcs = [
        _swung(draft, bodies, link, leg, pin) for link, leg in zip(links, group.legs, strict=True)
    ]
    mark = draft.board.draw(cross, pin, *arcs, side)
    legs = []
    for link, leg, arc in zip(links, group.legs, arcs, strict=True):
        line = _pinned(draft, bodies, link, leg, pin, mark)
        radius = draft.board.uses(arc)[1]
        legs.append(PinLeg(link.number, leg.body, leg.pair.name, _pivot(bodies, leg), line, radius))
    return Closing(group, pin, mark, mark, (legs[0], legs[1]))


def _rrp(
    draft: Draft,
    mechanism: records.Mechanism,
    group: Group,
    bodies: dict[int, Body],
    side: Mark | None,
) -> Closing:
    assert side is not None
    pin = group.inner.name
    turning, sliding = group.legs
    rod, slider = mechanism.by_number[turning.link], mechanism.by_number[sliding.link]
    arc = _swung(draft, bodies, rod, turning, pin)
    guide = _guide_leg(draft, mechanism, bodies, sliding, slider.points[pin], sliding.pair.name)
    mark = draft.board.draw(cut, pin, guide, arc, side)
    line = _pinned(draft, bodies, rod, turning, pin, mark)
    _sliding(draft, bodies, slider, sliding.pair, pin, mark, guide)
    pinned = PinLeg(
        rod.number,
        turning.body,
        turning.pair.name,
        _pivot(bodies, turning),
        line,
        draft.board.uses(arc)[1],
    )
    return Closing(
        group, pin, mark, mark, (pinned, GuideLeg(slider.number, sliding.body, guide, False))
    )


def _rpr(
    draft: Draft,
    mechanism: records.Mechanism,
    group: Group,
    bodies: dict[int, Body],
    side: Mark | None,
) -> Closing:
    assert side is not None
    stone_leg, rocker_leg = group.legs
    stone, rocker = mechanism.by_number[stone_leg.link], mechanism.by_number[rocker_leg.link]
    pin, centre = stone_leg.pair.name, rocker_leg.pair.name
    a, c = _pivot(bodies, stone_leg), _pivot(bodies, rocker_leg)
    inner = group.inner
    offset = level(inner, stone.number, stone.points[pin]) - level(
        inner, rocker.number, rocker.points[centre]
    )
    size = max(map(abs, (*stone.points.values(), *rocker.points.values(), offset)))
    name = f"({centre}{pin})"
    straight = abs(offset) <= ROUNDING * size
    if straight:
        guide = line = draft.board.draw(rocker_line, name, c, a)
    else:
        guide = draft.board.draw(
            tangent, f"({pin})", a, c, draft.length(f"h_{{{pin}}}", offset), side
        )
        line = draft.board.draw(join, name, c, a)
    distance = draft.board.draw(measure, f"{centre}{pin}", c, a)
    turned = side if straight else None
    _sliding(draft, bodies, stone, inner, pin, a, guide, turned)
    _sliding(draft, bodies, rocker, inner, centre, c, guide, turned)
    inner_leg = GuideLeg(stone.number, stone_leg.body, guide, True)
    return Closing(
        group,
        pin,
        a,
        guide,
        (inner_leg, PinLeg(rocker.number, rocker_leg.body, centre, c, line, distance)),
    )


def _prp(
    draft: Draft,
    mechanism: records.Mechanism,
    group: Group,
    bodies: dict[int, Body],
    side: Mark | None,
) -> Closing:
    pin = group.inner.name
    links = [mechanism.by_number[leg.link] for leg in group.legs]
    guides = [
        _guide_leg(draft, mechanism, bodies, leg, link.points[pin], leg.pair.name)
        for link, leg in zip(links, group.legs, strict=True)
    ]
    mark = draft.board.draw(meet, pin, *guides)
    for link, leg, guide in zip(links, group.legs, guides, strict=True):
        _sliding(draft, bodies, link, leg.pair, pin, mark, guide)
    first, second = (
        GuideLeg(leg.link, leg.body, guide, False)
        for leg, guide in zip(group.legs, guides, strict=True)
    )
    return Closing(group, pin, mark, mark, (first, second))


def _rpp(
    draft: Draft,
    mechanism: records.Mechanism,
    group: Group,
    bodies: dict[int, Body],
    side: Mark | None,
) -> Closing:
    stone_leg, yoke_leg = group.legs
    stone, yoke = mechanism.by_number[stone_leg.link], mechanism.by_number[yoke_leg.link]
    pin, inner = stone_leg.pair.name, group.inner
    a = _pivot(bodies, stone_leg)
    letter, own = _on_inner_guide(yoke, inner, level(inner, stone.number, stone.points[pin]))
    path = _guide_leg(draft, mechanism, bodies, yoke_leg, own, yoke_leg.pair.name)
    bend = direction(inner, yoke.number) - direction(yoke_leg.pair, yoke.number)
    guide = incline_by(draft, inner.name, a, path, bend)
    mark = draft.board.draw(meet, draft.board.free(letter), path, guide)
    _sliding(draft, bodies, stone, inner, pin, a, guide)
    _sliding(draft, bodies, yoke, yoke_leg.pair, letter, mark, path)
    body = bodies[yoke.number]
    body.at = own
    body.own[letter] = own
    return Closing(
        group,
        pin,
        a,
        mark,
        (
            GuideLeg(stone.number, stone_leg.body, guide, True),
            GuideLeg(yoke.number, yoke_leg.body, path, False),
        ),
    )


def _on_inner_guide(yoke: records.Link, inner: Pair, wanted: float) -> tuple[str, complex]:
    """Return a point of the yoke that the stone's pivot slides over: one of its letters, or a new one."""
    size = max([abs(wanted), *map(abs, yoke.points.values())])
    levels = {k: level(inner, yoke.number, own) for k, own in yoke.points.items()}
    for letter, at in levels.items():
        if abs(at - wanted) <= ROUNDING * size:
            return letter, yoke.points[letter]
    letter, own = next(iter(yoke.points.items()), (str(yoke.number), 0j))
    lifted = own + 1j * turn(direction(inner, yoke.number)) * (
        wanted - level(inner, yoke.number, own)
    )
    return f"{letter}′", lifted


_KINDS = {1: _rrr, 2: _rrp, 3: _rpr, 4: _prp, 5: _rpp}
