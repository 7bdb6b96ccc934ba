"""Forces on the board: lines of action, arms, moments; weights, inertia forces, couples, friction.

A force is a quantity (N, signed) along a line of action. The line of a vector of zero length has no direction:
nothing laid off along it comes to nothing, and its arm about any point is zero.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.grammar import operation
from graphic_tmm.board.values import Length, Line, Number, Point, Reals

STANDS = 1e-9
"""A speed below this share of the crank pin's is none: it has no sense. Far above rounding, far below what is
read."""
_TURNS = f"|{{omega}}| > {STANDS:.9f}·|{{of_crank}}|"
_NO_LENGTH = "the length to divide by is zero"
_PURE_COUPLE = "the forces come to a couple, which no single force replaces"
_NO_BALANCE = "what balances the crank is zero: there is nothing to compare with"
_NOT_SETTLED = "the passes of friction do not settle: the mechanism locks itself, or is near to it"


@operation()
def action(at: Point, tail: Point, head: Point, *, quarters: int = 0) -> Line:
    """Through {at} draw the line of action {it} parallel to {tail}{head}.

    ``quarters``: turned by so many right angles, counter-clockwise.
    """
    vector = head - tail
    size = np.abs(vector)
    none = size == 0.0
    direction = np.where(none, 0.0, vector / np.where(none, 1.0, size))
    return Line(at + 0.0 * direction, direction * 1j**quarters)


@operation(reads=True)
def arm(about: Point, line: Line) -> Length:
    """Measure the arm {it}, the distance of {about} from {line}.

    Positive where a force along the line turns counter-clockwise about the point.
    """
    return Length(wedge(line.at - about, line.along))


@operation()
def carry(pole: Point, of: Point, image: Point, times: Number, *, quarters: int = 0) -> Point:
    """Carry {image} of the plan turned by 90° over to the lever, {times} times as large: mark {it}.

    ``pole``: of the lever, ``of``: of the plan; ``quarters``: right angles, counter-clockwise, that the plan
    still lacks.
    """
    return Point(pole + (image - of) * times * 1j**quarters)


@operation()
def detach(point: Point, mu_l: Number, mu: Number) -> Point:
    """Carry {point} over to the figure of the detached links, which has a scale {mu} of its own: mark {it}.

    Directions are kept, so lines of action are drawn parallel.
    """
    return Point(point * (mu_l / mu))


@formula
def per_times(mu: Number, times: Number) -> Number:
    """{mu}/{times}"""


@formula
def weight(mass: Number, g: Number) -> Number:
    """{mass}·{g}"""


@formula
def inertia_force(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·{segment}·{mu}"""


