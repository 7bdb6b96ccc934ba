"""What is asked of an engine's crank mechanism (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.chapter import Asked
from graphic_tmm.chapters.indicator.task import IndicatorOrder


@dataclass(frozen=True)
class EngineOrder:
    """The forces of a crank mechanism, position by position: from the gas to the turning moment.

    ``point``: where the connecting rod meets the piston or crosshead. ``share``: of the rod's mass that goes
    to and fro with it; None for the exact split by the lever rule. ``mass``: the whole mass going to and fro
    (kg) where it is given so. ``series``: P_in by the two-term series instead of the plan of accelerations.
    ``unit``: of forces, "N" or "kgf". ``base``: the length of the diagrams' base, mm.
    """

    indicator: IndicatorOrder
    point: str
    share: float | None = None
    mass: float | None = None
    series: bool = False
    unit: str = "N"
    base: float = 120.0


ASKED: Asked[EngineOrder] = Asked("engine")
