"""Formulas of work and energy: gas force, reduced moment, kinetic energy, inertia and rim of a flywheel."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_NO_CRANK = "the crank pin does not move"
_NOT_NEEDED = "no flywheel is needed: the inertia of the links suffices"


@formula(why=said("The pressure acts on the area of the piston less that of its rod."))
def ring_area(outer: Number, inner: Number) -> Number:
    """π·({outer}² − {inner}²)/4"""


@formula(
    fails="the stroke has no length",
    why=said(
        "Closed in, the gas expands and is compressed by a polytropic law; the volume is the clearance and "
        "what the piston has left free."
    ),
)
def polytropic(
    pressure: Number,
    clearance: Number,
    start: Number,
    travel: Length,
    stroke: Length,
    exponent: Number,
) -> Number:
    """{pressure}·(({clearance} + {start})/({clearance} + {travel}/{stroke}))^{exponent}"""


@formula(
    fails="the stroke has no length",
    why=said(
        "Closed in, the gas expands and is compressed by a polytropic law; on this side the volume is largest"
        " where it is smallest on the other."
    ),
)
def polytropic_at_shaft(
    pressure: Number,
    clearance: Number,
    start: Number,
    travel: Length,
    stroke: Length,
    exponent: Number,
) -> Number:
    """{pressure}·(({clearance} + 1 − {start})/({clearance} + 1 − {travel}/{stroke}))^{exponent}"""


@formula(
    fails="the stroke has no length",
    why=said("Between two known points what is given changes evenly with the travel."),
)
def between(
    first: Number, last: Number, start: Number, end: Number, travel: Length, stroke: Length
) -> Number:
    """{first} + ({last} − {first})·({travel}/{stroke} − {start})/({end} − {start})"""


@formula(
    fails="the swing has no angle",
    why=said("Between two known angles what is given changes evenly with the swing."),
)
def between_turns(
    first: Number, last: Number, start: Number, end: Number, swing: Angle, whole: Angle
) -> Number:
    """{first} + ({last} − {first})·({swing}/{whole} − {start})/({end} − {start})"""


@formula(why=said("A pressure acts on every unit of the area."))
def gas_force(pressure: Number, area: Number) -> Number:
    """{pressure}·{area}"""


@formula(why=said("The piston feels the difference of the forces on its two sides."))
def net_force(cover: Number, shaft: Number) -> Number:
    """{cover} − {shaft}"""


@formula(
    holds="{of_pin} ≠ 0",
    fails=_NO_CRANK,
    why=said(
        "The reduced moment has the power of the force: force times velocity of its point is moment times "
        "ω. The ratio of the velocities is read off the plan."
    ),
)
def reduced_moment(
    outward: Number, force: Number, of_point: Length, of_pin: Length, arm: Number
) -> Number:
    """−{outward}·{force}·{of_point}/{of_pin}·{arm}"""


@formula(
    holds="{of_pin} ≠ 0",
    fails=_NO_CRANK,
    why=said(
        "The moment on the lever is a power, to scale; divided by the pin's velocity it is a force on the "
        "pin, times the crank's length a moment on the shaft."
    ),
)
def moment_of_drive(moment: Number, arm: Number, of_pin: Length) -> Number:
    """{moment}·{arm}/{of_pin}"""


@formula(
    holds="{of_pin} ≠ 0",
    fails=_NO_CRANK,
    why=said(
        "The moment on the lever is a power, to scale; divided by the pin's velocity it is a force on the "
        "pin, times the crank's length a moment on the shaft. A resistance takes power: it counts with the "
        "opposite sign."
    ),
)
def moment_of_resistance(moment: Number, arm: Number, of_pin: Length) -> Number:
    """−{moment}·{arm}/{of_pin}"""


@formula(
    why=said(
        "The kinetic energy of a mass that moves at v is m·v²/2, here with v = {segment}·{mu}."
    )
)
def translation(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·({segment}·{mu})²/2"""


@formula(why=said("The kinetic energy of a body that turns at ω is J·ω²/2."))
def rotation(inertia: Number, omega: Number) -> Number:
    """{inertia}·{omega}²/2"""


@formula(why=said("The parts add up to the whole."))
def added(first: Number, second: Number) -> Number:
    """{first} + {second}"""


@formula(
    why=said("A link is taken for an even rod: its moment of inertia about the middle is m·l²/12.")
)
def rod_inertia(mass: Number, length: Number) -> Number:
    """{mass}·{length}²/12"""


@formula(
    why=said(
        "The reduced moment of inertia, turning with the crank, has the kinetic energy of all links: "
        "J·ω²/2 = T."
    )
)
def reduced_inertia(energy: Number, omega: Number) -> Number:
    """2·{energy}/{omega}²"""


@formula(
    holds="{segment} > 0",
    fails=_NOT_NEEDED,
    why=said(
        "Between its greatest and its least speed the flywheel's energy changes by "
        "J·δ·ω²; that change is {segment} times {mu}."
    ),
)
def flywheel_inertia(segment: Length, mu: Number, delta: Number, omega: Number) -> Number:
    """{segment}·{mu}/({delta}·{omega}²)"""


@formula(
    why=said(
        "Between its greatest and its least speed the energy of a flywheel changes by J·δ·ω²; that change is "
        "{segment} times {mu}, and J is given."
    )
)
def irregularity(segment: Length, mu: Number, inertia: Number, omega: Number) -> Number:
    """{segment}·{mu}/({inertia}·{omega}²)"""


@formula(
    why=said(
        "A ray of the diagram of energy and mass has the slope ω²/2, to scale; at the greatest speed "
        "allowed ω² is larger by the share δ."
    )
)
def steepest(mu_J: Number, mu_T: Number, omega: Number, delta: Number) -> Angle:
    """arctan({mu_J}·{omega}²·(1 + {delta})/(2·{mu_T}))"""


@formula(
    why=said(
        "A ray of the diagram of energy and mass has the slope ω²/2, to scale; at the least speed allowed "
        "ω² is smaller by the share δ."
    )
)
def flattest(mu_J: Number, mu_T: Number, omega: Number, delta: Number) -> Angle:
    """arctan({mu_J}·{omega}²·(1 − {delta})/(2·{mu_T}))"""


@formula(why=said("The rim runs at ω·D/2; a faster one would not bear its own centrifugal force."))
def largest_rim(speed: Number, omega: Number) -> Number:
    """2·{speed}/{omega}"""


@formula(why=said("It is taken as this share of {of}, as is usual in the design."))
def share(of: Number, ratio: Number) -> Number:
    """{ratio}·{of}"""


@formula(why=said("The mass of a thin rim is thought of on its mean diameter."))
def mean(first: Number, second: Number) -> Number:
    """({first} + {second})/2"""


@formula(why=said("All of the rim's mass runs at nearly half its mean diameter: J = m·D²/4."))
def rim_mass(inertia: Number, mean_diameter: Number) -> Number:
    """4·{inertia}/{mean_diameter}²"""


@formula(
    why=said(
        "The mass of the ring, its area times width and density, at half its mean diameter has to have "
        "the moment of inertia found."
    )
)
def rim_width(
    inertia: Number, density: Number, outer: Number, inner: Number, middle: Number
) -> Number:
    """16·{inertia}/(π·{density}·({outer}² − {inner}²)·{middle}²)"""


@formula(why=said("A rectangle over the same base with this height has the same area."))
def mean_ordinate(area: Number, base: Length) -> Length:
    """{area}/{base}"""
