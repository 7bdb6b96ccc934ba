"""Planetary trains: tooth numbers by the conditions of coaxiality, assembly and neighbourhood; pictures of speeds.

Willis: with the carrier stopped a train has a plain ratio. The smallest train that meets every condition is found among
the schemes A, B, C, D; the picture of linear velocities gives the plan of angular velocities, and the ratio again.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 7, 25 (планетарные механизмы, подбор чисел зубьев).
"""

from __future__ import annotations

from graphic_tmm.chapter import Chapter, Place, Size
from graphic_tmm.chapters.planetary.captions import CAPTIONS
from graphic_tmm.chapters.planetary.plan import PLANETARY_TRAIN, record
from graphic_tmm.chapters.planetary.task import ASKED, SECTIONS
from graphic_tmm.chapters.planetary.views import planetary_views
from graphic_tmm.drawn import results_of, view_scales
from graphic_tmm.readers.measured import measured_columns
from graphic_tmm.scene.records import Scene

_NAME = PLANETARY_TRAIN.chapter
SCALE_KEYS = {
    "planetary": "mu_l_planetary",
    "planetary-velocities": "mu_v_planetary",
    "planetary-rates": "mu_omega_planetary",
}
"""What the scale factors are called where machines read them."""


def _fixed(scene: Scene) -> str:
    return "planetary.mu_l" if "planetary.mu_l" in scene.told else ""


CHAPTER = Chapter(
    name=_NAME,
    number=10,
    captions=CAPTIONS,
    board=_NAME,
    places=(Place("planetary", 120, planetary_views, sizes=lambda scene, view: (_NAME,)),),
    sizes=(Size(_NAME, fixed=_fixed),),
    asked=lambda scene: ASKED.of(scene) is not None,
    sections=SECTIONS,
    record=record,
    named=lambda project, reading, given: view_scales(project, reading),
    scale_key=lambda view: SCALE_KEYS.get(view, ""),
    plans=(_NAME,),
    columns=measured_columns,
    results=lambda drawn: results_of(drawn, PLANETARY_TRAIN.on(drawn).results),
)
