"""What the section of a cam in a note says: law of motion, region of centres, limits, profile; what follows."""

from __future__ import annotations

from graphic_tmm.language.said import said

LAW, CENTRES = said("Diagrams of the motion"), said("Least radius, region of centres")
LIMITS, PROFILE = said("Pressure angle and curvature"), said("Profile by reversed motion")
CHECKS = said("Limits kept, motion of the follower")
BASE = said(
    "Along the base the cam's turn is laid off, 360°; each phase takes its share and is divided into equal "
    "parts. Ordinates are taken to scale from the stroke:"
)
RADIANS = said("Derivatives are taken by the angle in radians; the phases are")
LAWS = {
    "sine": said(
        "The law is a sine. For S a semicircle of the radius R = h/(2π) is struck about the outer end of the "
        "phase and divided into as many parts as half of the phase; its points are carried to the axis there, "
        "from it parallel to the chord of the phase to the ordinates of the divisions. For dS/dφ and d²S/dφ² "
        "the semicircles have the radii R′ and R″ below, with the number of the phase; their points are "
        "carried straight across."
    ),
    "cosine": said(
        "The law is a cosine. For S a semicircle over the stroke, of the radius R = h/2, is divided into as "
        "many parts as the phase, and its points are carried across to the ordinates of the divisions. For "
        "dS/dφ and d²S/dφ² the semicircles have the radii R′ and R″ below, with the number of the phase."
    ),
    "constant acceleration": said(
        "The acceleration is constant over each half of the phase. S consists of two parabolas, drawn by rays "
        "to equal divisions of the ordinate over the middle; dS/dφ of two straight lines to the peak below; "
        "d²S/dφ² of two level lines."
    ),
    "unequal shares": said(
        "The acceleration is constant over each of both parts of the phase. S consists of two parabolas, drawn "
        "by rays to equal divisions of the ordinate between them; dS/dφ of two straight lines to the peak "
        "there; d²S/dφ² of two level lines, as high as the parts are short."
    ),
    "constant velocity": said(
        "The velocity is constant but for a sixth of the phase at either end. S is a straight line between two "
        "parabolas, drawn by rays to equal divisions of the ordinates over the ends of these sixths; dS/dφ "
        "rises to a level line along straight ones; d²S/dφ² is constant over the sixths and zero between them."
    ),
    "3-4-5": said(
        "The law is a polynomial of the fifth degree; its ordinates are calculated by the share u of the phase:"
    ),
    "table": said(
        "The law is given by a table of displacements; the slopes of chords between its lines are dS/dφ, what "
        "the slopes of neighbouring chords differ by is d²S/dφ²; where the follower comes to rest it is that "
        "of the cubic parabola which is level there and goes through the next two lines."
    ),
    "diagram": said(
        "The law is given by its acceleration diagram, which is integrated twice against a pole; the scale "
        "follows from the stroke."
    ),
}
ROCKS = said("S stands for the angle ψ of the rocker, in radians.")
READ = said(
    "At φ = {angle} (position {position}) the ordinates are S = {S}, dS/dφ = {dS}, d²S/dφ² = {ddS}, that is "
    "{travel}, {speed} and {rate}."
)
ROLLER = (
    said(
        "on the path of the follower's point its places B are marked by S from the lowest one, {B0};"
    ),
    said(
        "from B, square to the path, dS/dφ is laid off to the same scale, to the side to which the velocity "
        "points when it is turned by 90° as the cam turns; its end is Q;"
    ),
    said(
        "seen from a centre O of the cam, Q lies in the direction of the normal: the angle of OQ with the path "
        "is the pressure angle, wherever O stands;"
    ),
    said(
        "tangents inclined to the path by the allowed pressure angle are drawn to the curve of the rise and to "
        "that of the return; below both of them every centre will do;"
    ),
    said(
        "the line of the centres meets them at {O1} and {O2}; the lower one gives the least radius."
    ),
)
LEAST = said("The least radius is measured from there to {B0}:")
APEX = said(
    "The least of all radii, with the guide set off the centre to the region's apex O*, would be"
)
CHOSEN = said("The radius is taken as {r0}; on the drawing it is")
ANGLE = said(
    "With this centre the pressure angle in position {position} is {angle}, read between OQ and the path."
)
EXTREMES = said(
    "The pressure angles of all positions are laid off over the turn. The largest on the rise and on the "
    "return are read with the angles of the cam at which they stand:"
)
CURVATURE = said(
    "The curvature of the theoretical profile follows from how its normal turns; in position {position}:"
)
PARTS = said(
    "Here {it} tells how much the normal turns for the cam's own turn; {p} and {q} are the components of OQ "
    "along the path and square to it;"
)
CARRIED = said("{v} and {a} are dS/dφ and d²S/dφ² to the scale of the region of centres.")
SWUNG = said("{v} is dψ/dφ times O₁Q, {a} is d²ψ/dφ² times the lever, to the scale of the figure.")
AS_STROKE = said("The region and the profile are drawn to the scale of S:")
SHARPEST = said("Where it is largest, the radius of curvature is least:")
FACE = said(
    "The contact wanders along the face; farthest from the foot of the pivot and nearest to it are:"
)
ALLOWED = said("The roller may be as large as the smaller of two limits allows:")
TAKEN = said("A roller of radius {radius} is taken.")
REVERSED = (
    said("everything is given the angular velocity −ω: the cam stands, the guide goes round it;"),
    said(
        "from the centre O the line of the follower is drawn for every position, turned back by the angle φ;"
    ),
    said(
        "on it the roller's centre B is marked, as far off as the least radius and S together tell;"
    ),
    said(
        "a smooth curve through the points B is the theoretical profile; over the dwells it is a circle;"
    ),
    said(
        "rollers are drawn about the points B; the curve that touches all of them, at the distance of the "
        "roller's radius along the normals, is the working profile."
    ),
)
REACH = said(
    "In position {position} the roller's centre stands above O, along the guide, by this much ({s0} is the "
    "distance in the lowest place):"
)
LEFT = said("What is left up to the limits:")
MOVING = said("The cam turns at {speed}. In position {position} the follower moves with")

RADIUS = said("The least radius of the cam is {r0_min}; {r0} is taken.")
PRESSURE_KEPT = said(
    "The pressure angle reaches {pressure_rise} on the rise and {pressure_return} on the return; allowed are "
    "{allowed} and {behind}."
)
SPLINE = said(
    "The lines of the table stand at uneven angles: a spline through them, level where the follower is at "
    "rest, is read at as many even ones."
)
ALL = said(
    "All conditions of the cam hold: below the allowed pressure angle {left_rise} are left on the rise and "
    "{left_return} on the return, below the largest radius of the roller {left_roller_r0} by r0 and "
    "{left_roller_profile} by the profile."
)
EDGE = said(
    "All conditions of the cam hold: below the allowed pressure angle {left_rise} are left on the rise and "
    "{left_return} on the return."
)
FLAT = said(
    "The condition of the cam holds: the profile is convex, its least radius of curvature {left_curvature} "
    "above the allowed one."
)
