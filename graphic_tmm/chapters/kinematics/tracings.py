"""What is laid on tracing paper, and how well it fits where it lies: a plate on three legs, two joined plates.

How it lies is a `Line` of two directions: ``at`` that of the first leg or of the other plate, ``along`` that of
the plate's own line, by which a scene tells its places apart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any, Protocol

import numpy as np

from graphic_tmm.board.geometry import vector
from graphic_tmm.board.operations.tracing import (
    Square,
    arc_normal,
    arc_off,
    held,
    line_off,
    on_arcs,
    on_guide,
    on_guides,
    on_links,
    square_held,
    square_off,
    square_size,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Arc, Complexes, Line, Reals
from graphic_tmm.mechanism.groups import AssurGroup
from graphic_tmm.mechanism.records import Link

Loci = Sequence[Any]
"""What stands when it is laid, at a row of coordinates: the loci of three pins, or both pivots."""
GUIDE = 0.2
"""A guide is outlined to either side of its pin for this share of the leg and the plate."""
CORRECTIONS = on_arcs, on_guide, on_guides
"""A correction of how a plate lies, by how many of its pins are on guides."""


class Tracing(Protocol):
    """What is laid, by what it is laid on."""

    @property
    def group(self) -> AssurGroup:
        """The group of which it is."""

    @property
    def link(self) -> Link:
        """The plate of which a scene tells where it lies."""

    @property
    def angle(self) -> float:
        """The direction of its line in its own axes, degrees."""

    @property
    def loci(self) -> tuple[Mark, ...]:
        """The marks of what stands before it is laid."""

    def corrected(self, loci: Loci, lies: Line) -> Line:
        """Return how it lies after one correction."""

    def off(self, loci: Loci, lies: Line) -> Complexes:
        """Return by how much it does not fit: two lengths."""

    def size(self, loci: Loci) -> Reals:
        """Return the length of which that is a share."""

    def held(self, loci: Loci, lies: Line) -> Reals:
        """Return how well it is held: 0 where two of its places meet, of other signs at both."""

    def crossing(self, loci: Loci, lies: Line) -> tuple[int, int]:
        """Return which of what holds it cross most squarely."""

    def outline(self, loci: Loci, lies: Line) -> tuple[tuple[complex, ...], ...]:
        """Return the group as it lies there, in lines from point to point, m."""


@dataclass(frozen=True)
class PlateTracing:
    """A plate on three legs: the loci of its pins, and where these are from the first, m.

    ``second``: along its line; ``third``: along and to the left of that.
    """

    group: AssurGroup
    link: Link
    loci: tuple[Mark, ...]
    angle: float
    second: float
    third: complex

    def corrected(self, loci: Loci, lies: Line) -> Line:
        """Return how it lies after one correction."""
        first, second, third = loci
        guides = sum(not isinstance(locus, Arc) for locus in loci)
        return CORRECTIONS[guides](lies, first, second, third, *self._sizes())

    def off(self, loci: Loci, lies: Line) -> Complexes:
        """Return how far its second and its third pin are off their loci."""
        second, third = (
            arc_off(pin, locus) if isinstance(locus, Arc) else line_off(pin, locus)
            for pin, locus in zip(self._pins(loci, lies), loci[1:], strict=True)
        )
        return vector(second, third)

    def size(self, loci: Loci) -> Reals:
        """Return the length of its first leg with those of the plate."""
        return np.asarray(loci[0].radius + abs(self.second) + abs(self.third))

    def held(self, loci: Loci, lies: Line) -> Reals:
        """Return how well its three legs hold it."""
        return held(lies, *self._sizes(), *self._normals(loci, lies)[1:])

    def crossing(self, loci: Loci, lies: Line) -> tuple[int, int]:
        """Return the two legs of which the lines, or what is square to the guides, cross most squarely."""
        normals = self._normals(loci, lies)
        least = {
            (a, b): float(np.abs((np.conj(normals[a]) * normals[b]).imag).min())
            for a, b in combinations(range(3), 2)
        }
        return max(least, key=lambda two: round(least[two], 9))

    def outline(self, loci: Loci, lies: Line) -> tuple[tuple[complex, ...], ...]:
        """Return the plate and its legs, of one that slides a piece of the guide."""
        b = loci[0].centre + loci[0].radius * lies.at
        pins = [complex(np.ravel(pin)[0]) for pin in (b, *self._pins(loci, lies))]
        way = GUIDE * float(np.ravel(self.size(loci))[0])
        legs = [
            (complex(np.ravel(locus.centre)[0]), pin)
            if isinstance(locus, Arc)
            else tuple(pin + sign * way * complex(np.ravel(locus.along)[0]) for sign in (-1, 1))
            for pin, locus in zip(pins, loci, strict=True)
        ]
        return (*pins, pins[0]), *legs

    def _sizes(self) -> tuple[Complexes, Complexes]:
        return np.array([[complex(self.second)]]), np.array([[self.third]])

    def _pins(self, loci: Loci, lies: Line) -> tuple[Complexes, Complexes]:
        b = loci[0].centre + loci[0].radius * lies.at
        return b + self.second * lies.along, b + self.third * lies.along

    def _normals(self, loci: Loci, lies: Line) -> tuple[Complexes, Complexes, Complexes]:
        second, third = (
            arc_normal(pin, locus) if isinstance(locus, Arc) else locus.along * 1j
            for pin, locus in zip(self._pins(loci, lies), loci[1:], strict=True)
        )
        return lies.at, second, third


@dataclass(frozen=True)
class SquareTracing:
    """Two plates that two links join: ``loci``, the pivots of the other plate and of the one that is told.

    ``own``: the pins of the links on both, in the order of the pivots, from these along and to the left of the
    plates' lines, m; ``lengths``: of the links, m.
    """

    group: AssurGroup
    link: Link
    loci: tuple[Mark, ...]
    angle: float
    own: tuple[complex, ...]
    lengths: tuple[float, float]

    def corrected(self, loci: Loci, lies: Line) -> Line:
        """Return how they lie after one correction."""
        return on_links(lies, self._square(loci))

    def off(self, loci: Loci, lies: Line) -> Complexes:
        """Return how far both links do not fit."""
        return square_off(self._square(loci), lies)

    def size(self, loci: Loci) -> Reals:
        """Return how far the pins are from the pivots, all of them together."""
        return square_size(self._square(loci))

    def held(self, loci: Loci, lies: Line) -> Reals:
        """Return how well the links hold both plates."""
        return square_held(self._square(loci), lies)

    def crossing(self, loci: Loci, lies: Line) -> tuple[int, int]:
        """Return the two links: there are no others."""
        return 0, 1

    def outline(self, loci: Loci, lies: Line) -> tuple[tuple[complex, ...], ...]:
        """Return both plates and the links that join them."""
        to, at = (complex(np.ravel(pivot)[0]) for pivot in loci)
        other, told = (complex(np.ravel(way)[0]) for way in lies)
        b1, b2, c1, c2 = (
            pivot + one * way
            for one, (pivot, way) in zip(
                self.own, ((to, other), (to, other), (at, told), (at, told)), strict=True
            )
        )
        return (to, b1, b2, to), (at, c1, c2, at), (b1, c1), (b2, c2)

    def _square(self, loci: Loci) -> Square:
        b1, b2, c1, c2 = (np.array([[one]]) for one in self.own)
        first, second = (np.array([[one]]) for one in self.lengths)
        return Square(loci[0], loci[1], b1, b2, c1, c2, first, second)
