"""Forces on the board: lines of action, arms, moments; weights, inertia forces, couples, friction.

A force is a quantity (N, signed) along a line of action. The line of a vector of zero length has no direction:
nothing laid off along it comes to nothing, and its arm about any point is zero.
"""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.grammar import RAY, READ, SLIDE, operation
from graphic_tmm.board.values import Length, Line, Number, Point, Reals
from graphic_tmm.language.said import said

STANDS = 1e-9
"""A speed below this share of the crank pin's is none: it has no sense. Far above rounding, far below what is
read."""
_TURNS = f"|{{omega}}| > {STANDS:.9f}·|{{of_crank}}|"
_NO_LENGTH = "the length to divide by is zero"
_PURE_COUPLE = "the forces come to a couple, which no single force replaces"
_NO_BALANCE = "what balances the crank is zero: there is nothing to compare with"
_NOT_SETTLED = "the passes of friction do not settle: the mechanism locks itself, or is near to it"


@operation(
    symbol=SLIDE,
    swings=True,
    why=said(
        "A force acts along the line of this direction through the point that it is applied to."
    ),
)
def action(at: Point, tail: Point, head: Point, *, quarters: int = 0) -> Line:
    """Through {at} draw the line of action {it} parallel to {tail}{head}.

    ``quarters``: turned by so many right angles, counter-clockwise.
    """
    vector = head - tail
    size = np.abs(vector)
    none = size == 0.0
    direction = np.where(none, 0.0, vector / np.where(none, 1.0, size))
    return Line(at + 0.0 * direction, direction * 1j**quarters)


@operation(
    symbol=f"{SLIDE} + {READ}",
    reads=True,
    why=said(
        "The moment of a force about a point is the force times the distance of its line of action from "
        "that point."
    ),
)
def arm(about: Point, line: Line) -> Length:
    """Measure the arm {it}, the distance of {about} from {line}.

    Positive where a force along the line turns counter-clockwise about the point.
    """
    return Length(wedge(line.at - about, line.along))


@operation(
    symbol=f"{READ} + N1 + {SLIDE} + M1 + R1 + M2",
    why=said(
        "On a lever shaped like the plan of velocities turned by 90° the arm of a force about the pole is "
        "the part of the velocity along the force, so its moment is its power, to scale."
    ),
)
def carry(pole: Point, of: Point, image: Point, times: Number, *, quarters: int = 0) -> Point:
    """Carry {image} of the plan turned by 90° over to the lever, {times} times as large: mark {it}.

    ``pole``: of the lever, ``of``: of the plan; ``quarters``: right angles, counter-clockwise, that the plan
    still lacks.
    """
    return Point(pole + (image - of) * times * 1j**quarters)


@operation(
    symbol=f"{READ} + N1 + {SLIDE} + M1 + R1 + M2",
    why=said(
        "What is cut free is drawn by itself with all that acts on it: the removed links are replaced by "
        "their reactions."
    ),
)
def detach(point: Point, mu_l: Number, mu: Number) -> Point:
    """Carry {point} over to the figure of the detached links, which has a scale {mu} of its own: mark {it}.

    Directions are kept, so lines of action are drawn parallel.
    """
    return Point(point * (mu_l / mu))


@formula(
    why=said(
        "The lever is {times} times as large as the plan of velocities, so a millimetre of it stands for "
        "so much less."
    )
)
def per_times(mu: Number, times: Number) -> Number:
    """{mu}/{times}"""


@formula(why=said("The earth pulls every mass with the force mass times g."))
def weight(mass: Number, g: Number) -> Number:
    """{mass}·{g}"""


