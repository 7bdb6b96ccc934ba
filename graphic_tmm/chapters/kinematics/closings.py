"""What groups leave for the other plans: where each was closed, and its legs; the walks over all of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple, Never, NoReturn

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.kinematics.tracings import Branch
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.groups import (
    Group,
    Pair,
    PlateGroup,
    SquareGroup,
    class_two,
    known_groups,
)


class Closing(NamedTuple):
    """What a group leaves for the other plans: the closing point Q (with its letter) and its two legs.

    ``root`` is the mark in which the group was closed: where two loci met, or the line of a rocker.
    """

    group: Group
    letter: str
    point: Mark
    root: Mark
    legs: tuple[PinLeg | GuideLeg, PinLeg | GuideLeg]

    @property
    def image_letter(self) -> str:
        """The letter of Q's image: "b", or "a3" where Q is the point of link 3 over the pivot A."""
        small = self.letter.lower()
        return f"{small}{self.legs[1].link}" if self.group.kind in (3, 5) else small

    def placed(self, coordinates: Reals) -> dict[Mark, object]:
        """Return what is given of its place at coordinates of the drive: its side is told apart."""
        return {}

    @property
    def arms(self) -> tuple[ClosingLeg, ...]:
        """The links that are drawn from a pivot to a pin: its legs."""
        return self.legs

    def at(self, leg: ClosingLeg) -> Mark:
        """Return where what a leg holds acts: at its pivot, or at the closing point."""
        return _at(leg, self.point)

    def pin(self, leg: ClosingLeg) -> Mark:
        """Return the inner end of a leg: the closing point."""
        return self.point

    def slid(self, leg: ClosingLeg) -> Mark:
        """Return the point of a sliding leg's link that keeps to the guide as drawn."""
        return self.root

    def pin_letter(self, leg: ClosingLeg) -> str:
        """Return the letter of the inner end of a leg."""
        return self.letter

    def image_of(self, leg: ClosingLeg) -> str:
        """Return the letter of the image of the inner end of a leg."""
        return self.image_letter


class PlateClosing(NamedTuple):
    """What a group of class III leaves for the other plans: its three legs, the pins of the plate on them.

    Of a leg that slides along the plate its pivot is in the place of a pin: there the plate's point over it is
    meant. ``root``: the line of the plate as pricked, ``line``: its letters. ``near``: what is given of its
    place, the angles of the first leg and of the plate; ``branch``: what these are at coordinates of the drive.
    """

    group: PlateGroup
    root: Mark
    legs: tuple[ClosingLeg, ClosingLeg, ClosingLeg]
    pins: tuple[str, str, str]
    points: tuple[Mark, Mark, Mark]
    line: str
    near: tuple[Mark, Mark]
    branch: Branch

    def placed(self, coordinates: Reals) -> dict[Mark, object]:
        """Return what is given of its place at coordinates of the drive."""
        return dict(zip(self.near, self.branch.near(coordinates), strict=True))

    @property
    def plate(self) -> int:
        """The plate of which the scene tells where it lies."""
        return self.group.plate

    @property
    def special(self) -> str:
        """The letter of Assur's special point."""
        return f"W{self.plate}"

    @property
    def crossing(self) -> tuple[ClosingLeg, ClosingLeg]:
        """The legs in whose crossing Assur's special point is taken."""
        first, second = self.branch.crossing
        return self.legs[first], self.legs[second]

    @property
    def third(self) -> ClosingLeg:
        """The leg that does not cross there."""
        return next(leg for k, leg in enumerate(self.legs) if k not in self.branch.crossing)

    @property
    def letter(self) -> str:
        """The letter of the plate's pin on its third leg, by which its plans are closed."""
        return self.pin_letter(self.third)

    @property
    def point(self) -> Mark:
        """The plate's pin on its third leg."""
        return self.pin(self.third)

    @property
    def arms(self) -> tuple[ClosingLeg, ...]:
        """The links that are drawn from a pivot to a pin: its legs."""
        return self.legs

    def at(self, leg: ClosingLeg) -> Mark:
        """Return where what a leg holds acts: at its pivot, or at its pin."""
        return _at(leg, self.pin(leg))

    def pin(self, leg: ClosingLeg) -> Mark:
        """Return the plate's pin on a leg."""
        return self.points[self.legs.index(leg)]

    def slid(self, leg: ClosingLeg) -> Mark:
        """Return the point of a sliding leg's link that keeps to the guide as drawn: its pin."""
        return self.pin(leg)

    def pin_letter(self, leg: ClosingLeg) -> str:
        """Return the letter of the plate's pin on a leg."""
        return self.pins[self.legs.index(leg)]

    def borne(self, leg: ClosingLeg) -> int:
        """Return the link on which the inner end of a leg is: the plate."""
        return self.plate

    def image_of(self, leg: ClosingLeg) -> str:
        """Return the letter of the image of the plate's pin on a leg: "b"; "o3" of its point over a pivot O."""
        small = self.pin_letter(leg).lower()
        return f"{small}{self.plate}" if leg.inner else small


