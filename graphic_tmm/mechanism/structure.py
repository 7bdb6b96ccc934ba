"""Structure: mobility, dissection into the driving link and Assur groups, formula of structure.

W = 3n − 2p5 − p4 (Chebyshev). A letter on k links makes k − 1 turning pairs. Groups are found in the order
of attachment: two links joined by one pair, each joined by one pair to what is there already; of groups
that could come next, the one with the smallest numbers comes first, so the order of links changes nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from heapq import heappop, heappush
from itertools import combinations
from typing import NamedTuple

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.groups import Group, Kind, Leg, Pair, class_two
from graphic_tmm.mechanism.records import Link, Mechanism, Slide


class Structure(NamedTuple):
    """The anatomy of a mechanism with one drive."""

    moving: int
    pairs: tuple[Pair, ...]
    pivot: str
    pin: str
    groups: tuple[Group, ...]
    driver: int

    @property
    def mobility(self) -> int:
        """W = 3n − 2p5."""
        return 3 * self.moving - 2 * len(self.pairs)

    @property
    def formula(self) -> str:
        """The formula of structure, groups in order of attachment."""
        groups = (f"II({group.name})" for group in class_two(self.groups, "formula"))
        return " → ".join([f"I({self.driver})", *groups])


def dissect(mechanism: Mechanism) -> Structure:
    """Return the structure of a mechanism.

    Raises
    ------
    StructureError
        If a link is tied to nothing, W is not the number of drives, the driving link does not turn about
        a fixed pivot, or what remains is a group of a class above II; the message names the links.
    """
    pivot = _pivot(mechanism)
    known = [mechanism.frame.number, mechanism.drive.link]
    pairs = _pairs(mechanism)
    _refuse_loose_and_double(mechanism, pairs)
    mobility = 3 * len(mechanism.links) - 2 * len(pairs)
    if mobility != 1:
        n, p, w = len(mechanism.links), len(pairs), f"{mobility}".replace("-", "−")
        remedy = said("a pair is missing") if mobility > 1 else said("a pair is too many")
        raise StructureError(
            said(
                "W = 3·{links} − 2·{p} = {w}, but one drive is given (link {link}): {remedy} among "
                "{listed}",
                links=n,
                p=p,
                w=w,
                link=mechanism.drive.link,
                remedy=remedy,
                listed=", ".join(_describe(pair) for pair in pairs),
            )
        )
    groups: list[Group] = []
    attachment = _Attachment(mechanism, known)
    while attachment.left:
        group = attachment.next()
        if group is None:
            left = sorted(attachment.left)
            names = ", ".join(map(str, left))
            raise StructureError(
                said(
                    "links {names} make a group of class III or higher, or are tied to each other "
                    "only: this board draws groups of class II (two links, three pairs); check the "
                    "letters and slides of these links",
                    names=names,
                ),
                *(f"link {number}" for number in left),
            )
        groups.append(group)
        known += [leg.link for leg in group.legs]
        attachment.attach(group)
    pin = _pin(mechanism, pivot)
    order = {number: place for place, number in enumerate(known)}
    return Structure(
        len(mechanism.links),
        _in_order(pairs, order, mechanism),
        pivot,
        pin,
        tuple(groups),
        known[1],
    )


def _pivot(mechanism: Mechanism) -> str:
    crank = mechanism.by_number.get(mechanism.drive.link)
    if crank is None or crank is mechanism.frame:
        raise StructureError(
            said(
                "the drive names link {link}, which is not a moving link", link=mechanism.drive.link
            ),
            "drive.link",
        )
    shared = [letter for letter in crank.points if letter in mechanism.frame.points]
    if len(shared) != 1 or crank.slides:
        raise StructureError(
            said(
                "the driving link {number} must turn about one letter that it shares with the "
                "frame (it shares {listed})",
                number=crank.number,
                listed=", ".join(shared) or said("none"),
            ),
            f"link {crank.number}",
            "drive.link",
        )
    return shared[0]


def _pin(mechanism: Mechanism, pivot: str) -> str:
    crank = mechanism.by_number[mechanism.drive.link]
    others = [letter for letter in crank.points if letter != pivot]
    pinned = [
        letter
        for letter in others
        if any(letter in link.points for link in mechanism.links if link is not crank)
    ]
    if not (pinned or others):
        raise StructureError(
            said(
                "the driving link {number} has no second letter: give it the crank pin, e.g. A",
                number=crank.number,
            ),
            f"link {crank.number}, points",
        )
    return (pinned or others)[0]


def _pairs(mechanism: Mechanism) -> tuple[Pair, ...]:
    links = (*sorted(mechanism.links, key=lambda link: link.number), mechanism.frame)
    letters: dict[str, list[int]] = {}
    for link in links:
        for letter in link.points:
            letters.setdefault(letter, []).append(link.number)
    turning = [
        Pair("R", letter, (on[0], other)) for letter, on in letters.items() for other in on[1:]
    ]
    sliding = [
        Pair("P", slide.guide.name, (link.number, slide.on), slide)
        for link in links
        for slide in link.slides
    ]
    return (*turning, *sliding)


def _in_order(
    pairs: tuple[Pair, ...], order: dict[int, int], mechanism: Mechanism
) -> tuple[Pair, ...]:
    """Return the pairs as they come into being: at a letter of many links each joins the earliest."""
    letters: dict[str, list[int]] = {}
    for link in mechanism.by_number.values():
        for letter in link.points:
            letters.setdefault(letter, []).append(link.number)
    made = []
    for letter, on in letters.items():
        first, *rest = sorted(on, key=order.__getitem__)
        made += [Pair("R", letter, (min(first, k), max(first, k))) for k in rest]
    made += [pair for pair in pairs if pair.kind == "P"]

    def attached(pair: Pair) -> tuple[bool, list[int]]:
        return pair.kind == "P", sorted(map(order.__getitem__, pair.links), reverse=True)

    return tuple(sorted(made, key=attached))


def _refuse_loose_and_double(mechanism: Mechanism, pairs: tuple[Pair, ...]) -> None:
    tied = {number for pair in pairs for number in pair.links}
    loose = [link.number for link in mechanism.links if link.number not in tied]
    if loose:
        raise StructureError(
            said(
                "link {listed} is tied to nothing: give it a letter of another link, or a slide",
                listed=", ".join(map(str, loose)),
            ),
            *(f"link {number}" for number in loose),
        )
    for slide_owner in (p for p in pairs if p.slide is not None and p.links[0] == p.links[1]):
        raise StructureError(
            said("link {links} slides on itself", links=slide_owner.links[0]),
            f"link {slide_owner.links[0]}, slides",
        )
    for first, second in _neighbours(mechanism, pairs):
        shared = _shared(mechanism.by_number[first], mechanism.by_number[second])
        if len(shared) > 1:
            raise StructureError(
                said(
                    "links {first} and {second} share {listed}: they cannot move against each "
                    "other; make them one link",
                    first=first,
                    second=second,
                    listed=joined(said(" and "), shared),
                ),
                f"link {first}, points",
                f"link {second}, points",
            )


def _neighbours(mechanism: Mechanism, pairs: tuple[Pair, ...]) -> list[tuple[int, int]]:
    """Return links that share something, two by two, as they stand in the scene."""
    place = {number: k for k, number in enumerate(mechanism.by_number)}
    letters: dict[str, list[int]] = {}
    for number, link in mechanism.by_number.items():
        for letter in link.points:
            letters.setdefault(letter, []).append(number)
    found = {two for on in letters.values() for two in combinations(on, 2)}
    for pair in pairs:
        if pair.kind == "P" and pair.links[1] in place:
            first, second = sorted(pair.links, key=place.__getitem__)
            found.add((first, second))
    return sorted(found, key=lambda two: (place[two[0]], place[two[1]]))


def _shared(first: Link, second: Link) -> list[str]:
    slides = [
        slide.guide.name
        for link, other in ((first, second), (second, first))
        for slide in link.slides
        if slide.on == other.number
    ]
    return [letter for letter in first.points if letter in second.points] + slides


class _Attachment:
    """What is there of a mechanism while it grows group by group, and how the links left hold on to it.

    Each link is looked at when something that it is joined to comes: the work grows with the number of pairs.
    """

    def __init__(self, mechanism: Mechanism, known: Sequence[int]) -> None:
        self.bodies = mechanism.by_number
        self.left = {link.number for link in mechanism.links} - {mechanism.drive.link}
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

    def attach(self, group: Group) -> None:
        """Put a group to what is there."""
        for leg in group.legs:
            self.left.discard(leg.link)
        met = [number for leg in group.legs for number in self._enter(leg.link)]
        self._look(met)

    def next(self) -> Group | None:
        """Return the group with the smallest numbers of those that can come; None if none can."""
        while self.waiting:
            first, second = heappop(self.waiting)
            if not (self._ready(first) and self._ready(second)):
                continue
            inner = self._inner(first, second)
            if len(inner) == 1:
                legs = self.outer[first][0], self.outer[second][0]
                return _group(*legs, inner[0], first, second)
        return None

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


def _describe(pair: Pair) -> str:
    return f"{pair.name}({pair.links[0]},{pair.links[1]})"
