"""The sections of a scene file that ask for more than plans: diagrams."""

from __future__ import annotations

from graphic_tmm.scene import values as v
from graphic_tmm.scene.table import Table, key


class DiagramsTable(Table):
    """Kinematic diagrams of a point that slides on the frame."""

    point: v.Text = key("the letter of the point", "D")
    start: v.Start = key("what is taken from the plans", "displacement", "displacement")
    over: v.Over = key("what the base stands for", "time", "time")
    method: v.Method = key("how it is differentiated", "chords", "chords")
    base: v.Drawn | None = key("length of the base", "120 mm", None)
    mu_t: v.MuTime | None = key("time that 1 mm of the base stands for", "0.0025 s/mm", None)
    mu_phi: v.MuAngle | None = key("angle that 1 mm of the base stands for", "0.05 rad/mm", None)
    mu_S: v.MuL | None = key("m/mm", "0.001 m/mm", None)
    mu_V: v.MuVelocity | None = key("(m/s)/mm", "0.075 (m/s)/mm", None)
    mu_a: v.MuA | None = key("(m/s²)/mm", "2 (m/s^2)/mm", None)
    H_S: v.Drawn | None = key("pole distance of the integration, instead of mu_S", "20 mm", None)
    H_V: v.Drawn | None = key("pole distance of the velocities, instead of mu_V", "20 mm", None)
    H_a: v.Drawn | None = key("pole distance of the accelerations, instead of mu_a", "15 mm", None)
