"""The crank mechanism of an engine: forces of the piston, masses that go to and fro, rotating vectors."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Length, Line, Number, Point

KGF = 9.80665
"""A kgf in N."""


@operation()
def doubled(through: Point, outward: Line, crank: Line) -> Line:
    """Through {through} draw {it} at twice the angle of the crank {crank} from {outward}."""
    return Line(through, crank.along * crank.along * np.conj(outward.along))


@operation(formula=True)
def split_by_lever(mass: Number, length: Number, whole: Number) -> Number:
    """{mass}·{length}/{whole}"""
    return Number(mass * length / whole)


@operation(formula=True)
def mass_of_share(mass: Number, share: Number) -> Number:
    """{mass}·{share}"""
    return Number(mass * share)


@operation(formula=True)
def rest_of(whole: Number, part: Number) -> Number:
    """{whole} − {part}"""
    return Number(whole - part)


@operation(formula=True)
def lumped_inertia(first: Number, arm: Number, second: Number, other: Number) -> Number:
    """{first}·{arm}² + {second}·{other}²"""
    return Number(first * arm * arm + second * other * other)


@operation(formula=True)
def towards_crank(outward: Number, segment: Length, mu: Number) -> Number:
    """−{outward}·{segment}·{mu}"""
    return Number(-outward * segment * mu)


@operation(formula=True)
def against_acceleration(mass: Number, acceleration: Number) -> Number:
    """−{mass}·{acceleration}"""
    return Number(-mass * acceleration)


@operation(formula=True)
def crank_ratio(crank: Number, rod: Number) -> Number:
    """{crank}/{rod}"""
    return Number(crank / rod)


@operation(formula=True)
def first_order(mass: Number, omega: Number, radius: Number) -> Number:
    """{mass}·{omega}²·{radius}"""
    return Number(mass * omega * omega * radius)


@operation(formula=True)
def second_order(first: Number, ratio: Number) -> Number:
    """{first}·{ratio}"""
    return Number(first * ratio)


@operation(formula=True)
def projected(segment: Length, mu: Number) -> Number:
    """−{segment}·{mu}"""
    return Number(-segment * mu)


@operation(formula=True)
def per_mass(force: Number, mass: Number) -> Number:
    """−{force}/{mass}"""
    return Number(-force / mass)


@operation(formula=True)
def in_kgf(force: Number, unit: Number) -> Number:
    """{force}/{unit}"""
    return Number(force / unit)


@operation(formula=True)
def couple_of(force: Number, distance: Length, mu_l: Number) -> Number:
    """{force}·{distance}·{mu_l}"""
    return Number(force * distance * mu_l)
