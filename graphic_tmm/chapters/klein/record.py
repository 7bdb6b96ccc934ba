"""The constructions of Klein and Ritterhaus as they are drawn on a slider-crank of their own, by positions."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import ROUNDING, Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import (
    cross,
    join,
    lay_off,
    measure,
    meet,
    parallel,
    place,
    similar,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.chapters.kinematics.bodies import incline_by
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.klein import formulas as f
from graphic_tmm.chapters.klein import words as why
from graphic_tmm.chapters.klein.crank import SliderCrank, slider_crank
from graphic_tmm.chapters.klein.operations import circle_through
from graphic_tmm.chapters.klein.task import ASKED, KLEIN, KleinTask
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded


class Quantity(NamedTuple):
    """A side of the figure (Length), what it stands for (Number): which vector, as it is written."""

    vector: str
    segment: Mark
    value: Mark


class RodPoint(NamedTuple):
    """A point of the rod, and where it lies on the sides of velocities and of accelerations."""

    letter: str
    at: Mark
    velocity: Mark
    acceleration: Mark


@dataclass(frozen=True)
class Figure:
    """A construction as drawn in a ``view``: three μ (lengths, velocities, accelerations), mechanism, M, Q, N.

    ``moved``: where the pin gains speed, the ends of its whole acceleration and of the normal one behind it.
    ``along``: the line through the pivot along the guide. ``through``: what leads from M to Q: in Klein's the
    centre of the circle on the rod, this circle, a point of both circles, their chord; in Ritterhaus's R.
    """

    view: str
    scales: tuple[Mark, ...]
    pivot: Mark
    pin: Mark
    slider: Mark
    along: Mark
    M: Mark
    Q: Mark
    N: Mark
    moved: tuple[Mark, ...]
    through: tuple[Mark, ...]
    quantities: tuple[Quantity, ...]
    points: tuple[RodPoint, ...]


@dataclass(frozen=True)
class Klein:
    """The constructions of a slider-crank at some ``places`` (indices of positions), by view."""

    order: KleinTask
    of: SliderCrank
    figures: dict[str, Figure]
    places: tuple[int, ...]


KLEIN_PLAN: Recorded[Klein] = Recorded(KLEIN)


def record(bench: Bench) -> Klein | None:
    """Draw the constructions that are asked for."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    of = slider_crank(plans, order)
    places = chosen(order.positions, bench.names, KLEIN)
    figures = {view: _Drawing(bench.draft, plans, of, view).drawn() for view in order.views}
    for view in figures:
        bench.rows[view] = places
        bench.tell(view, places)
    return Klein(order, of, figures, places)


