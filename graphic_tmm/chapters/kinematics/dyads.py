"""The five kinds of dyads on the plan of positions: each is closed where two loci meet.

Arcs (kind 1), an arc and a guide (2), the line of a rocker or a tangent (3), two guides (4, 5). What the other
plans need of it, the closing point and two legs, is left in `Closing`.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from graphic_tmm.board.draft import ROUNDING, Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    cross,
    cut,
    cylinder_axis,
    directed,
    join,
    measure,
    meet,
    parallel,
    rocker_line,
    strike,
    tangent,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import (
    Body,
    draw_guide,
    incline_by,
    stand,
)
from graphic_tmm.chapters.kinematics.closings import Closing, GuideLeg, PinLeg
from graphic_tmm.mechanism.driven import sliding_pair
from graphic_tmm.mechanism.groups import Group, Leg, Pair, untreated
from graphic_tmm.mechanism.guides import direction, level, turn
from graphic_tmm.mechanism.records import Link


@dataclass(frozen=True)
class Ground:
    """What groups are attached to: the board, the bodies that stand there.

    ``letters``: those of the scene, which no point that the plan needs besides may bear. ``lengths``: how long
    a leg is at the moment whose rod, of this number, is driven out of its cylinder, m; ``rods``: those
    links.
    """

    draft: Draft
    bodies: dict[int, Body]
    letters: frozenset[str]
    lengths: Mapping[int, Mark]
    rods: tuple[Link, ...]

    def pivot(self, leg: Leg) -> Mark:
        """Return the mark of a leg's outer pivot."""
        return self.bodies[leg.body].marks[leg.pair.name]

    def swung(self, link: Link, leg: Leg, pin: str) -> tuple[Mark, Mark]:
        """Strike the arc of the inner pin about the outer pivot; return it and its opening."""
        outer = leg.pair.name
        rod = self.rod(link)
        opening = (
            self.draft.draw(to_board, f"{outer}{pin}", self.lengths[rod.number], self.draft.mu_l)
            if rod is not None
            else self.draft.length(f"{outer}{pin}", abs(link.points[pin] - link.points[outer]))
        )
        name = f"({outer}; {outer}{pin})"
        return self.draft.draw(strike, name, self.pivot(leg), opening, why=why.PIN_ARC), opening

    def rod(self, link: Link) -> Link | None:
        """Return the rod that is driven out of a link of the group, if it is a cylinder."""
        return next((one for one in self.rods if one.slides[0].on == link.number), None)

    def pinned(
        self,
        link: Link,
        leg: Leg,
        pin: str,
        mark: Mark,
        opening: Mark,
        line: Mark | None = None,
    ) -> PinLeg:
        """Enter a link that turns about an outer pivot and whose inner pin stands at ``mark``.

        ``line``: from one to the other, if it is drawn.
        """
        outer, pivot = leg.pair.name, self.pivot(leg)
        rod = self.rod(link)
        if rod is not None:
            return self._telescoped(link, rod, leg, pin, mark, opening)
        line = line or self.draft.draw(join, f"({outer}{pin})", pivot, mark, why=why.LINK_AXIS)
        arm = link.points[pin] - link.points[outer]
        body = Body(link, link.points[outer], math.degrees(cmath.phase(arm)), lambda: line)
        stand(body, outer, pivot, link.points[outer])
        stand(body, pin, mark, link.points[pin])
        self.bodies[link.number] = body
        return PinLeg(link.number, leg.body, outer, pivot, line, opening)

    def _telescoped(
        self, cylinder: Link, rod: Link, leg: Leg, pin: str, mark: Mark, opening: Mark
    ) -> PinLeg:
        """Enter a cylinder and the rod that is driven out of it: each lies along the line of both pins."""
        outer, pivot = leg.pair.name, self.pivot(leg)
        line = self.draft.draw(join, f"({outer}{pin})", pivot, mark, why=why.ROD_AXIS)
        pair = sliding_pair(rod)
        side = rod.slides[0].side
        outwards = (outer in cylinder.points) == (side is None or side.sign > 0)
        for link, letter, at in ((cylinder, outer, pivot), (rod, pin, mark)):
            if letter not in link.points:
                letter, at = (pin, mark) if letter == outer else (outer, pivot)
            way = direction(pair, link.number) + (0.0 if outwards else 180.0)
            axis = self.axis(line, letter, at, drawn=at == pivot)
            body = Body(link, link.points[letter], way, axis)
            stand(body, letter, at, link.points[letter])
            self.bodies[link.number] = body
        return PinLeg(
            cylinder.number, leg.body, outer, pivot, line, opening, rod.number, outer in rod.points
        )

    def axis(self, line: Mark, letter: str, at: Mark, *, drawn: bool) -> Callable[[], Mark]:
        """Return what draws the axis of a rod or its cylinder from one of its pins, if it is not ``drawn``."""
        if drawn:
            return lambda: line
        return lambda: self.draft.draw(parallel, f"({letter})", at, line, sense=1, why=why.ROD_AXIS)

    def path(self, leg: Leg, own: complex, name: str) -> Mark:
        """Draw the path of a point (own axes of the leg's link) along the outer guide."""
        height = level(leg.pair, leg.link, own)
        return draw_guide(self.draft, self.bodies[leg.body], leg.pair, height, name)

    def sliding(
        self,
        link: Link,
        pair: Pair,
        point: tuple[str, complex, Mark],
        line: Mark,
        side: Mark | None = None,
    ) -> None:
        """Enter a link that lies along ``line`` (in the sense ``side``); ``point``: letter, own axes, mark."""
        letter, own, mark = point

        def axis() -> Mark:
            if side is not None:
                return self.draft.draw(
                    directed, f"({link.number})", mark, line, side, why=why.SLIDER_AXIS
                )
            return self.draft.draw(parallel, f"({link.number})", mark, line, why=why.SLIDER_AXIS)

        body = Body(link, own, direction(pair, link.number), axis)
        stand(body, letter, mark, own)
        self.bodies[link.number] = body


