"""How a mechanism grows: groups are found in the order of attachment, from what stands already.

Two links joined by one pair, each joined by one pair to what is there already, make a group; of groups that
could come next, the one with the smallest numbers comes first, so the order of links changes nothing. A rod
that is driven out of its cylinder is one link with it while its group is looked for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from heapq import heappop, heappush
from itertools import chain, combinations

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.groups import (
    AssurGroup,
    Group,
    Kind,
    Leg,
    Pair,
    PlateGroup,
    SquareGroup,
)
from graphic_tmm.mechanism.records import Link, Mechanism, Slide


class Attachment:
    """What is there of a mechanism while it grows group by group, and how the links left hold on to it.

    Each link is looked at when something that it is joined to comes: the work grows with the number of pairs.
    """

    def __init__(
        self, mechanism: Mechanism, known: Sequence[int], telescopes: Sequence[Driven] = ()
    ) -> None:
        self.rods = {one.pair.links[1]: one.link for one in telescopes}
        self.links = mechanism.by_number
        self.bodies = dict(mechanism.by_number)
        for cylinder, rod in self.rods.items():
            self.bodies[cylinder] = _telescoped(self.bodies[cylinder], self.bodies.pop(rod))
        self.left = self.bodies.keys() - set(known)
        self.there: set[str] = set()
        self.outer: dict[int, list[Pair]] = {number: [] for number in self.left}
        self.waiting: list[tuple[int, int]] = []
        self.standing: dict[str, list[int]] = {}
        self.sliders: dict[int, list[tuple[int, Slide]]] = {}
        for number, link in self.bodies.items():
            for letter in link.points:
                self.standing.setdefault(letter, []).append(number)
            for slide in link.slides:
                self.sliders.setdefault(slide.on, []).append((number, slide))
        for number in known:
            self._enter(number)
        self._look(tuple(self.left))

    def attach(self, group: AssurGroup) -> list[int]:
        """Put a group to what is there; return its links, the rod of a cylinder behind it."""
        legs = [number for leg in group.legs for number in (leg.link, *self._rod(leg.link))]
        return self.stand([*legs, *group.rest])

    def stand(self, links: list[int]) -> list[int]:
        """Count links to what is there; return them."""
        self.left -= set(links)
        self.bodies |= {number: self.links[number] for number in links}
        self._look([met for number in links for met in self._enter(number)])
        return links

    def _rod(self, cylinder: int) -> list[int]:
        """Return the rod that runs out of a cylinder."""
        return [self.rods[cylinder]] if cylinder in self.rods else []

    def next(self) -> AssurGroup | None:
        """Return the group with the smallest numbers of those that can come, those of two links before."""
        while self.waiting:
            first, second = heappop(self.waiting)
            if not (self._ready(first) and self._ready(second)):
                continue
            inner = self._inner(first, second)
            if len(inner) == 1:
                legs = self.outer[first][0], self.outer[second][0]
                found = _group(*legs, inner[0], first, second)
                return found._replace(rods=tuple(k for n in (first, second) for k in self._rod(n)))
        return next(chain[AssurGroup](self._plates(), self._squares()), None)

    def _plates(self) -> Iterator[PlateGroup]:
        """Yield the plates that three links hold which are held by what is there."""
        for plate in sorted(number for number in self.left if not self.outer[number]):
            held = [(n, self._inner(n, plate)) for n in sorted(self.left) if self._ready(n)]
            legs = [(number, inner[0]) for number, inner in held if len(inner) == 1]
            if len(legs) == 3:
                yield self._plate(plate, legs)

    def _plate(self, plate: int, found: Sequence[tuple[int, Pair]]) -> PlateGroup:
        kinds = {n: (inner.kind == "P", self.outer[n][0].kind == "P") for n, inner in found}
        sliding = [number for number, one in kinds.items() if all(one)]
        if sliding:
            raise StructureError(
                said(
                    "links {names} and {plate} make a group of class III: this board draws it where each of "
                    "the three has at most one sliding pair; links {listed} do not",
                    names=", ".join(str(number) for number, _ in found),
                    plate=plate,
                    listed=", ".join(map(str, sliding)),
                ),
                *(f"link {number}, slides" for number in sliding),
            )
        first, second, third = sorted(found, key=lambda one: (*kinds[one[0]], one[0]))
        legs = tuple(
            Leg(number, self.outer[number][0].other(number), self.outer[number][0])
            for number, _ in (first, second, third)
        )
        rods = tuple(
            rod for number in sorted((plate, *(n for n, _ in found))) for rod in self._rod(number)
        )
        return PlateGroup(plate, (legs[0], legs[1], legs[2]), (first[1], second[1], third[1]), rods)

    def _squares(self) -> Iterator[SquareGroup]:
        """Yield two links held by what is there that two others join: with these they make a closed square."""
        ready = sorted(filter(self._ready, self.left))
        free = sorted(number for number in self.left if not self.outer[number])
        for one, two in combinations(ready, 2):
            found = [(k, self._inner(k, one), self._inner(k, two)) for k in free]
            joining = [(k, a[0], b[0]) for k, a, b in found if len(a) == 1 and len(b) == 1]
            if len(joining) == 2 and not self._inner(one, two):
                yield self._square(one, two, joining)

    def _square(self, one: int, two: int, joining: Sequence[tuple[int, Pair, Pair]]) -> SquareGroup:
        (first, *pins), (second, *others) = joining
        outer = [self.outer[number][0] for number in (one, two)]
        links = sorted((one, two, first, second))
        strange = [pair for pair in (*outer, *pins, *others) if pair.kind == "P"]
        letters = {pair.name for pair in (*pins, *others)}
        if strange or len(letters) < 4 or any(self._rod(number) for number in links):
            raise StructureError(
                said(
                    "links {names} make a group of class IV: this board draws it where all its six pairs are "
                    "turning ones at letters of their own, and none of its links is a cylinder that is driven",
                    names=", ".join(map(str, links)),
                ),
                *(f"link {number}" for number in links),
            )
        legs = (
            Leg(one, outer[0].other(one), outer[0]),
            Leg(two, outer[1].other(two), outer[1]),
        )
        return SquareGroup(legs, (first, second), ((pins[0], pins[1]), (others[0], others[1])))

    def _ready(self, number: int) -> bool:
        """Whether a link that is left holds on to what is there by one pair."""
        return number in self.left and len(self.outer[number]) == 1

    def _enter(self, number: int) -> list[int]:
        """Count a link to what is there; return the links left that are joined to it."""
        link, met = self.bodies[number], []
        for letter in link.points:
            if letter not in self.there:
                self.there.add(letter)
                others = [k for k in self.standing[letter] if k in self.left]
                for other in others:
                    self.outer[other].append(Pair("R", letter, (other, number)))
                met += others
        for slide in link.slides:
            if slide.on in self.left:
                self.outer[slide.on].append(Pair("P", slide.guide.name, (number, slide.on), slide))
                met.append(slide.on)
        for other, slide in self.sliders.get(number, ()):
            if other in self.left:
                self.outer[other].append(Pair("P", slide.guide.name, (other, number), slide))
                met.append(other)
        return met

    def _look(self, met: Sequence[int]) -> None:
        """Let links wait, two by two, that are joined to each other and each by one pair to what is there."""
        for number in filter(self._ready, dict.fromkeys(met)):
            link = self.bodies[number]
            near = [k for letter in link.points for k in self.standing[letter]]
            near += [slide.on for slide in link.slides]
            near += [k for k, _ in self.sliders.get(number, ())]
            for other in filter(self._ready, set(near) - {number}):
                heappush(self.waiting, (min(number, other), max(number, other)))

    def _inner(self, first: int, second: int) -> list[Pair]:
        """Return the pairs by which two links are joined that are not there yet."""
        one, other = self.bodies[first], self.bodies[second]
        return [
            *(
                Pair("R", letter, (first, second))
                for letter in one.points
                if letter in other.points and letter not in self.there
            ),
            *(Pair("P", s.guide.name, (first, second), s) for s in one.slides if s.on == second),
            *(Pair("P", s.guide.name, (second, first), s) for s in other.slides if s.on == first),
        ]


def _group(one: Pair, two: Pair, inner: Pair, first: int, second: int) -> Group:
    legs = (Leg(first, one.other(first), one), Leg(second, two.other(second), two))
    kinds = (one.kind, two.kind)
    if inner.kind == "R":
        kind: Kind = 1 if kinds == ("R", "R") else 4 if kinds == ("P", "P") else 2
        return Group(kind, legs if kinds != ("P", "R") else (legs[1], legs[0]), inner)
    if kinds == ("P", "P"):
        raise StructureError(
            said(
                "links {first} and {second} are joined by three sliding pairs: they make no Assur "
                "group (a turning pair is needed)",
                first=first,
                second=second,
            ),
            f"link {first}, slides",
            f"link {second}, slides",
        )
    if kinds == ("R", "R"):
        return Group(3, legs if inner.links[0] == first else (legs[1], legs[0]), inner)
    return Group(5, legs if kinds == ("R", "P") else (legs[1], legs[0]), inner)


def _telescoped(cylinder: Link, rod: Link) -> Link:
    """Return a rod and its cylinder as one link."""
    slides = tuple(one for one in cylinder.slides if one.on != rod.number)
    return replace(cylinder, points={**cylinder.points, **rod.points}, slides=slides)
