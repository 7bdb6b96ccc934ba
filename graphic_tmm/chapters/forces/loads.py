"""The loads of the links: weights, inertia forces and couples, gas, given forces and moments.

Each force gets a line of action on the plan of positions, through its point of application; its size is signed
along it. Nothing is drawn of an effect that is not called for.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import count
from operator import attrgetter
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import lay_off, parallel, ray, square
from graphic_tmm.board.operations.statics import (
    action,
    against_turning,
    inertia_couple,
    inertia_force,
    inertia_force_along,
    offset,
    weight,
    with_motion,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.directions import draw_along
from graphic_tmm.chapters.forces.kinds import Along
from graphic_tmm.chapters.forces.task import AGAINST, TURN, ForcesTask, Load
from graphic_tmm.chapters.forces.travel import by_travel, size_at_turn
from graphic_tmm.chapters.indicator.plan import Cylinder
from graphic_tmm.chapters.kinematics.motion import Motion, is_signed, reading_of
from graphic_tmm.chapters.kinematics.positions import Positions
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.masses import inertia_of, mass_centre
from graphic_tmm.mechanism.records import Link, Mechanism

VIEW = "loads"


class Force(NamedTuple):
    """A force on a link: its letter, its point of application, line of action, size (N, signed along it).

    ``image``: of the point, as a point of that link, on the plan of velocities.
    """

    letter: str
    link: int
    point: Mark
    line: Mark
    value: Mark
    image: Mark | None = None


class Couple(NamedTuple):
    """A couple on a link: its letter, its moment (N·m, counter-clockwise positive).

    ``rubs``: of friction, the letter of its pair and the link on the other side of it.
    """

    letter: str
    link: int
    value: Mark
    rubs: tuple[str, int] | None = None


@dataclass
class Loads:
    """What acts on the links: as kinetostatics takes it, and as it is carried onto the lever.

    They differ where an inertia force and couple are replaced by one force. ``given``: the sizes of the loads
    that the scene gives, in their order.
    """

    forces: list[Force] = field(default_factory=list)
    couples: list[Couple] = field(default_factory=list)
    on_lever: list[Force] = field(default_factory=list)
    couples_on_lever: list[Couple] = field(default_factory=list)
    given: list[Mark] = field(default_factory=list)

    @property
    def outer(self) -> tuple[Mark, ...]:
        """The sizes of the loads that are not inertia's."""
        sizes = [force.value for force in self.on_lever]
        sizes += [couple.value for couple in self.couples_on_lever]
        return tuple(size for size in sizes if size.role != roles.INERTIA)

    def add(self, load: Force | Couple) -> None:
        """Enter a load that both methods take alike."""
        if isinstance(load, Force):
            self.forces.append(load)
            self.on_lever.append(load)
        else:
            self.couples.append(load)
            self.couples_on_lever.append(load)


@dataclass
class Acting:
    """What acts on the links while groups are solved one after another: loads, then reactions handed on."""

    forces: dict[int, list[Force]] = field(default_factory=dict)
    couples: dict[int, list[Couple]] = field(default_factory=dict)

    def add(self, load: Force | Couple) -> None:
        """Enter a load."""
        if isinstance(load, Force):
            self.forces.setdefault(load.link, []).append(load)
        else:
            self.couples.setdefault(load.link, []).append(load)


class Ground(NamedTuple):
    """What loads are drawn on: the board, the mechanism, its plans, how the velocity plan is turned.

    ``quarters``: right angles by which a vector of the velocity plan is turned into its true direction.
    ``survey``: the mechanism at any angles. ``numbers``: where each position stands in the row, which has so
    many ``turns`` of so many ``intervals``.
    """

    draft: Draft
    mechanism: Mechanism
    positions: Positions
    velocities: Motion
    accelerations: Motion | None
    quarters: int
    pin_speed: Mark
    survey: Survey
    numbers: np.ndarray
    intervals: int
    turns: int = 1


def draw_loads(ground: Ground, order: ForcesTask, gas: Cylinder | None) -> Loads:
    """Calculate the loads and draw their lines of action.

    ``gas``: the cylinder whose gas pushes the piston.

    Raises
    ------
    StructureError
        If a load names a link or point that is not there, or a mass has no centre.
    """
    ground.draft.open(VIEW)
    loads = Loads()
    for link in sorted(ground.mechanism.links, key=attrgetter("number")):
        if order.gravity and link.mass:
            loads.add(_weight(ground, link, order.g))
        if order.inertia:
            _inertia(ground, link, loads, single=link.number in order.single)
    for k, load in enumerate(order.loads, 1):
        try:
            loads.add(_given(ground, load, loads))
        except StructureError as error:
            raise error.inside(f"load {k}") from None
    if gas is not None:
        loads.add(_gas(ground, gas))
    return loads


