"""What the section of a cam given by arcs says: contour, reversed motion, diagrams, what they come to."""

from __future__ import annotations

from graphic_tmm.language.said import said

CONTOUR, MOTION = said("Contour of the cam"), said("Displacements by reversed motion")
DIAGRAMS = said("Diagrams by chords, dS/dφ by the instant centre")
CIRCLES = said(
    "Where two arcs touch, their centres and that place lie in one line. So the centres of the flanks stand, "
    "and the roller's centre goes along circles about them, at these distances on the drawing:"
)
TANGENTS = said(
    "A straight flank is the common tangent of base circle and nose. The sizes on the drawing are:"
)
ROLLER = (
    said(
        "the cam stands, and the frame is turned round it the other way: the rod's line is drawn for every "
        "position;"
    ),
    said(
        "as long as the roller is on one arc, its centre B keeps its distance from the arc's centre: the rod's "
        "line cuts the circle of that radius at B (on a straight flank, the parallel to it);"
    ),
    said("from the lowest place on the same line the displacement s is measured."),
)
FLAT = (
    said(
        "the cam stands, and the frame is turned round it the other way: the rod's line is drawn for every "
        "position;"
    ),
    said(
        "through the centre of the arc that is touched the parallel to the rod is drawn, and the arc's radius "
        "laid off on it: there the face touches, square to the rod;"
    ),
    said(
        "where the face meets the rod's line, the displacement s is measured from the base circle."
    ),
)
ROCKER = (
    said(
        "the cam stands, and the frame is turned round it the other way: the lever's pivot goes round in a "
        "circle;"
    ),
    said(
        "about the pivot a circle of the lever's length is struck: where it meets the path of the roller's "
        "centre is B;"
    ),
    said("the swing ψ is the angle of the lever from its place on the base circle."),
)
WORKED = said("In position {position} (φ = {angle}) it is {travel}.")
CHORDS = said(
    "The displacements are laid off over the angle of the cam; the diagram is differentiated twice by chords, "
    "with the pole distances"
)
INSTANT = said(
    "dS/dφ is found once more without differentiation: the normal through B and the line through O square to "
    "the rod meet in the instant centre P of cam and follower, whose distance from O it is. In position "
    "{position}:"
)
PIVOTS = said(
    "dψ/dφ is found once more without differentiation: the normal through B meets the line of the pivots in "
    "the instant centre P of cam and lever, whose distances from the pivots are as the angular velocities. In "
    "position {position}:"
)
SECOND = said(
    "d²S/dφ² is found once more without differentiation, by the arc that the follower is on: its centre is the "
    "crank's pin, the normal the rod of a linkage that moves the follower alike, whose accelerations are "
    "drawn. At a change of arcs it jumps: the index + is that of the arc behind the change."
)
APART = said(
    "By chords dS/dφ is {chords} in position {position}, by the instant centre {instant}: there they differ "
    "most."
)
STROKE = said("The cam lifts its follower by {stroke}.")
SHARPEST = said("The second derivative is largest in size in position {position}: {value}.")
