"""What is asked of a flywheel (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.charts import STANDARD, ScaleOrder
from graphic_tmm.chapter import Asked
from graphic_tmm.chapters.indicator.task import IndicatorOrder


@dataclass(frozen=True)
class Rim:
    """A flywheel's rim: outer diameter (m), inner over outer, limit of speed (m/s), density (kg/m³).

    ``shaft`` (m), ``studs`` and their diameter (m) are for the sketch.
    """

    outer: float
    ratio: float = 0.85
    speed_limit: float = 110.0
    density: float = 7800.0
    shaft: float = 0.055
    studs: int = 3
    stud: float = 0.016


@dataclass(frozen=True)
class FlywheelOrder:
    """A flywheel for the coefficient of irregularity ``delta``.

    ``indicator``: the gas forces of which diagram; None: by the loads of the links.

    ``constant``: which moment is constant over the cycle, "resisting" or "driving". ``A``: the scale of the
    works, or the pole distance that gives it.
    ``integration``: mean ordinates, of the "areas" below the curve, its ordinates at the "middles" of the
    intervals, or those of "chords". ``tangents``: of the energy–mass curve, at the "curve" or at its "points"
    only; None leaves that method out.
    """

    indicator: IndicatorOrder | None
    delta: float
    constant: str = "resisting"
    A: ScaleOrder = STANDARD
    base: float = 120.0
    mu_M: float | None = None
    integration: str = "areas"
    tangents: str | None = "curve"
    rim: Rim | None = None


ASKED: Asked[FlywheelOrder] = Asked("flywheel")
