"""All places of a plate, drawn: a leg loosened, the locus of its pin crossed with what that leg leaves it."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.curve import french_curve
from graphic_tmm.board.operations.instruments import (
    cross,
    cut,
    join,
    lay_off,
    measure,
    place,
    ray,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Arc, Point, Side
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg, PlateClosing, on_three_legs
from graphic_tmm.chapters.kinematics.other_places import search_of
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, chosen
from graphic_tmm.chapters.kinematics.plates import TRACINGS
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.chapters.kinematics.tracings import Groove, PlateTracing
from graphic_tmm.chapters.loci import words as why
from graphic_tmm.chapters.loci.loosened import ROW, Loosened
from graphic_tmm.chapters.loci.operations import cross_arc, cross_guide
from graphic_tmm.chapters.loci.task import ASKED, LOCI, LociTask
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan, Project
from graphic_tmm.project import record as recorded
from graphic_tmm.scene.chapter import Recorded, aside
from graphic_tmm.scene.records import Scene

Pins = tuple[Mark, Mark, Mark]
"""The three pins of the plate in one of its places."""


@dataclass(frozen=True)
class Loci:
    """All places of a plate in one position, called ``at``; ``own``: which of them the mechanism has.

    ``held``: what its legs leave its pins, an arc or a guide, each behind the pivot of a leg that turns, or a
    point of the guide. ``curves``: loci of its third pin. ``size``: how far the construction reaches, m;
    ``near``: the directions of the first leg and of the plate's line in its own place, degrees; ``arm``: from
    the first pivot to the third pin there, as measured.
    """

    closing: PlateClosing
    loosened: Loosened
    at: str
    mu: Mark
    held: tuple[tuple[Mark, Mark], ...]
    curves: tuple[Mark, ...]
    places: tuple[Pins, ...]
    own: int
    size: float
    near: tuple[float, float]
    arm: Mark


LOCI_PLAN: Recorded[Loci] = Recorded(LOCI)
TRACED = "loci-tracing"
"""The view in which the plate is laid on tracing paper, to be compared."""
TRACING: Recorded[Mark] = Recorded(aside(LOCI))


class _Place(NamedTuple):
    """A place as it is calculated: pins, m; by which curve, behind which of its points, in which sense."""

    pins: tuple[complex, complex, complex]
    curve: int
    after: int
    outward: int


def record(bench: Bench) -> Loci | None:
    """Draw all places of the plate that is asked for.

    Raises
    ------
    StructureError
        If there is no such plate or position, or the plate cannot be laid there.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    traced = _positions(bench.scene)
    plans = KINEMATICS_PLAN.on(traced)
    tried = plans.tried
    closing = _plate(tried, order)
    index = chosen((order.at,), traced.names, LOCI)[0] if order.at is not None else 0
    coordinate = traced.coordinates[index]
    assert coordinate is not None
    loosened, lies = _laid(tried, closing, coordinate)
    curves = [*loosened.circuits]
    places = [*_places(loosened, lies)]
    leg, plate = closing.branch.near(np.array([coordinate]))
    if not places or not np.isfinite(plate).all():
        raise StructureError(
            said(
                "link {plate} cannot be laid in position {at}: name another",
                plate=closing.plate,
                at=traced.names[index],
            ),
            f"{LOCI}.at",
            head=LOCI,
        )
    own = min(
        range(len(lies)),
        key=lambda k: sum(
            abs(math.remainder(cmath.phase(one) - math.radians(float(near[0])), math.tau))
            for one, near in zip(lies[k], (leg, plate), strict=True)
        ),
    )
    held, drawn, laid = _Drawing(bench.draft, closing, loosened).drawn(places)
    spots = [loosened.pins(*one.at(np.arange(float(ROW))))[2] for one in curves]
    every = np.concatenate(
        [
            *spots,
            np.array([[*one.pins] for one in places]).ravel(),
            [complex(h.centre) for h in _arcs(loosened)],
        ]
    )
    size = float(max(np.ptp(every.real), np.ptp(every.imag)))
    draft = bench.draft
    arm = draft.draw(measure, f"{_pivot(closing)}{closing.pins[2]}", held[0][0], laid[own][2])
    return Loci(
        closing,
        loosened,
        traced.names[index],
        draft.mu_l,
        held,
        drawn,
        laid,
        own,
        size,
        (float(leg[0]), float(plate[0])),
        arm,
    )


