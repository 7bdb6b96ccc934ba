"""Formulas of the inertia of cylinders: both orders, their angles, what remains, when it is greatest."""

from __future__ import annotations

from graphic_tmm.board.formula import formula
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.language.said import said


@formula(
    holds="{rod} ≠ 0",
    fails="the rod has no length",
    why=said("Of the rod's slant the second order comes, in the ratio of crank to rod."),
)
def crank_to_rod(crank: Number, rod: Number) -> Number:
    """{crank}/{rod}"""


@formula(
    why=said(
        "A piston goes with r·ω²·(cos φ + λ·cos 2φ), further orders being small. The first part is the shadow "
        "on the cylinder's axis of a vector that turns with the crank."
    )
)
def force_of_first_order(mass: Number, crank: Number, omega: Number) -> Number:
    """{mass}·{crank}·{omega}²"""


@formula(
    why=said("The second part is the shadow of a vector that turns twice as fast as the crank.")
)
def force_of_second_order(first: Number, ratio: Number) -> Number:
    """{first}·{ratio}"""


@formula(
    why=said(
        "A force along an axis is two vectors of half its size that turn opposite ways: the direct one and the "
        "reverse one, which meet on the axis."
    )
)
def half_of_force(force: Number) -> Number:
    """{force}/2"""


@formula(why=said("Moments are taken about the middle of the shaft."))
def moment_about_middle(force: Number, place: Number) -> Number:
    """{force}·{place}"""


@formula(
    why=said("The engine's axis points upward; the vector of the first order lies along the crank.")
)
def along_crank(crank: Angle) -> Angle:
    """90° + {crank}"""


@formula(
    why=said("The vector of the second order stands at twice the crank's angle from the axis.")
)
def at_twice(crank: Angle) -> Angle:
    """90° + 2·{crank}"""


@formula(
    why=said("The reverse vector is the mirror image of the direct one in the cylinder's axis.")
)
def mirrored_in_axis(axis: Angle, crank: Angle) -> Angle:
    """90° + 2·{axis} − {crank}"""


@formula(
    why=said(
        "The direct vector of the second order stands at twice the angle of the crank from the cylinder's axis."
    )
)
def direct_at_twice(axis: Angle, crank: Angle) -> Angle:
    """90° + 2·{crank} − {axis}"""


@formula(
    why=said("The reverse vector is the mirror image of the direct one in the cylinder's axis.")
)
def mirrored_at_twice(axis: Angle, crank: Angle) -> Angle:
    """90° + 3·{axis} − 2·{crank}"""


@formula(
    why=said("What remains is greatest when its vector has turned into the axis of the cylinders.")
)
def turn_to_axis(angle: Angle) -> Angle:
    """90° − {angle}"""


@formula(why=said("The vector turns twice as fast as the shaft: into the axis by half its angle."))
def half_turn_to_axis(angle: Angle) -> Angle:
    """(90° − {angle})/2"""


@formula(why=said("Both vectors add up where they meet."))
def greatest_of_both(direct: Number, reverse: Number) -> Number:
    """{direct} + {reverse}"""


@formula(why=said("A quarter of a turn of theirs later they are opposite each other."))
def least_of_both(direct: Number, reverse: Number) -> Number:
    """|{direct} − {reverse}|"""


@formula(why=said("Turning opposite ways they meet halfway between them."))
def turn_to_meet(direct: Angle, reverse: Angle) -> Angle:
    """({reverse} − {direct})/2"""


@formula(why=said("Turning opposite ways they meet halfway, and twice as fast as the shaft turns."))
def half_turn_to_meet(direct: Angle, reverse: Angle) -> Angle:
    """({reverse} − {direct})/4"""


@formula(why=said("From the side a crank reaches up by its part along the engine's axis."))
def upright_part(crank: Number, angle: Angle) -> Number:
    """{crank}·cos({angle})"""
