"""Formulas of cams: scales, angles of the turn, curvature, limits of the roller; a law that is given."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_OVERCUT = "the roller is larger than the radius of curvature of the profile"
_HOLLOW = "a flat face does not reach a hollow profile"
_DIGITS = 1e-9
"""A millimetre that is over by less than this share of one is whole."""


@formula(why=said("A derivative by the angle is taken by radians."))
def radians_of(angle: Angle) -> Number:
    """π·{angle}/180°"""


@formula(
    why=said(
        "The follower moves by dS/dφ for a radian of the cam, which turns by {omega} radians in a second."
    )
)
def follower_velocity(omega: Number, length: Length, mu: Number) -> Number:
    """{omega}·{length}·{mu}"""


@formula(
    why=said(
        "The cam turns evenly, so differentiating by time once more brings the angular velocity in again."
    )
)
def follower_acceleration(omega: Number, length: Length, mu: Number) -> Number:
    """{omega}²·{length}·{mu}"""


@formula(
    why=said(
        "The largest velocity of a law is a number of its own times that of an even motion, h/Φ."
    )
)
def peak_velocity(factor: Number, stroke: Number, phase: Number) -> Number:
    """{factor}·{stroke}/{phase}"""


@formula(why=said("The largest acceleration of a law is a number of its own times h/Φ²."))
def peak_acceleration(factor: Number, stroke: Number, phase: Number) -> Number:
    """{factor}·{stroke}/{phase}²"""


@formula(
    why=said("The base stands for the whole turn of 360°: so many degrees are a millimetre of it.")
)
def degrees_per_mm(base: Length) -> Number:
    """360°/{base}"""


@formula(why=said("The base stands for the whole turn of 360°: an angle takes its share of it."))
def along_turn(angle: Angle, base: Length) -> Length:
    """{angle}·{base}/360°"""


@formula(why=said("The base stands for the whole turn of 360°: a length of it tells the angle."))
def angle_of_turn(x: Length, base: Length) -> Angle:
    """360°·{x}/{base}"""


@formula(why=said("The phase is divided into equal parts."))
def angle_of_part(angle: Angle, parts: Number) -> Angle:
    """{angle}/{parts}"""


@formula(
    holds="{height} > 0",
    fails="the diagram does not rise",
    why=said("The greatest ordinate stands for the whole stroke."),
)
def scale_of_stroke(stroke: Number, height: Length) -> Number:
    """{stroke}/{height}"""


@formula(why=said("The path on the arc divided by the lever is the angle, in radians."))
def swing_of(length: Length, mu: Number) -> Angle:
    """180°·{length}·{mu}/π"""


@formula(why=said("The angle, in radians, times the lever is the path on the arc."))
def travel_on_lever(length: Length, mu: Number, lever: Length) -> Length:
    """{length}·{mu}·{lever}"""


@formula(why=said("On the lever the path is shared out as on the circle of the pin."))
def along_path(part: Length, distance: Length, lever: Length) -> Length:
    """{part}·{distance}/{lever}"""


@formula(
    fails="the pole stands in the point",
    why=said(
        "The profile bends by as much as its normal turns, less than the cam turns where the follower "
        "gains speed."
    ),
)
def turning_of_normal(p: Length, q: Length, v: Length, a: Length) -> Number:
    """1 − ({a}·{p} − {q}·{v})/({p}² + {q}²)"""


@formula(why=said("Curvature is the turning of the normal to the length of the profile gone over."))
def curvature_of_profile(turning: Number, pace: Length, mu: Number) -> Number:
    """{turning}/({pace}·{mu})"""


@formula(
    holds="{height} > 0",
    fails="the profile is convex nowhere",
    why=said(
        "The radius of curvature is the inverse of the curvature: where the one is greatest the other is "
        "least."
    ),
)
def least_radius(height: Length, mu: Number) -> Number:
    """1/({height}·{mu})"""


@formula(
    holds="{pace} > {roller}·{turning}",
    fails=_OVERCUT,
    why=said(
        "The profile of the cam lies at the roller's radius inside the path of its centre, so where the "
        "normal turns it is shorter by the radius times that turning."
    ),
)
def equidistant_pace(pace: Length, roller: Length, turning: Number) -> Length:
    """{pace} − {roller}·{turning}"""


@formula(
    why=said(
        "For a flat follower the radius of curvature is the least radius, the travel and the second "
        "derivative together; it may not become negative."
    )
)
def flat_radius(r0: Length, displacement: Length, second: Length) -> Length:
    """{r0} + {displacement} + {second}"""


@formula(
    holds="{radius} > 0",
    fails=_HOLLOW,
    why=said("A flat follower touches a convex profile only."),
)
def convex(radius: Length) -> Length:
    """{radius}"""


_SWUNG = said(
    "The face turns as the frame does about the cam, and with its lever: against the cam it turns by this "
    "much while the cam turns by a radian."
)
_NO_CONTACT = "the lever turns as fast as the cam, and no contact of theirs moves on"


@formula(holds="1 + {speed}·{mu} > 0", fails=_NO_CONTACT, why=_SWUNG)
def turning_against(speed: Length, mu: Number) -> Number:
    """1 + {speed}·{mu}"""


@formula(holds="1 − {speed}·{mu} > 0", fails=_NO_CONTACT, why=_SWUNG)
def turning_along(speed: Length, mu: Number) -> Number:
    """1 − {speed}·{mu}"""


_ARMS = said(
    "The centre of the profile's curvature goes with the lever; so much of its distance is due to the place "
    "and the speed of the lever, so much to its acceleration."
)


@formula(why=_ARMS)
def arm_across(centres: Length, turning: Number) -> Length:
    """{centres}·(2·{turning} − 1)/{turning}²"""


@formula(why=_ARMS)
def arm_along(second: Length, mu: Number, centres: Length, turning: Number) -> Length:
    """{second}·{mu}·{centres}/{turning}³"""


@formula(
    why=said(
        "Cam and lever turn about each other in a point of the line of their centres; its distances from "
        "them are as their speeds of turning are."
    )
)
def instant_arm(centres: Length, turning: Number) -> Length:
    """{centres}/{turning}"""


@formula(
    holds="{need} < {centres}",
    fails="the face lies farther from its pivot than the cam's centre",
    why=said("While the lever rests the face must be so far from the cam's centre at least."),
)
def rest_angle(need: Length, centres: Length) -> Angle:
    """arcsin({need}/{centres})"""


@formula(why=said("The face lies nearer to the cam than the pivot of its lever, by this distance."))
def below_face(whole: Length, face: Length) -> Length:
    """{whole} − {face}"""


@formula(why=said("The face has to reach from the nearest contact to the farthest."))
def face_length(farthest: Number, nearest: Number) -> Number:
    """{farthest} − {nearest}"""


@formula(
    holds="{radius} > 0",
    fails=_HOLLOW,
    why=said("The profile is as long as its radius of curvature times the turning of the face."),
)
def face_pace(radius: Length, turning: Number) -> Length:
    """{radius}·{turning}"""


@formula(
    why=said("A roller larger than this share would undercut the profile or grow out of the cam.")
)
def allowed_share(share: Number, whole: Number) -> Number:
    """{share}·{whole}"""


_REST = said("The condition holds as long as something is left up to its limit.")


@formula(why=_REST)
def angle_left(limit: Angle, value: Angle) -> Angle:
    """{limit} − |{value}|"""


@formula(why=_REST)
def limit_left(limit: Number, value: Number) -> Number:
    """{limit} − {value}"""


@formula(why=_REST)
def above(value: Number, least: Number) -> Number:
    """{value} − {least}"""


@formula(why=said("Both bounds have to hold: the smaller one rules."))
def lesser_radius(first: Number, second: Number) -> Number:
    """min({first}, {second})"""


@formula(why=said("A radius that may not be smaller is rounded up to whole millimetres."))
def whole_mm_above(length: Number) -> Number:
    """⌈1000·{length}⌉/1000"""
    # a millimetre that rounding carried over a whole one is that one
    return Number(np.ceil(1000.0 * length - _DIGITS) / 1000.0)


@formula(why=said("Where any radius makes the profile convex enough a millimetre is taken."))
def greater_radius(first: Number, second: Number) -> Number:
    """max({first}, {second})"""


@formula(why=said("A radius that may not be larger is rounded down to whole millimetres."))
def whole_mm_below(length: Number) -> Number:
    """⌊1000·{length}⌋/1000"""
    # as above
    return Number(np.floor(1000.0 * length + _DIGITS) / 1000.0)


@formula(why=said("The angle is drawn as an ordinate to a scale."))
def on_protractor(angle: Angle, mu: Number) -> Length:
    """{angle}/{mu}"""


@formula(why=said("The ordinate, times the scale, is the angle."))
def off_protractor(length: Length, mu: Number) -> Angle:
    """{length}·{mu}"""


@formula(why=said("Between two given points the law is a straight line."))
def on_chord(share: Number, start: Number, end: Number, first: Length, last: Length) -> Length:
    """{first} + ({last} − {first})·({share} − {start})/({end} − {start})"""


@formula(
    why=said(
        "Areas read off paper are equal only nearly; the follower stops where they are, so what lies below the "
        "axis is evened by one factor."
    )
)
def evened(factor: Number, ordinate: Length) -> Length:
    """{factor}·{ordinate}"""


@formula(why=said("On the return the follower goes back over the same stroke."))
def rest_of_stroke(whole: Length, part: Length) -> Length:
    """{whole} − {part}"""


@formula(why=said("Simpson's rule takes the mean of a strip from both ends and the middle."))
def mean_of_strip(first: Length, middle: Length, last: Length) -> Length:
    """({first} + 4·{middle} + {last})/6"""
