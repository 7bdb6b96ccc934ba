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


@dataclass(frozen=True)
class Stretch:
    """A part of an indicator diagram: on the stroke "out" (from the cover) or "back", between two shares of it.

    Shares are counted from the cover, 0 … 1. From ``pressure`` (Pa) at ``start`` it follows p·V^``exponent`` =
    const, or a straight line to ``last`` (Pa) at ``end``.
    """

    stroke: str
    start: float
    end: float
    pressure: float
    exponent: float | None = None
    last: float = 0.0


@dataclass(frozen=True)
class Gas:
    """The pressure on one side of a piston over the diameter ``bore`` (m).

    ``pressures`` (Pa) at every position of the row; or ``stretches`` of the two strokes, all polytropic or all
    straight, with the ``clearance`` as a share of the stroke. ``rod``: the diameter (m) of a rod that passes
    through that side; 0 for none.
    """

    pressures: tuple[float, ...]
    bore: float
    rod: float = 0.0
    stretches: tuple[Stretch, ...] = ()
    clearance: float = 0.0


@dataclass(frozen=True)
class IndicatorOrder:
    """The indicator diagram of a cylinder whose piston's point slides on the frame.

    ``cover``: the side away from the crank; ``shaft``: the side towards it, None for a single-acting piston.
    ``base`` is the drawn length of the stroke; ``height`` that of the highest pressure, mm, unless ``mu``
    (Pa/mm) says.
    """

    point: str
    cover: Gas
    shaft: Gas | None = None
    base: float = 100.0
    height: float = 100.0
    mu: float | None = None


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
    A: Drawn = Drawn()
    base: float = 120.0
    mu_M: float | None = None
    integration: str = "areas"
    tangents: str | None = "curve"
    rim: Rim | None = None


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