@dataclass(frozen=True)
class Site(Ground):
    """Where a group of two links is attached: what it is attached to, the group, its links, its side."""

    group: Group
    links: tuple[Link, Link]
    side: Mark | None


def _rrr(site: Site) -> Closing:
    assert site.side is not None
    group, pin = site.group, site.group.inner.name
    struck = [site.swung(link, leg, pin) for link, leg in zip(site.links, group.legs, strict=True)]
    mark = site.draft.draw(cross, pin, *(arc for arc, _ in struck), site.side, why=why.TWO_ARCS)
    first, second = (
        site.pinned(link, leg, pin, mark, opening)
        for link, leg, (_, opening) in zip(site.links, group.legs, struck, strict=True)
    )
    return Closing(group, pin, mark, mark, (first, second))


def _rrp(site: Site) -> Closing:
    assert site.side is not None
    pin, (turning, sliding) = site.group.inner.name, site.group.legs
    rod, slider = site.links
    arc, opening = site.swung(rod, turning, pin)
    guide = site.path(sliding, slider.points[pin], sliding.pair.name)
    mark = site.draft.draw(cut, pin, guide, arc, site.side, why=why.ARC_AND_GUIDE)
    pinned = site.pinned(rod, turning, pin, mark, opening)
    site.sliding(slider, sliding.pair, (pin, slider.points[pin], mark), guide)
    held = GuideLeg(slider.number, sliding.body, guide, False, sliding.body)
    return Closing(site.group, pin, mark, mark, (pinned, held))


def rocker_offset(group: Group, stone: Link, rocker: Link) -> float:
    """Return how far, in kind 3, the stone's pivot lies to the left of the guide through the rocker's, m.

    Zero if it is nothing but rounding.
    """
    pin, centre = (leg.pair.name for leg in group.legs)
    offset = level(group.inner, stone.number, stone.points[pin]) - level(
        group.inner, rocker.number, rocker.points[centre]
    )
    size = max(map(abs, (*stone.points.values(), *rocker.points.values(), offset)))
    return 0.0 if abs(offset) <= ROUNDING * size else offset


