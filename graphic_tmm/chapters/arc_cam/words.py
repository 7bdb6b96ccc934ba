"""What people call the views of a cam given by arcs, its table, its columns and results."""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.names import ARC_CAM
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "arc_cam": said("Cam given by arcs"),
    "given arc_cam": said("Given data: cam given by arcs"),
    "table arc_cam": said("Motion of the follower"),
    "arc cam profile": said("Contour, reversed motion"),
    "arc cam S": said("Displacement of the follower"),
    "arc cam dS": said("Diagram of dS/dφ"),
    "arc cam ddS": said("Diagram of d²S/dφ²"),
    "arc_cam-calculation": said("Calculation of the cam given by arcs"),
    "phase nose": said("Nose"),
    "phase readings": said("Readings"),
    "given straight": said("straight"),
    "given flank": said("Flanks"),
    "given flank of the rise": said("Flank of the rise"),
    "given flank of the return": said("Flank of the return"),
    "given hollow": said("hollow"),
    "given face": said("flat face"),
    "given edge": said("edge"),
    "given follower": said("Follower"),
    "symbol arc S": "S",
    "symbol arc dS": "S′",
    "symbol arc dS_P": "S′_{P}",
    "symbol arc ddS": "S″",
    "symbol arc pressure": "α",
    "symbol arc ddS_K": "S″_{K}",
    "symbol arc ddS_K_after": "S″_{K+}",
    "symbol arc v": "v_{B}",
    "symbol arc a": "a_{B}",
    "symbol arc a_after": "a_{B+}",
    "symbol arc omega": "ω_{B}",
    "symbol arc eps": "ε_{B}",
    "symbol arc eps_after": "ε_{B+}",
    "arc_stroke": said("h, stroke"),
    "flank_centre1": "OF_{1}",
    "flank_to_nose1": "CF_{1}",
    "flank_centre2": "OF_{2}",
    "flank_to_nose2": "CF_{2}",
}

SYMBOLS = (
    ("r_1", said("radius of the base circle"), "m"),
    ("r_2", said("radius of the nose"), "m"),
    ("d", said("distance of the nose's centre"), "m"),
    ("S′_P", said("dS/dφ by the instant centre"), "m"),
    ("S″_K", said("d²S/dφ² by the arc's centre, before a change of arcs"), "m"),
    ("S″_{K+}", said("d²S/dφ² by the arc's centre, behind a change of arcs"), "m"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(ARC_CAM,),
    rank=81,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
