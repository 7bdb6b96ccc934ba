"""From the checked sections of diagrams, indicator and flywheel to the records of what is asked for."""

from __future__ import annotations

from itertools import pairwise

from graphic_tmm.board.charts import ScaleOrder
from graphic_tmm.chapters.diagrams.task import KinematicOrder
from graphic_tmm.chapters.flywheel.task import FlywheelOrder, Rim
from graphic_tmm.chapters.indicator.task import Gas, IndicatorOrder, Stretch
from graphic_tmm.scene.order_tables import (
    DiagramsTable,
    FlywheelTable,
    IndicatorTable,
    StrokeTable,
    TracedTable,
)

MATERIALS = {"steel": (110.0, 7800.0), "cast iron": (35.0, 7200.0)}
"""Limit of the rim's speed (m/s) and density (kg/m³) by material."""
SHAFT, STUD = 8.0, 28.0
"""Outer diameter of the rim over that of the shaft, and over that of the stud holes, where none is given."""


def diagrams(table: DiagramsTable) -> KinematicOrder:
    """Return what the section of diagrams asks for."""
    return KinematicOrder(
        point=table.point,
        start=table.start,
        over=table.over,
        method=table.method,
        base=table.base,
        mu_along=table.mu_t or table.mu_phi,
        S=ScaleOrder(table.mu_S, table.H_S),
        V=ScaleOrder(table.mu_V, table.H_V),
        a=ScaleOrder(table.mu_a, table.H_a),
    )


def indicator(table: IndicatorTable) -> IndicatorOrder:
    """Return what the section of the indicator diagram asks for."""
    cover = _gas(table, "cover")
    assert cover is not None
    return IndicatorOrder(
        table.point, cover, _gas(table, "shaft"), table.base, table.height, table.mu_p
    )


def flywheel(table: FlywheelTable, gas: IndicatorTable | None) -> FlywheelOrder:
    """Return what the sections of flywheel and indicator diagram ask for."""
    return FlywheelOrder(
        indicator(gas) if gas is not None else None,
        table.delta,
        table.constant,
        ScaleOrder(pole=table.H),
        table.base,
        table.mu_M,
        table.integration,
        None if table.tangents == "none" else table.tangents,
        _rim(table),
    )


def _gas(table: IndicatorTable, side: str) -> Gas | None:
    """Return the gas of one side of the piston; None if nothing is said of it."""
    pressures = getattr(table, side)
    traced: TracedTable | None = getattr(table, f"{side}_points")
    strokes: list[StrokeTable] = getattr(table, f"{side}_strokes")
    rod = (table.rod or 0.0) if side == "shaft" else 0.0
    if pressures is not None:
        return Gas(pressures, table.bore, rod)
    found = _straight(traced) if traced is not None else _polytropic(strokes)
    return Gas((), table.bore, rod, found, table.clearance) if found else None


def _straight(table: TracedTable) -> tuple[Stretch, ...]:
    return tuple(
        Stretch(way, a, b, p, None, q)
        for way, points in (("out", table.out), ("back", table.back))
        for (a, p), (b, q) in pairwise(points)
    )


def _polytropic(strokes: list[StrokeTable]) -> tuple[Stretch, ...]:
    reached = {"out": 0.0, "back": 1.0}
    found = []
    for part in strokes:
        found.append(Stretch(part.stroke, reached[part.stroke], part.to, part.p, part.n))
        reached[part.stroke] = part.to
    return tuple(found)


def _rim(table: FlywheelTable) -> Rim | None:
    if table.D_e is None:
        return None
    shaft = table.shaft or round(table.D_e / SHAFT, 3)
    stud = table.stud or round(table.D_e / STUD, 3)
    return Rim(table.D_e, table.ratio, *MATERIALS[table.material], shaft, table.studs, stud)
