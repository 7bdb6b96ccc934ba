"""The sections of a scene file that ask for more than plans: diagrams, the indicator diagram, a flywheel."""

from __future__ import annotations

from pydantic import Field

from graphic_tmm.scene import order_values as o
from graphic_tmm.scene import values as v
from graphic_tmm.scene.table import Table, key


class DiagramsTable(Table):
    """Kinematic diagrams of a point that slides on the frame."""

    point: v.Text = key("the letter of the point", "D")
    start: o.Start = key("what is taken from the plans", "displacement", "displacement")
    over: o.Over = key("what the base stands for", "time", "time")
    method: o.Method = key("how it is differentiated", "chords", "chords")
    base: v.Drawn | None = key("length of the base", "120 mm", None)
    mu_t: o.MuTime | None = key("time that 1 mm of the base stands for", "0.0025 s/mm", None)
    mu_phi: o.MuAngle | None = key("angle that 1 mm of the base stands for", "0.05 rad/mm", None)
    mu_S: v.MuL | None = key("m/mm", "0.001 m/mm", None)
    mu_V: o.MuVelocity | None = key("(m/s)/mm", "0.075 (m/s)/mm", None)
    mu_a: v.MuA | None = key("(m/s²)/mm", "2 (m/s^2)/mm", None)
    H_S: v.Drawn | None = key("pole distance of the integration, instead of mu_S", "20 mm", None)
    H_V: v.Drawn | None = key("pole distance of the velocities, instead of mu_V", "20 mm", None)
    H_a: v.Drawn | None = key("pole distance of the accelerations, instead of mu_a", "15 mm", None)


class TracedTable(Table):
    """An indicator diagram by points: shares of the stroke from the cover, and pressures."""

    out: o.Traced = key("points of the stroke from the cover", [[0, "300 kPa"], [1, "60 kPa"]])
    back: o.Traced = key("points of the stroke back", [[1, "30 kPa"], [0, "150 kPa"]])


class StrokeTable(Table):
    """A polytropic part of an indicator diagram; it begins where the part before it ended."""

    stroke: o.Way = key("out, from the cover, or back", "out")
    to: o.Within = key("the share of the stroke at which it ends", 0.3)
    p: o.Pressure = key("the pressure at which it begins", "600 kPa")
    n: o.Exponent = key("exponent of p·V^n = const; 0 for a constant pressure", 1.2)


class IndicatorTable(Table):
    """The indicator diagram of a cylinder: pressures in the positions of the row."""

    point: v.Text = key("the letter of the piston's point", "B")
    bore: v.PositiveLength = key("diameter of the cylinder", "120 mm")
    cover: o.Pressures | None = key(
        "pressures on the side away from the crank", ["300 kPa", "240 kPa"], None
    )
    cover_points: TracedTable | None = key("the same by points of both strokes", None, None)
    cover_strokes: list[StrokeTable] = Field(
        default_factory=list, description="the same by polytropic strokes, in order"
    )
    shaft: o.Pressures | None = key("pressures on the side towards the crank", None, None)
    shaft_points: TracedTable | None = key("the same by points of both strokes", None, None)
    shaft_strokes: list[StrokeTable] = Field(
        default_factory=list, description="the same by polytropic strokes, in order"
    )
    clearance: o.Within = key("clearance as a share of the stroke", 0.08, 0.0)
    rod: v.PositiveLength | None = key("diameter of the rod on that side", "30 mm", None)
    base: v.Drawn = key("drawn length of the stroke", "100 mm", 100.0)
    height: v.Drawn = key("room for the highest pressure", "100 mm", 100.0)
    mu_p: o.MuPressure | None = key("Pa/mm", "1500 Pa/mm", None)


class FlywheelTable(Table):
    """The flywheel of a machine driven by the gas of the indicator diagram."""

    delta: o.Irregularity = key("coefficient of irregularity", 0.04)
    constant: o.Constant = key("which moment is constant", "resisting", "resisting")
    H: v.Drawn | None = key("pole distance of the integration", "40 mm", None)
    base: v.Drawn = key("length of the base for a turn", "120 mm", 120.0)
    mu_M: o.MuMoment | None = key("(N·m)/mm", "8 N*m/mm", None)
    integration: o.Integration = key(
        "mean ordinates: of areas, at the middles of intervals, of chords", "areas", "areas"
    )
    tangents: o.Tangents = key("tangents of the energy–mass curve", "curve", "curve")
    D_e: v.PositiveLength | None = key("outer diameter of the rim", "0.45 m", None)
    ratio: o.RimRatio = key("inner diameter of the rim over the outer", 0.85, 0.85)
    material: o.Material = key("material of the rim", "steel", "steel")
    shaft: v.PositiveLength | None = key("diameter of the shaft", "55 mm", None)
    studs: o.Studs = key("how many stud holes", 3, 3)
    stud: v.PositiveLength | None = key("their diameter", "16 mm", None)
