"""What people call hodographs, analogues and their tables; why their steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.hodograph.task import HODOGRAPH, TABLE
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

ANALOGUES, LIMIT = "analogues", "hodograph_limit"
VELOCITY = said("Hodograph of the velocities of point {point}")
ACCELERATION = said("Hodograph of the accelerations of point {point}")
TANGENTS = said("Tangents of the hodograph of point {point}")
FIRST = said("Analogues of velocities")
SECOND = said("Analogues of accelerations")
CAPTIONS: dict[str, str] = {
    "chapter hodograph": said("Hodographs and analogues"),
    HODOGRAPH: said("Hodographs"),
    TABLE: said("Hodographs: angles to the plans"),
    LIMIT: said("its limit"),
    ANALOGUES: said("Analogues of velocities and accelerations"),
    f"table {HODOGRAPH}": said("Tangents of the hodograph against the plans of accelerations"),
    f"table {ANALOGUES}": said("Analogues s′ = dS/dφ, s″ = d²S/dφ²"),
}

CURVE = said("From position to position the end goes along the change of the vector.")

WORDS = Named(captions=CAPTIONS, plans=(HODOGRAPH, ANALOGUES), sources=("artobolevsky",))
