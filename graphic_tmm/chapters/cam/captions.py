"""What people call a cam's views, table, columns, phases and results."""

from __future__ import annotations

from graphic_tmm.language.said import said

CAPTIONS: dict[str, str] = {
    "given cam": said("Given data: cam"),
    "given law": said("Law of motion"),
    "given law of the rise": said("Law of the rise"),
    "given law of the return": said("Law of the return"),
    "law sine": said("sine"),
    "law cosine": said("cosine"),
    "law constant acceleration": said("constant acceleration"),
    "law 3-4-5": "3-4-5",
    "law diagram": said("by its diagram"),
    "cam": said("Cam"),
    "table cam": said("Motion of the follower"),
    "cam S": said("Displacement of the follower"),
    "cam dS": said("Diagram of dS/dφ"),
    "cam ddS": said("Diagram of d²S/dφ²"),
    "cam pressure": said("Pressure angle"),
    "cam curvature": said("Curvature of the profile"),
    "cam radii": said("Radius of curvature of the profile"),
    "cam limits": said("Limits of the centre"),
    "cam integration": said("Integration of the acceleration"),
    "cam centre": said("Region of centres of the cam"),
    "cam profile": said("Profile of the cam"),
    "symbol cam S": said("S"),
    "symbol cam dS": said("S′"),
    "symbol cam ddS": said("S″"),
    "symbol cam pressure": said("α"),
    "symbol cam curvature": said("κ"),
    "symbol cam radii": said("ρ"),
    "symbol cam": said("y"),
    "cam pressure angle": said("α"),
    "phase rise": said("Rise"),
    "phase return": said("Return"),
    "r0_min": said("r_{0min}"),
    "r0": said("r_{0}"),
    "roller_by_r0": said("[r] by r_{0}"),
    "roller_by_curvature": said("[r] by curvature"),
    "roller": said("r of the roller"),
    "pressure_rise": said("largest α, rise"),
    "pressure_return": said("largest α, return"),
    "least_curvature": said("ρ_{min}"),
}

SYMBOLS = (
    ("r_0", said("least radius of the cam"), "m"),
    ("α", said("pressure angle"), "°"),
    ("κ", said("curvature of the profile"), "1/m"),
    ("h", said("stroke of the follower"), "m"),
)
"""Its letters in a note: what they stand for, their units."""