def _at(ground: Ground, link: int, letter: str) -> tuple[Mark, Mark]:
    """Return a link's point on the plan of positions, and its image on that of velocities."""
    body = ground.positions.bodies[link]
    return body.marks[letter], ground.velocities.images.by_letter[link][letter]


def _weight(ground: Ground, link: Link, gravity: float) -> Force:
    draft, n = ground.draft, link.number
    point, image = _at(ground, n, mass_centre(ground.mechanism, link))
    assert link.mass is not None
    mass, g = draft.constant(f"m_{n}", link.mass, "kg"), draft.constant("g", gravity, "m/s²")
    value = draft.draw(weight, f"G_{n}", mass, g, unit="N")
    line = draft.draw(ray, f"(G_{n})", point, draft.direction(-90.0), why=why.WEIGHT)
    return Force(f"G_{n}", n, point, line, value, image)


def _inertia(ground: Ground, link: Link, loads: Loads, *, single: bool) -> None:
    plan = ground.accelerations
    assert plan is not None, "inertia needs the plan of accelerations"
    draft, n = ground.draft, link.number
    force = _inertia_force(ground, plan, link) if link.mass else None
    couple = None
    if link.inertia and n in plan.rates:
        inertia = inertia_of(draft, link)
        letter = f"M_{{i{n}}}"
        value = draft.draw(
            inertia_couple, letter, inertia, plan.rates[n], unit="N·m", role=roles.INERTIA
        )
        couple = Couple(letter, n, value)
    if not (single and force is not None and couple is not None):
        for load in (force, couple):
            if load is not None:
                loads.add(load)
        return
    loads.on_lever.append(force)
    loads.couples_on_lever.append(couple)
    by = draft.draw(offset, f"h_{{i{n}}}", couple.value, force.value)
    across = draft.draw(
        square, f"(h_{{i{n}}})", force.point, force.line, sense=1, why=why.SINGLE_ACROSS
    )
    point = draft.draw(lay_off, f"T{n}", across, by, free=True, why=why.SINGLE_AT)
    line = draft.draw(
        parallel, f"({force.letter}′)", point, force.line, sense=1, why=why.SINGLE_LINE
    )
    loads.forces.append(force._replace(point=point, line=line, image=None))


def _inertia_force(ground: Ground, plan: Motion, link: Link) -> Force | None:
    draft, n = ground.draft, link.number
    centre = mass_centre(ground.mechanism, link)
    point, image = _at(ground, n, centre)
    end = plan.images.by_letter[n][centre]
    segment = reading_of(draft, plan, end)
    if segment is None:
        return None
    assert link.mass is not None
    mass = draft.constant(f"m_{n}", link.mass, "kg")
    formula = inertia_force_along if is_signed(draft, segment) else inertia_force
    letter = f"P_{{i{n}}}"
    value = draft.draw(formula, letter, mass, segment, unit="N", role=roles.INERTIA)
    line = draft.draw(
        action,
        f"({letter})",
        point,
        end,
        plan.images.pole,
        role=roles.INERTIA,
        why=why.INERTIA_LINE,
    )
    return Force(letter, n, point, line, value, image)


def _gas(ground: Ground, cylinder: Cylinder) -> Force:
    """Draw the force of the gas on the piston: along its guide, from the cover towards the crank."""
    letter, link = cylinder.indicator.order.point, cylinder.leg.link
    point, image = _at(ground, link, letter)
    sense = -1 if cylinder.outward > 0 else 1
    line = ground.draft.draw(
        parallel, "(P)", point, cylinder.leg.line, sense=sense, why=why.GAS_LINE
    )
    return Force("P", link, point, line, cylinder.indicator.force, image)