@formula
def inertia_force_along(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·|{segment}|·{mu}"""


@formula
def inertia_couple(inertia: Number, epsilon: Number) -> Number:
    """−{inertia}·{epsilon}"""


def _sense(rate: Reals, fastest: Reals) -> Reals:
    none = np.abs(rate) <= STANDS * np.abs(fastest)
    return np.asarray(np.where(none, 0.0, np.sign(rate)) + 0.0 * fastest)


@formula(holds=f"|{{segment}}| > {STANDS:.9f}·|{{of_pin}}|, {{of_pin}} > 0")
def with_motion(size: Number, segment: Length, of_pin: Length) -> Number:
    """{size}·sgn({segment}/{of_pin})"""
    # what does not move has no sense, and a pin that stands is no division by zero
    return Number(size * _sense(segment, of_pin) + 0.0)


@formula(holds=_TURNS)
def against_turning(size: Number, omega: Number, of_crank: Number) -> Number:
    """−{size}·sgn({omega}/|{of_crank}|)"""
    # what does not turn has no sense
    return Number(-size * _sense(omega, of_crank) + 0.0)


@formula(holds="{force} ≠ 0", fails=_PURE_COUPLE)
def offset(couple: Number, force: Number, mu_l: Number) -> Length:
    """−{couple}/({force}·{mu_l})"""
    # no force and no couple: nothing lies anywhere off, where the text would say 0/0
    none = (couple == 0.0) & (force == 0.0)
    return Length(np.where(none, 0.0, -couple / np.where(none, 1.0, force * mu_l)))


@formula(holds="{force} > 0", fails=_PURE_COUPLE)
def place_of(couple: Number, force: Number, mu_l: Number) -> Length:
    """|{couple}|/({force}·{mu_l})"""
    # as in `offset`; the force is told by its size, its sense by the sign before the line
    none = (couple == 0.0) & (force == 0.0)
    return Length(np.where(none, 0.0, np.abs(couple) / np.where(none, 1.0, np.abs(force) * mu_l)))


@formula
def moment(force: Number, arm_: Length, mu_l: Number) -> Number:
    """{force}·{arm_}·{mu_l}"""


@formula
def reversed_(of: Number) -> Number:
    """−{of}"""


@formula(fails=_NO_LENGTH)
def tangential(moment_: Number, length: Length, mu_l: Number) -> Number:
    """{moment_}/({length}·{mu_l})"""


@formula(fails=_NO_LENGTH)
def balancing(moment_: Number, length: Length, mu_l: Number) -> Number:
    """−{moment_}/({length}·{mu_l})"""


@formula
def on_lever(force: Number, arm_: Length) -> Number:
    """{force}·{arm_}"""


@formula(fails=_NO_LENGTH)
def converted(
    couple: Number, times: Number, segment: Length, length: Length, mu_l: Number
) -> Number:
    """{couple}·{times}·{segment}/({length}·{mu_l})"""


@formula(fails=_NO_LENGTH)
def converted_reversed(
    couple: Number, times: Number, segment: Length, length: Length, mu_l: Number
) -> Number:
    """−{couple}·{times}·{segment}/({length}·{mu_l})"""


@formula(fails=_NO_LENGTH)
def balancing_on_lever(moment_: Number, segment: Length) -> Number:
    """−{moment_}/{segment}"""


@formula
def moment_on_arm(force: Number, length: Number) -> Number:
    """{force}·{length}"""


@formula(holds="{second} ≠ 0", fails=_NO_BALANCE)
def apart_percent(first: Number, second: Number) -> Number:
    """100·|{first} − {second}|/|{second}|"""


@operation()
def at_friction_angle(
    through: Point, guide: Line, f: Number, normal: Length, segment: Length, of_pin: Length
) -> Line:
    """Through {through} draw {it} at the angle of friction to the normal of {guide}.

    ``normal``: the normal part as found in the pass before, positive to the left of the guide; ``segment``:
    the speed of the same link along it. The reaction leans against that speed.
    """
    lean = f * np.sign(normal) * _sense(segment, of_pin)
    return Line(through, guide.along * ((1j - lean) / np.sqrt(1.0 + lean * lean)))


@formula
def circle_radius(f: Number, radius: Number) -> Number:
    """{f}·{radius}"""


@formula
def difference_of(first: Number, second: Number) -> Number:
    """{first} − {second}"""


@formula(holds=f"{{reaction}} ≥ 0, {_TURNS}")
def pin_friction(rho: Number, reaction: Number, omega: Number, of_crank: Number) -> Number:
    """−{rho}·{reaction}·sgn({omega}/|{of_crank}|)"""
    # what does not turn has no sense; a reaction is told by its size
    return Number(-rho * np.abs(reaction) * _sense(omega, of_crank))


@formula(holds="|{last} − {before}| < |{before} − {first}|", fails=_NOT_SETTLED)
def still_open(last: Number, before: Number, first: Number) -> Number:
    """|{last} − {before}|·max(1, q/(1 − q)),  q = |{last} − {before}|/|{before} − {first}|"""
    # passes that do not come nearer never settle; two passes alike to rounding have settled
    change, earlier = np.abs(last - before), np.abs(before - first)
    noise = change <= 1e-12 * np.maximum(np.abs(last), np.abs(before))
    q = np.where(noise, 0.0, change / np.where(earlier == 0.0, np.nan, earlier))
    q = np.where(np.isnan(q) & ~np.isnan(change), np.inf, q)
    grown = np.where(q < 1.0, q / np.where(q < 1.0, 1.0 - q, 1.0), np.inf)
    return Number(np.where(noise, change, change * np.maximum(1.0, grown)))


@formula(holds="{open_} ≤ |{last}|", fails=_NOT_SETTLED)
def settled(last: Number, open_: Number) -> Number:
    """{last} ± {open_}"""


@formula(
    holds="{without}·{with_} > 0, {speed} ≠ 0, ({without}/{with_})^sgn({without}·{speed}) ≤ 1",
    fails="no power passes through the crank",
)
def efficiency(without: Number, with_: Number, speed: Number) -> Number:
    """100·({without}/{with_})^sgn({without}·{speed})"""
    # a quotient, as the power is driven: by a power −1 it would be rounded twice; above 1 it is none
    driven = without * speed > 0.0
    above = np.where(driven, without, with_)
    below = np.where(driven, with_, without)
    same = (without * with_ > 0.0) & (np.abs(above) <= np.abs(below))
    return Number(100.0 * np.where(same, above, np.nan) / np.where(same, below, 1.0))
