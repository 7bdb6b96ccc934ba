"""What people call the views, columns and results of a cam given by arcs; why it is drawn as it is."""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.task import ARC_CAM
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
    "arc cam velocities": said("Velocities of the replacing linkage"),
    "arc cam accelerations": said("Accelerations of the replacing linkage"),
    "phase nose": said("Nose"),
    "phase readings": said("Readings"),
    "given straight": said("straight"),
    "given flank": said("Flanks"),
    "given flank of the rise": said("Flank of the rise"),
    "given flank of the return": said("Flank of the return"),
    "given hollow": said("hollow"),
    "given face": said("flat face"),
    "given flat rocker": said("lever with a flat face"),
    "given edge": said("edge"),
    "given follower": said("Follower"),
    "symbol arc S": "S",
    "symbol arc dS": "S′",
    "symbol arc dS_P": "S′_{P}",
    "symbol arc dS_K": "S′_{K}",
    "symbol arc dS_off": "ΔS′",
    "symbol arc ddS": "S″",
    "symbol arc ddS_off": "ΔS″",
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
    "arc_rate_max": "S′_{max}",
    "arc_second_max": "S″_{max}",
    "arc_second_min": "S″_{min}",
    "arc_v_max": "v_{max}",
    "arc_a_max": "a_{max}",
    "arc_a_min": "a_{min}",
    "arc_omega_max": "ω_{max}",
    "arc_eps_max": "ε_{max}",
    "arc_eps_min": "ε_{min}",
    "flank_centre1": "OF_{1}",
    "flank_to_nose1": "CF_{1}",
    "flank_centre2": "OF_{2}",
    "flank_to_nose2": "CF_{2}",
}

SYMBOLS = (
    ("r_1", said("radius of the base circle"), "m"),
    ("r_2", said("radius of the nose"), "m"),
    ("d", said("distance of the nose's centre"), "m"),
    ("R", said("radius of the eccentric"), "m"),
    ("l_f", said("distance of the face from the lever's pivot"), "m"),
    ("e_C", said("eccentricity"), "m"),
    ("S′_P", said("dS/dφ by the instant centre"), "m"),
    ("S′_K", said("dS/dφ by the replacing linkage"), "m"),
    ("ΔS′", said("by how much dS/dφ by chords differs from that"), "m"),
    ("ΔS″", said("by how much d²S/dφ² by chords differs from that of the replacing linkage"), "m"),
    ("S″_K", said("d²S/dφ² by the replacing linkage, before a change of arcs"), "m"),
    ("S″_{K+}", said("d²S/dφ² by the replacing linkage, behind a change of arcs"), "m"),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(ARC_CAM,),
    rank=81,
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)


NOSE = said(
    "The nose's centre stands at its distance from the cam's; the cam stands so that the follower begins to "
    "rise upright."
)
OPPOSITE = said(
    "The follower of an eccentric is at its lowest opposite the disc's centre, whose edge is nearest to the "
    "shaft there."
)
FIRST = said(
    "There the follower begins to rise, or comes to rest: base circle and flank touch where it touches them."
)
FLANK = said(
    "The centre of the flank is as far from either circle's centre as touching them asks for: it stands where "
    "two arcs meet."
)
TANGENT = said(
    "A line that touches both circles is parallel to the one from the nose's centre to the circle of the "
    "difference of their radii, a nose's radius farther out."
)
TOUCH = said(
    "Two circles touch in the line of their centres: there one arc goes over into the next."
)
INVERTED = said(
    "Instead of the cam the frame is turned, the other way: the follower goes round the cam that stands."
)
OFFSET = said(
    "The guide passes the cam's centre at its offset: it touches the circle of that radius."
)
REPLACED = said(
    "As long as the roller rolls on an arc, its centre keeps its distance from the arc's centre: a link of "
    "that length in place of cam and roller moves the follower alike."
)
ON_STRAIGHT = said(
    "On a straight flank the roller's centre goes along the parallel at the roller's radius."
)
FACE = said(
    "A flat face touches an arc where the arc's normal is its own: on the parallel to the rod through the "
    "arc's centre."
)
FACE_OF_LEVER = said(
    "A flat face touches an arc square to the arc's normal; the parallel to it through the pivot touches the "
    "circle about the same centre whose radius is larger by the face's distance from the pivot."
)
LOWEST = said("On the base circle the follower is at its lowest.")
TRAVEL = said("What the follower has risen by is measured from its lowest place, along its way.")
SWING = said("What the lever has swung by is the angle from its lowest place.")
NORMAL = said(
    "The force between cam and follower acts along the common normal: through the arc's centre."
)
ACROSS = said(
    "The instant centre of cam and follower stands on the line through the cam's centre square to the "
    "follower's way, for the follower's own centre lies at infinity square to it."
)
PIVOTS = said(
    "The instant centre of cam and lever stands on the line of their pivots: three instant centres lie in one "
    "line."
)
INSTANT = said(
    "It stands on the common normal, too: across it, at the contact, the bodies move alike."
)
PRESSURE = said("The pressure angle is that between the normal and the follower's way.")
LINKAGE = said(
    "On an arc the cam is a crank to the arc's centre, and a link from there keeps the follower's point at its "
    "distance: a linkage that moves the follower alike. A straight flank is a slot of the cam."
)
YOKE = said(
    "The arc's centre keeps its distance from the flat face: it slides as in a slot of the follower."
)
CRANK = said(
    "The cam's angular velocity is put to 1, so the crank's end has a velocity, and an acceleration, as large "
    "as the crank is long."
)
TURNS_OR_SLIDES = said(
    "What turns about a point moves square to the rod, what slides in a slot along it: that is its line."
)
MOVES = said("The follower's point moves along its guide, or square to its lever.")
BOTH = said("The vector is known in two ways: it ends where both lines meet.")
ROD = said("What goes round a point has an acceleration towards it, along the rod.")
LEVER = said("The lever's end has a normal acceleration towards the lever's pivot.")
CENTRE = said(
    "How far the centre of a flank stands from the other centres is read off the contour."
)
