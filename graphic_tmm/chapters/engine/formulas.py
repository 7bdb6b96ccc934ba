"""The crank mechanism of an engine: forces of the piston, masses that go to and fro, rotating vectors."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Length, Line, Number, Point

KGF = 9.80665
"""A kgf in N."""


@operation()
def doubled(through: Point, outward: Line, crank: Line) -> Line:
    """Through {through} draw {it} at twice the angle of the crank {crank} from {outward}."""
    return Line(through, crank.along * crank.along * np.conj(outward.along))


@formula
def split_by_lever(mass: Number, length: Number, whole: Number) -> Number:
    """{mass}·{length}/{whole}"""


@formula
def mass_of_share(mass: Number, share: Number) -> Number:
    """{mass}·{share}"""


@formula
def rest_of(whole: Number, part: Number) -> Number:
    """{whole} − {part}"""


@formula
def lumped_inertia(first: Number, arm: Number, second: Number, other: Number) -> Number:
    """{first}·{arm}² + {second}·{other}²"""


@formula
def towards_crank(outward: Number, segment: Length, mu: Number) -> Number:
    """−{outward}·{segment}·{mu}"""


@formula
def against_acceleration(mass: Number, acceleration: Number) -> Number:
    """−{mass}·{acceleration}"""


@formula
def crank_ratio(crank: Number, rod: Number) -> Number:
    """{crank}/{rod}"""


@formula
def first_order(mass: Number, omega: Number, radius: Number) -> Number:
    """{mass}·{omega}²·{radius}"""


@formula
def second_order(first: Number, ratio: Number) -> Number:
    """{first}·{ratio}"""


@formula
def projected(segment: Length, mu: Number) -> Number:
    """−{segment}·{mu}"""


@formula
def per_mass(force: Number, mass: Number) -> Number:
    """−{force}/{mass}"""


@formula
def in_kgf(force: Number, unit: Number) -> Number:
    """{force}/{unit}"""


@formula
def couple_of(force: Number, distance: Length, mu_l: Number) -> Number:
    """{force}·{distance}·{mu_l}"""
