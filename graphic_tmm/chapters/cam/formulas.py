"""Formulas of cams: scales, angles of the turn, curvature, limits of the roller; ordinates of laws."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_OVERCUT = "the roller is larger than the radius of curvature of the profile"
_ALL_EASED = "nothing is left of the even motion"
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
def left(limit: Number, value: Number) -> Number:
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


_PHASE = "{share} ≥ 0, {share} ≤ 1"


@formula(why=said("The sine law is S = h·(u − sin 2πu/(2π)): its wave has the amplitude h/(2π)."))
def sine_radius(height: Length) -> Length:
    """{height}/(2·π)"""


@formula(
    why=said(
        "The derivative of the sine law is (h/Φ)·(1 − cos 2πu): its wave has the amplitude h/Φ."
    )
)
def sine_radius_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}/({phase}·{mu})"""


@formula(
    why=said("The second derivative of the sine law is (2πh/Φ²)·sin 2πu: its amplitude is 2πh/Φ².")
)
def sine_radius_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """2·π·{stroke}/({phase}²·{mu})"""


@formula(why=said("The cosine law is S = (h/2)·(1 − cos πu): its wave has the amplitude h/2."))
def cosine_radius(height: Length) -> Length:
    """{height}/2"""


@formula(why=said("The derivative of the cosine law is (πh/(2Φ))·sin πu."))
def cosine_radius_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """π·{stroke}/(2·{phase}·{mu})"""


@formula(why=said("The second derivative of the cosine law is (π²h/(2Φ²))·cos πu."))
def cosine_radius_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """π²·{stroke}/(2·{phase}²·{mu})"""


@formula(
    holds=_PHASE,
    why=said(
        "A height on the circle is the sine of its central angle: the circle gives the sine without a "
        "table."
    ),
)
def around_outer(share: Number) -> Angle:
    """arcsin(sin(360°·{share}))"""
    # arcsin loses half the digits at its ends; here and below the same broken line, by its pieces
    return Angle(90.0 - np.abs(np.mod(360.0 * share + 90.0, 360.0) - 180.0))


@formula(
    holds=_PHASE,
    why=said(
        "A height on the circle counted from its lowest point is 1 minus the cosine of the central angle."
    ),
)
def around_lowest(share: Number) -> Angle:
    """arccos(cos(360°·{share}))"""
    return Angle(360.0 * np.minimum(share, 1.0 - share))


@formula(
    holds=_PHASE,
    why=said("Half a circle is a half wave: its height is the sine of the central angle."),
)
def half_around_outer(share: Number) -> Angle:
    """arcsin(sin(180°·{share}))"""
    return Angle(180.0 * np.minimum(share, 1.0 - share))


@formula(
    why=said("Half a circle is a half wave: its height is 1 minus the cosine of the central angle.")
)
def half_around(share: Number) -> Angle:
    """180°·{share}"""


@formula(why=said("This part of the law grows evenly with the angle."))
def even_height(share: Number, height: Length) -> Length:
    """{share}·{height}"""


@formula(
    holds="{eased} < 1",
    fails=_ALL_EASED,
    why=said(
        "At either end the follower speeds up evenly to the velocity of the even motion: rays to even parts of "
        "this ordinate cut those of the parabola."
    ),
)
def eased_rise(share: Number, eased: Number, height: Length) -> Length:
    """{share}·{height}/(2·(1 − {eased}))"""


@formula(
    holds="{eased} < 1",
    fails=_ALL_EASED,
    why=said(
        "At the other end it slows down as it sped up: the rays go from the end of the stroke."
    ),
)
def eased_rise_back(share: Number, eased: Number, height: Length) -> Length:
    """{height} − (1 − {share})·{height}/(2·(1 − {eased}))"""


@formula(
    holds="{eased} < 1",
    fails=_ALL_EASED,
    why=said("Over both eased ends the mean velocity is half of that between them."),
)
def eased_V(stroke: Number, phase: Number, eased: Number, mu: Number) -> Length:
    """{stroke}/({phase}·(1 − {eased})·{mu})"""


@formula(
    holds="0 < {eased}, {eased} < 1",
    fails=_ALL_EASED,
    why=said("Over the eased share of the phase the velocity of the even motion is reached."),
)
def eased_A(stroke: Number, phase: Number, eased: Number, mu: Number) -> Length:
    """{stroke}/({phase}²·{eased}·(1 − {eased})·{mu})"""


@formula(why=said("Under even acceleration the velocity grows to 2h/Φ in the middle of the phase."))
def parabola_V(stroke: Number, phase: Number, mu: Number) -> Length:
    """2·{stroke}/({phase}·{mu})"""


@formula(
    why=said(
        "Over half of the phase with even acceleration half of the stroke is done: h/2 = a·(Φ/2)²/2."
    )
)
def parabola_A(stroke: Number, phase: Number, mu: Number) -> Length:
    """4·{stroke}/({phase}²·{mu})"""


@formula(
    why=said(
        "This polynomial begins and ends without velocity and acceleration, so there is no shock."
    )
)
def polynomial_S(share: Number, height: Length) -> Length:
    """{height}·(10·{share}³ − 15·{share}⁴ + 6·{share}⁵)"""


@formula(why=said("It is the derivative of the law by the angle."))
def polynomial_V(share: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(30·{share}² − 60·{share}³ + 30·{share}⁴)/({phase}·{mu})"""
    # the powers of the text cancel towards the end of the phase; here and below they are factors
    return Length(30.0 * stroke * (share * (1.0 - share)) ** 2 / (phase * mu))


@formula(why=said("It is the second derivative of the law by the angle."))
def polynomial_A(share: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(60·{share} − 180·{share}² + 120·{share}³)/({phase}²·{mu})"""
    shape = 60.0 * share * (1.0 - share) * (1.0 - 2.0 * share)
    return Length(stroke * shape / (phase**2 * mu))


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


@formula(why=said("The laws are written by the share of the phase that has passed."))
def share_of_parts(number: Number, parts: Number) -> Number:
    """{number}/{parts}"""


@formula(why=said("Simpson's rule takes the mean of a strip from both ends and the middle."))
def mean_of_strip(first: Length, middle: Length, last: Length) -> Length:
    """({first} + 4·{middle} + {last})/6"""
