"""A mechanism as it lies in one position, and back: from places to lengths, own axes, offsets and sides.

As it *lies*, the points, guides and sliding pairs of every link are told in the axes of the frame. A link's own
axes go from its first letter to the next that stands elsewhere; what has one letter lies along the guide that
it slides on, else along its own.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from graphic_tmm.mechanism.groups import Group, Pair, known_groups, laid
from graphic_tmm.mechanism.guides import level, turn
from graphic_tmm.mechanism.records import Arm, Guide, Link, Mechanism, Slide
from graphic_tmm.mechanism.sketch_sides import pin_ends, put_along, put_left, put_near, rod_ends
from graphic_tmm.mechanism.structure import dissect

SAME = 1e-12
"""A smaller share of the mechanism's size is nothing: so near points are one place, so far off a line on it."""
TURN = 360.0


class Pose(NamedTuple):
    """Where a link's own axes are: their origin (m), the direction of the x axis (degrees)."""

    origin: complex = 0j
    angle: float = 0.0

    def lying(self, point: complex) -> complex:
        """Return a point of the link (own axes) as it lies."""
        return self.origin + point * turn(self.angle)

    def own(self, point: complex) -> complex:
        """Return a point that lies somewhere, in the link's own axes."""
        return (point - self.origin) * turn(-self.angle)


class Built(NamedTuple):
    """A mechanism in own axes; ``doubt``: how far each group is from where its assemblies meet, 0 to 1."""

    mechanism: Mechanism
    doubt: Mapping[str, float]


def lying(
    mechanism: Mechanism, places: Mapping[str, complex], there: Collection[int] = ()
) -> Mechanism:
    """Return a mechanism as it lies where its letters have these places, m.

    ``there``: links that are told as they lie already.

    Raises
    ------
    ValueError
        As `poses_of`.
    """
    poses = poses_of(mechanism, places, there)

    def guide(one: Guide, on: int) -> Guide:
        pose = poses[on]
        return replace(one, through=pose.lying(one.through), angle=one.angle + pose.angle)

    def moved(link: Link) -> Link:
        return replace(
            link,
            points={letter: poses[link.number].lying(z) for letter, z in link.points.items()},
            guides=tuple(guide(one, link.number) for one in link.guides),
            slides=tuple(replace(one, guide=guide(one.guide, one.on)) for one in link.slides),
        )

    links, passive = (tuple(map(moved, some)) for some in (mechanism.links, mechanism.passive))
    return replace(mechanism, links=links, passive=passive)


def placed(drawn: Mechanism, places: Mapping[str, complex]) -> Mechanism:
    """Return a mechanism that lies, with letters elsewhere, m; a guide through two letters follows these."""

    def points(link: Link) -> dict[str, complex]:
        return {letter: places.get(letter, z) for letter, z in link.points.items()}

    def slide(one: Slide) -> Slide:
        on = drawn.by_number[one.on]
        if any(guide.name == one.guide.name for guide in on.guides):
            return one
        ends = {a + b: (z, w) for a, z in points(on).items() for b, w in points(on).items()}
        start, end = ends[one.guide.name]
        angle = math.degrees(cmath.phase(end - start))
        return replace(one, guide=replace(one.guide, through=start, angle=angle))

    def moved(link: Link) -> Link:
        return replace(link, points=points(link), slides=tuple(map(slide, link.slides)))

    links, passive = (tuple(map(moved, some)) for some in (drawn.links, drawn.passive))
    return replace(drawn, frame=moved(drawn.frame), links=links, passive=passive)


def poses_of(
    mechanism: Mechanism, places: Mapping[str, complex], there: Collection[int] = ()
) -> dict[int, Pose]:
    """Return where the own axes of every link are, by the places of its letters; of some those of the frame.

    Raises
    ------
    ValueError
        With the links that have neither two letters with places nor a guide of a link that has.
    """
    size = _size(places.values())
    poses = dict.fromkeys((mechanism.frame.number, *there), Pose())
    left = [link for link in mechanism.drawn if link.number not in poses]
    while left:
        ready = {
            link.number: pose
            for link in left
            if (pose := _posed(link, mechanism, places, poses, size))
        }
        ready = ready or next(
            (_rod(link, mechanism, places, left) for link in left if link.slides), {}
        )
        if not ready:
            raise ValueError(", ".join(str(link.number) for link in left))
        poses |= ready
        left = [link for link in left if link.number not in ready]
    return poses