class SquareClosing(NamedTuple):
    """What a group of class IV leaves for the other plans: both plates as legs, and the links that join them.

    A leg of a plate goes from its pivot to its pin on the first of the links; these go from the first plate's
    pins to the second's. ``pins``, ``points``: the inner ends of the legs, then of the links. ``root``: the
    line of the first link as pricked; ``plate``: of which the scene tells where it lies; ``near``: what is
    given of the place.
    """

    group: SquareGroup
    plate: int
    root: Mark
    legs: tuple[PinLeg, PinLeg]
    joining: tuple[PinLeg, PinLeg]
    pins: tuple[str, str, str, str]
    points: tuple[Mark, Mark, Mark, Mark]
    near: tuple[Mark, Mark]
    branch: Branch

    def placed(self, coordinates: Reals) -> dict[Mark, object]:
        """Return what is given of its place at coordinates of the drive."""
        return dict(zip(self.near, self.branch.near(coordinates), strict=True))

    @property
    def special(self) -> str:
        """The letter of Assur's special point."""
        return "W{}{}".format(*self.group.plates)

    @property
    def line(self) -> str:
        """The letters of the line of the plate whose place is told."""
        leg = next(one for one in self.legs if one.link == self.plate)
        return leg.letter + self.pin_letter(leg)

    @property
    def crossing(self) -> tuple[PinLeg, PinLeg]:
        """The links in whose crossing Assur's special point is taken."""
        return self.joining

    @property
    def letter(self) -> str:
        """The letter of the second plate's pin on the first link, by which its plans are closed."""
        return self.pins[1]

    @property
    def point(self) -> Mark:
        """The second plate's pin on the first link."""
        return self.points[1]

    @property
    def arms(self) -> tuple[PinLeg, ...]:
        """The links that are drawn from a pivot to a pin: those that join the plates."""
        return self.joining

    def at(self, leg: ClosingLeg) -> Mark:
        """Return where what a leg holds acts: at its pivot."""
        return _at(leg, self.pin(leg))

    def pin(self, leg: ClosingLeg) -> Mark:
        """Return the inner end of a leg, or of a link that joins the plates."""
        return self.points[self._place(leg)]

    def slid(self, leg: ClosingLeg) -> Mark:
        """Return the point of a sliding leg's link that keeps to the guide as drawn: none slides."""
        return self.pin(leg)

    def pin_letter(self, leg: ClosingLeg) -> str:
        """Return the letter of the inner end of a leg, or of a link that joins the plates."""
        return self.pins[self._place(leg)]

    def borne(self, leg: ClosingLeg) -> int:
        """Return the plate on which the inner end is of a leg, or of a link that joins the plates."""
        plates = self.group.plates
        return leg.link if leg.link in plates else plates[1]

    def image_of(self, leg: ClosingLeg) -> str:
        """Return the letter of the image of the inner end of a leg, or of a link that joins the plates."""
        return self.pin_letter(leg).lower()

    def _place(self, leg: ClosingLeg) -> int:
        return [one.link for one in (*self.legs, *self.joining)].index(leg.link)


def _at(leg: ClosingLeg, pin: Mark) -> Mark:
    match leg:
        case PinLeg():
            return leg.pivot
        case GuideLeg():
            return pin
        case _:
            unheld(leg, "forces")


