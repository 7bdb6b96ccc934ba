"""What is asked for besides the plans: kinematic diagrams of a point (SI; drawn lengths in mm)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Drawn:
    """How one diagram of a chain is scaled: its μ (SI per mm), or the pole distance H (mm) that gives it.

    Neither: a standard μ is chosen. The first diagram of a chain has no pole.
    """

    mu: float | None = None
    pole: float | None = None


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
    S: Drawn = Drawn()
    V: Drawn = Drawn()
    a: Drawn = Drawn()