def trace_place(bench: Bench) -> Mark:
    """Lay the plate on tracing paper, too, on the same loci; return what is measured, from the first pivot."""
    made, draft = LOCI_PLAN.on(bench), bench.draft
    closing, off = made.closing, made.loosened.off
    draft.open(TRACED)
    first, second, third = (held.kind for _, held in made.held)
    tracing = TRACINGS[first, second, third]
    lengths = [
        draft.length(name, size)
        for name, size in (
            ("".join(closing.pins[:2]), made.loosened.apart),
            (f"x_{{{closing.pins[2]}}}", off.real),
            (f"y_{{{closing.pins[2]}}}", off.imag),
        )
    ]
    near = [draft.angle(f"≈{k}", angle) for k, angle in enumerate(made.near, 1)]
    line = draft.draw(
        tracing, f"({closing.line})", *(held for _, held in made.held), *lengths, *near
    )
    pin = draft.draw(place, closing.pins[2], line, *lengths[1:], why=why.OF_TRIANGLE)
    return draft.draw(measure, f"{_pivot(closing)}{closing.pins[2]}", made.held[0][0], pin)


def _positions(scene: Scene) -> Project:
    """Record the plan of positions; what refuses it is told as it is, its place is found once."""
    try:
        return recorded(scene, wanted={POSITIONS})
    except StructureError as error:
        raise error.__cause__ or error from error


def _pivot(closing: PlateClosing) -> str:
    """Return the letter of the pivot of the first leg, which turns."""
    leg = closing.legs[0]
    assert isinstance(leg, PinLeg)
    return leg.letter


def _arcs(of: Loosened) -> Iterator[Arc]:
    return (one for one in (of.first, of.locus, of.third) if isinstance(one, Arc))


def _plate(tried: Survey, order: LociTask) -> PlateClosing:
    """Return the plate that is asked for, on the small board of the mechanism."""
    plates = list(on_three_legs(tried.positions.closings, LOCI))
    found = [one for one in plates if order.plate in (None, one.plate)]
    if not found:
        listed = ", ".join(str(one.plate) for one in plates)
        says = (
            said(
                "link {n} is no plate on three legs; there is {listed}",
                n=order.plate,
                listed=listed,
            )
            if plates
            else said("there is no plate on three legs: leave [loci] out")
        )
        raise StructureError(says, f"{LOCI}.plate" if plates else LOCI, head=LOCI)
    if any(isinstance(leg, GuideLeg) and leg.inner for leg in found[0].legs):
        raise StructureError(
            said(
                "link {n} slides along one of its legs: no pin of it draws a locus; leave [loci] out",
                n=found[0].plate,
            ),
            f"link {found[0].plate}",
            head=LOCI,
        )
    if not isinstance(found[0].legs[0], PinLeg):
        raise StructureError(
            said(
                "no leg of link {n} turns: without one leg no pin of it draws a locus about a pivot; leave "
                "[loci] out",
                n=found[0].plate,
            ),
            f"link {found[0].plate}",
            head=LOCI,
        )
    return found[0]


def _laid(
    tried: Survey, closing: PlateClosing, coordinate: float
) -> tuple[Loosened, list[tuple[complex, complex]]]:
    """Return the plate on two legs at a coordinate, and all places that it has on three."""
    search = search_of(tried, closing.group.name)
    tracing = search.tracing
    assert isinstance(tracing, PlateTracing)
    second, third = tracing.own
    assert not isinstance(second, Groove)
    assert not isinstance(third, Groove)
    loci = search.loci(np.array([coordinate]))
    there = [type(one)(*(part.flat[0] for part in one)) for one in loci]
    found = Loosened(there[0], there[1], there[2], second.real, third)
    places = search.places(coordinate)
    return found, [(complex(one.at.flat[0]), complex(one.along.flat[0])) for one in places]


def _places(of: Loosened, lies: list[tuple[complex, complex]]) -> Iterator[_Place]:
    """Yield where each place is on the curves."""
    for leg, plate in lies:
        b = complex(of.first.centre) + float(of.first.radius) * leg
        c, f = b + of.apart * plate, b + of.off * plate
        side = of.side(b, c)
        for k, circuit in enumerate(of.circuits):
            knot = circuit.knot(cmath.phase(leg), side)
            if math.isfinite(knot):
                yield _Place((b, c, f), k, math.floor(knot) % ROW, of.outward(circuit, knot))
                break


