"""Formulas of springs and dampers, of a force that is sought at a tool, of the force between teeth."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.language.said import said

_NO_ARM = (
    "the lines of the three legs meet in one point, or are parallel: nothing holds the plate there"
)
_NO_RADIUS = "the pitch radius is too short to be measured at this scale"
_NO_WAY = (
    "the point of the unknown force does not move along it: no force there balances the others"
)
_NO_EFFORT = "the known loads come to nothing at what drives: there is nothing to compare with"


@formula(
    why=said(
        "The spring pulls by its stiffness for every metre by which it is longer than its free length; a "
        "negative force pushes."
    )
)
def spring_force(rate: Number, length: Length, mu_l: Number, free: Number) -> Number:
    """{rate}·({length}·{mu_l} − {free})"""


@formula(
    why=said(
        "To the force with which the spring is set in comes its stiffness for every metre by which it is "
        "longer than its free length."
    )
)
def preloaded_force(
    rate: Number, length: Length, mu_l: Number, free: Number, preload: Number
) -> Number:
    """{rate}·({length}·{mu_l} − {free}) + {preload}"""


@formula(
    why=said(
        "The damper holds back by its damping for every metre per second at which its ends part; where they "
        "come together the force pushes."
    )
)
def damper_force(damping: Number, segment: Length, mu_v: Number) -> Number:
    """{damping}·{segment}·{mu_v}"""


@formula(
    holds="{arm_} ≠ 0",
    fails=_NO_WAY,
    why=said(
        "The lever is in equilibrium about its pole: the unknown force has the moment of all others, reversed, "
        "and its arm is the velocity of its point along it."
    ),
)
def unknown_on_lever(moment_: Number, arm_: Length) -> Number:
    """−{moment_}/{arm_}"""


@formula(
    holds="{arm_} ≠ 0",
    fails=_NO_WAY,
    why=said("On the lever both forces have one moment: the less the arm, the larger the force."),
)
def advantage(segment: Length, arm_: Length) -> Number:
    """|{segment}|/|{arm_}|"""


@formula(
    holds="{whole} ≠ 0",
    fails=_NO_EFFORT,
    why=said(
        "With the force that the lever found at the tool, the groups leave nothing for what drives to balance; "
        "what they do leave is the error of the drawing."
    ),
)
def left_percent(left: Number, whole: Number) -> Number:
    """100·|{left}|/|{whole}|"""


@formula(
    fails=_NO_RADIUS,
    why=said(
        "The wheel is in equilibrium about its centre: the force of the other tooth has the moment that all "
        "other moments leave open, by its part along the common tangent, on the pitch radius {length}."
    ),
)
def tooth_across(moment_: Number, length: Length, mu_l: Number) -> Number:
    """−{moment_}/({length}·{mu_l})"""


@formula(
    why=said(
        "Teeth press along the line of action, which stands at {alpha} to the common tangent; whichever flank "
        "bears, that presses this wheel towards its own centre."
    )
)
def tooth_inwards(across: Number, alpha: Angle) -> Number:
    """−|{across}|·tan {alpha}"""


@formula(
    why=said(
        "Teeth press along the line of action, which stands at {alpha} to the common tangent; whichever flank "
        "bears, that presses this wheel, whose teeth are inside, away from its own centre."
    )
)
def tooth_outwards(across: Number, alpha: Angle) -> Number:
    """|{across}|·tan {alpha}"""


@formula(
    fails=_NO_ARM,
    why=said(
        "What holds the two legs that cross in the special point has no moment about it, so what holds the "
        "third one along its line has the moment that all others leave open."
    ),
)
def along_third(moment_: Number, arm_: Length, mu_l: Number) -> Number:
    """−{moment_}/({arm_}·{mu_l})"""
