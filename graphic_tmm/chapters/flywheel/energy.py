"""The kinetic energy of the links by the velocity plan, and the energy–mass curve (Wittenbauer)."""

from __future__ import annotations

from dataclasses import dataclass
from operator import attrgetter
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes
from graphic_tmm.board.operations.energetics import (
    added,
    flattest,
    flywheel_inertia,
    reduced_inertia,
    rotation,
    steepest,
    translation,
)
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.graph_curves import curve_of_two
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, ray, square
from graphic_tmm.board.operations.supports import supporting, supporting_curve
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.flywheel import words as why
from graphic_tmm.chapters.flywheel.task import ENERGY_MASS as VIEW
from graphic_tmm.chapters.flywheel.task import FLYWHEEL
from graphic_tmm.chapters.kinematics.motion import Motion, reading_of
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.masses import inertia_of, mass_centre
from graphic_tmm.mechanism.records import Link, Mechanism


class Energies(NamedTuple):
    """The parts of the energy by name, T_{2t} of translation and T_{2r} of rotation (J), and their sum."""

    parts: dict[str, Mark]
    total: Mark


def draw_energies(
    draft: Draft, mechanism: Mechanism, velocities: Motion, section: str = FLYWHEEL
) -> Energies:
    """Calculate the energies of all links that have a mass or a moment of inertia, in the open view.

    Raises
    ------
    StructureError
        If no link has any, or a mass has no centre on the plan.
    """
    parts: dict[str, Mark] = {}
    for link in sorted(mechanism.links, key=attrgetter("number")):
        parts |= _of_link(draft, mechanism, link, velocities)
    if not parts:
        raise StructureError(
            said("no link has a mass or J: write mass and J of the links that have them"),
            section,
            head=section,
        )
    total: Mark | None = None
    for part in parts.values():
        total = (
            part
            if total is None
            else draft.draw(
                added, "T_{L}", total, part, unit="J", role=roles.SUM, why=why.LINKS_ENERGY
            )
        )
    assert total is not None
    return Energies(parts, total)


def _of_link(draft: Draft, mechanism: Mechanism, link: Link, velocities: Motion) -> dict[str, Mark]:
    n, found = link.number, {}
    if link.mass:
        segment = _speed(draft, mechanism, link, velocities)
        if segment is not None:
            mass = draft.take(Number, f"m_{n}", link.mass, "kg")
            found[f"T_{{{n}t}}"] = draft.draw(translation, f"T_{{{n}t}}", mass, segment, unit="J")
    rate = velocities.rates.get(n)
    if link.inertia and rate is not None:
        inertia = inertia_of(draft, link)
        found[f"T_{{{n}r}}"] = draft.draw(rotation, f"T_{{{n}r}}", inertia, rate, unit="J")
    return found


def _speed(draft: Draft, mechanism: Mechanism, link: Link, velocities: Motion) -> Mark | None:
    """Return the reading of the velocity of a link's mass centre; None where the centre stands still."""
    images = velocities.images.by_letter.get(link.number, {})
    image = images.get(mass_centre(mechanism, link))
    return None if image is None else reading_of(draft, velocities, image)


class Surplus(NamedTuple):
    """ΔT as it was drawn over the crank's angle: its axes, its curve."""

    axes: Axes
    curve: Mark


@dataclass(frozen=True)
class EnergyMass:
    """The curve as drawn: its chart (μ_J), points, curve, tangents, the segment ab, the inertia found.

    ``angles``: of the tangents (Angle).
    """

    chart: Chart
    mu_T: Mark
    points: Mark
    curve: Mark
    tangents: tuple[Mark, Mark]
    angles: tuple[Mark, Mark]
    ends: tuple[Mark, Mark]
    segment: Mark
    inertia: Mark


def draw_energy_mass(
    draft: Draft,
    energies: Energies,
    surplus: Mark,
    source: Surplus,
    delta: Mark,
    omega: Mark,
    tangents: str,
) -> EnergyMass:
    """Draw the curve and its tangents; ``tangents``: at the "points", or at the "curve" through them.

    ``surplus``: ΔT as read (Length), to the scale of its graph ``source``.
    """
    row, mu_T = source.axes.base.intervals, source.axes.mu
    draft.open(VIEW)
    mu_J = draft.scale("μ_J", "(kg·m²)/mm")
    draft.lay_out()
    inertia = draft.draw(reduced_inertia, "J_{red}", energies.total, omega, unit="kg·m²")
    x = draft.draw(to_board, "x_J", inertia)
    origin = draft.take(Point, "O", 0j)
    along = draft.draw(ray, "(Ox)", origin, draft.direction(0.0))
    up = draft.draw(square, "(Oy)", origin, along, sense=1)
    feet = draft.draw(lay_off, "j", along, x, why=why.JT_POINT)
    lines = draft.draw(square, "(j)", feet, along, sense=1, why=why.JT_POINT)
    points = draft.draw(lay_off, "e", lines, surplus, why=why.JT_POINT)
    curve = draft.draw(curve_of_two, "(e–e)", points, source.curve, row=row)
    lines_found, angles, ends = [], [], []
    for op, name, letter, above in ((steepest, "max", "a", 1), (flattest, "min", "b", -1)):
        angle = draft.draw(op, f"ψ_{{{name}}}", mu_J, mu_T, omega, delta, unit="°")
        if tangents == "curve":
            line = draft.draw(supporting_curve, f"({letter})", curve, angle, above=above)
        else:
            line = draft.draw(supporting, f"({letter})", points, angle, row=row, above=above)
        lines_found.append(line)
        angles.append(angle)
        ends.append(draft.draw(meet, letter, up, line, why=why.JT_CUT))
    segment = draft.draw(measure_along, "ab", ends[1], ends[0], up, why=why.JT_CUT)
    found = draft.draw(flywheel_inertia, "J_F′", segment, mu_T, delta, omega, unit="kg·m²")
    measured = draft.draw(measure_along, "J_r", origin, feet, along)
    chart = Chart(VIEW, "J", "kg·m²", mu_J, (measured,), True, None, None)
    pair, spots = (lines_found[0], lines_found[1]), (ends[0], ends[1])
    turned = (angles[0], angles[1])
    return EnergyMass(chart, mu_T, points, curve, pair, turned, spots, segment, found)
