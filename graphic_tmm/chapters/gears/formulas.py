"""Formulas of a pair of spur gears with shift: dimensions, limits, contact ratio, specific sliding.

Lengths of the gears are quantities (m); angles are in degrees. inv α = tan α − α is the involute function.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.formula_text import define
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.values import Angle, Length, Number, Reals
from graphic_tmm.language.said import said

_NO_ANGLE = "no angle has this involute function"
_INSIDE = "the tip circle lies inside the base circle"
_SERIES = (21844 / 6081075, 1382 / 155925, 62 / 2835, 17 / 315, 2 / 15, 1 / 3)
"""The coefficients of tan α − α over α³, the highest power first."""
_NEAR = 0.1
"""Below this angle (radians) the difference tan α − α loses digits and its series is taken."""
_ROUNDING = 64 * EPS
"""A distance that differs by less than this share of itself is the same."""
_PASSES = 10
"""Newton's steps: each doubles the digits once the root is near."""


def involute_of(angle: Reals) -> Reals:
    """Return tan α − α of an angle in radians, to the last digits for small angles too."""
    series = np.zeros_like(angle)
    for factor in _SERIES:
        series = (series + factor) * (angle * angle if factor != _SERIES[-1] else 1.0)
    return np.where(np.abs(angle) < _NEAR, series * angle**3, np.tan(angle) - angle)


def angle_with(value: Reals) -> Reals:
    """Return the angle (radians) whose involute function is ``value``; NaN where it is negative.

    Both ∛(3v) and arctan(v + π/2) lie above the root and the function is convex: Newton's steps go down to it.
    """
    value = np.where(value >= 0.0, value, np.nan)
    angle = np.minimum(np.cbrt(3.0 * value), np.arctan(value + np.pi / 2.0))
    for _ in range(_PASSES):
        slope = np.where(value > 0.0, np.tan(angle) ** 2, 1.0)
        angle = angle - (involute_of(angle) - value) / slope
    return angle


define("inv", involute_of, of_angle=True)
define("arcinv", angle_with, angle=True)


@formula(
    why=said(
        "The involute function tells by which angle the involute has gone away from its beginning where "
        "the profile angle is {alpha}."
    )
)
def involute(alpha: Angle) -> Number:
    """tan({alpha}) − {alpha}·π/180°"""
    # the terms of the text cancel at small angles
    return Number(involute_of(np.radians(alpha)))


@formula(
    why=said(
        "Teeth without backlash fill the pitch on the rolling circles: that condition gives the angle at "
        "which both wheels mesh."
    )
)
def working_involute(x1: Number, x2: Number, alpha: Angle, z1: Number, z2: Number) -> Number:
    """2·({x1} + {x2})·tan {alpha}/({z1} + {z2}) + inv {alpha}"""


@formula(
    fails=_NO_ANGLE,
    why=said("The angle is found from its involute function, by tables or by iteration."),
)
def angle_of_involute(inv: Number) -> Angle:
    """arcinv({inv})"""


@formula(
    why=said(
        "The base circles stay the same; the centre distance changes with the cosine of the angle of mesh."
    )
)
def working_distance(a: Number, alpha: Angle, alpha_w: Angle) -> Number:
    """{a}·cos {alpha}/cos {alpha_w}"""


@formula(
    why=said(
        "It tells, in modules, by how much the axes stand farther apart than pitch circles that touch."
    )
)
def perceived_shift(a_w: Number, a: Number, m: Number) -> Number:
    """({a_w} − {a})/{m}"""
    # shifts that cancel leave the axes where they are, the angle of mesh but for its rounding
    apart = a_w - a
    return Number(np.where(np.abs(apart) < _ROUNDING * np.abs(a), 0.0, apart) / m)


@formula(
    why=said(
        "The axes go apart by less than both shifts together; so much is taken off the tips, to keep the "
        "clearance."
    )
)
def equalising_shift(x1: Number, x2: Number, y: Number) -> Number:
    """{x1} + {x2} − {y}"""


