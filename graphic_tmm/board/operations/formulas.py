"""Calculated lengths and quantities: steps too, each with its formula as its sentence.

The names in braces are the operation's arguments, so the text that is computed also gives the letters of the
calculation note and, with readings put in, its numbers. Angular quantities follow from
*signed* segments: the sense is the sign.
"""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_NO_INTERVALS = "the base has no intervals"
_ZERO_LENGTH = "the length to divide by is zero"


@formula(
    fails=_ZERO_LENGTH,
    why=said(
        "A length on the drawing is the quantity divided by its scale factor, which tells how much a "
        "millimetre stands for."
    ),
)
def to_board(quantity: Number, mu: Number) -> Length:
    """{quantity}/{mu}"""


@formula(
    why=said("A millimetre stands for {mu}, so the quantity is the length times the scale factor.")
)
def in_si(length: Length, mu: Number) -> Number:
    """{length}·{mu}"""


@formula(why=said("The two lengths lie one behind the other in one line."))
def total(first: Length, second: Length) -> Length:
    """{first} + {second}"""


@formula(why=said("The two lengths lie one over the other in one line."))
def difference(first: Length, second: Length) -> Length:
    """|{first} − {second}|"""


@formula(
    why=said(
        "The crank turns evenly, so equal angles are equal times; they are counted from the zero position "
        "in the sense of turning."
    )
)
def advance(zero: Angle, by: Angle) -> Angle:
    """{zero} + {by}"""


@formula(
    why=said(
        "What drives slides: how far it has come in each position is counted from where it is in the first."
    )
)
def run_out(zero: Number, by: Number) -> Number:
    """{zero} + {by}"""


_FOLLOWS = said(
    "While the first drive goes on by {row} − {zero} from the first position, this one goes on by {ratio} "
    "times that from {start}."
)


@formula(why=_FOLLOWS)
def angle_by_angle(start: Angle, ratio: Number, row: Angle, zero: Angle) -> Angle:
    """{start} + {ratio}·({row} − {zero})"""


@formula(why=_FOLLOWS)
def angle_by_length(start: Angle, ratio: Number, row: Number, zero: Number) -> Angle:
    """{start} + {ratio}·({row} − {zero})"""


@formula(why=_FOLLOWS)
def length_by_angle(start: Number, ratio: Number, row: Angle, zero: Angle) -> Number:
    """{start} + {ratio}·({row} − {zero})"""


@formula(why=_FOLLOWS)
def length_by_length(start: Number, ratio: Number, row: Number, zero: Number) -> Number:
    """{start} + {ratio}·({row} − {zero})"""


@formula(why=said("On a circle the rate of turning times the radius is the rate along the circle."))
def product(omega: Number, length: Number) -> Number:
    """{omega}·{length}"""


@formula(
    why=said(
        "A point that goes round in a circle gains ω²·l towards its centre, for the direction of its "
        "velocity turns at the rate ω."
    )
)
def product_of_squares(omega: Number, length: Number) -> Number:
    """{omega}²·{length}"""