def _posed(
    link: Link,
    mechanism: Mechanism,
    places: Mapping[str, complex],
    poses: Mapping[int, Pose],
    size: float,
) -> Pose | None:
    """Return where a link's own axes are, if its letters, or one of them and a guide, tell."""
    own = [(z, places[letter]) for letter, z in link.points.items() if letter in places]
    for z, at in own[:1]:
        for w, there in own[1:]:
            if abs(w - z) > SAME * size:
                angle = math.degrees(cmath.phase((there - at) / (w - z)))
                return Pose(at - z * turn(angle), angle)
        for angle in _held(link, mechanism, poses):
            return Pose(at - z * turn(angle), angle)
        if len(link.points) == 1 and not (link.guides or link.slides):
            return Pose(at - z)  # a wheel about its pin: however it is turned, it looks the same
    return None


def _held(link: Link, mechanism: Mechanism, poses: Mapping[int, Pose]) -> Iterable[float]:
    """Yield the directions of a link's x axis that sliding pairs with links that have one give, degrees."""
    for slide in link.slides:
        if slide.on in poses:
            yield poses[slide.on].angle + slide.guide.angle + slide.angle
    for other in mechanism.links:
        for slide in other.slides:
            if slide.on == link.number and other.number in poses:
                yield poses[other.number].angle - slide.angle - slide.guide.angle


def _rod(
    rod: Link, mechanism: Mechanism, places: Mapping[str, complex], left: Sequence[Link]
) -> dict[int, Pose]:
    """Return where a rod and its cylinder lie of which each has one letter with a place; none of others."""
    slide = rod.slides[0]
    cylinder = next((link for link in left if link.number == slide.on), None)
    if cylinder is None:
        return {}
    own = [
        next(((z, places[letter]) for letter, z in link.points.items() if letter in places), None)
        for link in (rod, cylinder)
    ]
    if own[0] is None or own[1] is None:
        return {}
    (pin, there), (pivot, at) = own[0], own[1]
    pair = Pair("P", slide.guide.name, (rod.number, slide.on), slide)
    across = level(pair, rod.number, pin) - level(pair, cylinder.number, pivot)
    along = math.sqrt(max(abs(there - at) ** 2 - across**2, 0.0))
    along *= -1.0 if slide.side is not None and slide.side.sign < 0 else 1.0
    way = math.degrees(cmath.phase((there - at) / complex(along, across)))
    angles = {rod.number: way + slide.angle, cylinder.number: way - slide.guide.angle}
    return {
        rod.number: Pose(there - pin * turn(angles[rod.number]), angles[rod.number]),
        cylinder.number: Pose(at - pivot * turn(angles[cylinder.number]), angles[cylinder.number]),
    }


def built(drawn: Mechanism, degrees: float = 0.0, like: Mechanism | None = None) -> Built:
    """Return a mechanism that lies in one position with the lengths, offsets and sides that it has there.

    ``degrees``: of the crank in that position; sides of ``drawn`` count for the flips passed until there alone.
    ``like``: links keep the own axes that they have in it, as far as their letters and guides tell these.

    Raises
    ------
    StructureError
        As `dissect`.
    """
    size = _size(z for link in drawn.by_number.values() for z in link.points.values())
    known = {link.number: link for link in like.drawn} if like is not None else {}
    poses = {
        link.number: _axes(link, size)
        if link.number not in known
        else _axes_like(link, known[link.number], size)
        for link in drawn.drawn
    }
    poses[drawn.frame.number] = Pose()
    bare = {link.number: _own(link, poses, size, known.get(link.number)) for link in drawn.links}
    structure = dissect(replace(drawn, links=tuple(bare.values())))
    doubt: dict[str, float] = {}
    for group in known_groups(structure.groups, "sketch"):
        if group.rods:
            for rod in group.rods:
                pair = next(one.pair for one in structure.driven if one.link == rod)
                put_along(bare, pair, rod_ends(drawn, pair), drawn, degrees)
        if not isinstance(group, Group):
            lies = poses[laid(group, bare)].angle
            put_near(bare, group, drawn, structure.first, (_angle(lies), degrees))
        elif group.kind == 1:
            doubt[group.name] = put_left(bare, group, drawn, degrees)
        elif group.kind < 4:
            pair = group.legs[1].pair if group.kind == 2 else group.inner
            doubt[group.name] = put_along(bare, pair, pin_ends(drawn, group), drawn, degrees)
    passive = tuple(_own(link, poses, size, known.get(link.number)) for link in drawn.passive)
    return Built(replace(drawn, links=tuple(bare.values()), passive=passive), doubt)


