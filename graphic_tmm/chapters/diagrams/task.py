"""What is asked of kinematic diagrams: the point, what is taken, scales (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.charts import STANDARD, ScaleOrder
from graphic_tmm.chapter import Asked


@dataclass(frozen=True)
class KinematicOrder:
    """Diagrams S, V, a of a point that slides on the frame.

    ``start``: what is taken from the plans, "displacement" (differentiated twice) or "velocity"
    (differentiated once, integrated once). ``over``: "time" or "angle". ``method``: "chords" or "tangents".
    The base is ``base`` mm long, or so long that 1 mm is ``mu_along`` (s or rad).
    """

    point: str
    start: str = "displacement"
    over: str = "time"
    method: str = "chords"
    base: float | None = None
    mu_along: float | None = None
    S: ScaleOrder = STANDARD
    V: ScaleOrder = STANDARD
    a: ScaleOrder = STANDARD


ASKED: Asked[KinematicOrder] = Asked("diagrams")
