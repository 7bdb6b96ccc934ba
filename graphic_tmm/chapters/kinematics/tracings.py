"""What is laid on tracing paper, and how well it fits where it lies: a plate on three legs, two joined plates.

How it lies is a `Line` of two directions: ``at`` that of the first leg or of the other plate, ``along`` that of
the plate's own line, by which a scene tells its places apart.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any, NamedTuple, Protocol

import numpy as np

from graphic_tmm.board.geometry import vector
from graphic_tmm.board.operations.slots import Slot, slot_arm, slot_normal, slot_off
from graphic_tmm.board.operations.tracing import (
    Square,
    arc_normal,
    arc_off,
    corrected,
    held,
    line_off,
    on_links,
    square_held,
    square_off,
    square_size,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Arc, Complexes, Line, Reals
from graphic_tmm.mechanism.groups import AssurGroup
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Link

Loci = Sequence[Any]
"""What stands when it is laid, at a row of coordinates: the loci of three pins, or both pivots."""
GUIDE = 0.2
"""A guide is outlined to either side of its pin for this share of the leg and the plate."""


class Groove(NamedTuple):
    """A guide of a plate: its direction from the plate's line, degrees, and how far a leg's pivot is off, m.

    That is to the left of a parallel to the guide through the plate's first pin.
    """

    bend: float
    height: float


class _Fit(NamedTuple):
    """How a plate keeps to one of its loci.

    ``arm``: from its first pin, in its own axes, to where it is held; ``off``: how far that is off, to the side
    of ``normal``.
    """

    arm: Complexes
    off: Reals
    normal: Complexes


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
    """A plate on three legs: the loci of its pins, or the pivots that its guides pass.

    ``own``: where its second and its third pin are from the first, along and to the left of its line, m; or
    the guides.
    """

    group: AssurGroup
    link: Link
    loci: tuple[Mark, ...]
    angle: float
    own: tuple[complex | Groove, complex | Groove]

    def corrected(self, loci: Loci, lies: Line) -> Line:
        """Return how it lies after one correction."""
        second, third = self._fits(loci, lies)
        off = vector(second.off, third.off)
        return corrected(
            lies, loci[0].radius, second.arm, third.arm, off, second.normal, third.normal
        )

    def off(self, loci: Loci, lies: Line) -> Complexes:
        """Return how far it is off its second and its third locus."""
        second, third = self._fits(loci, lies)
        return vector(second.off, third.off)

    def size(self, loci: Loci) -> Reals:
        """Return the length of its first leg with those of the plate."""
        own = (one.height if isinstance(one, Groove) else one for one in self.own)
        return np.asarray(loci[0].radius + sum(map(abs, own)))

    def held(self, loci: Loci, lies: Line) -> Reals:
        """Return how well its three legs hold it."""
        second, third = self._fits(loci, lies)
        return held(lies, second.arm, third.arm, second.normal, third.normal)

    def crossing(self, loci: Loci, lies: Line) -> tuple[int, int]:
        """Return the two legs of which the lines, or what is square to the guides, cross most squarely."""
        normals = lies.at, *(one.normal for one in self._fits(loci, lies))
        least = {
            (a, b): float(np.abs((np.conj(normals[a]) * normals[b]).imag).min())
            for a, b in combinations(range(3), 2)
        }
        return max(least, key=lambda two: round(least[two], 9))

    def outline(self, loci: Loci, lies: Line) -> tuple[tuple[complex, ...], ...]:
        """Return the plate and its legs, of one that slides a piece of the guide."""
        b = loci[0].centre + loci[0].radius * lies.at
        fits = self._fits(loci, lies)
        pins = [_first(b), *(_first(b + one.arm * lies.along) for one in fits)]
        way = GUIDE * float(np.ravel(self.size(loci))[0])
        legs = [(_first(loci[0].centre), pins[0])]
        for pin, locus, one in zip(pins[1:], loci[1:], fits, strict=True):
            along = 1j * way * _first(one.normal)
            legs.append(
                (_first(locus.centre), pin)
                if isinstance(locus, Arc)
                else (pin - along, pin + along)
            )
        return (*pins, pins[0]), *legs

    def _fits(self, loci: Loci, lies: Line) -> tuple[_Fit, _Fit]:
        b = loci[0].centre + loci[0].radius * lies.at
        second, third = (
            _fit(own, locus, b, lies) for own, locus in zip(self.own, loci[1:], strict=True)
        )
        return second, third


def _first(values: Complexes) -> complex:
    return complex(np.ravel(values)[0])


def _fit(own: complex | Groove, locus: Any, b: Complexes, lies: Line) -> _Fit:
    """Return how a plate whose first pin is at ``b`` keeps to a locus, or its guide to a pivot."""
    if isinstance(own, Groove):
        slot = Slot(locus, np.array([[turn(own.bend)]]), np.array([[own.height]]))
        return _Fit(slot_arm(slot, b, lies), slot_off(slot, b, lies), slot_normal(slot, lies))
    arm = np.array([[own]])
    pin = b + arm * lies.along
    if isinstance(locus, Arc):
        return _Fit(arm, arc_off(pin, locus), arc_normal(pin, locus))
    return _Fit(arm, line_off(pin, locus), locus.along * 1j)


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
        to, at = map(_first, loci)
        other, own = map(_first, lies)
        b1, b2, c1, c2 = (
            pivot + one * way
            for one, (pivot, way) in zip(
                self.own, ((to, other), (to, other), (at, own), (at, own)), strict=True
            )
        )
        return (to, b1, b2, to), (at, c1, c2, at), (b1, c1), (b2, c2)

    def _square(self, loci: Loci) -> Square:
        b1, b2, c1, c2 = (np.array([[one]]) for one in self.own)
        first, second = (np.array([[one]]) for one in self.lengths)
        return Square(loci[0], loci[1], b1, b2, c1, c2, first, second)