def _given(ground: Ground, load: Load, loads: Loads) -> Force | Couple:
    links = ground.mechanism.by_number
    if load.link not in links or load.link == ground.mechanism.frame.number:
        raise StructureError(
            said("there is no moving link {link}", link=load.link), "link", head="load"
        )
    if load.point is None:
        return _moment(ground, load, loads)
    if load.point not in links[load.link].points:
        known = ", ".join(links[load.link].points)
        raise StructureError(
            said(
                "load on link {link}: it has no point {point}; its points are {known}",
                link=load.link,
                point=load.point,
                known=known,
            ),
            "point",
        )
    draft = ground.draft
    point, image = _at(ground, load.link, load.point)
    letter = _letter(ground, "F", load.link)
    if load.direction != AGAINST:
        size = _size(ground, load, letter, "N", loads)
        line = _line(ground, load.direction, point, letter)
        return Force(letter, load.link, point, line, size, image)
    reading = reading_of(draft, ground.velocities, image)
    if reading is None:
        raise StructureError(
            said(
                "load on link {link}: {point} does not move: give the direction as an angle",
                link=load.link,
                point=load.point,
            ),
            "direction",
        )
    size = _size(ground, load, f"|{letter}|", "N", loads)
    line = _against(ground, letter, point, image, reading)
    value = draft.draw(with_motion, letter, size, reading, ground.pin_speed, unit="N")
    return Force(letter, load.link, point, line, value, image)


def _line(ground: Ground, direction: float | str | Along, point: Mark, letter: str) -> Mark:
    """Draw the line of action of a load, in a direction fixed in the sheet or in one that turns with a link."""
    draft = ground.draft
    if isinstance(direction, Along):
        return draw_along(draft, ground.positions, ground.mechanism, direction, point, letter)
    degrees = draft.direction(float(direction))
    return draft.draw(ray, f"({letter})", point, degrees, why=why.GIVEN_LINE)


def _letter(ground: Ground, symbol: str, link: int) -> str:
    """Return the letter of a given load: F_5; a second one on its link is F_{5(2)}."""
    draft, letter = ground.draft, f"{symbol}_{link}"
    for k in count(2):
        if draft.board.free(letter) == letter:
            break
        letter = f"{symbol}_{{{link}({k})}}"
    return letter


def _against(ground: Ground, letter: str, point: Mark, image: Mark, reading: Mark) -> Mark:
    """Draw the line of action against a velocity; where that was read along a line, against its sense."""
    draft, turns, because = ground.draft, ground.quarters, why.AGAINST_VELOCITY
    if not is_signed(ground.draft, reading):
        pole = ground.velocities.images.pole
        return draft.draw(action, f"({letter})", point, image, pole, quarters=turns, why=because)
    along = draft.uses(reading)[2]
    if turns == 0:
        return draft.draw(parallel, f"({letter})", point, along, sense=-1, why=because)
    return draft.draw(square, f"({letter})", point, along, sense=-turns, why=because)


def _moment(ground: Ground, load: Load, loads: Loads) -> Couple:
    draft, plan = ground.draft, ground.velocities
    letter = _letter(ground, "M", load.link)
    if load.direction != AGAINST:
        return Couple(letter, load.link, _size(ground, load, letter, "N·m", loads))
    rate = plan.rates.get(load.link)
    if rate is None:
        raise StructureError(
            said(
                "load on link {link}: it does not turn: leave the moment's direction out",
                link=load.link,
            ),
            "direction",
        )
    size = _size(ground, load, f"|{letter}|", "N·m", loads)
    fastest = plan.rates[ground.mechanism.drive.link]
    value = draft.draw(against_turning, letter, size, rate, fastest, unit="N·m")
    return Couple(letter, load.link, value)


def _size(ground: Ground, load: Load, letter: str, unit: str, loads: Loads) -> Mark:
    """Take the size of a load: constant, by position, by angle; or find it by a travel. Note it."""
    found = _sized(ground, load, letter, unit)
    loads.given.append(found)
    return found


def _sized(ground: Ground, load: Load, letter: str, unit: str) -> Mark:
    draft, intervals = ground.draft, ground.intervals
    if load.travel is not None:
        return by_travel(draft, ground, load.travel, ground.numbers.size, (letter, unit))
    value: object = load.size
    if load.by_angle:
        value = size_at_turn(load.by_angle, ground.numbers * (TURN / intervals))[None, :]
    elif isinstance(load.size, tuple):
        if len(load.size) != intervals:
            raise StructureError(
                said(
                    "load on link {link}: {n} sizes for {count} positions: give one for each",
                    link=load.link,
                    n=len(load.size),
                    count=intervals,
                ),
                "by_position",
            )
        row = [*load.size] * ground.turns
        value = np.array([*row, *[np.nan] * (ground.numbers.size - len(row))])[None, :]
    return draft.take(Number, letter, value, unit)
