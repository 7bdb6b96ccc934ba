"""The indicator diagram of a cylinder: the pressure on each side of a piston over its stroke.

Pressures are given position by position, or by the parts of the two strokes: polytropic, p·V^n = const, over the
clearance, or straight between given points. The force of the gas on the piston is their difference on its areas.

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 10 (индикаторные диаграммы).
"""

from __future__ import annotations

from graphic_tmm.chapter import Chapter
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS
from graphic_tmm.chapters.indicator.captions import CAPTIONS
from graphic_tmm.chapters.indicator.cylinder import INDICATOR, record
from graphic_tmm.chapters.indicator.plan import VIEW
from graphic_tmm.chapters.indicator.task import SECTIONS
from graphic_tmm.chapters.kinematics.plan import KINEMATICS

CHAPTER = Chapter(
    name=INDICATOR.chapter,
    number=4,
    captions=CAPTIONS,
    builds_on=(KINEMATICS.chapter, DIAGRAMS.chapter),
    sections=SECTIONS,
    record=record,
    charts=lambda made: (made.indicator.chart,),
    scale_key=lambda view: "mu_p" if view == VIEW else "",
)
