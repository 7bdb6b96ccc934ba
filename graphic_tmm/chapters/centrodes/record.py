"""The centrodes of a link: its instantaneous centre in every position, in the frame's axes and in its own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.operations.carried import carry_over
from graphic_tmm.board.operations.graphs import standing
from graphic_tmm.board.operations.instruments import (
    join,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.operations.statics import difference_of
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.centrodes import operations as o
from graphic_tmm.chapters.centrodes import words as why
from graphic_tmm.chapters.centrodes.task import ASKED, CENTRODES, CentrodesTask
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.closings import outer_guides
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import Said, said
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded
from graphic_tmm.scene.records import Scene


class Side(NamedTuple):
    """A centrode and the body in whose axes it lies.

    ``points``: two of the body in every position, ``stood``: where they stand as both centrodes touch (none of
    the frame's). ``centre``: P as it is carried there; ``x``, ``y``: P in the body's axes (Length, signed).
    """

    link: int
    points: tuple[Mark, ...]
    stood: tuple[Mark, ...]
    centre: Mark
    x: Mark
    y: Mark
    curve: Mark
    tangent: Mark
    arc: Mark


@dataclass(frozen=True)
class Centrodes:
    """The ``fixed`` and the ``moving`` centrode of a link, in a view of their own, to a scale ``mu``.

    ``centre``: P in every position, where both ``normals`` meet; ``touching``: the position (index) in which
    the moving centrode is drawn, ``touch``: P there, ``off``: the angle between both tangents. ``pivots``: of
    the frame; ``count`` positions make the row. ``index``: of P, the numbers of both links.
    """

    view: str
    mu: Mark
    centre: Mark
    normals: tuple[Mark, Mark]
    fixed: Side
    moving: Side
    touching: int
    touch: Mark
    off: Mark
    pivots: tuple[Mark, ...]
    count: int
    index: str

    @property
    def sides(self) -> tuple[Side, Side]:
        """Both centrodes."""
        return self.fixed, self.moving


CENTRODES_PLAN: Recorded[tuple[Centrodes, ...]] = Recorded(CENTRODES)


class Hold(NamedTuple):
    """How a point of a link moves on the frame: about a ``pivot``, or straight with the link ``slider``.

    ``even``: whether it is the pin of the crank whose angles are the row.
    """

    point: str
    pivot: str = ""
    slider: int = 0
    even: bool = False


def holds(mechanism: Mechanism, link: Link) -> list[Hold]:
    """Return the points of a link whose normals need no plan of velocities, one driven evenly first."""
    fixed, found = mechanism.frame.points, dict[str, Hold]()
    driven = {drive.link for drive in mechanism.drives}
    for letter in link.points:
        for other in mechanism.drawn:
            if other is link or letter not in other.points:
                continue
            pivot = next((one for one in other.points if one in fixed), None)
            if pivot is not None:
                even = other.number == mechanism.drive.link
                found.setdefault(letter, Hold(letter, pivot, even=even))
            elif other.number not in driven and any(
                slide.on == mechanism.frame.number for slide in other.slides
            ):
                found.setdefault(letter, Hold(letter, slider=other.number))
    return sorted(found.values(), key=lambda hold: not hold.even)


def needs(scene: Scene) -> dict[str, bool]:
    """Return that velocities are needed, where the lines of pivots and guides do not give every centre."""
    order, mechanism = ASKED.of(scene), scene.mechanism
    if order is None or mechanism is None:
        return {}
    links = [mechanism.by_number[n] for n in order.links if n in mechanism.by_number]
    held = [holds(mechanism, link) for link in links]
    straight = _on_frame(mechanism, order) and all(len(one) > 1 and one[0].even for one in held)
    return {} if straight else {VELOCITIES: True}


def _on_frame(mechanism: Mechanism, order: CentrodesTask) -> bool:
    return order.against in (None, mechanism.frame.number)


def record(bench: Bench) -> tuple[Centrodes, ...] | None:
    """Draw the centrodes of each link that is asked for.

    Raises
    ------
    StructureError
        If a link has none: it turns about a pivot, or only slides; or there is no such position.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    return tuple(_Plan(bench, plans, order, number).draw() for number in order.links)


class _Plan:
    """The drawing of one link's centrodes."""

    def __init__(
        self, bench: Bench, plans: KinematicPlans, order: CentrodesTask, number: int
    ) -> None:
        self.draft, self.plans, self.turned = bench.draft, plans, bench.scene.turned
        mechanism, bodies = plans.mechanism, plans.positions.bodies
        self.body, self.frame = bodies[number], bodies[mechanism.frame.number]
        self.on = self.frame if order.against is None else bodies[order.against]
        _refuse_none(self.body.link, self.on.link)
        self.touching = 0 if order.at is None else _place(bench.names, order.at)
        self.at = bench.names[self.touching]
        on = self.on.link.number
        self.index = f"{number}{on}" if max(number, on) < 10 else f"{number},{on}"
        self.known: dict[Mark, Mark] = {}
        named = f"{number}" if self.on is self.frame else f"{number}/{on}"
        self.draft.open(f"{CENTRODES} {named}")
        self.mu = self.draft.scale("μ_l", "m/mm")

    def draw(self) -> Centrodes:
        """Draw P in every position, both curves, both tangents."""
        draft = self.draft
        draft.lay_out(self.point(self.plans.positions.point(self.plans.structure.origin)))
        letters, normals, even = self.normals()
        centre = draft.draw(meet, f"P_{{{self.index}}}", *normals, why=why.CENTRE)
        pin = self.point(self.body.marks[letters[0]])
        weight = (
            draft.draw(measure_along, f"{letters[0]}P", pin, centre, normals[0], why=why.DISTANCE)
            if even
            else self.rate()
        )
        row, closed = self.plans.in_turn, int(self.plans.closed)

        def curve(letter: str, through: Mark) -> Mark:
            op = o.branched_curve if even else o.branched_by_rate
            return draft.draw(op, letter, through, weight, row=row, closed=closed)

        own = () if self.on is self.frame else tuple(self.on.link.points)[:2]
        fixed = self.side(self.on, own, centre, ("x", "y"), curve)
        moving = self.side(self.body, letters, centre, ("ξ", "η"), curve)
        touch = draft.draw(
            standing, f"P_{{{self.at}}}", fixed.centre, place=self.touching, why=why.TOUCH
        )
        tangents = fixed.tangent, moving.tangent
        off = draft.draw(o.between_lines, "δ", *tangents, unit="°", role=roles.READ_OFF)
        pivots = tuple(self.point(mark) for mark in self.frame.marks.values())
        return Centrodes(
            self.mu.view, self.mu, centre, normals, fixed, moving, self.touching, touch, off,
            pivots, self.plans.in_turn, self.index,
        )  # fmt: skip

    def point(self, of: Mark) -> Mark:
        """Return a point of the plan of positions as it stands here."""
        if of not in self.known:
            factors = (self.draft.mu_l, self.mu)
            self.known[of] = self.draft.draw(carry_over, of.name, of, *factors, free=True)
        return self.known[of]

    def normals(self) -> tuple[tuple[str, str], tuple[Mark, Mark], bool]:
        """Draw the normals of two points; return their letters, and whether the first is driven evenly."""
        mechanism, link = self.plans.mechanism, self.body.link
        straight = holds(mechanism, link)[:2] if self.on is self.frame else []
        first = [hold.point for hold in straight]
        letters = (*first, *(one for one in link.points if one not in first))[:2]
        lines = tuple(
            self.straight(straight[k]) if k < len(straight) else self.by_velocity(letter)
            for k, letter in enumerate(letters)
        )
        even = len(straight) > 1 and straight[0].even
        return (letters[0], letters[1]), (lines[0], lines[1]), even

    def straight(self, hold: Hold) -> Mark:
        """Draw a normal that pivot or guide give."""
        draft, at, name = self.draft, self.point(self.body.marks[hold.point]), f"(n_{hold.point})"
        if hold.pivot:
            pivot = self.point(self.frame.marks[hold.pivot])
            return draft.draw(join, name, pivot, at, free=True, why=why.NORMAL_OF_PIN)
        legs = outer_guides(self.plans.positions.closings, CENTRODES)
        line = next(leg.line for _, leg in legs if leg.link == hold.slider)
        return draft.draw(square, name, at, line, free=True, why=why.NORMAL_OF_GUIDE)

    def by_velocity(self, letter: str) -> Mark:
        """Draw a normal to the velocity of a point, relative to the body on which the link rolls."""
        plan, mark = self.plans.velocities, self.body.marks[letter]
        assert plan is not None
        end = plan.images.by_letter[self.body.link.number][letter]
        start = plan.images.pole
        self.draft.open(VELOCITIES)
        if self.on is not self.frame:
            on = self.on.link.number
            start = plan.images.of(on, mark, letter, f"{letter.lower()}{on}")
        way = self.draft.draw(join, f"(v_{letter})", start, end, free=True, why=why.WAY)
        self.draft.open(self.mu.view)
        op, because = (parallel, why.TURNED) if self.turned else (square, why.NORMAL)
        return self.draft.draw(op, f"(n_{letter})", self.point(mark), way, free=True, why=because)

    def rate(self) -> Mark:
        """Return ω of the link, as the body on which it rolls sees it: its sign is what is asked for."""
        plan = self.plans.velocities
        assert plan is not None
        numbers = (self.body.link.number, self.on.link.number)
        rates = [plan.rates[n] for n in numbers if n in plan.rates]
        if not rates:
            says = said(
                "link {number} does not turn: its instantaneous centre is always at infinity",
                number=numbers[0],
            )
            raise _refuse(says)
        if len(rates) == 1:
            return rates[0]
        letter = f"ω_{{{self.index}}}"
        return self.draft.draw(difference_of, letter, *rates, unit="1/s", free=True)

    def side(
        self,
        body: Body,
        letters: tuple[str, ...],
        centre: Mark,
        names: tuple[str, str],
        curve: Callable[[str, Mark], Mark],
    ) -> Side:
        """Draw a centrode: P read in the axes of its body, carried to where the body stands as both touch."""
        draft, prime = self.draft, "′" if body is self.body else ""
        points, stood = tuple(self.point(body.marks[one]) for one in letters), tuple[Mark, ...]()
        carried = centre
        if points:
            axis = draft.draw(join, f"({''.join(letters)})", *points, free=True, why=why.OWN_AXIS)
            stood = tuple(
                draft.draw(standing, f"{letter}_{{{self.at}}}", at, place=self.touching, free=True)
                for letter, at in zip(letters, points, strict=True)
            )
            name = f"P_{{{self.index}}}{prime or '″'}"
            carried = draft.draw(o.swing_over, name, *stood, *points, centre)
            start = points[0]
        else:
            start = self.point(self.plans.positions.point(self.plans.structure.origin))
            axis = draft.draw(ray, "(x)", start, draft.direction(0.0), why=why.FRAME_AXIS)
        up = draft.draw(square, f"({names[1]})", start, axis, free=True, why=why.UPRIGHT)
        x, y = (
            draft.draw(measure_along, f"{name}_{{P{self.index}}}", start, centre, along)
            for name, along in zip(names, (axis, up), strict=True)
        )
        line = curve(f"(P_{{{self.index}}}{prime})", carried)
        tangent = draft.draw(o.curve_tangent, f"(τ{prime})", line, place=self.touching)
        arc = draft.draw(o.stepped_off, f"s{prime}_{{{self.index}}}", line, carried)
        return Side(body.link.number, points, stood, carried, x, y, line, tangent, arc)


def _refuse(says: Said, key: str = "link") -> StructureError:
    return StructureError(says, f"{CENTRODES}.{key}", head=CENTRODES)


def _refuse_none(link: Link, on: Link) -> None:
    """Refuse a link whose centre is one point, or always at infinity; one that has no two points."""
    shared = next((one for one in link.points if one in on.points), None)
    if shared is not None:
        says = said(
            "link {number} turns about {letter} of link {on}: both its centrodes are that point",
            number=link.number,
            letter=shared,
            on=on.number,
        )
        raise _refuse(says)
    if any(slide.on == b.number for a, b in ((link, on), (on, link)) for slide in a.slides):
        says = said(
            "link {number} slides straight on link {on}: its instantaneous centre is always at infinity",
            number=link.number,
            on=on.number,
        )
        raise _refuse(says)
    for one in (link, on):
        if (len(one.points) < 2 and on.number != one.number) or not one.points:
            says = said(
                "link {number} has one point, a centrode is carried with two: give it another in points",
                number=one.number,
            )
            raise _refuse(says)


def _place(names: tuple[str, ...], at: str) -> int:
    """Return the index of the position in which both centrodes touch."""
    if at not in names:
        says = said(
            "there is no position {missing}; there are {known}", missing=at, known=", ".join(names)
        )
        raise _refuse(says, "at")
    return names.index(at)


PLAN = Plan(needs=needs, record=record)
