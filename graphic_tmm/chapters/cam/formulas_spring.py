"""Formulas of what closes cam and follower by force: inertia, spring, contact, moment on the shaft."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said


@formula(
    why=said(
        "The inertia force is opposite to the acceleration, which is ω² times the second derivative."
    )
)
def follower_inertia(mass: Number, omega: Number, second: Length, mu: Number) -> Number:
    """−({mass}·{omega}²·{second}·{mu})"""


@formula(why=said("The spring is to hold more than the inertia force, by its reserve."))
def with_reserve(reserve: Number, inertia: Number) -> Number:
    """{reserve}·{inertia}"""


@formula(why=said("What presses the follower on the cam besides need not come from the spring."))
def less_load(wanted: Number, load: Number) -> Number:
    """{wanted} − {load}"""


@formula(why=said("A spring pushes or does nothing: it cannot pull the follower off."))
def pushing(force: Number) -> Number:
    """max({force}, 0)"""


@formula(why=said("The rate of a spring is by how much its force grows along the stroke."))
def rate_of_spring(most: Number, preload: Number, stroke: Number) -> Number:
    """({most} − {preload})/{stroke}"""


@formula(why=said("At the end of the stroke the spring is compressed by the stroke more."))
def greatest_force(preload: Number, rate: Number, stroke: Number) -> Number:
    """{preload} + {rate}·{stroke}"""


@formula(why=said("The force of a spring grows evenly with the displacement."))
def follower_spring(preload: Number, rate: Number, length: Length, mu: Number) -> Number:
    """{preload} + {rate}·{length}·{mu}"""


@formula(why=said("The reserve holds as long as the spring has something over the wanted force."))
def over_wanted(force: Number, wanted: Number) -> Number:
    """{force} − {wanted}"""


@formula(why=said("Spring and load press together."))
def pressed(force: Number, load: Number) -> Number:
    """{force} + {load}"""


@formula(why=said("What presses, less what lifts, is left to the contact."))
def closing(pressing: Number, inertia: Number) -> Number:
    """{pressing} − {inertia}"""


@formula(
    why=said("The way of the follower is square to its face: the contact carries the whole force.")
)
def along_rod(force: Number) -> Number:
    """{force}"""


@formula(why=said("The contact's force is inclined to the follower's way by the pressure angle."))
def by_pressure_angle(force: Number, angle: Angle) -> Number:
    """{force}/cos({angle})"""


@formula(
    why=said(
        "The part of the contact's force square to the lever, times the lever, is in balance with the moment."
    )
)
def by_roller_lever(moment: Number, lever: Length, mu: Number, angle: Angle) -> Number:
    """{moment}/({lever}·{mu}·cos({angle}))"""


@formula(
    holds="{distance} > 0",
    fails="the contact stands at the foot of the pivot or beyond",
    why=said("The contact's force is square to the face: its arm is the distance from the foot."),
)
def on_face(moment: Number, distance: Length, mu: Number) -> Number:
    """{moment}/({distance}·{mu})"""


@formula(
    why=said("The contact's force times its arm about the cam's centre is its moment on the shaft.")
)
def shaft_moment(force: Number, arm: Length, mu: Number) -> Number:
    """{force}·{arm}·{mu}"""
