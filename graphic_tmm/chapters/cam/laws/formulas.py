"""Formulas of the laws: ordinates of S, V and A by the share of the phase that has passed."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_ALL_EASED = "nothing is left of the even motion"


@formula(why=said("The laws are written by the share of the phase that has passed."))
def share_of_parts(number: Number, parts: Number) -> Number:
    """{number}/{parts}"""


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
    holds="{part} > 0",
    fails="nothing of the phase is left for it",
    why=said("Over its part of the phase the velocity grows to 2h/Φ, or falls from it."),
)
def shared_A(stroke: Number, phase: Number, part: Number, mu: Number) -> Length:
    """2·{stroke}/({part}·{phase}²·{mu})"""


@formula(
    why=said(
        "This polynomial begins and ends without velocity and acceleration, so there is no shock."
    )
)
def polynomial_S(share: Number, height: Length) -> Length:
    """{height}·(10·{share}³ − 15·{share}⁴ + 6·{share}⁵)"""


@formula(
    why=said(
        "The chord between the neighbours of a line of the table has the slope of the curve there, nearly."
    )
)
def chord_V(after: Number, before: Number, parts: Number, phase: Number, mu: Number) -> Length:
    """({after} − {before})·{parts}/(2·{phase}·{mu})"""


@formula(
    why=said(
        "The slopes of the chords on both sides of a line differ by what the velocity gains over a step."
    )
)
def chord_A(
    after: Number, here: Number, before: Number, parts: Number, phase: Number, mu: Number
) -> Length:
    """({after} − 2·{here} + {before})·{parts}²/({phase}²·{mu})"""


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
