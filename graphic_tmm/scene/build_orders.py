"""From the checked sections of diagrams, indicator and flywheel to the records of what is asked for."""

from __future__ import annotations

from graphic_tmm.mechanism.orders import (
    Drawn,
    FlywheelOrder,
    Gas,
    IndicatorOrder,
    KinematicOrder,
    Rim,
)
from graphic_tmm.scene.order_tables import DiagramsTable, FlywheelTable, IndicatorTable

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
        S=Drawn(table.mu_S, table.H_S),
        V=Drawn(table.mu_V, table.H_V),
        a=Drawn(table.mu_a, table.H_a),
    )


def flywheel(table: FlywheelTable, indicator: IndicatorTable) -> FlywheelOrder:
    """Return what the sections of flywheel and indicator diagram ask for."""
    rod = indicator.rod or 0.0
    shaft = Gas(indicator.shaft, indicator.bore, rod) if indicator.shaft else None
    order = IndicatorOrder(
        indicator.point,
        Gas(indicator.cover, indicator.bore),
        shaft,
        indicator.base,
        indicator.height,
        indicator.mu_p,
    )
    return FlywheelOrder(
        order,
        table.delta,
        table.constant,
        table.H,
        table.base,
        table.mu_M,
        table.integration,
        None if table.tangents == "none" else table.tangents,
        _rim(table),
    )


def _rim(table: FlywheelTable) -> Rim | None:
    if table.D_e is None:
        return None
    shaft = table.shaft or round(table.D_e / SHAFT, 3)
    stud = table.stud or round(table.D_e / STUD, 3)
    return Rim(table.D_e, table.ratio, *MATERIALS[table.material], shaft, table.studs, stud)
