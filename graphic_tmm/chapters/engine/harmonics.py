"""The two-term series of the reciprocating masses: first and second order as projections of rotating vectors.

m·ω²·R turns with the crank, m·ω²·R·λ twice as fast; their projections on the guide, reversed, are the orders of
the inertia force. The exact slider-crank has more terms: both stand side by side.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import lay_off, measure_along, parallel
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.engine import reasons as why
from graphic_tmm.chapters.engine.formulas import (
    crank_ratio,
    doubled,
    first_order,
    per_mass,
    projected,
    second_order,
)
from graphic_tmm.chapters.engine.lumping import Legs
from graphic_tmm.chapters.engine.names import HARMONICS as VIEW
from graphic_tmm.chapters.indicator.cylinder import Machine


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
        parallel, "(x)", origin, legs.slider.line, sense=1 if outward > 0 else -1, why=why.AXIS
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