@formula(
    why=said(
        "The base circle touches the line of action, which leans by {alpha}: radius and pitch on it are "
        "smaller by the cosine."
    )
)
def times_cosine(length: Number, alpha: Angle) -> Number:
    """{length}·cos {alpha}"""


@formula(
    why=said(
        "In the right triangle with the base radius and the line of action the radius is the base radius "
        "divided by the cosine."
    )
)
def over_cosine(length: Number, alpha: Angle) -> Number:
    """{length}/cos {alpha}"""


@formula(
    why=said("The tool cuts in as deep as its addendum with the clearance, less by the shift.")
)
def root_radius(r: Number, m: Number, ha: Number, c: Number, x: Number) -> Number:
    """{r} − {m}·({ha} + {c} − {x})"""


@formula(
    why=said(
        "The tip stands above the pitch circle by the addendum and the shift, less by the equalising "
        "shift."
    )
)
def tip_radius(r: Number, m: Number, ha: Number, x: Number, dy: Number) -> Number:
    """{r} + {m}·({ha} + {x} − {dy})"""


@formula(
    why=said("The distance of the axes is given: the base circles tell at which angle they mesh.")
)
def angle_of_distance(a: Number, alpha: Angle, a_w: Number) -> Angle:
    """arccos({a}·cos {alpha}/{a_w})"""


@formula(why=said("So much shift fills the pitch on the rolling circles without backlash."))
def sum_of_shifts(inv_w: Number, inv: Number, alpha: Angle, z: Number) -> Number:
    """({inv_w} − {inv})·{z}/(2·tan {alpha})"""


@formula(why=said("The tooth reaches from the root circle to the tip circle."))
def tooth_height(m: Number, ha: Number, c: Number, dy: Number) -> Number:
    """{m}·(2·{ha} + {c} − {dy})"""


@formula(
    why=said(
        "So deep the teeth of both wheels reach into each other: the height without the clearance."
    )
)
def working_depth(m: Number, ha: Number, dy: Number) -> Number:
    """{m}·(2·{ha} − {dy})"""


@formula(
    why=said("A pitch is π modules: so the pitch diameter is the module times the number of teeth.")
)
def pitch_of(m: Number) -> Number:
    """π·{m}"""


@formula(
    why=said("Half of the pitch, and by the shift the rack's tooth is thinner there on both sides.")
)
def tooth_thickness(m: Number, x: Number, alpha: Angle) -> Number:
    """{m}·(π/2 + 2·{x}·tan {alpha})"""


@formula(
    fails=_INSIDE,
    why=said(
        "In the right triangle of base radius and tip radius the cosine of the profile angle is their "
        "ratio."
    ),
)
def tip_angle(r_b: Number, r_a: Number) -> Angle:
    """arccos({r_b}/{r_a})"""


@formula(
    why=said(
        "From the pitch circle to the tip the flanks come nearer by the difference of the involute "
        "functions, on each side."
    )
)
def tip_thickness(r_a: Number, s: Number, r: Number, alpha: Angle, alpha_a: Angle) -> Number:
    """{r_a}·({s}/{r} + 2·(inv {alpha} − inv {alpha_a}))"""


@formula(
    why=said(
        "Where the flanks meet the tooth is pointed: its half thickness is eaten up by the involute "
        "function."
    )
)
def pointed_involute(s: Number, r: Number, alpha: Angle) -> Number:
    """{s}/(2·{r}) + inv {alpha}"""


@formula(
    why=said(
        "The path of contact divided by the base pitch: so many pairs of teeth are in contact on the "
        "average."
    )
)
def contact_ratio(z1: Number, a1: Angle, z2: Number, a2: Angle, alpha_w: Angle) -> Number:
    """({z1}·(tan {a1} − tan {alpha_w}) + {z2}·(tan {a2} − tan {alpha_w}))/(2·π)"""


@formula(
    why=said(
        "The tip of the other wheel reaches beyond the limit of the line of action, where no involute is: the "
        "path of contact begins at the limit."
    )
)
def contact_from_limit(z: Number, a: Angle) -> Number:
    """{z}·tan {a}/(2·π)"""