class _Drawing:
    """A construction while it is drawn."""

    def __init__(self, draft: Draft, plans: KinematicPlans, of: SliderCrank, view: str) -> None:
        self.draft, self.plans, self.of, self.view = draft, plans, of, view
        self.quantities: list[Quantity] = []

    def drawn(self) -> Figure:
        """Draw it all."""
        draft, of = self.draft, self.of
        pivot, A, B = of.pivot, of.pin, of.slider
        draft.open(self.view)
        mu = draft.scale("μ_l", "m/mm")
        draft.open(f"{self.view} scales")
        omega = self.omega = self._omega()
        self.scales = {
            unit: draft.draw(op, letter, mu, omega, unit=f"({unit})/mm")
            for op, letter, unit in (
                (f.velocities_on_figure, "μ_v", "m/s"), (f.accelerations_on_figure, "μ_a", "m/s²"),
            )
        }  # fmt: skip
        draft.open(self.view)
        self.O = draft.take(Point, pivot, 0j)
        draft.lay_out(self.O)
        self.crank = self._crank()
        self.arm = self._length(pivot, A, of.crank)
        self.A = draft.draw(lay_off, A, self.crank, self.arm, why=why.CRANK)
        leg = of.rod
        self.rod = draft.draw(parallel, f"({A}{B})", self.A, leg.line, why=why.ROD)
        self.B = draft.draw(lay_off, B, self.rod, self._length(A, B, of.length), why=why.ROD)
        self.along = draft.draw(parallel, f"({pivot}N)", self.O, of.guide.line, why=why.ALONG)
        self.across = draft.draw(square, f"({pivot}M)", self.O, self.along, why=why.ACROSS)
        self.M = self._point("M", self.rod, self.across, why.TURNED)
        self._read(f"v_{B}", self.O, self.M)
        self._read(f"v_{{{B}{A}}}", self.A, self.M)
        Q, across, through = self._klein() if self.view == KLEIN else self._ritterhaus()
        moved = self._gaining(Q) if of.driven.epsilon else ()
        self.image, end = moved or (self.A, Q)
        if moved or across is None:
            across = draft.draw(square, f"({end.letter}N)", end, self.rod, why=why.TANGENTIAL)
        self.N = self._point("N", across, self.along, why.WHOLE)
        if not moved:
            self._read(f"a_{{{B}{A}}}^{{n}}", self.A, Q)
        self._read(f"a_{{{B}{A}}}^{{t}}", end, self.N)
        self._read(f"a_{B}", self.O, self.N)
        points = tuple(self._rod_point(letter, own) for letter, own in of.points.items())
        scales = (mu, *self.scales.values())
        return Figure(
            self.view, scales, self.O, self.A, self.B, self.along, self.M, Q, self.N, moved,
            through,
            tuple(self.quantities), points,
        )  # fmt: skip

    def _omega(self) -> Mark:
        """Return how fast the crank turns, without its sign; taken where no plan has it."""
        pair, velocities = self.plans.pairs[0], self.plans.velocities
        known = velocities.speeds.get(pair.link) if velocities is not None else None
        return known or self.of.driven.turning(self.draft)

    def _crank(self) -> Mark:
        of = self.of
        body = self.plans.positions.bodies[of.driven.link]
        bend = math.degrees(cmath.phase(of.arm)) - body.angle
        bend = 0.0 if abs(bend) <= ROUNDING * 360.0 else bend
        return incline_by(self.draft, f"{of.pivot}{of.pin}", self.O, body.axis, bend, why.CRANK)

    def _length(self, start: str, end: str, metres: float) -> Mark:
        real = self.draft.constant(f"l_{{{start}{end}}}", metres, "m")
        return self.draft.draw(to_board, f"{start}{end}", real, self.draft.scale_of(self.view))

    def _point(self, letter: str, first: Mark, second: Mark, because: str) -> Mark:
        return self.draft.draw(meet, letter, first, second, free=True, why=because)

    def _read(self, vector: str, start: Mark, end: Mark) -> Mark:
        """Measure a side of the figure, calculate what it stands for; return the side."""
        segment = f"{start.letter}{end.letter}"
        unit, because = ("m/s", why.VELOCITY) if vector[0] == "v" else ("m/s²", why.ACCELERATION)
        length = self.draft.draw(measure, segment, start, end, free=True, why=because)
        value = self.draft.draw(in_si, vector, length, self.scales[unit], unit=unit, free=True)
        self.quantities.append(Quantity(vector, length, value))
        return length

    def _gaining(self, Q: Mark) -> tuple[Mark, ...]:
        """Lay off what the pin gains behind the crank, and AQ behind that; return both ends."""
        draft, of, A, plan = self.draft, self.of, self.of.pin, self.plans.accelerations
        normal = self._read(f"a_{{{of.slider}{A}}}^{{n}}", self.A, Q)
        epsilon = (plan.rates.get(of.driven.link) if plan else None) or of.driven.gaining(draft)
        known = self.arm, epsilon, self.omega
        length = draft.draw(f.tangential_on_figure, f"{A}{A}′", *known)
        line = draft.draw(
            square, f"({A}{A}′)", self.A, self.crank, sense=-1, why=why.PIN_TANGENTIAL
        )
        image = draft.draw(lay_off, f"{A}′", line, length, why=why.PIN_TANGENTIAL)
        self._read(f"a_{A}", self.O, image)
        along = draft.draw(parallel, f"({A}′Q′)", image, self.rod, why=why.AGAIN_NORMAL)
        return image, draft.draw(lay_off, "Q′", along, normal, why=why.AGAIN_NORMAL)

    def _klein(self) -> tuple[Mark, Mark | None, tuple[Mark, ...]]:
        """Draw both circles; return Q, their common chord, and what leads to it."""
        draft, A = self.draft, self.of.pin
        about = draft.draw(circle_through, f"({A}; {A}M)", self.A, self.M, why=why.OPENING)
        centre = draft.draw(halve, "E", self.A, self.B, free=True, why=why.MIDDLE)
        on_rod = draft.draw(circle_through, f"(E; E{A})", centre, self.A, why=why.ON_ROD)
        side = draft.take(Side, "±", 1.0)
        both = draft.draw(cross, "U", about, on_rod, side, free=True, why=why.SHARED)
        chord = draft.draw(square, "(QN)", both, self.rod, why=why.CHORD)
        return self._point("Q", self.rod, chord, why.NORMAL), chord, (centre, on_rod, both, chord)

    def _ritterhaus(self) -> tuple[Mark, Mark | None, tuple[Mark, ...]]:
        """Draw the parallels; return Q, no line through it yet, and R."""
        draft, of = self.draft, self.of
        base = self.along
        if not of.in_line:
            base = draft.draw(join, f"({of.slider}{of.pivot})", self.B, self.O, why=why.SIDE)
        first = draft.draw(parallel, "(MR)", self.M, base, why=why.SIMILAR)
        R = self._point("R", first, self.crank, why.SIMILAR)
        second = draft.draw(parallel, "(RQ)", R, self.across, why=why.AGAIN)
        Q = self._point("Q", second, self.rod, why.NORMAL_BY_RATIO)
        return Q, None, (R,)

    def _on_rod(self, letter: str, own: complex) -> Mark:
        """Draw a point of the rod by how far it lies along the rod from A, and beside it (m)."""
        draft, mu, A = self.draft, self.draft.scale_of(self.view), self.of.pin
        if own.imag == 0.0:
            along = self._length(A, letter, own.real)
            return draft.draw(lay_off, letter, self.rod, along, free=True, why=why.ROD_POINT)
        reals = ((f"x_{{{letter}}}", own.real), (f"y_{{{letter}}}", own.imag))
        x, y = (
            draft.draw(to_board, name, draft.constant(name.upper(), size, "m"), mu)
            for name, size in reals
        )
        return draft.draw(place, letter, self.rod, x, y, free=True, why=why.ROD_POINT)

    def _rod_point(self, letter: str, own: complex) -> RodPoint:
        """Find a point of the rod on AM and AN."""
        draft, small = self.draft, letter.lower()
        at = self._on_rod(letter, own)
        mechanism = self.A, self.B, at
        v = draft.draw(similar, f"{small}′", self.A, self.M, *mechanism, free=True, why=why.IMAGE_V)
        a = draft.draw(
            similar, f"{small}″", self.image, self.N, *mechanism, free=True, why=why.IMAGE_A
        )
        self._read(f"v_{{{letter}}}", self.O, v)
        self._read(f"a_{{{letter}}}", self.O, a)
        return RodPoint(letter, at, v, a)


PLAN = Plan(record=record)
