"""Replacing masses: the masses of links put into their pins, and the counterweights that follow from them.

From the last group to the crank: what a link bears, its own mass and those put into its pins by links that hang
on it, is either put into its two pins (a coupler), or a counterweight draws the centre of it all to the pin
about which the link turns (a rocker, a rod; at last the crank). A mass whose centre stands off the line of the
pins is replaced by two whose static moments are turned by the angles at the pins: S = A + z·(B − A) with a
complex z, so that z·m at B and (1 − z)·m at A give m·S in every position.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.balance import operations as f
from graphic_tmm.chapters.balance.counterweights import Arm, arms_of
from graphic_tmm.chapters.balance.task import (
    BALANCE,
    FULL,
    HALF,
    MASSES,
    UNBALANCE,
    BalanceTask,
    Counterweight,
)
from graphic_tmm.chapters.kinematics.closings import (
    Closing,
    GuideLeg,
    PinLeg,
    dyads,
)
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.plan import KinematicPlans
from graphic_tmm.chapters.rotors import formulas as rotors
from graphic_tmm.chapters.rotors.polygon import Polygon, Vector, draw_polygon, turned
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.masses import mass_centre
from graphic_tmm.mechanism.records import Link
from graphic_tmm.project import Bench

SAME_PLACE = 1e-9
"""Places of a link nearer than this share of its length are one."""


class Borne(NamedTuple):
    """A mass that a link bears at one of its letters: of what, as drawn and exactly (kg).

    ``turned``: by how much its static moment is turned, degrees.
    """

    tag: str
    mass: Mark
    exact: float
    at: str
    turned: float = 0.0


class Unbalance(NamedTuple):
    """The static moments of what a link bears about its pin, as a polygon.

    ``held``: mass (kg), radius (m) and angle from the link's axis of the counterweight that closes it; None
    where it closes by itself.
    """

    link: int
    polygon: Polygon
    held: tuple[Mark, Mark, Mark] | None


@dataclass
class _Work:
    """What is borne by whom while masses are replaced, and the counterweights found so far."""

    bench: Bench
    plans: KinematicPlans
    order: BalanceTask
    arms: dict[int, Arm]
    borne: dict[int, list[Borne]] = field(default_factory=dict)
    found: list[Unbalance] = field(default_factory=list)

    def points(self, link: int) -> dict[str, complex]:
        """Return the points of a link in its own axes, m."""
        return dict(self.plans.mechanism.by_number[link].points)

    def put(self, link: int, one: Borne) -> None:
        """Let a link bear a mass; what the frame bears is at rest."""
        if link != self.plans.mechanism.frame.number:
            self.borne.setdefault(link, []).append(one)

    def known(self, letter: str, value: float, unit: str) -> Mark:
        """Take a given number, once in a view."""
        return self.bench.draft.constant(letter, value, unit)


def replace_masses(
    bench: Bench, plans: KinematicPlans, order: BalanceTask
) -> tuple[Unbalance, ...]:
    """Replace the masses of all links, draw the static moments, and find the counterweights by the method.

    Raises
    ------
    StructureError
        If the mechanism is not of turning pairs and of sliders on the frame alone, or a counterweight is asked
        for on a link that needs none.
    """
    _refuse(plans)
    work = _Work(bench, plans, order, arms_of(plans))
    for link in plans.mechanism.links:
        if link.mass:
            work.put(link.number, _own(work, link))
    for closing in reversed(tuple(dyads(plans.positions.closings, BALANCE))):
        _group(work, closing)
    crank = next(pair.link for pair in plans.pairs if isinstance(pair, Crank))
    _balanced(work, crank)
    links = {one.link for one in work.found}
    for one in order.counterweights:
        if one.link not in links:
            says = said(
                "by this method link {link} bears no counterweight; the links that do: {links}",
                link=one.link,
                links=", ".join(map(str, sorted(links))),
            )
            raise StructureError(says, "counterweight.link", head=BALANCE)
    return tuple(work.found)


def _own(work: _Work, link: Link) -> Borne:
    work.bench.draft.open(MASSES)
    assert link.mass is not None
    mass = work.known(f"m_{link.number}", link.mass, "kg")
    return Borne(str(link.number), mass, link.mass, mass_centre(work.plans.mechanism, link))


def _refuse(plans: KinematicPlans) -> None:
    """Refuse wheels, passive links, cylinders: no masses at pins replace what they bear."""
    positions = plans.positions
    others = [one.leg.link for one in positions.wheels] + [one.link for one in positions.passive]
    others += [rod for closing in positions.closings for rod in closing.group.rods]
    if others:
        _refuse_link(others[0])


def _refuse_link(link: int) -> None:
    says = said(
        "replacing masses are found of links with turning pairs and of sliders on the frame; link {link} moves "
        "otherwise: give its mechanism [[counterweight]] with mass and radius, and leave method out",
        link=link,
    )
    raise StructureError(says, "balance.method", head=BALANCE)


def _group(work: _Work, closing: Closing) -> None:
    """Put what both links of a group bear into the pins by which it hangs on the others."""
    first, second = closing.legs
    frame = work.plans.mechanism.frame.number
    if closing.group.kind == 1 and isinstance(first, PinLeg) and isinstance(second, PinLeg):
        coupler, rocker = (first, second) if first.body != frame else (second, first)
        _split(work, coupler, closing.letter, rocker.link)
        _drawn_to_pivot(work, rocker)
        return
    if closing.group.kind == 2 and isinstance(first, PinLeg) and isinstance(second, GuideLeg):
        if second.body != frame:
            _refuse_link(second.link)
        _slider(work, first, second.link, closing.letter)
        return
    if closing.group.kind == 3 and isinstance(second, PinLeg) and isinstance(first, GuideLeg):
        _stone(work, closing, first.link)
        _drawn_to_pivot(work, second)
        return
    _refuse_link(first.link if isinstance(first, GuideLeg) else closing.legs[1].link)


def _slider(work: _Work, leg: PinLeg, slider: int, pin: str) -> None:
    """Put a slider's mass into the pin of its rod: all its points go alike; then the rod's into its pins."""
    sliding = [one._replace(at=pin) for one in work.borne.pop(slider, [])]
    for one in sliding:
        work.put(leg.link, one)
    if work.order.method == FULL:
        _drawn_to_pivot(work, leg)
        return
    share = work.order.share if work.order.share is not None else HALF
    draft = work.bench.draft
    for one, outer in _in_two(work, leg.link, leg.letter, pin):
        if outer:
            work.put(leg.body, one)
        elif share > 0.0:
            draft.open(MASSES)
            part = work.known("k", share, "")
            mass = draft.draw(f.answered, f"m′_{{{one.tag}}}", one.mass, part, unit="kg")
            exact = share * one.exact
            work.put(leg.body, Borne(f"{one.tag}′", mass, exact, leg.letter, one.turned))


def _stone(work: _Work, closing: Closing, stone: int) -> None:
    """Put a stone's mass into the pin that it has on another link; it has to be there already."""
    pin = closing.letter
    points = work.points(stone)
    size = max(abs(one) for one in (*points.values(), *work.points(closing.legs[1].link).values()))
    for one in work.borne.pop(stone, []):
        if abs(points[one.at] - points[pin]) > SAME_PLACE * size:
            says = said(
                "link {link} slides on a link that turns: its mass is replaced only where its centre is its "
                'pin {pin}; write centre = "{pin}"',
                link=stone,
                pin=pin,
            )
            raise StructureError(says, f"link {stone}, centre", head=BALANCE)
        on = next(leg.body for leg in closing.group.legs if leg.link == stone)
        work.put(on, one._replace(at=pin))