@formula(
    why=said(
        "Both tips reach beyond the limits of the line of action, where no involute is: the path of contact "
        "lies between the limits."
    )
)
def contact_of_limits(z1: Number, z2: Number, alpha_w: Angle) -> Number:
    """({z1} + {z2})·tan {alpha_w}/(2·π)"""


@formula(
    why=said(
        "Between the tip of one wheel and the root of the other there is what the centre distance leaves."
    )
)
def tip_clearance(a_w: Number, r_a: Number, r_f: Number) -> Number:
    """{a_w} − {r_a} − {r_f}"""


@formula(
    why=said(
        "The pitch circles roll on one another, tooth by tooth: the speeds are inverse to the numbers of teeth."
    )
)
def ratio_of_teeth(driven: Number, driving: Number) -> Number:
    """{driven}/{driving}"""


@formula(
    why=said(
        "The contact ratio tells how many base pitches the touching point goes along the line of action."
    )
)
def path_of_contact(ratio: Number, pitch: Number) -> Number:
    """{ratio}·{pitch}"""


@formula(
    why=said(
        "While the touching point goes along the line of action, the base circles turn by arcs of that length; "
        "on the rolling circles the arc is longer as their radius is."
    )
)
def arc_of_engagement(path: Number, r_w: Number, r_b: Number) -> Number:
    """{path}·{r_w}/{r_b}"""


@formula(
    why=said("The line of action is the common normal: along it both flanks are equally fast.")
)
def sliding_velocity(omega1: Number, omega2: Number, x: Number, pole: Number) -> Number:
    """({omega1} + {omega2})·({x} − {pole})"""


@formula(why=said("It is told by how fast both rolling circles run."))
def ratio_of_speeds(sliding: Number, rolling: Number) -> Number:
    """{sliding}/{rolling}"""


@formula(why=said("The rolling circles do not slide: with more teeth the wheel turns more slowly."))
def driven_speed(omega: Number, ratio: Number) -> Number:
    """{omega}/{ratio}"""


@formula(why=said("All teeth together take the whole turn."))
def angular_pitch(z: Number) -> Angle:
    """360°/{z}"""


@formula(why=said("The circle is divided into as many pitches as there are teeth."))
def arc_of_pitch(r: Number, z: Number) -> Number:
    """2·π·{r}/{z}"""


@formula(why=said("A tooth is symmetrical: half of it is laid off to either side."))
def half_of(length: Length) -> Length:
    """{length}/2"""


@formula(why=said("The line of action is divided into parts, at which the sliding is found."))
def part_of(share: Number, length: Length) -> Length:
    """{share}·{length}"""


@formula(why=said("What is not on the one side of the point is on the other."))
def remainder(whole: Length, part: Length) -> Length:
    """{whole} − {part}"""


@formula(
    fails="the length to divide by is zero",
    why=said(
        "The drawn path of contact to the drawn pitch: the contact ratio read off the drawing."
    ),
)
def ratio_of(part: Length, whole: Length) -> Number:
    """{part}/{whole}"""


@formula(why=said("No flank goes below the base circle: the compass is not set smaller."))
def at_least(length: Length, least: Length) -> Length:
    """max({length}, {least})"""


@formula(why=said("The drawing is compared with the calculation."))
def percent_off(found: Number, due: Number) -> Number:
    """100·({found} − {due})/{due}"""


@formula(
    holds="{near} > 0, {far} ≥ 0",
    fails="the point does not lie between the limits of the line of action",
    why=said(
        "The flanks roll and slide: the sliding velocity is taken by that along the own flank; both follow "
        "from the distances to the ends of the line of action."
    ),
)
def specific_sliding(own: Number, other: Number, far: Length, near: Length) -> Number:
    """1 − {own}/{other}·{far}/{near}

    ``near``: how far the point is from the limit of the wheel's own base circle, ``far``: from the other's.
    """
