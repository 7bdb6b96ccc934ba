"""The energy–mass curve (Wittenbauer): ΔT over the reduced inertia of the links, two tangents, the inertia."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.calculations import to_board
from graphic_tmm.board.curve import french_curve
from graphic_tmm.board.energetics import flattest, flywheel_inertia, reduced_inertia, steepest
from graphic_tmm.board.operations import lay_off, measure_along, meet, ray, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.supports import supporting, supporting_curve
from graphic_tmm.board.values import Number, Point
from graphic_tmm.plans.charts import Chart
from graphic_tmm.plans.draft import Draft
from graphic_tmm.plans.energy import Energies
from graphic_tmm.plans.graphs import Axes

VIEW = "energy-mass"
ROOM = 100.0
"""Room for the largest reduced inertia, mm."""


@dataclass(frozen=True)
class EnergyMass:
    """The curve as drawn: its chart (μ_J), points, curve, tangents, the segment ab, the inertia found."""

    chart: Chart
    mu_T: Mark
    points: Mark
    curve: Mark
    tangents: tuple[Mark, Mark]
    ends: tuple[Mark, Mark]
    segment: Mark
    inertia: Mark


def draw_energy_mass(
    draft: Draft,
    energies: Energies,
    surplus: Mark,
    source: Axes,
    delta: Mark,
    omega: Mark,
    tangents: str,
) -> EnergyMass:
    """Draw the curve and its tangents; ``tangents``: at the "points", or at the "curve" through them.

    ``surplus``: ΔT as read (Length), to the scale of ``source``.
    """
    board, row = draft.board, source.base.intervals
    board.open(VIEW)
    mu_J = board.take(Number, "μ_J", "(kg·m²)/mm")
    board.lay_out(None, mu_J)
    inertia = board.draw(reduced_inertia, "J_{red}", energies.total, omega, unit="kg·m²")
    x = board.draw(to_board, "x_J", inertia, mu_J)
    origin = draft.take(Point, "O", 0j)
    along = board.draw(ray, "(Ox)", origin, draft.direction(0.0))
    up = board.draw(square, "(Oy)", origin, along, sense=1)
    feet = board.draw(lay_off, "j", along, x)
    lines = board.draw(square, "(j)", feet, along, sense=1)
    points = board.draw(lay_off, "e", lines, surplus)
    curve = board.draw(french_curve, "(e–e)", points, row=row)
    lines_found, ends = [], []
    for op, name, letter, above in ((steepest, "max", "a", 1), (flattest, "min", "b", -1)):
        angle = board.draw(op, f"ψ_{{{name}}}", mu_J, source.mu, omega, delta, unit="°")
        if tangents == "curve":
            line = board.draw(supporting_curve, f"({letter})", curve, angle, above=above)
        else:
            line = board.draw(supporting, f"({letter})", points, angle, row=row, above=above)
        lines_found.append(line)
        ends.append(board.draw(meet, letter, up, line))
    segment = board.draw(measure_along, "ab", ends[1], ends[0], up)
    found = board.draw(flywheel_inertia, "J_F", segment, source.mu, delta, omega, unit="kg·m²")
    measured = board.draw(measure_along, "J_r", origin, feet, along)
    chart = Chart(VIEW, "J", "kg·m²", mu_J, (measured,), True, None, ROOM)
    pair, spots = (lines_found[0], lines_found[1]), (ends[0], ends[1])
    return EnergyMass(chart, source.mu, points, curve, pair, spots, segment, found)
