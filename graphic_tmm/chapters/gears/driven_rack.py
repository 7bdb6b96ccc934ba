"""A rack that wheel 1 drives: a wheel of infinite radius, whose involutes are straight.

Its rolling line touches the pitch circle in P and the line of action leans by α always; a shift of the wheel
moves the datum line away. N₂ is infinitely far; contact begins where the line of the rack's tips cuts the line
of action, in N₁ at the earliest. Flanks stand square to the line of action; the root is rounded as that of the
basic rack (`rack`).
"""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import pitch_radius
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length, Number
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears.helical import Helix
from graphic_tmm.chapters.gears.rack import RackSizes
from graphic_tmm.chapters.gears.ring import less
from graphic_tmm.chapters.gears.shifts import Axes, Section, drawn_shifts, letter_of
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.language.said import said

SHIFT = said("The distance of the datum line is given: it tells the shift of the wheel.")
LOWEST = said("The tips of the rack reach down to this point of the flank.")
CLEAR = said("Between tips and roots there is what the distances from the axis leave.")
FROM_AXIS = said("Lines of the rack are told by their distances from the axis of the wheel.")


@formula(
    why=said(
        "The rolling line touches the pitch circle; a shift moves the datum line of the rack away from it."
    )
)
def datum_distance(r: Number, x: Number, m: Number) -> Number:
    """{r} + {x}·{m}"""


@formula(why=said("The teeth of the rack reach so far from its datum line towards the wheel."))
def addendum(ha: Number, m: Number) -> Number:
    """{ha}·{m}"""


@formula(why=said("With each tooth the rack goes on by a pitch: so far in a turn of the wheel."))
def travel_in_a_turn(p: Number, z: Number) -> Number:
    """{p}·{z}"""


@formula(why=said("The teeth of a wheel have room in the rack, with the clearance."))
def dedendum(ha: Number, c: Number, m: Number) -> Number:
    """({ha} + {c})·{m}"""


@formula(why=said("On the datum line of a rack tooth and space are alike."))
def half_of_pitch(p: Number) -> Number:
    """{p}/2"""


@formula(why=said("Both flanks of the rack lean by α: its tooth becomes narrower towards the tip."))
def rack_tip_thickness(s: Number, h: Number, alpha: Angle) -> Number:
    """{s} − 2·{h}·tan {alpha}"""


@formula(
    why=said(
        "The path of contact goes from the line of the rack's tips to the tip circle of the wheel; divided by "
        "the base pitch it tells how many pairs touch."
    )
)
def contact_ratio_with_rack(z: Number, a: Angle, alpha: Angle, ha: Number, x: Number) -> Number:
    """{z}·(tan {a} − tan {alpha})/(2·π) + ({ha} − {x})/(π·sin {alpha}·cos {alpha})"""


@formula(
    fails="the point stands at the limit of the line of action",
    why=said(
        "The flanks roll and slide: the sliding velocity is taken by that along the own flank. A point of the "
        "wheel's goes along it as fast as it is far from N₁, one of the rack's as P is."
    ),
)
def sliding_on_rack(other: Length, own: Length) -> Number:
    """1 − {other}/{own}"""


@formula(
    why=said("The rack does not turn: the flanks slide as the wheel turns about the pitch point.")
)
def sliding_velocity_on_rack(omega: Number, x: Number, pole: Number) -> Number:
    """{omega}·({x} − {pole})"""


@dataclass(frozen=True)
class DrivenRack:
    """A rack in mesh (Number, m): how far its teeth reach to both sides of the datum line, their thicknesses.

    ``tip``, ``root``, ``straight``: how far the lines of its tips, of its roots and of the ends of its straight
    flanks are from the axis; ``clearance``: between the tips of the wheel and its roots; ``profile``: of its
    roots; ``travel``: in a turn of the wheel.
    """

    h_a: Mark
    h_f: Mark
    s: Mark
    s_a: Mark
    tip: Mark
    root: Mark
    straight: Mark
    clearance: Mark
    profile: RackSizes
    travel: Mark


def calculate_axis(
    draft: Draft, order: GearTask, normal: Section, drawn: Section, helix: Helix | None
) -> Axes:
    """Calculate how far the datum line is from the axis, or by that distance the shift."""
    z = draft.take(Number, "z_1", float(order.z1))
    r, name = draft.draw(pitch_radius, "r_1", drawn.m, z, unit="m"), letter_of(order, "x", 1)
    if order.distance is None:
        x = draft.take(Number, name, order.x1 or 0.0)
        distance = draft.draw(datum_distance, "H", r, x, normal.m, unit="m")
    else:
        distance = draft.take(Number, "H", order.distance, "m")
        x = draft.draw(g.perceived_shift, name, distance, r, normal.m, why=SHIFT)
    across = drawn_shifts(draft, helix, (x,))
    inv = draft.draw(g.involute, letter_of(order, "inv α"), drawn.alpha)
    return Axes((z,), (x,), across, (r,), None, distance, inv, inv, drawn.alpha, None)


def calculate_rack(
    draft: Draft, order: GearTask, normal: Section, axes: Axes, across: tuple[Mark, Mark, Mark],
    profile: RackSizes,
) -> DrivenRack:  # fmt: skip
    """Calculate the rack; ``across``: in the drawn section its pitch, angle and the tip radius of the wheel."""
    pitch, alpha, top = across
    h_a = draft.draw(addendum, "h_{a2}", normal.ha[1], normal.m, unit="m")
    h_f = draft.draw(dedendum, "h_{f2}", normal.ha[0], normal.c, normal.m, unit="m")
    s = draft.draw(half_of_pitch, letter_of(order, "s", 2), pitch, unit="m")
    s_a = draft.draw(rack_tip_thickness, letter_of(order, "s_{a}", 2), s, h_a, alpha, unit="m")
    tip, root, straight = (
        draft.draw(op, name, axes.a_w, high, unit="m", why=FROM_AXIS)
        for op, name, high in (
            (less, "H_{a}", h_a), (added, "H_{f}", h_f), (added, "H_{l}", profile.straight)
        )
    )  # fmt: skip
    clearance = draft.draw(less, "c_2", root, top, unit="m", why=CLEAR)
    travel = draft.draw(travel_in_a_turn, "L", pitch, axes.z[0], unit="m")
    return DrivenRack(h_a, h_f, s, s_a, tip, root, straight, clearance, profile, travel)
