"""Kinematic pairs, the groups of two links that they make, and the only walk over groups of all kinds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Literal, NamedTuple, Never, NoReturn

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Slide


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


Kind = Literal[1, 2, 3, 4, 5]


class Leg(NamedTuple):
    """How a group holds on to what is there: its link, the body it is joined to, and the pair."""

    link: int
    body: int
    pair: Pair


class Group(NamedTuple):
    """An Assur group of class II: kind 1–5, its two legs, its inner pair.

    The first leg of kinds 2 and 5 is the turning one; of kind 3 it is that of the slider (the stone). ``rods``:
    those that are driven out of cylinders among its links.
    """

    kind: Kind
    legs: tuple[Leg, Leg]
    inner: Pair
    rods: tuple[int, ...] = ()

    @property
    def links(self) -> tuple[int, int]:
        """The two links, smaller number first."""
        first, second = sorted(leg.link for leg in self.legs)
        return first, second

    @property
    def name(self) -> str:
        """The group as it stands in the formula of structure: "2-3"."""
        return "{}-{}".format(*self.links)


def class_two(groups: Iterable[Group], room: str) -> Iterator[Group]:
    """Yield groups in the order of attachment; StructureError of one that a room does not treat."""
    for group in groups:
        match group.kind:
            case 1 | 2 | 3 | 4 | 5:
                yield group
            case _:
                untreated(group.kind, group, room)


def untreated(kind: Never, group: Group, room: str) -> NoReturn:
    """Refuse a group of a kind that a room does not treat: mypy sees that none of the kinds comes here."""
    raise StructureError(
        said(
            "group {name} is of a kind that is not treated here: {kind}", name=group.name, kind=kind
        ),
        *(f"link {leg.link}" for leg in group.legs),
        head=room,
    )
