"""Formulas of work and energy: gas force, reduced moment, kinetic energy, inertia and rim of a flywheel."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number

_NO_CRANK = "the crank pin does not move"
_NOT_NEEDED = "no flywheel is needed: the inertia of the links suffices"


@formula
def ring_area(outer: Number, inner: Number) -> Number:
    """π·({outer}² − {inner}²)/4"""


@formula(fails="the stroke has no length")
def polytropic(
    pressure: Number,
    clearance: Number,
    start: Number,
    travel: Length,
    stroke: Length,
    exponent: Number,
) -> Number:
    """{pressure}·(({clearance} + {start})/({clearance} + {travel}/{stroke}))^{exponent}"""


@formula(fails="the stroke has no length")
def polytropic_at_shaft(
    pressure: Number,
    clearance: Number,
    start: Number,
    travel: Length,
    stroke: Length,
    exponent: Number,
) -> Number:
    """{pressure}·(({clearance} + 1 − {start})/({clearance} + 1 − {travel}/{stroke}))^{exponent}"""


@formula(fails="the stroke has no length")
def between(
    first: Number, last: Number, start: Number, end: Number, travel: Length, stroke: Length
) -> Number:
    """{first} + ({last} − {first})·({travel}/{stroke} − {start})/({end} − {start})"""


@formula
def gas_force(pressure: Number, area: Number) -> Number:
    """{pressure}·{area}"""


@formula
def net_force(cover: Number, shaft: Number) -> Number:
    """{cover} − {shaft}"""


@formula(holds="{of_pin} ≠ 0", fails=_NO_CRANK)
def reduced_moment(
    outward: Number, force: Number, of_point: Length, of_pin: Length, arm: Number
) -> Number:
    """−{outward}·{force}·{of_point}/{of_pin}·{arm}"""


@formula(holds="{of_pin} ≠ 0", fails=_NO_CRANK)
def moment_of_drive(moment: Number, arm: Number, of_pin: Length) -> Number:
    """{moment}·{arm}/{of_pin}"""


@formula(holds="{of_pin} ≠ 0", fails=_NO_CRANK)
def moment_of_resistance(moment: Number, arm: Number, of_pin: Length) -> Number:
    """−{moment}·{arm}/{of_pin}"""


@formula
def translation(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·({segment}·{mu})²/2"""


@formula
def rotation(inertia: Number, omega: Number) -> Number:
    """{inertia}·{omega}²/2"""


@formula
def added(first: Number, second: Number) -> Number:
    """{first} + {second}"""


@formula
def reduced_inertia(energy: Number, omega: Number) -> Number:
    """2·{energy}/{omega}²"""


@formula(holds="{segment} > 0", fails=_NOT_NEEDED)
def flywheel_inertia(segment: Length, mu: Number, delta: Number, omega: Number) -> Number:
    """{segment}·{mu}/({delta}·{omega}²)"""


@formula
def steepest(mu_J: Number, mu_T: Number, omega: Number, delta: Number) -> Angle:
    """arctan({mu_J}·{omega}²·(1 + {delta})/(2·{mu_T}))"""


@formula
def flattest(mu_J: Number, mu_T: Number, omega: Number, delta: Number) -> Angle:
    """arctan({mu_J}·{omega}²·(1 − {delta})/(2·{mu_T}))"""


@formula
def largest_rim(speed: Number, omega: Number) -> Number:
    """2·{speed}/{omega}"""


@formula
def share(of: Number, ratio: Number) -> Number:
    """{ratio}·{of}"""


@formula
def mean(first: Number, second: Number) -> Number:
    """({first} + {second})/2"""


@formula
def rim_mass(inertia: Number, mean_diameter: Number) -> Number:
    """4·{inertia}/{mean_diameter}²"""


@formula
def rim_width(
    inertia: Number, density: Number, outer: Number, inner: Number, middle: Number
) -> Number:
    """16·{inertia}/(π·{density}·({outer}² − {inner}²)·{middle}²)"""


@formula
def mean_ordinate(area: Number, base: Length) -> Length:
    """{area}/{base}"""