def _rpr(site: Site) -> Closing:
    assert site.side is not None
    draft, (stone_leg, rocker_leg) = site.draft, site.group.legs
    stone, rocker = site.links
    pin, centre, inner = stone_leg.pair.name, rocker_leg.pair.name, site.group.inner
    a, c = site.pivot(stone_leg), site.pivot(rocker_leg)
    offset = rocker_offset(site.group, stone, rocker)
    filled = inner.slide is not None and inner.slide.cylinder
    if offset == 0.0:
        axis = cylinder_axis if filled else rocker_line
        guide = line = draft.draw(axis, f"({centre}{pin})", c, a)
        side: Mark | None = site.side
    else:
        height = site.draft.length(f"h_{{{pin}}}", offset)
        guide = draft.draw(tangent, f"({inner.name})", a, c, height, site.side)
        line, side = draft.draw(join, f"({centre}{pin})", c, a, why=why.LINK_AXIS), None
    because = why.CYLINDER_LENGTH if filled else why.ROCKER_LENGTH
    distance = draft.draw(measure, f"{centre}{pin}", c, a, why=because)
    site.sliding(stone, inner, (pin, stone.points[pin], a), guide, side)
    site.sliding(rocker, inner, (centre, rocker.points[centre], c), guide, side)
    slid = GuideLeg(stone.number, stone_leg.body, guide, True, site.links[1].number)
    turned = PinLeg(rocker.number, rocker_leg.body, centre, c, line, distance)
    return Closing(site.group, pin, a, guide, (slid, turned))


def _prp(site: Site) -> Closing:
    group, pin = site.group, site.group.inner.name
    guides = [
        site.path(leg, link.points[pin], leg.pair.name)
        for link, leg in zip(site.links, group.legs, strict=True)
    ]
    mark = site.draft.draw(meet, pin, *guides, why=why.TWO_GUIDES)
    held = []
    for link, leg, guide in zip(site.links, group.legs, guides, strict=True):
        site.sliding(link, leg.pair, (pin, link.points[pin], mark), guide)
        held.append(GuideLeg(leg.link, leg.body, guide, False, leg.body))
    return Closing(group, pin, mark, mark, (held[0], held[1]))


def _rpp(site: Site) -> Closing:
    stone_leg, yoke_leg = site.group.legs
    stone, yoke = site.links
    pin, inner, a = stone_leg.pair.name, site.group.inner, site.pivot(stone_leg)
    height = level(inner, stone.number, stone.points[pin])
    letter, own = _on_inner_guide(yoke, inner, height, site.letters)
    path = site.path(yoke_leg, own, yoke_leg.pair.name)
    bend = direction(inner, yoke.number) - direction(yoke_leg.pair, yoke.number)
    guide = incline_by(site.draft, inner.name, a, path, bend)
    mark = site.draft.draw(meet, letter, path, guide, free=True, why=why.TWO_GUIDES)
    site.sliding(stone, inner, (pin, stone.points[pin], a), guide)
    site.sliding(yoke, yoke_leg.pair, (letter, own, mark), path)
    slid = GuideLeg(stone.number, stone_leg.body, guide, True, site.links[1].number)
    held = GuideLeg(yoke.number, yoke_leg.body, path, False, yoke_leg.body)
    return Closing(site.group, pin, a, mark, (slid, held))


def _on_inner_guide(
    yoke: Link, inner: Pair, wanted: float, taken: frozenset[str]
) -> tuple[str, complex]:
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
    letter += "′"
    while letter in taken:
        letter += "′"
    return letter, lifted


def close(site: Site) -> Closing:
    """Close a group of any kind."""
    match site.group.kind:
        case 1:
            return _rrr(site)
        case 2:
            return _rrp(site)
        case 3:
            return _rpr(site)
        case 4:
            return _prp(site)
        case 5:
            return _rpp(site)
        case _:
            untreated(site.group.kind, site.group, "positions")
