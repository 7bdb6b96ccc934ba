"""What people call the views and the results of a pair of gears."""

from __future__ import annotations

from graphic_tmm.chapters.gears.names import GEARS
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
    "arc_of_engagement1": "c_{1}d_{1}",
    "arc_of_engagement2": "c_{2}d_{2}",
}

SYMBOLS = (
    ("z", said("number of teeth"), ""),
    ("m", said("module"), "m"),
    ("x", said("shift coefficient"), ""),
    ("α_w", said("angle of engagement"), "°"),
    ("a_w", said("distance of the centres"), "m"),
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