def _split(work: _Work, leg: PinLeg, pin: str, rocker: int) -> None:
    """Put what a coupler bears into both its pins."""
    for one, outer in _in_two(work, leg.link, leg.letter, pin):
        work.put(leg.body if outer else rocker, one)


def _in_two(work: _Work, link: int, first: str, second: str) -> Iterator[tuple[Borne, bool]]:
    """Yield what a link bears as masses at two of its letters, each with whether it is at the first."""
    points, draft = work.points(link), work.bench.draft
    for one in work.borne.pop(link, []):
        place = points[one.at]
        for pin, other, outer in ((first, second, True), (second, first, False)):
            far, whole = place - points[other], points[pin] - points[other]
            if abs(place - points[pin]) <= SAME_PLACE * abs(whole):
                yield one._replace(at=pin), outer
                break
            if abs(far) <= SAME_PLACE * abs(whole):
                continue
            draft.open(MASSES)
            length = work.known(f"l_{{{first}{second}}}", abs(whole), "m")
            apart = work.known(f"l_{{{other}{one.at}}}", abs(far), "m")
            tag = f"{one.tag}{pin}"
            mass = draft.draw(f.at_pin, f"m_{{{tag}}}", one.mass, apart, length, unit="kg")
            exact, more = cmath.polar(far / whole)
            yield Borne(tag, mass, one.exact * exact, pin, one.turned + math.degrees(more)), outer