def _size(places: Iterable[complex]) -> float:
    """Return how far places lie apart, m."""
    row = list(places)
    return max((abs(z - row[0]) for z in row), default=0.0) or 1.0


def _axes(link: Link, size: float) -> Pose:
    """Return where the own axes of a link that lies somewhere are put."""
    row = list(link.points.values())
    guides = [*(one.guide for one in link.slides), *link.guides]
    origin = row[0] if row else guides[0].through if guides else 0j
    other = next((z for z in row if abs(z - origin) > SAME * size), None)
    if other is not None:
        return Pose(origin, math.degrees(cmath.phase(other - origin)))
    return Pose(origin, guides[0].angle if guides else 0.0)


def _axes_like(link: Link, like: Link, size: float) -> Pose:
    """Return where the own axes of a link that lies somewhere are put, that it lies in them as another does.

    The letter at the origin stays there. What slides keeps its direction to the guide; else the next letter on
    the x axis stays on it, else own guides keep their directions, else another letter does.
    """
    row = [letter for letter in like.points if letter in link.points]
    row.sort(key=lambda letter: abs(like.points[letter]) > SAME * size)
    if not row:
        return _axes(link, size)
    origin, was = link.points[row[0]], like.points[row[0]]
    ways = [
        (z - was, link.points[letter] - origin)
        for letter in row[1:]
        if abs((z := like.points[letter]) - was) > SAME * size
    ]
    known = {(one.on, one.guide.name): one.angle for one in like.slides}
    angles = {one.name: one.angle for one in like.guides}
    directions = [
        *(s.guide.angle + known[at] for s in link.slides if (at := (s.on, s.guide.name)) in known),
        *(_between(*way) for way in ways if abs(way[0].imag) < SAME * size and way[1]),
        *(one.angle - angles[one.name] for one in link.guides if one.name in angles),
        *(_between(*way) for way in ways if way[1]),
        _axes(link, size).angle,
    ]
    return Pose(origin - was * turn(directions[0]), directions[0])


def parted(body: Link, arm: Arm, like: Link | None) -> tuple[Link, float]:
    """Return an arm of a body in own axes as a link in its own, and how far these are turned, degrees.

    ``like``: the arm keeps the own axes that it has in it.
    """
    bare = Link(arm.number, {letter: body.points[letter] for letter in arm.letters})
    size = _size(body.points.values())
    pose = _axes(bare, size) if like is None else _axes_like(bare, like, size)
    return _own(bare, {arm.number: pose}, size), _angle(pose.angle)


def _between(first: complex, second: complex) -> float:
    """Return the angle from one way to another, degrees."""
    return math.degrees(cmath.phase(second / first))


def _own(link: Link, poses: Mapping[int, Pose], size: float, like: Link | None = None) -> Link:
    """Return a link that lies somewhere in its own axes, without sides; its guides by points of another."""
    pose = poses[link.number]

    def clean(length: float) -> float:
        return 0.0 if abs(length) < SAME * size else length

    def point(z: complex, of: Pose) -> complex:
        own = of.own(z)
        return complex(clean(own.real), clean(own.imag))

    def guide(one: Guide, of: Pose) -> Guide:
        return replace(one, through=point(one.through, of), angle=_angle(one.angle - of.angle))

    def line(one: Guide) -> Guide:
        own = guide(one, pose)
        off = ((points.get(own.name, own.through) - own.through) * turn(-own.angle)).imag
        return (
            replace(own, through=points[own.name]) if own.name in points and not clean(off) else own
        )

    points = {one.name: one.through for one in like.guides} if like is not None else {}

    def slide(one: Slide) -> Slide:
        way = turn(one.guide.angle)
        offset = clean(((pose.origin - one.guide.through) * way.conjugate()).imag)
        angle = _angle(pose.angle - one.guide.angle)
        return replace(
            one, guide=guide(one.guide, poses[one.on]), offset=offset, angle=angle, side=None
        )

    return replace(
        link,
        points={letter: point(z, pose) for letter, z in link.points.items()},
        guides=tuple(map(line, link.guides)),
        slides=tuple(map(slide, link.slides)),
        side=None,
    )


def _angle(degrees: float) -> float:
    """Return an angle from −180 to 180°; 0 where it is nothing but rounding."""
    angle = (degrees + TURN / 2) % TURN - TURN / 2
    return 0.0 if abs(angle) < SAME * TURN else angle
