"""Wheels on links: two links in mesh, each turning about a pin of one rigid link that joins both centres.

A wheel that rolls on another is a group of one link with a lower pair, its pin, and a higher one, the mesh: W =
3·1 − 2·1 − 1 = 0. Distances along the line of centres are signed, so one rule holds for external and internal
wheels: seen from the link that joins the centres both turn in the inverse ratio of the pitch radii.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeVar

from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.records import Link, Mechanism, Mesh

G = TypeVar("G")
W = TypeVar("W")
PITCH, FAR = "K", "L"
"""The letters of a pitch point, or of where a belt leaves the wheel, and of where it leaves the other; with a
prime where a point of the scene has them."""


class Rolling(NamedTuple):
    """A wheel that stands by another one: its link, that on which it rolls, the one that joins the centres.

    ``body``: what its pin is on: ``arm``, or the frame where that has the letter, too.
    ``pin``, ``other``: the letters of its own centre and of the other's. ``reach``: how far the pitch point is
    from its own centre towards the other, ``away``: from the other's centre towards its own, m, with signs.
    ``start``: the angle of its own x axis from that of ``arm`` where the other's lies along that, degrees.
    ``after``: so many groups of two links stand before it; ``letter``: that of the pitch point; ``far``: of the
    other end of what a belt spans. ``span``: the number of the link that would hold as that does.
    """

    mesh: Mesh
    link: int
    on: int
    arm: int
    body: int
    pin: str
    other: str
    reach: float
    away: float
    start: float
    after: int
    letter: str
    far: str
    span: int

    @property
    def name(self) -> str:
        """Its link, as it stands in the formula of structure."""
        return str(self.link)

    @property
    def ratio(self) -> float:
        """How far it turns for one turn of the other, both seen from the link that joins the centres."""
        return -self.away / self.reach

    @property
    def ring(self) -> bool:
        """Whether its teeth are inside."""
        return self.mesh.internal and abs(self.reach) > abs(self.away)

    @property
    def note(self) -> str:
        """How the log heads its steps."""
        return f"p4({self.name})" + (" by a flexible link" if self.mesh.belted else "")

    @property
    def pair(self) -> Pair:
        """Its higher pair, or the flexible link that counts as one."""
        return _pair(self.letter, self.far, self.mesh)


def size_names(mechanism: Mechanism, mesh: Mesh) -> list[str]:
    """Return the letters of teeth or pitch radii in the order of links; primes tell steps of one link apart."""
    letter, names = "z" if mesh.toothed else "r", list[str]()
    for link, size in zip(mesh.links, mesh.sizes, strict=True):
        meshes = [m for m in mechanism.meshes if link in m.links and m.toothed == mesh.toothed]
        steps = list(dict.fromkeys(one.sizes[one.links.index(link)] for one in meshes))
        primes = "′" * steps.index(size)
        names.append(f"{letter}_{{{link}{primes}}}" if primes else f"{letter}_{link}")
    return names


def in_order(groups: Sequence[G], wheels: Iterable[W], after: Iterable[int]) -> Iterator[G | W]:
    """Yield groups and wheels in the order of attachment; ``after``: so many groups stand before each wheel."""
    places = [*zip(wheels, after, strict=True)]
    for k in range(len(groups) + 1):
        yield from (wheel for wheel, place in places if place == k)
        yield from groups[k : k + 1]


def meshing(mechanism: Mechanism) -> list[Pair]:
    """Return the higher pairs of a mechanism."""
    return [
        _pair(_letter(mechanism, k), _letter(mechanism, k, FAR), mesh)
        for k, mesh in enumerate(mechanism.meshes)
    ]


def _pair(letter: str, far: str, mesh: Mesh) -> Pair:
    first, second = sorted(mesh.links)
    return Pair(*(("F", far + letter) if mesh.belted else ("K", letter)), (first, second))


def bearers(bodies: Mapping[int, Link], mesh: Mesh) -> list[int]:
    """Return the links that join both centres of a mesh rigidly."""
    return [
        number
        for number, body in bodies.items()
        if number not in mesh.links and all(letter in body.points for letter in mesh.centres)
    ]


def rolling(
    mechanism: Mechanism, known: Collection[int], held: Mapping[int, list[Pair]], after: int
) -> Iterator[Rolling]:
    """Yield the wheels that can come next; ``held``: how links that are left are joined to what is there."""
    bodies = mechanism.by_number
    for k, mesh in enumerate(mechanism.meshes):
        arms = [number for number in bearers(bodies, mesh) if number in known]
        ends = [*zip(mesh.links, mesh.centres, strict=True)]
        for own, ((link, pin), (on, other)) in enumerate((ends, ends[::-1])):
            if not arms or on not in known or link in known:
                continue
            pairs = held.get(link, [])
            if [pair.name for pair in pairs] != [pin]:
                continue
            points = bodies[arms[0]].points
            first, second = mesh.reaches(abs(points[pin] - points[other]))
            reach, away = (first, second) if own == 0 else (second, first)
            start = mesh.start if own else mesh.start * away / reach
            yield Rolling(
                mesh,
                link,
                on,
                arms[0],
                pairs[0].other(link),
                pin,
                other,
                reach,
                away,
                start,
                after,
                _letter(mechanism, k),
                _letter(mechanism, k, FAR),
                max(bodies) + 1 + k,
            )


def _letter(mechanism: Mechanism, k: int, first: str = PITCH) -> str:
    """Return the letter of the pitch point of the mesh of this index, or of the far end of its belt."""
    taken = {letter for link in mechanism.by_number.values() for letter in link.points}
    letter = first if len(mechanism.meshes) == 1 else f"{first}{k + 1}"
    while letter in taken:
        letter += "′"
    return letter
