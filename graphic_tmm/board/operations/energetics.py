"""Formulas of work and energy: gas force, reduced moment, kinetic energy, inertia and rim of a flywheel."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Angle, Length, Number, Reals

_NO_CRANK = ("the crank pin does not move", "палец кривошипа неподвижен")
_NOT_NEEDED = (
    "no flywheel is needed: the inertia of the links suffices",
    "маховик не нужен: достаточно инерции звеньев",
)


@operation(formula=True)
def ring_area(outer: Number, inner: Number) -> Number:
    """π·({outer}² − {inner}²)/4"""
    return Number(np.pi * (outer**2 - inner**2) / 4.0)


@operation(formula=True, fails=("the stroke has no length", "ход равен нулю"))
def polytropic(
    pressure: Number,
    clearance: Number,
    start: Number,
    travel: Length,
    stroke: Length,
    exponent: Number,
) -> Number:
    """{pressure}·(({clearance} + {start})/({clearance} + {travel}/{stroke}))^{exponent}"""
    volumes = (clearance + start) / (clearance + travel / stroke)
    return Number(pressure * np.where(exponent == 0.0, 1.0, volumes**exponent))


@operation(formula=True, fails=("the stroke has no length", "ход равен нулю"))
def polytropic_at_shaft(
    pressure: Number,
    clearance: Number,
    start: Number,
    travel: Length,
    stroke: Length,
    exponent: Number,
) -> Number:
    """{pressure}·(({clearance} + 1 − {start})/({clearance} + 1 − {travel}/{stroke}))^{exponent}"""
    volumes = (clearance + 1.0 - start) / (clearance + 1.0 - travel / stroke)
    return Number(pressure * np.where(exponent == 0.0, 1.0, volumes**exponent))


@operation(formula=True, fails=("the stroke has no length", "ход равен нулю"))
def between(
    first: Number, last: Number, start: Number, end: Number, travel: Length, stroke: Length
) -> Number:
    """{first} + ({last} − {first})·({travel}/{stroke} − {start})/({end} − {start})"""
    return Number(first + (last - first) * (travel / stroke - start) / (end - start))


@operation(formula=True)
def gas_force(pressure: Number, area: Number) -> Number:
    """{pressure}·{area}"""
    return Number(pressure * area)


@operation(formula=True)
def net_force(cover: Number, shaft: Number) -> Number:
    """{cover} − {shaft}"""
    return Number(cover - shaft)


@operation(formula=True, fails=_NO_CRANK)
def reduced_moment(
    outward: Number, force: Number, of_point: Length, of_pin: Length, arm: Number
) -> Number:
    """−{outward}·{force}·{of_point}/{of_pin}·{arm}"""
    return Number(-outward * force * of_point / np.where(of_pin == 0.0, np.nan, of_pin) * arm)


@operation(formula=True, fails=_NO_CRANK)
def moment_of_drive(moment: Number, arm: Number, of_pin: Length) -> Number:
    """{moment}·{arm}/{of_pin}"""
    return Number(moment * arm / np.where(of_pin == 0.0, np.nan, of_pin))


@operation(formula=True, fails=_NO_CRANK)
def moment_of_resistance(moment: Number, arm: Number, of_pin: Length) -> Number:
    """−{moment}·{arm}/{of_pin}"""
    return Number(-moment * arm / np.where(of_pin == 0.0, np.nan, of_pin))


@operation(formula=True)
def translation(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·({segment}·{mu})²/2"""
    return Number(mass * (segment * mu) ** 2 / 2.0)


@operation(formula=True)
def rotation(inertia: Number, omega: Number) -> Number:
    """{inertia}·{omega}²/2"""
    return Number(inertia * omega**2 / 2.0)


@operation(formula=True)
def added(first: Number, second: Number) -> Number:
    """{first} + {second}"""
    return Number(first + second)


@operation(formula=True)
def reduced_inertia(energy: Number, omega: Number) -> Number:
    """2·{energy}/{omega}²"""
    return Number(2.0 * energy / omega**2)


def _needed(segment: Length) -> Reals:
    return np.asarray(np.where(segment > 0.0, segment, np.nan))


@operation(formula=True, fails=_NOT_NEEDED)
def flywheel_inertia(segment: Length, mu: Number, delta: Number, omega: Number) -> Number:
    """{segment}·{mu}/({delta}·{omega}²)"""
    return Number(_needed(segment) * mu / (delta * omega**2))


@operation(formula=True)
def steepest(mu_J: Number, mu_T: Number, omega: Number, delta: Number) -> Angle:
    """arctan({mu_J}·{omega}²·(1 + {delta})/(2·{mu_T}))"""
    return Angle(np.degrees(np.arctan(mu_J * omega**2 * (1.0 + delta) / (2.0 * mu_T))))


@operation(formula=True)
def flattest(mu_J: Number, mu_T: Number, omega: Number, delta: Number) -> Angle:
    """arctan({mu_J}·{omega}²·(1 − {delta})/(2·{mu_T}))"""
    return Angle(np.degrees(np.arctan(mu_J * omega**2 * (1.0 - delta) / (2.0 * mu_T))))


@operation(formula=True)
def largest_rim(speed: Number, omega: Number) -> Number:
    """2·{speed}/{omega}"""
    return Number(2.0 * speed / omega)


@operation(formula=True)
def share(of: Number, ratio: Number) -> Number:
    """{ratio}·{of}"""
    return Number(ratio * of)


@operation(formula=True)
def mean(first: Number, second: Number) -> Number:
    """({first} + {second})/2"""
    return Number((first + second) / 2.0)


@operation(formula=True)
def rim_mass(inertia: Number, mean_diameter: Number) -> Number:
    """4·{inertia}/{mean_diameter}²"""
    return Number(4.0 * inertia / mean_diameter**2)


@operation(formula=True)
def rim_width(
    inertia: Number, density: Number, outer: Number, inner: Number, middle: Number
) -> Number:
    """16·{inertia}/(π·{density}·({outer}² − {inner}²)·{middle}²)"""
    return Number(16.0 * inertia / (np.pi * density * (outer**2 - inner**2) * middle**2))


@operation(formula=True)
def mean_ordinate(area: Number, base: Length) -> Length:
    """{area}/{base}"""
    return Length(area / base)
