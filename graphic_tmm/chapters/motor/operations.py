"""Operations and formulas of a motor: its characteristic on the crank, and the crossing of one interval."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import FREE, operation
from graphic_tmm.board.values import Curve, Length, Number, Point, Reals
from graphic_tmm.chapters.motor.operations_curve import BEYOND, Motor, crossed, single
from graphic_tmm.language.said import said

KNOTS = 241
"""Points of a characteristic: with a critical slip of 0.05 its curve is off by 4e-6 of the greatest moment."""
BY_POINTS, BY_RULER = "12K1 + 12K2", "2R1 + R2"
"""By hand a characteristic is drawn with the French curve through a dozen points, or straight."""
HALF, FROM_REST = 0.5, 2.0 / 3.0
"""Which share of the mean moment of an interval is that of its end; of the interval that begins at rest."""


@formula(why=said("Power is moment times angular velocity, so the nominal speed has this moment."))
def nominal_moment(power: Number, omega: Number) -> Number:
    """{power}/{omega}"""


@formula(why=said("The slip is by what share the rotor stays behind the field."))
def slip(synchronous: Number, omega: Number) -> Number:
    """({synchronous} − {omega})/{synchronous}"""


@formula(
    why=said(
        "Kloss's formula goes through the nominal point; so much is the slip with the greatest moment."
    )
)
def critical_slip(nominal: Number, overload: Number) -> Number:
    """{nominal}·({overload} + √({overload}² − 1))"""


@formula(
    why=said("On the crank the motor's moment counts as many times as the motor turns faster.")
)
def moment_on_crank(moment: Number, times: Number, ratio: Number) -> Number:
    """{moment}·{times}·{ratio}"""


@formula(why=said("The crank turns so many times more slowly than the motor."))
def speed_of_crank(omega: Number, ratio: Number) -> Number:
    """{omega}/{ratio}"""


@formula(
    why=said(
        "What turns faster than the crank has its energy, J·(i·ω)²/2: on the crank it counts i² times."
    )
)
def inertia_on_crank(inertia: Number, ratio: Number) -> Number:
    """{inertia}·{ratio}²"""


@formula(
    holds="{idle} ≠ {omega}",
    fails="both speeds of the motor are the same",
    why=said(
        "The straight line through the speed without load and the nominal point begins at this moment."
    ),
)
def starting_moment(moment: Number, idle: Number, omega: Number) -> Number:
    """{moment}·{idle}/({idle} − {omega})"""


def _through(omega: Reals, moment: Reals, rise: Reals, mu_M: Reals, mu_omega: Reals) -> Curve:
    """Return a curve by speeds, moments there, and their rise by unit of speed."""
    mu_M, mu_omega, step = single((mu_M, mu_omega, omega[:, 1:2]))
    return Curve(
        omega / mu_omega + 1j * moment / mu_M, step / mu_omega + 1j * rise * step / mu_M, False
    )


def _speeds(idle: Reals) -> Reals:
    return np.asarray(BEYOND * idle * np.arange(KNOTS) / (KNOTS - 1))


@operation(
    symbol=BY_POINTS,
    across=True,
    why=said(
        "By Kloss's formula M = 2·M_k/(s/s_k + s_k/s) an asynchronous motor pulls by its slip."
    ),
)
def kloss_curve(
    greatest: Number, critical: Number, synchronous: Number, mu_M: Number, mu_omega: Number
) -> Curve:
    """By 2·{greatest}/(s/{critical} + {critical}/s), s = 1 − ω/{synchronous}, draw the characteristic {it}."""
    greatest, critical, synchronous = single((greatest, critical, synchronous))
    omega = _speeds(synchronous)
    s = 1.0 - omega / synchronous
    square = s**2 + critical**2
    moment = 2.0 * greatest * s * critical / square
    rise = -2.0 * greatest * critical * (critical**2 - s**2) / square**2 / synchronous
    return _through(omega, moment, rise, mu_M, mu_omega)


@operation(
    symbol=BY_RULER,
    across=True,
    why=said("A motor with a straight characteristic loses moment evenly with speed."),
)
def straight_curve(starting: Number, idle: Number, mu_M: Number, mu_omega: Number) -> Curve:
    """From the moment {starting} at rest to none at {idle} draw the straight characteristic {it}."""
    starting, idle = single((starting, idle))
    omega = _speeds(idle)
    moment = starting * (1.0 - omega / idle)
    return _through(omega, moment, np.broadcast_to(-starting / idle, omega.shape), mu_M, mu_omega)


@operation(
    symbol=BY_RULER,
    across=True,
    why=said(
        "A table tells the moment at some speeds; below the first and above the last it is level."
    ),
)
def level_curve(
    moment: Number, last: Number, ratio: Number, mu_M: Number, mu_omega: Number
) -> Curve:
    """Up to {last} and on, by {ratio} times less on the crank, draw {it} level, as high as {moment}."""
    moment, last, ratio = single((moment, last, ratio))
    omega = _speeds(last / ratio)
    return _through(omega, moment * ratio + 0.0 * omega, 0.0 * omega, mu_M, mu_omega)


@operation(
    symbol=BY_POINTS,
    across=True,
    why=said("Between two speeds of the table the moment changes evenly."),
)
def on_to(
    motor: Curve, omega: Number, moment: Number, after: Number, then: Number, ratio: Number,
    mu_M: Number, mu_omega: Number,
) -> Curve:  # fmt: skip
    """From {omega}, {moment} on draw {motor} straight to {after}, {then}, by {ratio} on the crank: {it}."""
    values = single((omega, moment, after, then, ratio, mu_M, mu_omega))
    omega, moment, after, then, ratio, mu_M, mu_omega = values
    x, step = motor.knots.real, motor.tangents.real[:, :1]
    slope = (then - moment) * ratio / mu_M / ((after - omega) / ratio / mu_omega)
    begin, end = omega / ratio / mu_omega, after / ratio / mu_omega
    behind, beyond = x >= begin * (1.0 - 1e-12), x >= end * (1.0 - 1e-12)
    y = moment * ratio / mu_M + slope * (np.minimum(x, end) - begin)
    y = np.where(behind, y, motor.knots.imag)
    rise = np.where(behind, np.where(beyond, 0.0, slope * step), motor.tangents.imag)
    return Curve(x + 1j * y, step + 1j * rise, False)


@operation(
    symbol="E1 + E2", across=True, why=said("The characteristic begins with the pull at rest.")
)
def pull_at_rest(motor: Curve, mu: Number) -> Number:
    """Measure {it} at the beginning of {motor}."""
    return Number(motor.knots.imag[:, :1] * mu[:, :1])


# ------------------------------------------------------------ one step


@formula(why=said("The base is divided evenly: so far the crank turns in an interval."))
def way_of_interval(base: Length, mu: Number, intervals: Number) -> Number:
    """{base}·{mu}/{intervals}"""


@formula
def known_energy(
    energy: Length, mu_T: Number, after: Length, before: Length, mu_A: Number, share: Number,
    moment: Length, mu_M: Number, way: Number,
) -> Number:  # fmt: skip
    """{energy}·{mu_T} + ({after} − {before})·{mu_A} + (1 − {share})·{moment}·{mu_M}·{way}"""


@operation(
    symbol=BY_POINTS,
    across=True,
    why=said(
        "The energy that the machine would have at the end of the interval, by its speed there."
    ),
)
def parabola(inertia: Length, motor: Curve, mu_J: Number, mu_T: Number, mu_omega: Number) -> Curve:
    """Over the speeds of {motor} draw the parabola J·ω²/2 of {inertia}: {it}."""
    inertia, mu_J, mu_T, mu_omega = single((inertia, mu_J, mu_T, mu_omega))
    x, scale = motor.knots.real, inertia * mu_J * mu_omega**2 / mu_T
    return Curve(
        x + 0.5j * scale * x**2, motor.tangents.real + 1j * scale * x * motor.tangents.real, False
    )


@operation(
    symbol=BY_POINTS,
    across=True,
    why=said(
        "The energy that there is at the end of the interval: the motor's part of it hangs on the speed there."
    ),
)
def energy_by_motor(
    known: Number, motor: Curve, share: Number, way: Number, mu_M: Number, mu_T: Number,
) -> Curve:  # fmt: skip
    """Raise the motor's curve {motor}, to the scale of energies, by {known}: {it}."""
    known, share, way, mu_M, mu_T = single((known, share, way, mu_M, mu_T))
    scale = share * way * mu_M / mu_T
    knots = motor.knots.real + 1j * (known / mu_T + scale * motor.knots.imag)
    return Curve(knots, motor.tangents.real + 1j * scale * motor.tangents.imag, False)


@operation(
    symbol=FREE,
    across=True,
    fails="the curves do not cross: the machine stops in this interval",
    why=said("Where both energies are one is the speed at the end of the interval."),
)
def crossing(parabola: Curve, energy: Curve, start: Length) -> Point:
    """From {start} on, where {parabola} and {energy} cross, mark {it}."""
    rise = energy.tangents.imag - parabola.tangents.imag
    left = Motor(parabola.knots.real, energy.knots.imag - parabola.knots.imag, rise)
    x = crossed(left, start[:, :1], left.inside(start[:, :1]))
    return Point(x + 1j * Motor(left.omega, parabola.knots.imag, parabola.tangents.imag).inside(x))
