"""What is recorded of a cam of arcs: its plan, and aside its accelerations and where its centres stand."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import measure
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam import words as why
from graphic_tmm.chapters.arc_cam.contour import Contour
from graphic_tmm.chapters.arc_cam.linkage import Plans, draw_plans
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, LETTERS, marks, record
from graphic_tmm.chapters.arc_cam.task import ARC_CAM
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

VIEW = "arc_cam-calculation"
"""The view of what is calculated."""


class Aside(NamedTuple):
    """What the follower does, found without differentiation.

    ``plans``: of the replacing linkage. ``apart``: by how much dS/dφ and d²S/dφ² by chords differ from those.
    ``velocity`` and ``acceleration``, on both sides of a change of arcs, at all positions (m/s, m/s²; of a
    lever 1/s, 1/s²), ``scales``: what a mm of the plans stands for (m/s, m/s²); None without a speed.
    ``centres``: of each flank with a centre, by its number, how far this stands from the cam's centre and from
    the nose's (Number, m).
    """

    plans: Plans
    apart: tuple[Mark, Mark]
    centres: Mapping[str, tuple[Mark, Mark]]
    velocity: Mark | None = None
    acceleration: tuple[Mark, Mark] | None = None
    scales: tuple[Mark, Mark] | None = None


BESIDE: Recorded[Aside] = Recorded(aside(ARC_CAM))


def record_beside(bench: Bench) -> Aside:
    """Draw the plans of the replacing linkage, compare the chords; with a speed, velocity and acceleration."""
    made, draft = ARC_CAM_PLAN.on(bench), bench.draft
    plans = draw_plans(draft, made, bench.names)
    draft.open(VIEW)
    centres, unit = _centres(draft, made.contour), plans.first.unit
    chords, sides = marks(made), ((plans.first, plans.first), plans.second)
    rate, second = (
        draft.draw(f.off_by_chords, f"Δ{LETTERS[which]}", *pair, unit=unit)
        for which, pair in (
            ("V", (chords["dS"], made.charts["V"].mu, *sides[0])),
            ("A", (chords["ddS"], made.charts["A"].mu, *sides[1])),
        )
    )
    if made.order.speed is None:
        return Aside(plans, (rate, second), centres)
    rocks = made.order.rocks
    omega = draft.take(Number, "ω_1", made.order.speed, "1/s")
    letters, unit = (("ω_{B}", "ε_{B}"), "1/s") if rocks else (("v_{B}", "a_{B}"), "m/s")
    velocity = draft.draw(f.velocity, letters[0], omega, plans.first, unit=unit)
    after = letters[1].replace("}", "+}")
    before, behind = (
        draft.draw(f.acceleration, letter, omega, mark, unit=f"{unit}²")
        for letter, mark in zip((letters[1], after), plans.second, strict=True)
    )
    ops = ((f.velocity, "μ_v", "(m/s)/mm"), (f.acceleration, "μ_a", "(m/s²)/mm"))
    mu_v, mu_a = (
        draft.draw(op, letter, omega, mu, unit=of)
        for (op, letter, of), mu in zip(ops, plans.scales, strict=True)
    )
    return Aside(plans, (rate, second), centres, velocity, (before, behind), (mu_v, mu_a))


def _centres(draft: Draft, contour: Contour) -> dict[str, tuple[Mark, Mark]]:
    """Read how far the centres of the flanks stand from those of the cam and of the nose."""
    found = {}
    for number, name in (("1", "rise"), ("2", "return")):
        arc = contour.arcs.get(name)
        if arc is not None and (centre := arc.centre) is not None:
            lengths = [
                draft.draw(measure, f"{one.name}F_{number}", one, centre, why=why.CENTRE)
                for one in (contour.origin, contour.nose)
            ]
            near, far = (
                draft.draw(f.transfer, f"l_{{{long.name}}}", long, contour.mu, unit="m")
                for long in lengths
            )
            found[number] = (near, far)
    return found


PLAN = Plan(record=record, aside=record_beside, charts=lambda made: made.charts.values())