class _Drawing:
    """The construction while it is drawn."""

    def __init__(self, draft: Draft, closing: PlateClosing, of: Loosened) -> None:
        self.draft, self.closing, self.of = draft, closing, of
        self.names = closing.pins
        draft.open(LOCI)
        draft.mu_l = draft.scale("μ_l", "m/mm")
        draft.lay_out()

    def drawn(
        self, places: list[_Place]
    ) -> tuple[tuple[tuple[Mark, Mark], ...], tuple[Mark, ...], tuple[Pins, ...]]:
        """Draw it all: what the legs leave the pins, the curves, the places."""
        draft, of = self.draft, self.of
        self.pivot = draft.take(Point, _pivot(self.closing), 0j)
        self.axis = draft.draw(ray, "(x)", self.pivot, draft.direction(0.0))
        self.held = held = [self._held(k) for k in range(3)]
        curves = [self._curve(k, held) for k in range(len([*of.circuits]))]
        laid = [self._place(k, one, curves, held[2][1]) for k, one in enumerate(places, 1)]
        return tuple(held), tuple(curves), tuple(laid)

    def _held(self, k: int) -> tuple[Mark, Mark]:
        """Draw a leg's pivot and its pin's circle, or a point of its guide and the guide."""
        draft, leg, pin = self.draft, self.closing.legs[k], self.names[k]
        locus = (self.of.first, self.of.locus, self.of.third)[k]
        start = complex(self.of.first.centre)
        if isinstance(locus, Arc):
            assert isinstance(leg, PinLeg)
            name = leg.letter
            pivot = self.pivot if k == 0 else self._off(name, complex(locus.centre) - start)
            arm = draft.length(f"{name}{pin}", float(locus.radius))
            return pivot, draft.draw(strike, f"({name}; {name}{pin})", pivot, arm)
        along = complex(locus.along)
        foot = complex(locus.at) - start
        foot -= (foot * along.conjugate()).real * along
        point = self._off(f"N_{pin}", foot)
        angle = draft.angle(f"ψ_{pin}", math.degrees(cmath.phase(along)))
        return point, draft.draw(ray, f"({pin}–{pin})", point, angle)

    def _off(self, name: str, spot: complex) -> Mark:
        return self.draft.draw(place, name, self.axis, *self._coordinates(name, spot))

    def _curve(self, k: int, held: list[tuple[Mark, Mark]]) -> Mark:
        """Draw the locus of the third pin on one of its curves."""
        draft, of, prime = self.draft, self.of, "′" * k
        b, c, f = (f"{name}{prime}" for name in self.names)
        angles, sides = [*of.circuits][k].at(np.arange(float(ROW)))
        way = draft.take(Angle, f"β{prime}", np.degrees(angles)[None, :], "°")
        side = draft.take(Side, "±", sides[None, :] if np.ptp(sides) else float(sides[0]))
        line = draft.draw(ray, f"({self.pivot.letter}{b})", self.pivot, way, why=why.ON_CIRCLE)
        arm = draft.uses(held[0][1])[1]
        pin = draft.draw(lay_off, b, line, arm, why=why.ON_CIRCLE)
        apart = draft.length("".join(self.names[:2]), of.apart)
        arc = draft.draw(strike, f"({b}; {b}{c})", pin, apart, why=why.BY_ARCS)
        if isinstance(of.locus, Arc):
            second = draft.draw(cross, c, arc, held[1][1], side, why=why.BY_ARCS)
        else:
            second = draft.draw(cut, c, held[1][1], arc, side, why=why.BY_ARCS)
        base = draft.draw(join, f"({b}{c})", pin, second)
        off = self._coordinates(self.names[2], of.off)
        third = draft.draw(place, f, base, *off, why=why.OF_TRIANGLE)
        return draft.draw(french_curve, f"({f}–{f})", third, row=ROW, why=why.LOCUS)

    def _place(self, k: int, one: _Place, curves: list[Mark], third: Mark) -> Pins:
        """Mark a crossing, and find the other pins of the plate back from it."""
        draft, of, f = self.draft, self.of, self.names[2]
        op = cross_arc if isinstance(of.third, Arc) else cross_guide
        pin = draft.draw(
            op, f"{f}_{k}", curves[one.curve], third, after=one.after, outward=one.outward
        )
        near, second = (0, 1) if of.squarely(one.pins, 0) >= of.squarely(one.pins, 1) else (1, 0)
        own = (0j, complex(of.apart))
        arm, along = of.off - own[near], own[second] - own[near]
        at, to = self.names[near], self.names[second]
        far = draft.length(f"{at}{f}", abs(arm))
        arc = draft.draw(strike, f"({f}_{k}; {at}{f})", pin, far, why=why.BACK)
        side = draft.take(Side, "±", of.side_of(one.pins, near))
        held = self.held[near][1]
        op, both = (cross, (arc, held)) if held.kind is Arc else (cut, (held, arc))
        first = draft.draw(op, f"{at}_{k}", *both, side, why=why.BACK)
        base = draft.draw(join, f"({at}_{k}{f}_{k})", first, pin)
        x, y = self._coordinates(to, along * arm.conjugate() / abs(arm))
        other = draft.draw(place, f"{to}_{k}", base, x, y, why=why.OF_TRIANGLE)
        return (first, other, pin) if near == 0 else (other, first, pin)

    def _coordinates(self, name: str, spot: complex) -> tuple[Mark, Mark]:
        """Return how far a point is along a line, and to the left of it."""
        x, y = (
            self.draft.length(f"{a}_{{{name}}}", size)
            for a, size in (("x", spot.real), ("y", spot.imag))
        )
        return x, y


PLAN = Plan(record=record, aside=trace_place)
