"""The loads of the links: weights, inertia forces and couples, gas, given forces and moments.

Each force gets a line of action on the plan of positions, through its point of application; its size is signed
along it. Nothing is drawn of an effect that is not called for.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from operator import attrgetter

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import lay_off, parallel, ray, square
from graphic_tmm.board.operations.statics import (
    action,
    inertia_couple,
    inertia_force,
    inertia_force_along,
    offset,
    reversed_,
    weight,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.given_loads import given_load
from graphic_tmm.chapters.forces.loads import VIEW, Couple, Force, Ground, Loads, point_of
from graphic_tmm.chapters.forces.springs import draw_spring, numbers
from graphic_tmm.chapters.forces.task import ForcesTask
from graphic_tmm.chapters.indicator.diagram import letter_of
from graphic_tmm.chapters.indicator.plan import Cylinder
from graphic_tmm.chapters.kinematics.motion import Motion, is_signed, reading_of
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.masses import inertia_of, mass_centre
from graphic_tmm.mechanism.records import Link


def draw_loads(ground: Ground, order: ForcesTask, gas: Cylinder | None) -> Loads:
    """Calculate the loads and draw their lines of action.

    ``gas``: the cylinders whose gas pushes the pistons.

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
            for one in given_load(ground, load, loads):
                loads.add(one)
        except StructureError as error:
            raise error.inside(f"load {k}") from None
    _springs(ground, order, loads)
    for cylinder in gas.every if gas is not None else ():
        for one in _gas(ground, cylinder):
            loads.add(one)
    return loads


def _springs(ground: Ground, order: ForcesTask, loads: Loads) -> None:
    for k, index in enumerate(numbers(order.springs)):
        spring = order.springs[k]
        if ground.velocities.possible:  # its ends stand: a damper bears nothing
            spring = replace(spring, damping=None)
        if spring.rate is None and spring.damping is None and not spring.force:
            continue
        try:
            sprung, pulls = draw_spring(ground, spring, index)
        except StructureError as error:
            raise error.inside(f"spring {k + 1}") from None
        loads.springs.append(sprung)
        for one in pulls:
            loads.add(one)


def _weight(ground: Ground, link: Link, gravity: float) -> Force:
    draft, n = ground.draft, link.number
    point, image = point_of(ground, n, mass_centre(ground.mechanism, link))
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
    point, image = point_of(ground, n, centre)
    end = plan.images.by_letter[n][centre]
    assert link.mass is not None
    mass, letter = draft.constant(f"m_{n}", link.mass, "kg"), f"P_{{i{n}}}"
    drawn = inertia_force_at(draft, plan, letter, mass, point, end)
    if drawn is None:
        return None
    value, line = drawn
    return Force(letter, n, point, line, value, image)


def inertia_force_at(
    draft: Draft, plan: Motion, letter: str, mass: Mark, point: Mark, end: Mark
) -> tuple[Mark, Mark] | None:
    """Return the inertia force of a mass at a point, N, and its line of action; None where it never moves.

    ``end``: the image of the point on the plan of accelerations.
    """
    segment = reading_of(draft, plan, end)
    if segment is None:
        return None
    op = inertia_force_along if is_signed(draft, segment) else inertia_force
    value = draft.draw(op, letter, mass, segment, unit="N", role=roles.INERTIA)
    ends = (point, end, plan.images.pole)
    line = draft.draw(action, f"({letter})", *ends, role=roles.INERTIA, why=why.INERTIA_LINE)
    return value, line


def _gas(ground: Ground, cylinder: Cylinder) -> Iterator[Force]:
    """Draw the force of the gas on the piston, along its guide from the cover towards the crank.

    A cylinder that swings is pushed as much the other way, at its pin.
    """
    draft, letter, link = ground.draft, cylinder.indicator.order.point, cylinder.leg.link
    point, image = point_of(ground, link, letter)
    sense = -1 if cylinder.outward > 0 else 1
    name, value = letter_of("P", cylinder.tag), cylinder.indicator.force
    line = draft.draw(
        parallel, f"({name})", point, cylinder.leg.line, sense=sense, why=why.GAS_LINE
    )
    yield Force(name, link, point, line, value, image)
    if cylinder.swings is not None:
        own = cylinder.swings
        pin, image = point_of(ground, own.link, own.letter)
        back = f"P′_{{{cylinder.tag}}}" if cylinder.tag else "P′"
        across = draft.draw(parallel, f"({back})", pin, line, sense=1, why=why.BOTTOM_LINE)
        reverse = draft.draw(reversed_, back, value, unit="N")
        yield Force(back, own.link, pin, across, reverse, image)
