"""The indicator diagram as it is drawn: its base, divided as pistons travel, pressures, curves, gas forces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.charts import Chart, Follower
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.curve import taut_curve
from graphic_tmm.board.operations.energetics import gas_force, mean_ordinate, net_force, ring_area
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.operations.supports import farthest, planimeter
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length, Number, Point
from graphic_tmm.chapters.indicator import words as why
from graphic_tmm.chapters.indicator.stretches import Row, by_stretches, indexed
from graphic_tmm.chapters.indicator.task import VIEW, Gas, IndicatorTask
from graphic_tmm.chapters.kinematics.closings import GuideLeg, PinLeg
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said

AUXILIARY = -30.0
"""The angle of the auxiliary ray below the base, degrees."""
NAMES = {"cover": "k", "shaft": "v"}
"""Letters of the sides: of the cover, of the shaft."""


class Piston(NamedTuple):
    """A piston: its ``travel`` from where the base begins, as read (Length), its positions, its leg.

    No pressure is known at positions that stand behind the row. ``outward``: the sense of the guide to its
    cover. ``length``: its stroke between dead centres (Length), None where the row has both. ``tag``: its point
    where there are several. ``swings``: the leg by which its cylinder swings; None of one that stands.
    """

    order: IndicatorTask
    travel: Mark
    row: Row
    leg: GuideLeg
    outward: float
    length: Mark | None = None
    tag: str = ""
    swings: PinLeg | None = None


@dataclass(frozen=True)
class Side:
    """One side of the piston on the diagram.

    Its points, curve, ordinates read (Length), the pressures they stand for, mean pressure, gas force.
    ``mean``: None on a shaft side whose pressure is the same all the time: it does no work in a cycle.
    """

    name: str
    points: Mark
    curve: Mark
    ordinate: Mark
    pressure: Mark
    mean: Mark | None
    force: Mark


@dataclass(frozen=True)
class Indicator:
    """The diagram as drawn: its chart (μ_p), the ends of its base, the feet, the sides, the piston's force.

    ``divisions``: the points on the auxiliary ray by which the base is divided; ``stroke``: the piston's, as
    read there (Length). ``tag``: the points of its pistons where there are further diagrams.
    """

    order: IndicatorTask
    chart: Chart
    origin: Mark
    end: Mark
    feet: Mark
    divisions: Mark
    stroke: Mark
    sides: tuple[Side, ...]
    force: Mark
    tag: str = ""


class _Ground(NamedTuple):
    """What both sides stand on: the base's length, perpendiculars, feet, ordinate axis, the piston's stroke.

    ``sign``: what stands behind the letters of what pistons have in common.
    """

    length: Mark
    lines: Mark
    feet: Mark
    up: Mark
    stroke: Mark
    sign: str


def draw_diagram(draft: Draft, pistons: Sequence[tuple[Piston, int]], tag: str) -> list[Indicator]:
    """Draw a diagram that pistons share; each comes with how many positions it is behind the first."""
    first = draw_indicator(draft, pistons[0][0], tag)
    found = [first, *(_further(draft, first, piston) for piston, _ in pistons[1:])]
    ordinates = tuple(side.ordinate for one in found for side in one.sides)
    followers = tuple(
        Follower(side.curve, side.points, behind)
        for one, (_, behind) in zip(found[1:], pistons[1:], strict=True)
        for side in one.sides
    )
    chart = first.chart._replace(ordinates=ordinates, followers=followers)
    return [replace(one, chart=chart) for one in found]


def draw_indicator(draft: Draft, piston: Piston, tag: str = "") -> Indicator:
    """Draw the diagram of a piston; ``tag``: the points of all that share it, if there are further diagrams.

    Raises
    ------
    StructureError
        If the pressures are not as many as the positions of the row.
    """
    order = piston.order
    draft.open(view_of(tag))
    mu = draft.scale("μ_p", "Pa/mm")
    draft.lay_out()
    origin = draft.take(Point, "O", 0j)
    base = draft.draw(ray, "(Ox)", origin, draft.direction(0.0))
    up = draft.draw(square, "(Oy)", origin, base, sense=1)
    drawn = draft.take(Length, "L", order.base, "mm")
    end = draft.draw(lay_off, "E", base, drawn)
    feet, divisions, stroke = _divide(draft, (origin, base, end), piston)
    lines = draft.draw(square, "(i)", feet, base, sense=1)
    ground = _Ground(drawn, lines, feet, up, stroke, tag.replace(" ", ""))
    sides, force = _sides(draft, piston, ground)
    ordinates = tuple(side.ordinate for side in sides)
    chart = Chart(view_of(tag), "p", "Pa", mu, ordinates, True, order.mu, order.height)
    return Indicator(order, chart, origin, end, feet, divisions, stroke, sides, force, tag)


def _further(draft: Draft, first: Indicator, piston: Piston) -> Indicator:
    """Find the positions of a further piston on a diagram, lay off and read its pressures there.

    Both strokes are equal, so the base is divided by parallels to the same line.
    """
    base, length = draft.uses(first.end)
    way, (_, through) = draft.uses(first.divisions)[0], draft.uses(first.feet)
    closing, up = draft.uses(through)[1], draft.uses(first.sides[0].ordinate)[2]
    q, i = letter_of("q", piston.tag), letter_of("i", piston.tag)
    divisions = draft.draw(lay_off, q, way, piston.travel, why=why.TRAVEL_ON_RAY)
    through = draft.draw(parallel, f"({q})", divisions, closing, sense=1, why=why.ALIKE)
    feet = draft.draw(meet, i, base, through, why=why.ALIKE)
    lines = draft.draw(square, f"({i})", feet, base, sense=1)
    ground = _Ground(length, lines, feet, up, piston.length or first.stroke, "")
    sides, force = _sides(draft, piston, ground, first.sides)
    own = replace(first, order=piston.order, feet=feet, divisions=divisions)
    return replace(own, sides=sides, force=force)


def _divide(draft: Draft, axis: tuple[Mark, Mark, Mark], piston: Piston) -> tuple[Mark, Mark, Mark]:
    """Divide the base in proportion to the travel by similar triangles on an auxiliary ray.

    ``axis``: its origin, the base, its end. Returns the feet of the positions, their points on the ray, the
    stroke as it lies there (Length).
    """
    origin, base, end = axis
    way = draft.draw(ray, "(Oq)", origin, draft.take(Angle, "θ", AUXILIARY, "°"), why=why.AUXILIARY)
    marks = draft.draw(lay_off, "q", way, piston.travel, why=why.TRAVEL_ON_RAY)
    if piston.length is None:
        last = draft.draw(farthest, "q_S", origin, marks, row=piston.row.size)
    else:
        last = draft.draw(lay_off, "q_S", way, piston.length, why=why.STROKE_ON_RAY)
    closing = draft.draw(join, "(q_SE)", last, end, why=why.CLOSING)
    lines = draft.draw(parallel, "(q)", marks, closing, sense=1, why=why.ALIKE)
    stroke = draft.draw(measure, "s_{max}", origin, last)
    return draft.draw(meet, "i", base, lines, why=why.ALIKE), marks, stroke


def _sides(
    draft: Draft, piston: Piston, on: _Ground, first: Sequence[Side] = ()
) -> tuple[tuple[Side, ...], Mark]:
    """Draw both sides of a piston; ``first``: those whose curves it has. Returns the force of the gas, too."""
    order, tag = piston.order, piston.tag
    sides = [_side(draft, "cover", order.cover, piston, on, *first[:1])]
    force = sides[0].force
    if order.shaft is not None:
        sides.append(_side(draft, "shaft", order.shaft, piston, on, *first[1:]))
        force = draft.draw(net_force, letter_of("P", tag), force, sides[1].force, unit="N")
    return tuple(sides), force


def _side(
    draft: Draft, name: str, gas: Gas, piston: Piston, on: _Ground, first: Side | None = None
) -> Side:
    """Lay off the pressures of one side, read them, go round them with the planimeter."""
    row = piston.row
    sign, count, extras = NAMES[name] + piston.tag, row.size, row.extras
    if gas.stretches:
        pressure = by_stretches(
            draft, sign, gas, row, piston.travel, on.stroke, at_shaft=name == "shaft"
        )
    elif len(gas.pressures) == count:
        values = np.array([*gas.pressures, *[np.nan] * extras])[None, :]
        pressure = draft.take(Number, indexed("p", sign), values, "Pa")
    else:
        raise StructureError(
            said(
                "{n} pressures for {count} positions: give one for each",
                n=len(gas.pressures),
                count=count,
            ),
            f"indicator.{name}",
            head=f"indicator, {name}",
        )
    height = draft.draw(to_board, indexed("h", sign), pressure)
    points = draft.draw(lay_off, sign, on.lines, height, why=why.PRESSURE)
    own = NAMES[name] + on.sign
    curve = first.curve if first else None
    curve = curve or draft.draw(taut_curve, f"({own}–{own})", points, row=count)
    ordinate = draft.draw(
        measure_along, indexed("y", sign), on.feet, points, on.up, why=why.PRESSURE_READ
    )
    read = draft.draw(in_si, indexed("p", sign), ordinate, unit="Pa")
    mean = first.mean if first else None
    if first is None and not (gas.even and name == "shaft"):
        mean = _mean(draft, own, curve, on.length)
    outer = draft.take(Number, indexed("D", sign), gas.bore, "m")
    inner = draft.take(Number, indexed("d", sign), gas.rod, "m")
    face = draft.draw(ring_area, indexed("F", sign), outer, inner, unit="m²")
    force = draft.draw(gas_force, indexed("P", sign), read, face, unit="N")
    return Side(name, points, curve, ordinate, read, mean, force)


def _mean(draft: Draft, sign: str, curve: Mark, length: Mark) -> Mark:
    """Go round the diagram of a side with the planimeter; return the mean pressure."""
    area = draft.draw(planimeter, f"f_{sign}", curve, unit="mm²")
    height = draft.draw(mean_ordinate, f"h_{{{sign}m}}", area, length)
    return draft.draw(in_si, f"p_{{{sign}m}}", height, unit="Pa")


def view_of(tag: str) -> str:
    """Return the view of a diagram; ``tag``: the points of its pistons where there are further diagrams."""
    return f"{VIEW} {tag}" if tag else VIEW


def letter_of(letter: str, tag: str) -> str:
    """Return a letter of what belongs to a cylinder where there are several: P_{B}."""
    return f"{letter}_{{{tag}}}" if tag else letter