@formula(
    fails=_ZERO_LENGTH,
    why=said(
        "About one end of a length the other moves at ω (ε) times that length, so the rate of turning is "
        "this part of the vector divided by the length."
    ),
)
def rate(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
    """{segment}·{mu}/({link}·{mu_l})"""


@formula(
    fails=_ZERO_LENGTH,
    why=said(
        "About one end of a length the other moves at ω times that length; on the turned plan the sense is "
        "the opposite one."
    ),
)
def rate_turned(segment: Length, mu: Number, link: Length, mu_l: Number) -> Number:
    """−{segment}·{mu}/({link}·{mu_l})"""


@formula(
    fails=_ZERO_LENGTH,
    why=said(
        "About another point of the link a point goes round in a circle with the velocity "
        "{segment}·{mu_v}: its normal acceleration is the square of that divided by the radius "
        "{link}·{mu_l}, on the plan divided by {mu_a}."
    ),
)
def normal(segment: Length, mu_v: Number, link: Length, mu_l: Number, mu_a: Number) -> Length:
    """({segment}·{mu_v})²/({link}·{mu_l})/{mu_a}"""


@formula(
    why=said(
        "The guide turns while the other link slides along it: the relative velocity is turned with the "
        "guide, and that link comes to places that move faster or slower. Each adds ω·v_r, both together "
        "2·ω·v_r."
    )
)
def coriolis(omega: Number, segment: Length, mu_v: Number, mu_a: Number) -> Length:
    """2·{omega}·{segment}·{mu_v}/{mu_a}"""


@formula(
    why=said(
        "The rocker's slow and fast strokes take the crank's angles 180° + θ and 180° − θ; at even speed "
        "K_v is their ratio, hence θ."
    )
)
def swing_angle(ratio: Number) -> Angle:
    """180°·({ratio} − 1)/({ratio} + 1)"""


@formula(
    why=said(
        "In the extreme positions the rocker touches the circle of the crank pin, so the crank is square "
        "to it: in that right triangle the crank is opposite θ/2."
    )
)
def sine_of_half(length: Number, angle: Angle) -> Number:
    """{length}·sin({angle}/2)"""


@formula(
    why=said(
        "Between its extreme positions the arm's end goes over a chord as long as the stroke, under the "
        "angle θ: half the chord is the arm times sin(θ/2)."
    )
)
def half_chord(stroke: Number, angle: Angle) -> Number:
    """{stroke}/(2·sin({angle}/2))"""


@formula(
    fails=_NO_INTERVALS,
    why=said("{base} is divided into {intervals} equal parts, of which {n} are taken."),
)
def abscissa(n: Number, base: Length, intervals: Number) -> Length:
    """{n}·{base}/{intervals}"""


@formula(why=said("The base of the graph stands for a whole turn, 2π rad."))
def turn_per_mm(base: Length) -> Number:
    """2π/{base}"""


@formula(
    why=said("The base of the graph stands for the whole cycle of {turns} turns, 2π rad each.")
)
def cycle_per_mm(turns: Number, base: Length) -> Number:
    """2π·{turns}/{base}"""


@formula(why=said("The base stands for a whole turn, which takes the time 2π/ω."))
def time_per_mm(omega: Number, base: Length) -> Number:
    """2π/({omega}·{base})"""


@formula(why=said("The drive goes evenly: from the first position to the last it takes this time."))
def time_of_row(way: Number, speed: Number) -> Number:
    """{way}/{speed}"""


@formula(why=said("The base stands for the whole row, from its first position to its last."))
def row_per_mm(whole: Number, base: Length) -> Number:
    """{whole}/{base}"""


@formula(why=said("The base stands for the whole row; to this scale it is so long."))
def mm_of_row(whole: Number, mu: Number) -> Length:
    """{whole}/{mu}"""


@formula(why=said("The base stands for a whole turn, 2π rad, to this scale."))
def mm_of_turn(mu: Number) -> Length:
    """2π/{mu}"""


@formula(why=said("A turn takes the time 2π/ω; to this scale the base is so long."))
def mm_of_time(omega: Number, mu: Number) -> Length:
    """2π/({omega}·{mu})"""


@formula(
    why=said(
        "A ray of the slope of the graph rises over the pole distance by the derivative: its scale is "
        "fixed, so that distance follows from it."
    )
)
def pole_distance(mu: Number, mu_of_derivative: Number, mu_along: Number) -> Length:
    """{mu}/({mu_of_derivative}·{mu_along})"""


@formula(
    why=said(
        "The slope of a graph, mm/mm, is the derivative divided by {mu}/{mu_along}; a ray of that slope "
        "shows it, over the pole distance {pole}, by {pole} times the slope in mm. So a millimetre stands "
        "for {mu}/({mu_along}·{pole})."
    )
)
def scale_of_derivative(mu: Number, mu_along: Number, pole: Length) -> Number:
    """{mu}/({mu_along}·{pole})"""


@formula(
    why=said(
        "A ray over the pole distance {pole} as high as an ordinate has the slope ordinate/{pole}; drawn "
        "on over an interval it adds the area below the graph divided by {pole}. So a millimetre stands "
        "for {mu}·{mu_along}·{pole}."
    )
)
def scale_of_integral(mu: Number, mu_along: Number, pole: Length) -> Number:
    """{mu}·{mu_along}·{pole}"""


@formula(
    why=said(
        "The same quantity is drawn to another scale: its length changes in the ratio of both."
    )
)
def rescaled(length: Length, mu: Number, other: Number) -> Length:
    """{length}·{mu}/{other}"""


@formula(why=said("The pitch circle carries {z} teeth of the pitch π·{m}: 2π·r = π·{m}·{z}."))
def pitch_radius(m: Number, z: Number) -> Number:
    """{m}·{z}/2"""


@formula(why=said("A revolution is 2π, a minute 60 s."))
def turns_a_minute(omega: Number) -> Number:
    """30·{omega}/π"""
