"""What people call a cam's views, columns, phases and results; why it is drawn as it is."""

from __future__ import annotations

import re

from graphic_tmm.chapters.cam import words_drum, words_plate, words_spring
from graphic_tmm.chapters.cam.task import CAM
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "given cam": said("Given data: cam"),
    "given law": said("Law of motion"),
    "given law of the rise": said("Law of the rise"),
    "given law of the return": said("Law of the return"),
    "given shares": said("Speeding up : slowing down"),
    "law sine": said("sine"),
    "law cosine": said("cosine"),
    "law constant acceleration": said("constant acceleration"),
    "law constant velocity": said("constant velocity, eased"),
    "law 3-4-5": "3-4-5",
    "law diagram": said("by its diagram"),
    "law table": said("by its table"),
    "cam": said("Cam"),
    "table cam": said("Motion of the follower"),
    "cam S": said("Displacement of the follower"),
    "cam dS": said("Diagram of dS/dφ"),
    "cam ddS": said("Diagram of d²S/dφ²"),
    "rocker cam S": said("Angle of the rocker"),
    "rocker cam dS": said("Diagram of dψ/dφ"),
    "rocker cam ddS": said("Diagram of d²ψ/dφ²"),
    "cam pressure": said("Pressure angle"),
    "cam curvature": said("Curvature of the profile"),
    "cam radii": said("Radius of curvature of the profile"),
    "cam limits": said("Limits of the centre"),
    "cam contact": said("Place of the contact on the face"),
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
    **words_drum.CAPTIONS,
    **words_plate.CAPTIONS,
    **words_spring.CAPTIONS,
    "symbol cam S": said("S"),
    "symbol cam dS": said("S′"),
    "symbol cam ddS": said("S″"),
    "symbol rocker cam S": "ψ",
    "symbol rocker cam dS": "ψ′",
    "symbol rocker cam ddS": "ψ″",
    "symbol cam v": "v_{B}",
    "symbol cam a": "a_{B}",
    "symbol cam omega": "ω_{B}",
    "symbol cam eps": "ε_{B}",
    "symbol cam pressure": said("α"),
    "symbol cam curvature": said("κ"),
    "symbol cam radii": said("ρ"),
    "symbol cam contact": "x",
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
    "face_to": said("x of the contact, farthest"),
    "face_from": said("x of the contact, nearest"),
    "face_length": said("length of face needed"),
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


_OF_PHASE = {
    "cam # acceleration": said("Acceleration of the follower in phase {k}"),
    "cam # velocity": said("Velocity of the follower in phase {k}"),
    "cam # displacement": said("Displacement of the follower in phase {k}"),
    "dS_max_#": said("largest S′, phase {k}"),
    "ddS_max_#": said("largest S″, phase {k}"),
    "given law #": said("Law of phase {k}"),
    "given shares #": said("Speeding up : slowing down, phase {k}"),
}
"""Of a cam with several lifts."""


def of_phase(name: str, speech: Speech) -> str:
    """Return what a view, a result or a given law is called that has the number of a phase in its name."""
    number = re.search(r"\d+", name)
    told = _OF_PHASE.get(name.replace(number[0], "#", 1)) if number else None
    return speech(told, k=number[0]) if number and told else ""


WORDS = Named(
    captions=CAPTIONS,
    called=of_phase,
    result=of_phase,
    plans=(CAM,),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)


