"""The masses of a crank mechanism: the rod's shared between its pins, the two-term series of the rest."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, measure_along, parallel
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.engine import words as why
from graphic_tmm.chapters.engine.formulas import (
    crank_ratio,
    doubled,
    first_order,
    lumped_inertia,
    mass_of_share,
    per_mass,
    projected,
    rest_of,
    second_order,
    split_by_lever,
)
from graphic_tmm.chapters.engine.task import HARMONICS as VIEW
from graphic_tmm.chapters.engine.task import EngineTask
from graphic_tmm.chapters.indicator.plan import Machine
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.masses import inertia_of
from graphic_tmm.mechanism.records import Link


class Legs(Protocol):
    """The rod's leg and the slider's."""

    @property
    def rod(self) -> PinLeg:
        """The leg of the rod."""

    @property
    def slider(self) -> GuideLeg:
        """The leg of the slider."""


class Lumped(NamedTuple):
    """The mass that goes to and fro (kg); the rod's masses at crank pin and crosshead, J before and after.

    ``inertia``: of the two masses about the rod's mass centre; ``lost``: by how much it exceeds the rod's own;
    None where the rod's mass, centre or J is not given.
    """

    mass: Mark
    at_crank: Mark | None = None
    at_slider: Mark | None = None
    inertia: Mark | None = None
    lost: Mark | None = None


def lump(draft: Draft, rod: Link, legs: Legs, machine: Machine, order: EngineTask) -> Lumped:
    """Share the rod's mass and add up what goes to and fro.

    Raises
    ------
    StructureError
        If there is neither a mass given nor masses of rod and slider.
    """
    slider = machine.mechanism.by_number[legs.slider.link]
    parts = _parts(draft, rod, legs, order)
    if order.mass is not None:
        whole = draft.take(Number, "m", order.mass, "kg")
    elif slider.mass is None or parts is None:
        raise StructureError(
            said(
                "links {rod} and {slider} need a mass, and the rod a share or its centre: give "
                "them, or the mass that goes to and fro",
                rod=rod.number,
                slider=slider.number,
            ),
            f"link {rod.number}, mass",
            f"link {slider.number}, mass",
            "engine.share",
            head="engine",
        )
    else:
        own = draft.take(Number, f"m_{slider.number}", slider.mass, "kg")
        whole = draft.draw(added, "m", own, parts[1], unit="kg")
    if parts is None:
        return Lumped(whole)
    inertia = lost = None
    arms = _arms(draft, rod, legs.rod.letter, order.point)
    if arms is not None and rod.inertia is not None:
        first, second = arms
        inertia = draft.draw(lumped_inertia, "J′", parts[0], first, parts[1], second, unit="kg·m²")
        own = inertia_of(draft, rod)
        lost = draft.draw(rest_of, "ΔJ", inertia, own, unit="kg·m²")
    return Lumped(whole, *parts, inertia, lost)


def _parts(draft: Draft, rod: Link, legs: Legs, order: EngineTask) -> tuple[Mark, Mark] | None:
    """Return the rod's masses at the crank pin and at the crosshead."""
    if rod.mass is None:
        return None
    mass = draft.take(Number, f"m_{rod.number}", rod.mass, "kg")
    if order.share is not None:
        share = draft.take(Number, "k", order.share)
        at_slider = draft.draw(mass_of_share, f"m_{{{rod.number}B}}", mass, share, unit="kg")
    else:
        arms = _arms(draft, rod, legs.rod.letter, order.point)
        if arms is None:
            return None
        length = draft.uses(legs.rod.length)[0]
        at_slider = draft.draw(
            split_by_lever, f"m_{{{rod.number}B}}", mass, arms[0], length, unit="kg"
        )
    at_crank = draft.draw(rest_of, f"m_{{{rod.number}A}}", mass, at_slider, unit="kg")
    return at_crank, at_slider


def _arms(draft: Draft, rod: Link, pin: str, crosshead: str) -> tuple[Mark, Mark] | None:
    """Return how far the crank pin and the crosshead are from the rod's mass centre, m."""
    if rod.centre is None or rod.centre not in rod.points:
        return None
    centre = rod.points[rod.centre]
    first, second = (
        draft.take(Number, letter, abs(rod.points[end] - centre), "m")
        for letter, end in ((f"l_{{A{rod.centre}}}", pin), (f"l_{{{rod.centre}B}}", crosshead))
    )
    return first, second


class Harmonics(NamedTuple):
    """Both orders and their sum (force unit), the acceleration of the series (m/s²); what was drawn of them.

    ``ends``: of the two rotating vectors; ``axis``: the direction from the crank to the cover.
    """

    first: Mark
    second: Mark
    force: Mark
    acceleration: Mark
    origin: Mark
    ends: tuple[Mark, Mark]
    axis: Mark
    mu: Mark


def draw_harmonics(
    draft: Draft,
    machine: Machine,
    mass: Mark,
    legs: Legs,
    outward: float,
    told: Callable[[str, Mark], Mark],
) -> Harmonics:
    """Draw the rotating vectors; ``told`` brings a force (N) to the unit of the task."""
    speed = machine.velocities.speed
    assert speed is not None
    draft.open(VIEW)
    rod = draft.uses(legs.rod.length)[0]
    ratio = draft.draw(crank_ratio, "λ", machine.arm, rod)
    size = draft.draw(first_order, "m·ω²·R", mass, speed, machine.arm, unit="N")
    half = draft.draw(second_order, "m·ω²·R·λ", size, ratio, unit="N")
    mu = draft.scale("μ_F", "N/mm")
    origin = draft.take(Point, "O", 0j)
    draft.lay_out(origin)
    crank = machine.positions.bodies[machine.mechanism.drive.link].axis
    axis = draft.draw(
        parallel, "(Ox)", origin, legs.slider.line, sense=1 if outward > 0 else -1, why=why.AXIS
    )
    once = draft.draw(parallel, "(I)", origin, crank, sense=1, why=why.ONCE)
    twice = draft.draw(doubled, "(II)", origin, axis, once)
    ends, forces = [], []
    for k, (name, line, force) in enumerate((("I", once, size), ("II", twice, half)), 1):
        length = draft.draw(to_board, f"y_{name}", force)
        end = draft.draw(lay_off, name, line, length, why=why.PROJECTED)
        segment = draft.draw(measure_along, f"x_{name}", origin, end, axis, why=why.PROJECTED)
        forces.append(draft.draw(projected, f"P_{{in{k}}}", segment, unit="N"))
        ends.append(end)
    total = draft.draw(added, "P_{inΣ}", *forces, unit="N", why=why.BOTH_ORDERS)
    acceleration = draft.draw(per_mass, "a_{Σ}", total, mass, unit="m/s²")
    first, second = (
        told(f"P_{{in{name}}}", force) for name, force in zip(("1", "2"), forces, strict=True)
    )
    whole = told("P_{in,ser}", total)
    return Harmonics(first, second, whole, acceleration, origin, (ends[0], ends[1]), axis, mu)
