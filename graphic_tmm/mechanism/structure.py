"""Structure: mobility, dissection into what is driven and Assur groups, formula of structure.

W = 3n − 2p5 − p4 (Chebyshev). A letter on k links makes k − 1 turning pairs.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from itertools import combinations
from typing import Any, NamedTuple

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.attachment import Attachment
from graphic_tmm.mechanism.driven import Driven, driven_pairs
from graphic_tmm.mechanism.groups import AssurGroup, Pair, known_groups, numeral
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.wheels import Rolling, bearers, in_order, meshing, rolling

CLASSES = "I", "II", "III", "IV"
"""The classes of groups, the highest last; that of a driving link is the first."""


class Structure(NamedTuple):
    """The anatomy of a mechanism: its pairs, what is driven, groups in the order of attachment.

    ``origin``: the letter of the frame from which a sheet is drawn: the pivot of the crank. ``wheels``: those
    that roll on others, each a group of one link.
    """

    moving: int
    pairs: tuple[Pair, ...]
    driven: tuple[Driven, ...]
    groups: tuple[AssurGroup, ...]
    origin: str
    wheels: tuple[Rolling, ...] = ()

    @property
    def first(self) -> Driven:
        """What is driven first: its coordinate makes the row of positions."""
        return self.driven[0]

    @property
    def mobility(self) -> int:
        """W = 3n − 2p5 − p4."""
        return 3 * self.moving - 2 * len(self.pairs) - len(self.wheels)

    @property
    def attached(self) -> Iterator[AssurGroup | Rolling]:
        """Groups and wheels in the order of attachment."""
        return in_order(
            tuple(known_groups(self.groups, "formula")),
            self.wheels,
            [one.after for one in self.wheels],
        )

    @property
    def rank(self) -> int:
        """The place of its class among the classes: that of its highest group, of a driving link alone 0."""
        return max((CLASSES.index(numeral(one)) for one in self.groups), default=0)

    @property
    def numeral(self) -> str:
        """Its class."""
        return CLASSES[self.rank]

    @property
    def formula(self) -> str:
        """The formula of structure, groups in order of attachment."""
        initial = ", ".join(f"I({one.name})" for one in self.driven)
        groups = (
            f"p4({one.name})" if isinstance(one, Rolling) else one.formula for one in self.attached
        )
        return " → ".join([initial, *groups])


class Count(NamedTuple):
    """How many links move, the pairs between them, and W of both."""

    moving: int
    pairs: tuple[Pair, ...]
    higher: int = 0

    @property
    def mobility(self) -> int:
        """W = 3n − 2p5 − p4."""
        return 3 * self.moving - 2 * len(self.pairs) - self.higher


def freedoms(moving: int, lower: int, higher: int) -> str:
    """Return W as it is added up: 3·4 − 2·5 − 1."""
    return f"3·{moving} − 2·{lower}" + (f" − {higher}" if higher else "")


def count(mechanism: Mechanism) -> Count:
    """Return what a mechanism has of links and pairs, whatever it lacks."""
    return Count(len(mechanism.links), _pairs(mechanism), len(mechanism.meshes))


def dissect(mechanism: Mechanism) -> Structure:
    """Return the structure of a mechanism.

    Raises
    ------
    StructureError
        If a link is tied to nothing, W is not the number of drives, a drive drives no pair, or what remains
        is a group that is not drawn here; the message names its links, and a link that could drive instead.
    """
    try:
        return _dissected(mechanism)
    except _StrangeGroup as strange:
        other = next(iter(driven_otherwise(mechanism)), None)
        if other is None:
            raise StructureError(strange.says, *strange.keys) from None
        raise StructureError(
            said(
                "{refusal}; driven by link {link} the mechanism is of class {numeral}, {formula}: write "
                "[drive] link = {link}",
                refusal=strange.says,
                link=other.first.link,
                numeral=other.numeral,
                formula=other.formula,
            ),
            *strange.keys,
            "drive.link",
        ) from None


def driven_otherwise(mechanism: Mechanism) -> list[Structure]:
    """Return the structures of the lowest class that a mechanism has if another link on the frame drives it."""
    found = []
    for link in sorted(mechanism.links, key=lambda one: one.number):
        drive = replace(mechanism.drive, link=link.number, slides=bool(link.slides))
        if not mechanism.further and drive.link != mechanism.drive.link:
            with suppress(StructureError):
                found.append(_dissected(replace(mechanism, drive=drive)))
    found = [one for one in found if not one.first.telescopes]
    lowest = min((one.rank for one in found), default=0)
    return [one for one in found if one.rank == lowest]


class _StrangeGroup(StructureError):
    """What is left when a mechanism grows is no group that this board draws."""


def _dissected(mechanism: Mechanism) -> Structure:
    driven = driven_pairs(mechanism)
    pairs = _pairs(mechanism)
    _refuse_loose_and_double(mechanism, pairs)
    mobility = count(mechanism).mobility
    if mobility != len(driven):
        raise _unequal(mechanism, pairs, mobility)
    groups: list[AssurGroup] = []
    known = [mechanism.frame.number, *(one.link for one in driven if not one.telescopes)]
    attachment = Attachment(mechanism, known, [one for one in driven if one.telescopes])
    wheels: list[Rolling] = []
    while attachment.left:
        wheel = next(rolling(mechanism, known, attachment.outer, len(groups)), None)
        if wheel is not None and wheel.link in attachment.left:
            wheels.append(wheel)
            known += attachment.stand([wheel.link])
            continue
        try:
            group = attachment.next()
        except StructureError as strange:
            raise _StrangeGroup(strange.says, *strange.keys) from None
        if group is None:
            raise _left_over(mechanism, sorted(attachment.left))
        groups.append(group)
        known += attachment.attach(group)
    order = {number: place for place, number in enumerate(known)}
    return Structure(
        len(mechanism.links),
        _in_order(pairs, order, mechanism),
        driven,
        tuple(groups),
        _origin(mechanism, driven[0]),
        tuple(wheels),
    )


def _left_over(mechanism: Mechanism, left: list[int]) -> _StrangeGroup:
    """Return the refusal of a mechanism whose links are left when no group can come next."""
    names = ", ".join(map(str, left))
    keys = [f"link {number}" for number in left]
    for mesh in mechanism.meshes:
        arms = [number for number in bearers(mechanism.by_number, mesh) if number in left]
        if arms and any(number in left for number in mesh.links):
            return _StrangeGroup(
                said(
                    "links {names} are left: a wheel is drawn where another one in mesh with it and the link "
                    "that joins their centres stand already; drive link {arm}, which joins {first} and "
                    "{second}, or give the train as [planetary]",
                    names=names,
                    arm=arms[0],
                    first=mesh.centres[0],
                    second=mesh.centres[1],
                ),
                *keys,
            )
    return _StrangeGroup(
        said(
            "links {names} make a group of a class above IV or of a higher order, or are tied to each other "
            "only: this board draws groups of class II (two links, three pairs), of class III where three "
            "links hold one plate, and of class IV where two links join two plates; check the letters and "
            "slides of these links",
            names=names,
        ),
        *keys,
    )


def _origin(mechanism: Mechanism, first: Driven) -> str:
    """Return the letter of the frame from which a sheet is drawn."""
    if first.pair.kind == "R":
        return first.pair.name
    if not mechanism.frame.points:
        raise StructureError(
            said(
                "the frame has no point from which the sheet could be drawn: give it one in [frame], O = [0, 0]"
            ),
            "frame",
        )
    return next(iter(mechanism.frame.points))


def _unequal(mechanism: Mechanism, pairs: tuple[Pair, ...], mobility: int) -> StructureError:
    """Return the refusal of a mechanism whose W is not the number of its drives."""
    drives = mechanism.drives
    few = mobility > len(drives)
    many = said("a pair is too many (a link that only doubles others takes passive = true)")
    remedy = said("a pair is missing") if few else many
    number: dict[str, Any] = {
        "sum": freedoms(len(mechanism.links), len(pairs), len(mechanism.meshes)),
        "w": f"{mobility}".replace("-", "−"),
        "listed": ", ".join(_describe(pair) for pair in (*pairs, *meshing(mechanism))),
    }
    if len(drives) == 1:
        return StructureError(
            said(
                "W = {sum} = {w}, but one drive is given (link {link}): {remedy} among {listed}",
                **number,
                link=mechanism.drive.link,
                remedy=remedy,
            )
        )
    return StructureError(
        said(
            "W = {sum} = {w}, but {count} drives are given (links {drives}): {remedy} among "
            "{listed}, or a drive",
            **number,
            count=len(drives),
            drives=", ".join(str(one.link) for one in drives),
            remedy=remedy,
        )
    )


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


def _describe(pair: Pair) -> str:
    return f"{pair.name}({pair.links[0]},{pair.links[1]})"