FOLLOWER_LINE = said("The follower moves along this line; its lowest place is where it begins.")
ROLLER_AT = said(
    "The displacement of this position, to the scale of this figure, stands on the way of its point "
    "B: the roller's centre, or the edge."
)
SPEED_LINE = said(
    "The derivative dS/dφ is laid off square to the displacement, on the side to which the velocity turned "
    "by 90° with the cam points."
)
SPEED_AT = said(
    "Seen from the centre of the cam the end of dS/dφ lies in the direction of the normal: so the pressure "
    "angle can be read off."
)
CENTRE_LINE = said(
    "The centre of the cam stands on the line of the follower, or beside it by the offset."
)
LIMIT_MET = said(
    "Above this point of the line the pressure angle would be too large in this phase."
)
APEX = said(
    "Below both tangents lies the region of all centres allowed; its vertex has the least radius of all."
)
LEAST_READ = said(
    "From the centre to the lowest place of B there is the least radius of the profile."
)
CHOSEN_CIRCLE = said("The centre stands at the chosen radius from the lowest place of B.")
CENTRE = said("The centre is on its line, at the chosen radius, and so within the region allowed.")
INVERTED = said(
    "Instead of the cam everything else is turned about it, the other way: so the follower goes round the "
    "cam that stands still."
)
REACH = said(
    "B stands above the centre of the cam by what it has at the lowest place and its displacement."
)
PROFILE_POINT = said(
    "In this place of the follower its point B is a point of the theoretical profile."
)
CONTACT = said("The roller touches the cam on the normal, by its radius nearer to the cam.")
FACE_ARM = said(
    "The two arms lead to E; what of O1E falls on the line of the centres is the radius of curvature, and "
    "the distance of the face from its pivot."
)
FACE_TANGENT = said(
    "Seen square to this tangent E is just as far as the least radius of curvature wants."
)
FACE_LIMIT = said(
    "The line of the centres that is square to the tangent is the limit of this position: one that is "
    "nearer to the lever would let the profile become too sharp."
)
FACE_CENTRE = said(
    "The centre stands below the lowest face by r0, and at its distance from the pivot."
)
FACE_RADIUS = said(
    "The projection of O1E on the line of the centres reaches from the pivot as far as the centre of "
    "curvature lies below it."
)
INSTANT_CENTRE = said("In this point of the line of the centres cam and lever have one velocity.")
FACE_CONTACT = said(
    "The normal of the contact passes the instant centre: square to the face it leads to the contact."
)
FACE_LENGTH = said("So far from its foot the face has to reach in this position.")
DWELL = said("While the follower rests the profile is an arc about the centre of the cam.")
PHASE_FOOT = said("The phase takes its share of the base.")
LEVEL = said(
    "Here the lower place of the follower is not the lowest of the turn: what follows stands on its level."
)
PHASE_PART = said("The phase is divided into equal parts of the angle.")
BY_TABLE = said("The ordinate is what the table gives for this line, to scale.")
BY_SPLINE = said("The ordinate is read off the spline through the lines of the table.")
DIAGRAM_READ = said("The ordinate of the diagram is what this law gives in this position.")
ANGLE_AT = said("Over each place on the base stands what belongs to this angle of the cam.")
EXTREME_READ = said("The extreme is what is judged; where it stands tells the angle of the cam.")
SHARE_OF_CENTRE = said(
    "The components of the vector from the centre, along the way and square to it, go into the curvature "
    "of the profile."
)
WAVE_CENTRE = said("The circle of the wave stands on the ordinate of the phase's beginning.")
WAVE_CIRCLE = said(
    "A circle with the amplitude of the wave as its radius gives all heights of the wave."
)
WAVE_LEVEL = said("The height of the point on the circle is carried across to the positions.")
WAVE_AT = said(
    "The level of its part of the circle and the place of the position on the base meet in a point of the "
    "diagram."
)
OVER_POSITION = said("Over each part of the phase stands its ordinate.")
STROKE_TOP = said("At the inner end of the phase the whole stroke is done.")
MIDDLE = said("In the middle of the phase the acceleration changes its sign.")
SHARED = said("Here the follower no longer speeds up: it begins to slow down.")
PARABOLA_RAY = said("Rays to equal parts of the middle ordinate cut the ordinates of the parabola.")
EASED_END = said("Over a sixth of the phase at either end the motion is eased.")
EVEN_LINE = said(
    "The even motion is a straight line; it touches the parabola of either end where that is over, and so cuts "
    "the level of the dwell half-way."
)
TRIANGLE_SIDE = said(
    "Under constant acceleration the velocity changes evenly: along a straight line."
)
