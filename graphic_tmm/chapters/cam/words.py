"""What people call a cam's views, table, columns, phases and results."""

from __future__ import annotations

from graphic_tmm.chapters.cam.names import CAM
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

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
    "cam rise acceleration": said("Acceleration of the follower in the rise"),
    "cam rise velocity": said("Velocity of the follower in the rise"),
    "cam rise displacement": said("Displacement of the follower in the rise"),
    "cam return acceleration": said("Acceleration of the follower in the return"),
    "cam return velocity": said("Velocity of the follower in the return"),
    "cam return displacement": said("Displacement of the follower in the return"),
    "cam centre": said("Region of centres of the cam"),
    "cam profile": said("Profile of the cam"),
    "cam scheme": said("Scheme of the cam mechanism"),
    "cam-calculation": said("Calculation of the cam"),
    "symbol cam S": said("S"),
    "symbol cam dS": said("S′"),
    "symbol cam ddS": said("S″"),
    "symbol cam v": "v_{B}",
    "symbol cam a": "a_{B}",
    "symbol cam omega": "ω_{B}",
    "symbol cam eps": "ε_{B}",
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
    "left_rise": said("[α] − α, rise"),
    "left_return": said("[α] − α, return"),
    "left_roller_r0": said("[r] by r_{0} − r"),
    "left_roller_profile": said("[r] by curvature − r"),
    "left_curvature": "ρ_{min} − [ρ]",
    "dS_max_rise": said("largest S′, rise"),
    "ddS_max_rise": said("largest S″, rise"),
    "dS_max_return": said("largest S′, return"),
    "ddS_max_return": said("largest S″, return"),
}

SYMBOLS = (
    ("r_0", said("least radius of the cam"), "m"),
    ("α", said("pressure angle"), "°"),
    ("κ", said("curvature of the profile"), "1/m"),
    ("h", said("stroke of the follower"), "m"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(CAM,),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
