"""The energy–mass curve (Wittenbauer): ΔT over the reduced inertia of the links, two tangents, the inertia."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.graphs import Axes
from graphic_tmm.board.operations.energetics import (
    flattest,
    flywheel_inertia,
    reduced_inertia,
    steepest,
)
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.graph_curves import curve_of_two
from graphic_tmm.board.operations.instruments import lay_off, measure_along, meet, ray, square
from graphic_tmm.board.operations.supports import supporting, supporting_curve
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.flywheel import reasons as why
from graphic_tmm.chapters.flywheel.energy import Energies
from graphic_tmm.chapters.flywheel.names import ENERGY_MASS as VIEW


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