def _drawn_to_pivot(work: _Work, leg: PinLeg) -> None:
    """Balance a link about the pin by which it hangs: all that it bears is at this pin for the other link."""
    if work.order.method != FULL:
        work.borne.pop(leg.link, None)
        return
    borne = work.borne.get(leg.link, [])
    if (weight := _balanced(work, leg.link)) is not None:
        borne = [*borne, weight]
    for one in borne:
        work.put(leg.body, one._replace(at=leg.letter))


def _balanced(work: _Work, link: int) -> Borne | None:
    """Draw the static moments of what a link bears about its pin; return the counterweight that closes them."""
    points, arm, draft = work.points(link), work.arms[link], work.bench.draft
    pivot, body = points[arm.pivot], work.plans.positions.bodies[link]
    borne = [one for one in work.borne.pop(link, []) if abs(points[one.at] - pivot) > 0.0]
    draft.open(MASSES)
    vectors = []
    for one in borne:
        way = points[one.at] - pivot
        radius = work.known(f"l_{{{arm.pivot}{one.at}}}", abs(way), "m")
        letter, angle = f"D_{{{one.tag}}}", math.degrees(cmath.phase(way)) - body.angle + one.turned
        size = draft.draw(rotors.unbalance, letter, one.mass, radius, unit="kg·m")
        exact = turned(one.exact * abs(way), angle)
        vectors.append(Vector(letter, size, draft.direction(_near(angle)), exact))
    view, mu = f"{UNBALANCE} {link}", ("μ_D", "(kg·m)/mm")
    polygon = draw_polygon(draft, view, mu, vectors, f"D_{{c{link}}}")
    if polygon is None:
        return None
    if polygon.angle is None:
        work.found.append(Unbalance(link, polygon, None))
        return None
    mass, radius, exact = _sized(work, link, polygon)
    work.found.append(Unbalance(link, polygon, (mass, radius, polygon.angle)))
    return Borne(f"c{link}", mass, exact, arm.pivot)


def _near(degrees: float) -> float:
    """Return an angle within −180° … 180°, one of rounding alone as none."""
    found = math.remainder(round(degrees, 9), 360.0)
    return found + 0.0


def _sized(work: _Work, link: int, polygon: Polygon) -> tuple[Mark, Mark, float]:
    """Return mass and radius of a counterweight, its mass exactly: one is given, and the other follows.

    One that nothing is said of stands as far from the pivot as the pin does.
    """
    draft, arm, missing = work.bench.draft, work.arms[link], polygon.size
    one = next((one for one in work.order.counterweights if one.link == link), None)
    if one is None:
        if not arm.pin:
            says = said(
                "link {link} has no pin that the radius of its counterweight could be taken from: write "
                '[[counterweight]] with link = {link} and radius = "100 mm"',
                link=link,
            )
            raise StructureError(says, "counterweight", head=BALANCE)
        points = work.points(link)
        one = Counterweight(link, None, abs(points[arm.pin] - points[arm.pivot]))
    if one.mass is not None:
        mass = draft.take(Number, f"m_{{c{link}}}", one.mass, "kg")
        found = draft.draw(
            rotors.radius_of_counterweight, f"r_{{c{link}}}", missing, mass, unit="m"
        )
        return mass, found, one.mass
    assert one.radius is not None
    radius = draft.take(Number, f"r_{{c{link}}}", one.radius, "m")
    mass = draft.draw(rotors.mass_of_counterweight, f"m_{{c{link}}}", missing, radius, unit="kg")
    return mass, radius, abs(polygon.exact) / one.radius
