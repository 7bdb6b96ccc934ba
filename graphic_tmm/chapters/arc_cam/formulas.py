"""Formulas of a cam given by arcs: centres, angles as ordinates, rates; what the follower does step by step."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.geometry import degrees
from graphic_tmm.board.grammar import ANGLE, FREE, operation
from graphic_tmm.board.values import Angle, Length, Line, Number, Point
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


@formula(
    why=said(
        "Chords give the mean of an interval; at a change of arcs they are compared with the middle of both "
        "sides."
    )
)
def off_by_chords(chord: Length, mu: Number, before: Number, behind: Number) -> Number:
    """{chord}·{mu} − ({before} + {behind})/2"""


@formula(
    why=said(
        "The follower moves by dS/dφ for a radian of the cam, which turns by {omega} radians in a second."
    )
)
def velocity(omega: Number, rate: Number) -> Number:
    """{omega}·{rate}"""


@formula(
    why=said(
        "The cam turns evenly, so differentiating by time once more brings the angular velocity in again."
    )
)
def acceleration(omega: Number, second: Number) -> Number:
    """{omega}²·{second}"""


@formula(why=said("The angle over which the follower moves is divided into equal parts."))
def part_of_work(number: Number, work: Angle, parts: Number) -> Angle:
    """{number}·{work}/{parts}"""


@formula(why=said("The base stands for the angle over which the follower moves, in radians."))
def work_per_mm(work: Angle, base: Length) -> Number:
    """π·{work}/(180°·{base})"""


_TOGETHER = said("The follower is on one arc at a time; here they are put together.")


@operation(symbol=FREE, why=_TOGETHER)
def on_arc(first: Point, second: Point, at: Number) -> Point:
    """Where the follower is on the arc of {first} take that, else {second}; this is {it}."""
    return Point(np.where(at > 0, first, second))


@operation(symbol=FREE, why=_TOGETHER)
def line_on_arc(first: Line, second: Line, at: Number) -> Line:
    """Where the follower is on the arc of the line {first} take that, else {second}; this is {it}."""
    chosen = at > 0
    return Line(np.where(chosen, first.at, second.at), np.where(chosen, first.along, second.along))


@operation(
    symbol=FREE,
    why=said("The follower is on one arc at a time: what is drawn for an arc holds there."),
)
def while_on(of: Point, at: Number) -> Point:
    """In the positions in which the follower is on the arc take {of}; this is {it}."""
    return Point(of * np.where(at > 0, 1.0, np.nan))


@operation(
    symbol=ANGLE,
    why=said(
        "Between both places the follower moves: it is at its lowest at the first and at the second."
    ),
)
def turn_between(first: Line, second: Line, *, sense: int) -> Angle:
    """Measure the angle {it} from {first} to {second}.

    ``sense``: 1 if it counts counter-clockwise, −1 clockwise; 0 … 360°.
    """
    return Angle(np.mod(sense * degrees(second.along * np.conj(first.along)), 360.0))
