"""Formulas of mechanisms found from a task: slider-cranks, crank-rockers, circles through three places."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.formula_text import define
from graphic_tmm.board.values import Angle, Number, Reals
from graphic_tmm.language.said import said

_DEAD_ENDS = said(
    "In the dead centres crank and connecting rod lie in one line: the ends of the stroke are l + r and "
    "l − r from O, which sees the stroke under θ at the height e over it."
)
_CIRCLE = said(
    "A point keeps its distance from its centre of turning, so that centre stands on the bisectors of two "
    "chords between its places; their equations give it."
)


def _ln(value: Reals) -> Reals:
    return np.log(np.where(value > 0.0, value, np.nan))


define("ln", _ln)


@formula(
    holds="{omega} ≠ 0",
    fails="the crank stands",
    why=said("A turn takes 2π/ω, and the slider goes twice over its stroke meanwhile."),
)
def stroke_by_speed(speed: Number, omega: Number) -> Number:
    """π·{speed}/{omega}"""


@formula(holds="{theta} > 0", fails="θ is zero", why=_DEAD_ENDS)
def crank_by_offset(stroke: Number, offset: Number, theta: Angle) -> Number:
    """√({stroke}²/4 − {stroke}·{offset}·tan({theta}/2)/2)"""


@formula(holds="{theta} > 0", fails="θ is zero", why=_DEAD_ENDS)
def rod_by_offset(stroke: Number, offset: Number, theta: Angle) -> Number:
    """√({stroke}²/4 + {stroke}·{offset}/(2·tan({theta}/2)))"""


@formula(why=said("The slider goes as far as the crank pin along its way: the diameter 2·r."))
def half_stroke(stroke: Number) -> Number:
    """{stroke}/2"""


@formula(
    holds="{stroke} > 0, {ratio} > 0",
    fails="there is no stroke",
    why=said(
        "The dead centres are √((l + r)² − e²) and √((l − r)² − e²) along the guide, and their difference is "
        "the stroke; with l = λ·r that is an equation for r²."
    ),
)
def crank_by_ratio(stroke: Number, offset: Number, ratio: Number) -> Number:
    """{stroke}·√((1 + {ratio}² + √((1 + {ratio}²)² − 4·{ratio}²·(1 + 4·{offset}²/{stroke}²)))/(8·{ratio}²))"""


@formula(why=said("The task gives the ratio of the connecting rod to the crank."))
def rod_by_ratio(ratio: Number, crank: Number) -> Number:
    """{ratio}·{crank}"""


@formula(
    holds="sin({pressure}) ≠ 0",
    fails="the pressure angle is zero",
    why=said(
        "The connecting rod stands most aslant where the crank is square to the guide: sin α = r/l."
    ),
)
def rod_by_pressure(crank: Number, pressure: Angle) -> Number:
    """{crank}/sin({pressure})"""


@formula(
    holds="sin({pressure}) ≠ 0",
    fails="the pressure angle is zero",
    why=said(
        "The connecting rod stands most aslant where the crank is square to the guide, on the side away from "
        "it: sin α = (r + e)/l."
    ),
)
def rod_by_pressure_offset(crank: Number, offset: Number, pressure: Angle) -> Number:
    """({crank} + {offset})/sin({pressure})"""


@formula(why=said("Half the chord between both extreme places of B is the rocker times sin(ψ/2)."))
def half_of_chord(rocker: Number, swing: Angle) -> Number:
    """{rocker}·sin({swing}/2)"""


@formula(why=said("The chord lies as far from the pivot C as the rocker times cos(ψ/2)."))
def height_of_chord(rocker: Number, swing: Angle) -> Number:
    """{rocker}·cos({swing}/2)"""


@formula(
    holds="{theta} > 0",
    fails="θ is zero",
    why=said(
        "The circle from which the chord is seen under θ has its centre on the axis of the chord, half the "
        "chord by tan θ behind it."
    ),
)
def centre_beyond(height: Number, half: Number, theta: Angle) -> Number:
    """{height} + {half}/tan({theta})"""


@formula(
    holds="{theta} > 0",
    fails="θ is zero",
    why=said(
        "The circle from which the chord is seen under θ has its centre on the axis of the chord, half the "
        "chord by tan θ before it."
    ),
)
def centre_before(height: Number, half: Number, theta: Angle) -> Number:
    """{height} − {half}/tan({theta})"""


@formula(
    holds="{centre} ≠ 0",
    fails="both circles have one centre",
    why=said(
        "O stands on that circle and, at the distance of the pivots, on a circle about C: both equations "
        "give how far along the axis."
    ),
)
def along_axis(frame: Number, height: Number, half: Number, centre: Number) -> Number:
    """({frame}² + {height}² − {half}² + 2·{height}·({centre} − {height}))/(2·{centre})"""


@formula(
    holds="{frame}² ≥ {along}²",
    fails="the circles do not meet",
    why=said("O is at the distance of the pivots from C: Pythagoras gives how far from the axis."),
)
def off_axis(frame: Number, along: Number) -> Number:
    """√({frame}² − {along}²)"""


_ABOUT = said(
    "Where θ is half of ψ, the circle from which the chord is seen under θ is about C and goes through both "
    "places of B: O stands on it as far from C as B does."
)


@formula(why=_ABOUT)
def pivots_about(rocker: Number) -> Number:
    """{rocker}"""


@formula(why=_ABOUT)
def along_by_angle(frame: Number, angle: Angle) -> Number:
    """{frame}·cos({angle})"""


@formula(why=_ABOUT)
def off_by_angle(frame: Number, angle: Angle) -> Number:
    """{frame}·sin({angle})"""


@formula(why=said("O and the far end of the chord are corners of a right triangle."))
def far_end(off: Number, half: Number, along: Number, height: Number) -> Number:
    """√(({off} + {half})² + ({along} − {height})²)"""


@formula(why=said("O and the near end of the chord are corners of a right triangle."))
def near_end(off: Number, half: Number, along: Number, height: Number) -> Number:
    """√(({off} − {half})² + ({along} − {height})²)"""


@formula(
    why=said(
        "In the dead centres crank and coupler lie in one line: B is l + r and l − r from O, so the crank is "
        "half the difference."
    )
)
def half_difference(far: Number, near: Number) -> Number:
    """({far} − {near})/2"""


@formula(
    why=said(
        "In the dead centres crank and coupler lie in one line: B is l + r and l − r from O, so the coupler "
        "is half the sum."
    )
)
def half_sum(far: Number, near: Number) -> Number:
    """({far} + {near})/2"""


_TRANSMISSION = said(
    "The coupler presses on the rocker most aslant where crank and frame lie in one line; the law of cosines "
    "gives the angle between coupler and rocker there."
)


@formula(
    holds="{coupler} > 0, {rocker} > 0, {coupler} + {rocker} ≥ |{frame} − {crank}|, "
    "|{coupler} − {rocker}| ≤ |{frame} − {crank}|",
    fails="the links do not close",
    why=_TRANSMISSION,
)
def transmission_folded(crank: Number, coupler: Number, rocker: Number, frame: Number) -> Angle:
    """arccos(({coupler}² + {rocker}² − ({frame} − {crank})²)/(2·{coupler}·{rocker}))"""


@formula(
    holds="{coupler} > 0, {rocker} > 0, {coupler} + {rocker} ≥ |{frame} + {crank}|, "
    "|{coupler} − {rocker}| ≤ |{frame} + {crank}|",
    fails="the links do not close",
    why=_TRANSMISSION,
)
def transmission_stretched(crank: Number, coupler: Number, rocker: Number, frame: Number) -> Angle:
    """arccos(({coupler}² + {rocker}² − ({frame} + {crank})²)/(2·{coupler}·{rocker}))"""


@formula(why=said("The end of a link stands its length away along its direction."))
def end_across(start: Number, length: Number, angle: Angle) -> Number:
    """{start} + {length}·cos({angle})"""


@formula(why=said("The end of a link stands its length away along its direction."))
def end_up(start: Number, length: Number, angle: Angle) -> Number:
    """{start} + {length}·sin({angle})"""


@formula(
    why=said(
        "The rocker is held in its first position, so the frame turns back about C by the rocker's angle."
    )
)
def turned_across(x: Number, y: Number, pivot: Number, first: Angle, angle: Angle) -> Number:
    """{pivot} + ({x} − {pivot})·cos({angle} − {first}) + {y}·sin({angle} − {first})"""


@formula(
    why=said(
        "The rocker is held in its first position, so the frame turns back about C by the rocker's angle."
    )
)
def turned_up(x: Number, y: Number, pivot: Number, first: Angle, angle: Angle) -> Number:
    """{y}·cos({angle} − {first}) − ({x} − {pivot})·sin({angle} − {first})"""


@formula(why=_CIRCLE)
def double_area(x1: Number, y1: Number, x2: Number, y2: Number, x3: Number, y3: Number) -> Number:
    """2·(({x2} − {x1})·({y3} − {y1}) − ({x3} − {x1})·({y2} − {y1}))"""


@formula(why=_CIRCLE)
def chord_square(x1: Number, y1: Number, x2: Number, y2: Number) -> Number:
    """({x2} − {x1})² + ({y2} − {y1})²"""


@formula(holds="{area} ≠ 0", fails="the three places lie in one line", why=_CIRCLE)
def circle_centre(
    own: Number, first: Number, second: Number, third: Number, q: Number, s: Number, area: Number
) -> Number:
    """{own} + (({third} − {first})·{q} − ({second} − {first})·{s})/{area}"""


@formula(why=said("The length of a link is how far its ends are apart."))
def link_length(x1: Number, y1: Number, x2: Number, y2: Number) -> Number:
    """√(({x2} − {x1})² + ({y2} − {y1})²)"""


_DIAGONAL = said(
    "B is the rod's length from A and the rocker's from C: the law of cosines gives how far along the diagonal "
    "AC it lies, and how far off it."
)
_OF_COUPLER = said("The point lies in its coupler, which is turned and moved with AB.")


@formula(holds="{far} > 0", fails="A stands in C", why=_DIAGONAL)
def along_diagonal(rod: Number, rocker: Number, far: Number) -> Number:
    """({rod}² + {far}² − {rocker}²)/(2·{far})"""


@formula(holds="{rod}² ≥ {along}²", fails="the links do not close", why=_DIAGONAL)
def off_diagonal(rod: Number, along: Number) -> Number:
    """√({rod}² − {along}²)"""


@formula(holds="{far} > 0", fails="A stands in C", why=_DIAGONAL)
def pin_across(
    x: Number, y: Number, pivot: Number, far: Number, along: Number, off: Number
) -> Number:
    """{x} + ({along}·({pivot} − {x}) + {off}·{y})/{far}"""


@formula(holds="{far} > 0", fails="A stands in C", why=_DIAGONAL)
def pin_up(x: Number, y: Number, pivot: Number, far: Number, along: Number, off: Number) -> Number:
    """{y} + ({off}·({pivot} − {x}) − {along}·{y})/{far}"""


@formula(holds="{rod} > 0", fails="the coupler has no length", why=_OF_COUPLER)
def point_across(
    x: Number, y: Number, end_x: Number, end_y: Number, rod: Number, across: Number, up: Number
) -> Number:
    """{x} + (({end_x} − {x})·{across} − ({end_y} − {y})·{up})/{rod}"""


@formula(holds="{rod} > 0", fails="the coupler has no length", why=_OF_COUPLER)
def point_up(
    x: Number, y: Number, end_x: Number, end_y: Number, rod: Number, across: Number, up: Number
) -> Number:
    """{y} + (({end_y} − {y})·{across} + ({end_x} − {x})·{up})/{rod}"""


@formula(
    holds="sin({swing}/2) ≠ 0",
    fails="the cylinder does not swing",
    why=said(
        "In its extreme positions the cylinder touches the circle of the crank pin, whose radius is seen from "
        "C under half the swing."
    ),
)
def pivots_by_swing(crank: Number, swing: Angle) -> Number:
    """{crank}/sin({swing}/2)"""


@formula(
    why=said(
        "At the places of Chebyshev's spacing a function that is met in three of them is off least between."
    )
)
def chebyshev(low: Number, high: Number, share: Number) -> Number:
    """({low} + {high})/2 + {share}·({high} − {low})·√(3)/4"""


@formula(holds="{x} > 0", fails="the argument is not positive", why=said("The function is given."))
def power_function(x: Number, exponent: Number) -> Number:
    """{x}^{exponent}"""


@formula(why=said("The function is given."))
def power_of_any(x: Number, exponent: Number) -> Number:
    """{x}^{exponent}"""


@formula(holds="{x} > 0", fails="the argument is not positive", why=said("The function is given."))
def logarithm(x: Number) -> Number:
    """ln({x})"""


@formula(why=said("The function is given, its argument in degrees."))
def sine(x: Number) -> Number:
    """sin({x}·1°)"""


@formula(
    holds="{low} ≠ {high}",
    fails="the range of the argument is empty",
    why=said("Angles are laid off in proportion to what they stand for."),
)
def in_proportion(value: Number, low: Number, high: Number, start: Angle, end: Angle) -> Angle:
    """{start} + ({value} − {low})/({high} − {low})·({end} − {start})"""