class PinLeg(NamedTuple):
    """T: link ``link`` turns on ``body`` about ``pivot``; the line and the length from there to Q.

    ``rod``: the rod that is driven out of that link, a cylinder, and makes it longer; 0 where it is rigid;
    ``turned``: whether the rod is what turns about the pivot, and the cylinder ends at Q.
    """

    link: int
    body: int
    letter: str
    pivot: Mark
    line: Mark
    length: Mark
    rod: int = 0
    turned: bool = False

    @property
    def inner(self) -> bool:
        """Whether it slides along another link of its group: it does not."""
        return False

    @property
    def links(self) -> tuple[int, ...]:
        """Its link, and the rod that is driven out of it: as they lie from the pivot to Q."""
        if not self.rod:
            return (self.link,)
        return (self.rod, self.link) if self.turned else (self.link, self.rod)


class GuideLeg(NamedTuple):
    """S: link ``link`` slides on ``body`` along ``line``. I (``inner``): Q slides off its pivot on ``body``.

    ``on``: the link that is slid on.
    """

    link: int
    body: int
    line: Mark
    inner: bool
    on: int


ClosingLeg = PinLeg | GuideLeg
"""How a link of a group is held by what is there already."""
SpecialClosing = PlateClosing | SquareClosing
"""What a group of a class above II leaves: its plans are drawn by a special point."""
AnyClosing = Closing | SpecialClosing
"""What a group of any class leaves."""


def groups_of(closings: Iterable[AnyClosing], room: str) -> Iterator[AnyClosing]:
    """Yield groups of all classes in the order of attachment; StructureError of one that is not known."""
    closings = tuple(closings)
    known = known_groups((one.group for one in closings), room)
    for closing, _ in zip(closings, known, strict=True):
        for leg in closing.legs:
            match leg:
                case PinLeg() | GuideLeg():
                    pass
                case _:
                    unheld(leg, room)
        yield closing


def two_legged(closings: Iterable[AnyClosing], room: str) -> Iterator[Closing]:
    """Yield the groups of two links alone: what is asked of these cannot be asked of others."""
    return (one for one in groups_of(closings, room) if isinstance(one, Closing))


def with_plates(closings: Iterable[AnyClosing], room: str) -> Iterator[SpecialClosing]:
    """Yield the groups that have plates: those whose place is given, and whose plans have a special point."""
    return (one for one in groups_of(closings, room) if not isinstance(one, Closing))


def on_three_legs(closings: Iterable[AnyClosing], room: str) -> Iterator[PlateClosing]:
    """Yield the groups of one plate on three legs alone."""
    return (one for one in with_plates(closings, room) if isinstance(one, PlateClosing))


def dyads(closings: Iterable[AnyClosing], room: str) -> Iterator[Closing]:
    """Yield groups of two links; StructureError of one of another class."""
    closings = tuple(closings)
    refused = class_two((one.group for one in closings), room)
    for closing, _ in zip(two_legged(closings, room), refused, strict=True):
        yield closing


def legs_of(closings: Iterable[AnyClosing], room: str) -> Iterator[tuple[AnyClosing, ClosingLeg]]:
    """Yield the legs of groups of all classes, each beside its group."""
    return ((closing, leg) for closing in groups_of(closings, room) for leg in closing.legs)


def last_legs(closing: AnyClosing) -> tuple[ClosingLeg, ClosingLeg]:
    """Return the legs whose unknown sides close a polygon of forces: that of the first leg is its last."""
    return closing.crossing if isinstance(closing, PlateClosing) else closing.legs


def outer_guides(
    closings: Iterable[AnyClosing], room: str
) -> Iterator[tuple[AnyClosing, GuideLeg]]:
    """Yield the legs that slide on what is there already, each beside its group."""
    for closing, leg in legs_of(closings, room):
        if isinstance(leg, GuideLeg) and not leg.inner:
            yield closing, leg


def unheld(leg: Never, room: str) -> NoReturn:
    """Refuse a leg of a kind that a room does not treat: mypy sees that none of the kinds comes here."""
    link, kind = getattr(leg, "link", "?"), type(leg).__name__
    raise StructureError(
        said("link {link} is held in a way that is not treated here: {kind}", link=link, kind=kind),
        f"link {link}",
        head=room,
    )


def pair_of(closing: AnyClosing, leg: GuideLeg) -> Pair:
    """Return the sliding pair of a leg."""
    group = closing.group
    if leg.inner:
        return next(pair for pair in group.inner_pairs if leg.link in pair.links)
    return next(k.pair for k in group.legs if k.link == leg.link)
