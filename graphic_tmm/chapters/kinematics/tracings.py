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
from graphic_tmm.board.operations.joined import Square, on_links, square_laid
from graphic_tmm.board.operations.on_slides import (
    Hold,
    OnSlides,
    balance,
    corrected_on_slides,
    guide_hold,
    slides_laid,
    slot_hold,
)
from graphic_tmm.board.operations.slots import Slot, slot_fit
from graphic_tmm.board.operations.tracing import (
    Fit,
    Laid,
    TracedPlate,
    arc_fit,
    corrected,
    first_pin,
    line_fit,
    plate_laid,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Arc, Complexes, Line, Reals
from graphic_tmm.mechanism.groups import AssurGroup
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Link, Sweep

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


class Branch(NamedTuple):
    """One place of a plate, followed along its drive: coordinates, and the angles near which it lies there.

    ``leg``, ``plate``: directions of the first leg (of class IV: of the other plate) and of the plate's line,
    degrees, without leaps. ``sweep``:
    what the coordinates go through; where ``whole`` is False the plate can be laid between the ends only.
    ``crossing``: the two legs (indices) that cross most squarely all along it.
    """

    at: Reals
    leg: Reals
    plate: Reals
    sweep: Sweep
    whole: bool
    crossing: tuple[int, int]

    def near(self, coordinates: Reals) -> tuple[Reals, Reals]:
        """Return both angles at coordinates of the drive; NaN where the plate cannot be laid."""
        row = coordinates
        if self.sweep.closed:
            way = self.sweep.high
            # a new array a line is most of what a million coordinates take
            turns = row - self.at[0]
            turns *= 1.0 / way
            np.floor(turns, out=turns)
            turns *= way
            row = np.subtract(row, turns, out=turns)
        # of a whole turn the ends are one: what rounding puts beyond them is there
        beyond = None if self.whole else complex(np.nan, np.nan)
        # both at once: what takes time is to find between which places a coordinate lies
        both = np.interp(row, self.at, vector(self.leg, self.plate), left=beyond, right=beyond)
        return both.real, both.imag


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

    def laid(self, loci: Loci, lies: Line) -> Laid:
        """Return how it came to lie, and how well it is held: of other signs at two places that meet."""

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
        return corrected(self._traced(loci, lies))

    def laid(self, loci: Loci, lies: Line) -> Laid:
        """Return how it came to lie, and how well its three legs hold it."""
        return plate_laid(self._traced(loci, lies))

    def crossing(self, loci: Loci, lies: Line) -> tuple[int, int]:
        """Return the two legs of which the lines, or what is square to the guides, cross most squarely."""
        plate = self._traced(loci, lies)
        return _crossing(lies.at, plate.second.normal, plate.third.normal)

    def outline(self, loci: Loci, lies: Line) -> tuple[tuple[complex, ...], ...]:
        """Return the plate and its legs, of one that slides a piece of the guide."""
        *_, b, second, third = self._traced(loci, lies)
        pins = [_first(b), *(_first(b + one.arm * lies.along) for one in (second, third))]
        way = GUIDE * float(np.ravel(self.laid(loci, lies).size)[0])
        legs = [(_first(loci[0].centre), pins[0])]
        for pin, locus, one in zip(pins[1:], loci[1:], (second, third), strict=True):
            along = 1j * way * _first(one.normal)
            legs.append(
                (_first(locus.centre), pin)
                if isinstance(locus, Arc)
                else (pin - along, pin + along)
            )
        return (*pins, pins[0]), *legs

    def _traced(self, loci: Loci, lies: Line) -> TracedPlate:
        b = first_pin(loci[0], lies)
        second, third = (
            _fit(own, locus, b, lies) for own, locus in zip(self.own, loci[1:], strict=True)
        )
        return TracedPlate(lies, loci[0].radius, b, second, third)


def _crossing(*normals: Complexes) -> tuple[int, int]:
    """Return which two of three directions are most square to each other where they are least so."""
    least = {
        (a, b): float(np.abs((np.conj(normals[a]) * normals[b]).imag).min())
        for a, b in combinations(range(3), 2)
    }
    return max(least, key=lambda two: round(least[two], 9))


def _first(values: Complexes) -> complex:
    return complex(np.ravel(values)[0])


def _slot(own: Groove) -> Slot:
    return Slot(np.array([[turn(own.bend)]]), np.array([[own.height]]))


def _fit(own: complex | Groove, locus: Any, b: Complexes, lies: Line) -> Fit:
    """Return how a plate whose first pin is at ``b`` keeps to a locus, or its guide to a pivot."""
    if isinstance(own, Groove):
        return slot_fit(locus, _slot(own), b, lies)
    arm = np.array([[own]])
    return (arc_fit if isinstance(locus, Arc) else line_fit)(locus, arm, b, lies)


@dataclass(frozen=True)
class SlidesTracing:
    """A plate of which no leg turns: the guides of its pins, or the pivots that its guides pass.

    ``own``: where its pins are from its first point, along and to the left of its line, m; or the guides. Its
    line alone tells its places apart: it stands for the first leg, too.
    """

    group: AssurGroup
    link: Link
    loci: tuple[Mark, ...]
    angle: float
    own: tuple[complex | Groove, ...]

    def corrected(self, loci: Loci, lies: Line) -> Line:
        """Return how it lies after one correction."""
        way = corrected_on_slides(self._held(loci, lies))
        return Line(way, way)

    def laid(self, loci: Loci, lies: Line) -> Laid:
        """Return how it came to lie, and how well its three legs hold it."""
        return slides_laid(self._held(loci, lies))

    def crossing(self, loci: Loci, lies: Line) -> tuple[int, int]:
        """Return the two legs of which what is square to the guides crosses most squarely."""
        _, _, *holds = self._held(loci, lies)
        return _crossing(*(one.normal for one in holds))

    def outline(self, loci: Loci, lies: Line) -> tuple[tuple[complex, ...], ...]:
        """Return the plate, and of each guide a piece."""
        plate = self._held(loci, lies)
        b = _first(plate.origin + balance(plate).place)
        holds = plate.first, plate.second, plate.third
        pins = [
            _first(locus) if isinstance(own, Groove) else b + own * _first(lies.along)
            for own, locus in zip(self.own, loci, strict=True)
        ]
        way = GUIDE * max(abs(one - other) for one in pins for other in pins)
        along = [1j * way * _first(one.normal) for one in holds]
        guides = [(pin - one, pin + one) for pin, one in zip(pins, along, strict=True)]
        return (*pins, pins[0]), *guides

    def _held(self, loci: Loci, lies: Line) -> OnSlides:
        origin = loci[0].at if isinstance(loci[0], Line) else loci[0]

        def hold(own: complex | Groove, locus: Any) -> Hold:
            if isinstance(own, Groove):
                return slot_hold(locus, _slot(own), lies.along, origin)
            return guide_hold(locus, np.array([[own]]), lies.along, origin)

        first, second, third = map(hold, self.own, loci)
        return OnSlides(lies.along, origin, first, second, third)


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

    def laid(self, loci: Loci, lies: Line) -> Laid:
        """Return how they came to lie, and how well the links hold both."""
        return square_laid(self._square(loci), lies)

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
