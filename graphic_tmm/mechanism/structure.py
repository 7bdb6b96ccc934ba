"""Structure: mobility, dissection into the driving link and Assur groups, formula of structure.

W = 3n − 2p5 − p4 (Chebyshev). A letter on k links makes k − 1 turning pairs. Groups are found in the order
of attachment: two links joined by one pair, each joined by one pair to what is there already; of groups
that could come next, the one with the smallest numbers comes first, so the order of links changes nothing.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.records import Link, Mechanism, Slide


class Pair(NamedTuple):
    """A kinematic pair of class 5: turning ("R", by its letter) or sliding ("P", by its guide's name).

    For a sliding pair ``links`` is (slider, owner of the guide).
    """

    kind: str
    name: str
    links: tuple[int, int]
    slide: Slide | None = None

    def other(self, link: int) -> int:
        """Return the other link of the pair."""
        return self.links[1] if self.links[0] == link else self.links[0]


class Leg(NamedTuple):
    """How a group holds on to what is there: its link, the body it is joined to, and the pair."""

    link: int
    body: int
    pair: Pair


class Group(NamedTuple):
    """An Assur group of class II: kind 1–5, its two legs, its inner pair.

    The first leg of kinds 2 and 5 is the turning one; of kind 3 it is that of the slider (the stone).
    """

    kind: int
    legs: tuple[Leg, Leg]
    inner: Pair

    @property
    def links(self) -> tuple[int, int]:
        """The two links, smaller number first."""
        first, second = sorted(leg.link for leg in self.legs)
        return first, second

    @property
    def name(self) -> str:
        """The group as it stands in the formula of structure: "2-3"."""
        return "{}-{}".format(*self.links)


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
        return " → ".join([f"I({self.driver})", *(f"II({group.name})" for group in self.groups)])


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
    left = sorted({link.number for link in mechanism.links} - {mechanism.drive.link})
    while left:
        group = _next_group(mechanism, known, left)
        if group is None:
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
        for leg in group.legs:
            known.append(leg.link)
            left.remove(leg.link)
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
    numbers = list(mechanism.by_number)
    for place, first in enumerate(numbers):
        for second in numbers[place + 1 :]:
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


def _shared(first: Link, second: Link) -> list[str]:
    slides = [
        slide.guide.name
        for link, other in ((first, second), (second, first))
        for slide in link.slides
        if slide.on == other.number
    ]
    return [letter for letter in first.points if letter in second.points] + slides


def _joints(mechanism: Mechanism, number: int, among: list[int]) -> list[Pair]:
    """Return the pairs of a link with bodies among the given ones; a letter counts once."""
    link = mechanism.by_number[number]
    found = []
    for letter in link.points:
        other = next(
            (k for k in among if k != number and letter in mechanism.by_number[k].points), None
        )
        if other is not None:
            found.append(Pair("R", letter, (number, other)))
    for k in among:
        body = mechanism.by_number[k]
        found += [Pair("P", s.guide.name, (number, k), s) for s in link.slides if s.on == k]
        found += [Pair("P", s.guide.name, (k, number), s) for s in body.slides if s.on == number]
    return found


def _next_group(mechanism: Mechanism, known: list[int], left: list[int]) -> Group | None:
    outer = {number: _joints(mechanism, number, known) for number in left}
    there = {letter for number in known for letter in mechanism.by_number[number].points}
    for place, first in enumerate(left):
        for second in left[place + 1 :]:
            if len(outer[first]) != 1 or len(outer[second]) != 1:
                continue
            inner = [
                p
                for p in _joints(mechanism, first, [second])
                if p.kind == "P" or p.name not in there
            ]
            if len(inner) == 1:
                return _group(outer[first][0], outer[second][0], inner[0], first, second)
    return None


def _group(one: Pair, two: Pair, inner: Pair, first: int, second: int) -> Group:
    legs = (Leg(first, one.other(first), one), Leg(second, two.other(second), two))
    kinds = (one.kind, two.kind)
    if inner.kind == "R":
        kind = {("R", "R"): 1, ("P", "P"): 4}.get(kinds, 2)
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
