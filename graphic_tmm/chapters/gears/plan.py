"""A pair of gears, drawn as by hand: dimensions, circles, flanks, contact ratio, specific sliding."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard, standard_length
from graphic_tmm.chapters.gears.contact import Check, Contact, draw_contact, record_checks
from graphic_tmm.chapters.gears.dimensions import GearSizes, calculate_sizes, known
from graphic_tmm.chapters.gears.line import ActionLine, draw_action_line
from graphic_tmm.chapters.gears.refusals import refuse_order, refuse_ring, refuse_sizes
from graphic_tmm.chapters.gears.sliding import ROOM as SLIDING
from graphic_tmm.chapters.gears.sliding import Sliding, draw_sliding
from graphic_tmm.chapters.gears.task import ASKED, GEARS, GearTask
from graphic_tmm.chapters.gears.teeth import Rows, Wheel, choose_rows, draw_wheel
from graphic_tmm.chapters.gears.toothed_rack import RackTeeth, draw_rack
from graphic_tmm.fitting.scales import Fitting
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

ROOM = 430.0
"""Room for the centre distance, mm."""
TOOTH, ACTION = 25.0, 400.0
"""Room for the height of a tooth where the centres have none, and for the line of action, mm."""


@dataclass(frozen=True)
class Gear:
    """The pair as drawn: its dimensions, line of action, wheels or wheel and rack, contact, sliding, checks."""

    order: GearTask
    sizes: GearSizes
    rows: Rows
    line: ActionLine
    wheels: tuple[Wheel, ...]
    contact: Contact
    sliding: Sliding
    checks: tuple[Check, ...]
    rack: RackTeeth | None


GEARS_PLAN: Recorded[Gear] = Recorded(GEARS)


def record(bench: Bench) -> Gear | None:
    """Draw the pair of gears that the scene asks for."""
    order = ASKED.of(bench.scene)
    return None if order is None else draw_gear(bench.draft, order)


def draw_gear(draft: Draft, order: GearTask) -> Gear:
    """Draw the whole pair on a draft of its own: its axis of positions are the steps of the rolling.

    Raises
    ------
    StructureError
        If the order cannot be a gear pair; what is merely poor is told by the checks.
    """
    refuse_order(order)
    refuse_ring(order)
    sizes = calculate_sizes(draft, order)
    value = known(draft)
    refuse_sizes(sizes, value)
    checks = record_checks(draft, sizes)
    rows = choose_rows(sizes, value)
    line = draw_action_line(draft, sizes)
    wheels = tuple(draw_wheel(draft, k, sizes, line, rows, value) for k in range(len(sizes.wheels)))
    contact = draw_contact(draft, sizes, line, wheels, value)
    rack = draw_rack(draft, sizes, line, rows)
    sliding = draw_sliding(draft, sizes, line, rows, value)
    return Gear(order, sizes, rows, line, wheels, contact, sliding, checks, rack)


def gear_scales(fitting: Fitting) -> dict[Mark, object]:
    """Return μ_l (m/mm) and the scale of the sliding (1/mm): what the order fixes, else standard ones.

    Both centres shall stand on the drawing; where the teeth would be too small for that, a larger scale is
    taken, as far as the line of action has room.
    """
    gear = GEARS_PLAN.on(fitting)
    sizes, free = gear.sizes, {gear.line.mu: 1.0}
    # a ring's teeth stand its root radius away from its centre
    far = sizes.wheels[1].r_f if sizes.ring else sizes.a_w
    wanted = (far, sizes.h, gear.line.length, sizes.a_w)
    exact = execute(fitting.project.construction, {**fitting.given, **free}, wanted)
    distance, height, action, axes = (float(exact[mark][0, 0]) for mark in wanted)
    larger = max(standard_length(height, TOOTH), standard_length(action, ACTION))
    usual, share = min(standard_length(distance, ROOM), larger), fitting.sizes[GEARS]
    told = axes / gear.order.axes if gear.order.axes else gear.order.mu
    mu = told or (usual if share == 1.0 else standard_length(usual / share, 1.0))
    chart, floor = gear.sliding.chart, gear.sliding.floor
    return {gear.line.mu: mu, chart.mu: chart.wanted or standard(floor, SLIDING)}