@formula(
    why=said(
        "By d'Alembert's principle a body may be treated as in equilibrium if to the real forces is added "
        "minus mass times the acceleration of its mass centre."
    )
)
def inertia_force(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·{segment}·{mu}"""


@formula(
    why=said(
        "By d'Alembert's principle the mass times the acceleration of its centre, against that "
        "acceleration, is added to the forces."
    )
)
def inertia_force_along(mass: Number, segment: Length, mu: Number) -> Number:
    """{mass}·|{segment}|·{mu}"""


@formula(
    why=said(
        "A link that turns unevenly resists with a couple: its moment of inertia times ε, against ε."
    )
)
def inertia_couple(inertia: Number, epsilon: Number) -> Number:
    """−{inertia}·{epsilon}"""


def _sense(rate: Reals, fastest: Reals) -> Reals:
    none = np.abs(rate) <= STANDS * np.abs(fastest)
    return np.asarray(np.where(none, 0.0, np.sign(rate)) + 0.0 * fastest)


@formula(
    holds=f"|{{segment}}| > {STANDS:.9f}·|{{of_pin}}|, {{of_pin}} > 0",
    why=said(
        "The resistance turns round with the motion: where {segment} is negative, the force on its line is "
        "negative too."
    ),
)
def with_motion(size: Number, segment: Length, of_pin: Length) -> Number:
    """{size}·sgn({segment}/{of_pin})"""
    # what does not move has no sense, and a pin that stands is no division by zero
    return Number(size * _sense(segment, of_pin) + 0.0)


@formula(
    holds=_TURNS,
    why=said("A resistance acts against the motion: its sign is the opposite of that of {omega}."),
)
def against_turning(size: Number, omega: Number, of_crank: Number) -> Number:
    """−{size}·sgn({omega}/|{of_crank}|)"""
    # what does not turn has no sense
    return Number(-size * _sense(omega, of_crank) + 0.0)


@formula(
    holds="{force} ≠ 0",
    fails=_PURE_COUPLE,
    why=said(
        "A force and a couple are as much as one force shifted aside by couple divided by force: its "
        "moment about the old point is the couple."
    ),
)
def offset(couple: Number, force: Number, mu_l: Number) -> Length:
    """−{couple}/({force}·{mu_l})"""
    # no force and no couple: nothing lies anywhere off, where the text would say 0/0
    none = (couple == 0.0) & (force == 0.0)
    return Length(np.where(none, 0.0, -couple / np.where(none, 1.0, force * mu_l)))


@formula(
    holds="{force} > 0",
    fails=_PURE_COUPLE,
    why=said(
        "A reaction that leaves a moment about the pin is one that stands aside of it, by that moment "
        "divided by the force."
    ),
)
def place_of(couple: Number, force: Number, mu_l: Number) -> Length:
    """|{couple}|/({force}·{mu_l})"""
    # as in `offset`; the force is told by its size, its sense by the sign before the line
    none = (couple == 0.0) & (force == 0.0)
    return Length(np.where(none, 0.0, np.abs(couple) / np.where(none, 1.0, np.abs(force) * mu_l)))


@formula(
    why=said(
        "The moment is the force times its arm, in metres: the arm on the drawing times {mu_l}."
    )
)
def moment(force: Number, arm_: Length, mu_l: Number) -> Number:
    """{force}·{arm_}·{mu_l}"""


@formula(why=said("Action and reaction are equal and opposite."))
def reversed_(of: Number) -> Number:
    """−{of}"""


@formula(
    fails=_NO_LENGTH,
    why=said(
        "The link is in equilibrium about its inner pin: only the tangential part of the outer reaction "
        "balances the moments of the known forces, with the length of the link as its arm."
    ),
)
def tangential(moment_: Number, length: Length, mu_l: Number) -> Number:
    """{moment_}/({length}·{mu_l})"""


@formula(
    fails=_NO_LENGTH,
    why=said(
        "The crank is in equilibrium about its pivot: the balancing force at the pin, square to the crank, "
        "has the moment that all other moments leave open."
    ),
)
def balancing(moment_: Number, length: Length, mu_l: Number) -> Number:
    """−{moment_}/({length}·{mu_l})"""


@formula(
    why=said(
        "The moment on the lever is force times arm; the arm is the velocity along the force, so this is "
        "its power, to the scale of the lever."
    )
)
def on_lever(force: Number, arm_: Length) -> Number:
    """{force}·{arm_}"""


@formula(
    fails=_NO_LENGTH,
    why=said(
        "On the lever the couple is replaced by one of the same power: it is multiplied by the ratio of "
        "the link's image to the link."
    ),
)
def converted(
    couple: Number, times: Number, segment: Length, length: Length, mu_l: Number
) -> Number:
    """{couple}·{times}·{segment}/({length}·{mu_l})"""


@formula(
    fails=_NO_LENGTH,
    why=said(
        "On the lever the couple is replaced by one of the same power; the image lies the other way round "
        "than the link, so the sign changes."
    ),
)
def converted_reversed(
    couple: Number, times: Number, segment: Length, length: Length, mu_l: Number
) -> Number:
    """−{couple}·{times}·{segment}/({length}·{mu_l})"""


@formula(
    fails=_NO_LENGTH,
    why=said(
        "The sum of the powers of all forces, the balancing one among them, is 0: the lever is in "
        "equilibrium about its pole."
    ),
)
def balancing_on_lever(moment_: Number, segment: Length) -> Number:
    """−{moment_}/{segment}"""


@formula(why=said("The force is square to its arm: the moment is their product."))
def moment_on_arm(force: Number, length: Number) -> Number:
    """{force}·{length}"""


@formula(
    holds="{second} ≠ 0",
    fails=_NO_BALANCE,
    why=said(
        "Two ways that know nothing of one another have to come to one force; what they differ by is the "
        "error of the drawing."
    ),
)
def apart_percent(first: Number, second: Number) -> Number:
    """100·|{first} − {second}|/|{second}|"""


@operation(
    symbol=f"N1 + {RAY}",
    why=said(
        "Friction is f times the pressure and against the motion, so the whole reaction leans back from "
        "the normal by the angle whose tangent is f."
    ),
)
def at_friction_angle(
    through: Point, guide: Line, f: Number, normal: Length, segment: Length, of_pin: Length
) -> Line:
    """Through {through} draw {it} at the angle of friction to the normal of {guide}.

    ``normal``: the normal part as found in the pass before, positive to the left of the guide; ``segment``:
    the speed of the same link along it. The reaction leans against that speed.
    """
    lean = f * np.sign(normal) * _sense(segment, of_pin)
    return Line(through, guide.along * ((1j - lean) / np.sqrt(1.0 + lean * lean)))


@formula(
    why=said(
        "In a pin with friction the reaction does not pass through the centre: it touches the circle of "
        "friction, of the radius f·r."
    )
)
def circle_radius(f: Number, radius: Number) -> Number:
    """{f}·{radius}"""


@formula(why=said("One link turns about the other at the difference of both angular velocities."))
def difference_of(first: Number, second: Number) -> Number:
    """{first} − {second}"""


@formula(
    holds=f"{{reaction}} ≥ 0, {_TURNS}",
    why=said(
        "The reaction acts at the radius {rho} of the circle of friction, and its moment is against the "
        "relative turning."
    ),
)
def pin_friction(rho: Number, reaction: Number, omega: Number, of_crank: Number) -> Number:
    """−{rho}·{reaction}·sgn({omega}/|{of_crank}|)"""
    # what does not turn has no sense; a reaction is told by its size
    return Number(-rho * np.abs(reaction) * _sense(omega, of_crank))


@formula(
    holds="|{last} − {before}| < |{before} − {first}|",
    fails=_NOT_SETTLED,
    why=said(
        "Each pass of the friction changes less than the one before: what all further ones would change is "
        "a geometric series."
    ),
)
def still_open(last: Number, before: Number, first: Number) -> Number:
    """|{last} − {before}|·max(1, q/(1 − q)),  q = |{last} − {before}|/|{before} − {first}|"""
    # passes that do not come nearer never settle; two passes alike to rounding have settled
    change, earlier = np.abs(last - before), np.abs(before - first)
    noise = change <= 1e-12 * np.maximum(np.abs(last), np.abs(before))
    q = np.where(noise, 0.0, change / np.where(earlier == 0.0, np.nan, earlier))
    q = np.where(np.isnan(q) & ~np.isnan(change), np.inf, q)
    grown = np.where(q < 1.0, q / np.where(q < 1.0, 1.0 - q, 1.0), np.inf)
    return Number(np.where(noise, change, change * np.maximum(1.0, grown)))


@formula(
    holds="{open_} ≤ |{last}|",
    fails=_NOT_SETTLED,
    why=said("What further passes would change is told beside the value."),
)
def settled(last: Number, open_: Number) -> Number:
    """{last} ± {open_}"""


@formula(
    holds="{without}·{with_} > 0, {speed} ≠ 0, ({without}/{with_})^sgn({without}·{speed}) ≤ 1",
    fails="no power passes through",
    why=said(
        "The efficiency is the work that would do without friction to the work that has to be done with "
        "it."
    ),
)
def efficiency(without: Number, with_: Number, speed: Number) -> Number:
    """100·({without}/{with_})^sgn({without}·{speed})"""
    # a quotient, as the power is driven: by a power −1 it would be rounded twice; above 1 it is none
    driven = without * speed > 0.0
    above = np.where(driven, without, with_)
    below = np.where(driven, with_, without)
    same = (without * with_ > 0.0) & (np.abs(above) <= np.abs(below))
    return Number(100.0 * np.where(same, above, np.nan) / np.where(same, below, 1.0))
