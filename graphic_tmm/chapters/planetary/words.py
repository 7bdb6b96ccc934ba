"""What people call a planetary train's views and results."""

from __future__ import annotations

from graphic_tmm.chapters.planetary.names import PLANETARY_TRAIN
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

CAPTIONS: dict[str, str] = {
    "given planetary": said("Given data: train"),
    "planetary": said("Planetary train"),
    "planetary-velocities": said("Picture of linear velocities"),
    "planetary-rates": said("Plan of angular velocities"),
    "planetary-conditions": said("Conditions on the tooth numbers"),
    "planetary-trains": said("Trains, the smallest first"),
    "train size": said("size"),
    "planetary-calculation": said("Calculation of the train"),
    "planetary-behind": said("Speed behind the train"),
    "planetary_satellites": said("number of satellites k"),
    "planetary_ratio": said("U"),
    "planetary_ratio_drawn": said("U as drawn"),
    "planetary_difference": said("Δ_{U}"),
    "planetary_mesh_1": said("U^{H} of the first mesh"),
    "planetary_mesh_2": said("U^{H} of the second mesh"),
    "planetary_most": "k_{max}",
    "overall_ratio": "U_{0}",
}

SYMBOLS = (
    ("U", said("transmission ratio"), ""),
    ("z", said("number of teeth"), ""),
)
"""Its letters in a note: what they stand for, their units."""


WORDS = Named(
    captions=CAPTIONS,
    plans=(PLANETARY_TRAIN,),
    sources=("artobolevsky", "popov"),
    symbols=SYMBOLS,
)
