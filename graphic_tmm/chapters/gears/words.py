"""What people call the views and the results of a pair of gears; why it is drawn as it is."""

from __future__ import annotations

from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "chapter gears": said("Gear pair"),
    "given gears": said("Given data: gears"),
    "gears": said("Gear pair"),
    "gear": said("Meshing of the gears"),
    "gear-dimensions": said("Dimensions of the gear pair"),
    "gear-rolling-1": said("Construction of a tooth of wheel 1"),
    "gear-rolling-2": said("Construction of a tooth of wheel 2"),
    "gear-shifts": said("Chart of shifts"),
    "gear-calculation": said("Calculation of the gear pair"),
    "sliding": said("Specific sliding"),
    "gear_ratio": "u_{12}",
    "arc_of_engagement": "s_{cd}",
    "sliding-table": said("Specific sliding"),
    "alpha_w": "α_{w}",
    "delta_y": "Δy",
    "contact_ratio": "ε_{α}",
    "contact_ratio_drawn": "ε_{dr}",
    "contact_ratio_difference": "Δε",
    "contact_ratio_uncut": "[ε_{α}]",
    "overlap_ratio": "ε_{β}",
    "total_ratio": "ε_{γ}",
    "alpha_t": "α_{t}",
    "x_sum": "x_{Σ}",
    "travel": "L",
    "r_a2_least": "r_{l2}",
    "tip_overlap": "δ_{θ}",
    "assembly_gap": "δ_{ψ}",
    "v_rolling": "v",
    **{f"omega{wheel}": f"ω_{{{wheel}}}" for wheel in (1, 2)},
    "v_s_ratio": "v_{s}/v",
    **{f"v_s{place}_ratio": f"v_{{s{place}}}/v" for place in ("N1", "a", "b", "N2")},
    "arc_of_engagement1": "c_{1}d_{1}",
    "arc_of_engagement2": "c_{2}d_{2}",
}

SYMBOLS = (
    ("z", said("number of teeth"), ""),
    ("m", said("module"), "m"),
    ("x", said("shift coefficient"), ""),
    ("α_w", said("angle of engagement"), "°"),
    ("a_w", said("distance of the centres"), "m"),
    ("H", said("distance of the datum line of a rack from the axis"), "m"),
    ("L", said("travel of a rack in a turn of its wheel"), "m"),
    ("r_b", said("base radius"), "m"),
    ("ε_α", said("contact ratio"), ""),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(GEARS,),
    sources=("artobolevsky", "popov", "contour", "geometry"),
    symbols=SYMBOLS,
)


CENTRES = said("The centres of both wheels stand on this line, the distance of the axes apart.")
POLE = said(
    "The rolling circles touch in the pitch point, which divides the centre line in the ratio of the "
    "teeth."
)
CIRCLE = said("Circles of a wheel stand about its centre.")
LIMIT = said(
    "The common normal of involutes touches their base circle, and by the law of gearing it goes through "
    "the pitch point: so the line of action is this tangent."
)
ACTION = said("Both involutes touch one another on this line only.")
ENTERS = said(
    "A pair of teeth begins to touch where the tip circle of the driven wheel cuts the line of action."
)
LEAVES = said(
    "A pair of teeth ceases to touch where the tip circle of the driving wheel cuts the line of action."
)
ROOT = said("The flank of a ring ends outward on its root circle.")
APEX = said("A pointed tooth ends where its flanks meet, below the tip circle.")
RACK_LINE = said(
    "The lines of the rack stand square to that of centres; one touches the pitch circle in P."
)
RACK_TIP = said("A pair begins to touch where the line of the rack's tips cuts the line of action.")
RACK_FLANK = said(
    "The involute of a wheel of infinite radius: a straight line, square to the line of action."
)
RACK_TOOTH = said("The teeth of the rack are alike: the next one stands a pitch farther along it.")
RACK_ROOT = said("The rounding at the root is that of the basic rack.")
RACK_TURNED = said("So the flank stands where contact begins, and where it ends.")
RACK_WORKING = said("On the flank contact goes from the height of one end to that of the other.")
MESH_ANGLE = said(
    "The line of action leans by the angle of mesh; read off, it checks the calculated one."
)
SPAN = said(
    "Pieces of the line of action tell where the teeth touch; the contact ratio and the sliding follow "
    "from them."
)
UNROLLED = said(
    "The thread from the limit point to here is wound back on the base circle: there the involute begins."
)
TANGENT = said("The thread leaves the base circle along the tangent, square to the radius.")
INVOLUTE_POINT = said(
    "The end of the thread, as long as the arc it has left, is a point of the involute."
)
INVOLUTE = said("Through the ends of the thread goes the involute: the flank of the tooth.")
TOOTH_AXIS = said(
    "Half of the tooth's thickness from the flank, on the pitch circle, lies its axis."
)
FILLET_POINT = said(
    "The rounding of the tool's tip cuts here, where its normal goes through the point of rolling."
)
FILLET = said("The points that the rounding of the tool cuts make the fillet.")
NEXT_PAIR = said("The next pair of teeth touches one base pitch farther along the line of action.")
TURNED_FLANK = said(
    "Turned by this angle the flank goes through the end of the working line: so it stands at the "
    "beginning and the end of the contact."
)
STATION = said("The place of contact on the line of action.")
SLIDING_AT = said("The ordinate shows how much the flanks slide where they touch here.")
ROLLED = said("The wheel rolls by equal steps: so much of the thread has come off by then.")
