"""Kinematic pairs, the groups of two links that they make, and the only walk over groups of all kinds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Literal, NamedTuple, Never, NoReturn

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.records import Link, Slide


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

    @property
    def formula(self) -> str:
        """What it is in the formula of structure: "II(2-3)"."""
        return f"II({self.name})"

    @property
    def described(self) -> Said:
        """What it is: its class, order and kind."""
        return said("Group {name}: class II, order 2, kind {kind}", name=self.name, kind=self.kind)

    @property
    def pairs(self) -> int:
        """How many pairs it has."""
        return 3

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs between its links."""
        return (self.inner,)

    @property
    def inside(self) -> tuple[tuple[int, int], ...]:
        """The links that these join: in each the one that pushes, and the one that is pushed."""
        first, second = self.legs
        return ((first.link, second.link),)

    @property
    def rest(self) -> tuple[int, ...]:
        """Its links that nothing holds which is there: none."""
        return ()

    @property
    def plates(self) -> tuple[int, ...]:
        """Its links that are laid with tracing paper: none."""
        return ()


class PlateGroup(NamedTuple):
    """An Assur group of class III and order 3: a plate on three legs, each held by what is there already.

    ``inner``: the pair of each leg with the plate. The legs that turn come first, those that slide along the
    plate last.
    """

    plate: int
    legs: tuple[Leg, Leg, Leg]
    inner: tuple[Pair, Pair, Pair]
    rods: tuple[int, ...] = ()

    @property
    def links(self) -> tuple[int, ...]:
        """The plate and its legs, the smallest number first."""
        return tuple(sorted((self.plate, *(leg.link for leg in self.legs))))

    @property
    def name(self) -> str:
        """The group as it stands in the formula of structure: "2-3-4-5"."""
        return "-".join(map(str, self.links))

    @property
    def formula(self) -> str:
        """What it is in the formula of structure: "III(2-3-4-5)"."""
        return f"III({self.name})"

    @property
    def described(self) -> Said:
        """What it is: its class and order, its plate."""
        return said(
            "Group {name}: class III, order 3, the closed figure is link {plate}",
            name=self.name,
            plate=self.plate,
        )

    @property
    def pairs(self) -> int:
        """How many pairs it has."""
        return 6

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs of its legs with the plate."""
        return self.inner

    @property
    def inside(self) -> tuple[tuple[int, int], ...]:
        """The links that these join: in each the one that pushes, and the one that is pushed."""
        return tuple((leg.link, self.plate) for leg in self.legs)

    @property
    def rest(self) -> tuple[int, ...]:
        """Its links that nothing holds which is there: the plate."""
        return (self.plate,)

    @property
    def plates(self) -> tuple[int, ...]:
        """Its links that are laid with tracing paper: the plate."""
        return (self.plate,)


class SquareGroup(NamedTuple):
    """An Assur group of class IV and order 2: two plates, each about a pivot that is there, and two links.

    ``legs``: the plates as they hold on to what is there, the smaller number first. ``joining``: the links that
    join them; ``inner``: the turning pairs of each of these with the first plate and with the second.
    """

    legs: tuple[Leg, Leg]
    joining: tuple[int, int]
    inner: tuple[tuple[Pair, Pair], tuple[Pair, Pair]]
    rods: tuple[int, ...] = ()

    @property
    def links(self) -> tuple[int, ...]:
        """The plates and what joins them, the smallest number first."""
        return tuple(sorted((*self.plates, *self.joining)))

    @property
    def name(self) -> str:
        """The group as it stands in the formula of structure: "2-3-4-5"."""
        return "-".join(map(str, self.links))

    @property
    def formula(self) -> str:
        """What it is in the formula of structure: "IV(2-3-4-5)"."""
        return f"IV({self.name})"

    @property
    def described(self) -> Said:
        """What it is: its class and order, its closed figure."""
        return said(
            "Group {name}: class IV, order 2, a closed figure of four links", name=self.name
        )

    @property
    def pairs(self) -> int:
        """How many pairs it has."""
        return 6

    @property
    def inner_pairs(self) -> tuple[Pair, ...]:
        """The pairs of what joins the plates with these."""
        return tuple(pair for ends in self.inner for pair in ends)

    @property
    def inside(self) -> tuple[tuple[int, int], ...]:
        """The links that these join: in each the one that pushes, and the one that is pushed."""
        first, second = self.plates
        return tuple(ends for k in self.joining for ends in ((first, k), (k, second)))

    @property
    def rest(self) -> tuple[int, ...]:
        """Its links that nothing holds which is there: those that join the plates."""
        return self.joining

    @property
    def plates(self) -> tuple[int, ...]:
        """Its links that are laid with tracing paper: both plates."""
        return tuple(leg.link for leg in self.legs)


SpecialGroup = PlateGroup | SquareGroup
"""A group of a class above II: it has plates."""
AssurGroup = Group | SpecialGroup
"""A group of any class that this board draws."""


def numeral(group: AssurGroup) -> str:
    """Return the class of a group: "II"."""
    return group.formula.partition("(")[0]


def laid(group: AssurGroup, links: Mapping[int, Link]) -> int:
    """Return the plate of a group whose place a scene tells by its key near, the first if none does so."""
    return next((k for k in group.plates if links[k].near is not None), group.plates[0])


def known_groups(groups: Iterable[AssurGroup], room: str) -> Iterator[AssurGroup]:
    """Yield groups of all classes in the order of attachment; StructureError of one that is not known."""
    for group in groups:
        match group:
            case Group(kind=1 | 2 | 3 | 4 | 5) | PlateGroup() | SquareGroup():
                yield group
            case _:
                untreated(group.kind, group, room)


def of_two_links(groups: Iterable[AssurGroup], room: str) -> Iterator[Group]:
    """Yield the groups of two links alone: what is done to these cannot be done to others."""
    return (group for group in known_groups(groups, room) if isinstance(group, Group))


def class_two(groups: Iterable[AssurGroup], room: str) -> Iterator[Group]:
    """Yield groups of two links; StructureError of one of another class."""
    for group in known_groups(groups, room):
        if not isinstance(group, Group):
            raise StructureError(
                said(
                    "group {name} is of class {numeral}: this is drawn of groups of class II only; leave "
                    "it out",
                    name=group.name,
                    numeral=numeral(group),
                ),
                *(f"link {number}" for number in group.links),
                head=room,
            )
        yield group


def untreated(kind: Never, group: Group, room: str) -> NoReturn:
    """Refuse a group of a kind that a room does not treat: mypy sees that none of the kinds comes here."""
    raise StructureError(
        said(
            "group {name} is of a kind that is not treated here: {kind}", name=group.name, kind=kind
        ),
        *(f"link {leg.link}" for leg in group.legs),
        head=room,
    )
