"""Formulas of a cam given by arcs: where centres stand, angles as ordinates, rates by the instant centre."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_AROUND = said(
    "Two circles that touch have their centres, and the point where they touch, in one line: where one lies "
    "inside the other the centres are as far apart as the radii differ, else as far as both together."
)


@formula(holds="{first} > {second}", fails="the arc is smaller than the circle", why=_AROUND)
def inside(first: Length, second: Length) -> Length:
    """{first} − {second}"""


@formula(why=_AROUND)
def outside(first: Length, second: Length) -> Length:
    """{first} + {second}"""


@formula(why=said("An angle is drawn as an ordinate in radians, to a scale."))
def swing_on_board(angle: Angle, mu: Number) -> Length:
    """π·{angle}/(180°·{mu})"""


@formula(
    why=said(
        "The follower's velocity is that of the cam's point at the instant centre of cam and follower, which "
        "stands so far from the cam's centre."
    )
)
def transfer(part: Length, mu: Number) -> Number:
    """{part}·{mu}"""


@formula(
    holds="{rest} > 0",
    fails="the instant centre is the lever's pivot",
    why=said(
        "Cam and lever have one velocity at the instant centre on the line of their pivots, so their angular "
        "velocities are inverse to its distances from them."
    ),
)
def rate_of_lever(part: Length, rest: Length) -> Number:
    """{part}/{rest}"""


@formula(why=said("The angle over which the follower moves is divided into equal parts."))
def part_of_work(number: Number, work: Angle, parts: Number) -> Angle:
    """{number}·{work}/{parts}"""


@formula(why=said("The base stands for the angle over which the follower moves, in radians."))
def work_per_mm(work: Angle, base: Length) -> Number:
    """π·{work}/(180°·{base})"""
