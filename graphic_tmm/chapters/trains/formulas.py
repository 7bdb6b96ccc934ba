"""Formulas of planetary trains: radii and axes, the ratio by Willis, the conditions on tooth numbers."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.formula_text import define
from graphic_tmm.board.grammar import WHOLE_ROW, operation
from graphic_tmm.board.values import Angle, Length, Number, Point, Reals
from graphic_tmm.language.said import said

_NO_TEETH = "a wheel has no teeth"
_STANDS = "the driven shaft stands"
_NO_ROOM = "satellites have no room beside each other"
_NO_SATELLITES = "there are no satellites"


def _gcd(first: Reals, second: Reals) -> Reals:
    whole = np.gcd(np.rint(first).astype(np.int64), np.rint(second).astype(np.int64))
    return np.asarray(whole + 0.0 * (first + second))


define("gcd", _gcd)


@formula(
    why=said(
        "The pitch circles of wheels in outer mesh touch: the axes are as far apart as both radii "
        "together."
    )
)
def axes_outside(m: Number, first: Number, second: Number) -> Number:
    """{m}·({first} + {second})/2"""


@formula(
    why=said(
        "In inner mesh the pitch circles touch from inside: the axes are as far apart as the difference of "
        "the radii. Both meshes need the same distance."
    )
)
def axes_inside(m: Number, ring: Number, wheel: Number) -> Number:
    """{m}·({ring} − {wheel})/2"""


@formula(why=said("Neighbouring satellites must not touch by their tips."))
def tip_diameter(m: Number, z: Number, ha: Number) -> Number:
    """{m}·({z} + 2·{ha})"""


@formula(why=said("In inner mesh tips interfere where the difference of the teeth is too small."))
def tooth_difference(ring: Number, wheel: Number) -> Number:
    """{ring} − {wheel}"""


@formula(
    holds="{k} ≠ 0",
    fails=_NO_SATELLITES,
    why=said(
        "The axes of {k} satellites stand on one circle, evenly: the chord between neighbours."
    ),
)
def neighbouring_axes(axes: Number, k: Number) -> Number:
    """2·{axes}·sin(180°/{k})"""


@formula(
    holds="{z1} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "With the carrier held the row is a train with −z3/z1 (Willis); letting it go and holding the ring "
        "adds 1."
    ),
)
def ratio_of_row(z1: Number, z3: Number) -> Number:
    """1 + {z3}/{z1}"""


@formula(
    holds="{z1}·{z3} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "By Willis: with the carrier held the ratio is negative, so its amount is added to 1."
    ),
)
def ratio_opposed(z1: Number, z2: Number, z3: Number, z4: Number) -> Number:
    """1 + {z2}·{z4}/({z1}·{z3})"""


@formula(
    holds="{z1}·{z3} ≠ 0",
    fails=_NO_TEETH,
    why=said("By Willis: with the carrier held the ratio is positive, so it is taken from 1."),
)
def ratio_alike(z1: Number, z2: Number, z3: Number, z4: Number) -> Number:
    """1 − {z2}·{z4}/({z1}·{z3})"""
    # a difference of tooth numbers is exact, where that of their ratio from 1 is rounded
    below = np.where(z1 * z3 == 0.0, np.nan, z1 * z3)
    return Number((below - z2 * z4) / below)


@formula(
    holds="{z1} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "With the carrier held the wheels are a plain train; the satellite only hands on (Willis)."
    ),
)
def held_row(z1: Number, z3: Number) -> Number:
    """−{z3}/{z1}"""


@formula(
    holds="{z1}·{z3} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "With the carrier held the ratios of both meshes multiply; one of them turns backwards."
    ),
)
def held_opposed(z1: Number, z2: Number, z3: Number, z4: Number) -> Number:
    """−{z2}·{z4}/({z1}·{z3})"""


@formula(
    holds="{z1}·{z3} ≠ 0",
    fails=_NO_TEETH,
    why=said("With the carrier held the ratios of both meshes multiply; their senses are alike."),
)
def held_alike(z1: Number, z2: Number, z3: Number, z4: Number) -> Number:
    """{z2}·{z4}/({z1}·{z3})"""


@formula(
    why=said(
        "By Willis: with that wheel held the carrier moves, and the ratio to it is 1 less the one with the "
        "carrier held."
    )
)
def ratio_to_carrier(held: Number) -> Number:
    """1 − {held}"""


@formula(
    holds="{driven} ≠ 0",
    fails=_STANDS,
    why=said("Both ratios are to one carrier: the one wheel over the other is their quotient."),
)
def ratio_of_ratios(driving: Number, driven: Number) -> Number:
    """{driving}/{driven}"""


_WILLIS = said(
    "Seen from the carrier the train is a plain one (Willis): (ω_1 − ω_H)/(ω_n − ω_H) is the ratio with the "
    "carrier held, and two of the three angular velocities are given."
)


@formula(holds="{held} ≠ 1", fails="the train is locked", why=_WILLIS)
def rate_of_carrier(held: Number, first: Number, last: Number) -> Number:
    """({first} − {held}·{last})/(1 − {held})"""


@formula(why=_WILLIS)
def rate_of_first(held: Number, last: Number, carrier: Number) -> Number:
    """{held}·{last} + (1 − {held})·{carrier}"""


@formula(holds="{held} ≠ 0", fails=_NO_TEETH, why=_WILLIS)
def rate_of_last(held: Number, first: Number, carrier: Number) -> Number:
    """({first} − (1 − {held})·{carrier})/{held}"""


@formula(
    why=said(
        "Between wheel and satellite the tips of the ring end on the circle where the satellite's involute "
        "begins, or outside it."
    )
)
def tip_of_ring(m: Number, z: Number, ha: Number) -> Number:
    """{m}·({z}/2 − {ha})"""


@formula(why=said("The base circle carries the involute."))
def base_radius(m: Number, z: Number, alpha: Angle) -> Number:
    """{m}·{z}·cos {alpha}/2"""


@formula(why=said("So far along the line of action from one base circle to the other."))
def along_action(m: Number, ring: Number, z: Number, alpha: Angle) -> Number:
    """{m}·({ring} − {z})·sin {alpha}/2"""


@formula(why=said("There the line of action touches the base circle of the satellite."))
def least_tip_of_ring(base: Number, along: Number) -> Number:
    """√({base}² + {along}²)"""


@formula(
    holds="{ratio} ≠ 0",
    fails=_STANDS,
    why=said("Driven from the other side the train has the inverse ratio."),
)
def inverse_ratio(ratio: Number) -> Number:
    """1/{ratio}"""


@formula(
    holds="{driving} ≠ 0",
    fails=_NO_TEETH,
    why=said("Ratios of stages in series multiply."),
)
def overall_ratio(ratio: Number, driven: Number, driving: Number) -> Number:
    """|{ratio}|·{driven}/{driving}"""


@formula(
    holds="{driven} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "Wheels in outer mesh turn each other backwards, the one with more teeth more slowly."
    ),
)
def rate_back(omega: Number, driving: Number, driven: Number) -> Number:
    """−{omega}·{driving}/{driven}"""


@formula(
    why=said(
        "Willis: with the ring held the ratio is 1 + z3/z1, and that gives the teeth of the ring."
    )
)
def teeth_of_ring(z1: Number, ratio: Number) -> Number:
    """{z1}·({ratio} − 1)"""


@formula(
    holds="{ratio} ≠ 0",
    fails=_STANDS,
    why=said("The carrier drives, so the ratio is the inverse of 1 + z3/z1."),
)
def teeth_of_driven_ring(z1: Number, ratio: Number) -> Number:
    """{z1}·(1/{ratio} − 1)"""


@formula(why=said("The satellite fills the gap between the sun and the ring: common axis."))
def teeth_between(z3: Number, z1: Number) -> Number:
    """({z3} − {z1})/2"""


@formula(
    holds="{driving} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "With the carrier stopped the wheels are a plain pair; outer teeth turn each other backwards."
    ),
)
def mesh_outside(driven: Number, driving: Number) -> Number:
    """−{driven}/{driving}"""


@formula(
    holds="{driving} ≠ 0",
    fails=_NO_TEETH,
    why=said(
        "With the carrier stopped the wheels are a plain pair; inside a ring both turn the same way."
    ),
)
def mesh_inside(driven: Number, driving: Number) -> Number:
    """{driven}/{driving}"""


@formula(
    holds="{axes} > 0",
    fails=_NO_ROOM,
    why=said(
        "Neighbouring satellites must not touch: the chord between their axes is longer than the tip diameter."
    ),
)
def most_satellites(tip: Number, axes: Number) -> Number:
    """⌈180°/arcsin(min(1, {tip}/(2·{axes})))⌉ − 1"""


@formula(
    why=said("Both rims of the satellites must clear each other, so the smaller number counts.")
)
def fewer(first: Number, second: Number) -> Number:
    """min({first}, {second})"""


@formula(
    holds="{ratio} ≠ 0",
    fails=_STANDS,
    why=said(
        "The ratio tells how many times more slowly the last wheel turns than the driving shaft."
    ),
)
def speed_behind(speed: Number, ratio: Number) -> Number:
    """|{speed}|/{ratio}"""


@formula(
    why=said("The rack runs as fast as the pitch circle of its wheel: a pitch with each tooth.")
)
def speed_of_rack(module: Number, z: Number, n: Number) -> Number:
    """π·{module}·{z}·{n}/60"""


@formula(
    why=said(
        "The satellite's rims come into the same places again after as many teeth as their common divisor "
        "allows."
    )
)
def common_divisor(z2: Number, z3: Number) -> Number:
    """gcd({z2}, {z3})"""


@formula(
    holds="{k} ≠ 0",
    fails=_NO_SATELLITES,
    why=said(
        "{k} satellites can be put in evenly only if this number is whole: from one place to the next the "
        "wheels have turned by whole teeth."
    ),
)
def assembly_of_row(z1: Number, z3: Number, k: Number) -> Number:
    """({z1} + {z3})/{k}"""


@formula(
    holds="{k}·{g} ≠ 0",
    fails=_NO_SATELLITES,
    why=said("The satellites can be put in evenly only if this number is whole."),
)
def assembly_opposed(
    z1: Number, z2: Number, z3: Number, z4: Number, k: Number, g: Number
) -> Number:
    """({z1}·{z3} + {z2}·{z4})/({k}·{g})"""


@formula(
    holds="{k}·{g} ≠ 0",
    fails=_NO_SATELLITES,
    why=said("The satellites can be put in evenly only if this number is whole."),
)
def assembly_alike(z1: Number, z2: Number, z3: Number, z4: Number, k: Number, g: Number) -> Number:
    """({z1}·{z3} − {z2}·{z4})/({k}·{g})"""


@formula(
    holds="2·{z}·sin²{alpha} − 4·{ha} > 0",
    fails="no ring is clear of so few teeth",
    why=said(
        "With fewer teeth the ring's tips would meet the satellite's flank below its involute."
    ),
)
def least_ring(z: Number, alpha: Angle, ha: Number) -> Number:
    """({z}²·sin²{alpha} − 4·{ha}²)/(2·{z}·sin²{alpha} − 4·{ha})"""


@formula(
    holds="{driven} ≠ 0",
    fails="the segment is too short to be read at this scale",
    why=said(
        "On one level segments are the angular velocities, to one scale: their ratio is that of the train."
    ),
)
def ratio_of_segments(driving: Length, driven: Length) -> Number:
    """{driving}/{driven}"""


@formula(
    holds="{due} ≠ 0",
    fails="there is no ratio to compare with",
    why=said("Numbers of teeth are whole, so the ratio asked for is met within a tolerance only."),
)
def miss_of_ratio(found: Number, due: Number) -> Number:
    """100·|{found} − {due}|/|{due}|"""


@operation(
    kept=True,
    across=True,
    everywhere=True,
    fails=WHOLE_ROW,
    why=said("Neighbours decide whether the satellites have room."),
)
def next_satellite(axis: Point, *, row: int) -> Point:
    """Mark {it}, the axis of the satellite that follows {axis}."""
    after = np.full_like(axis, np.nan)
    after[:, :row] = np.roll(axis[:, :row], -1, axis=1)
    return Point(after)
