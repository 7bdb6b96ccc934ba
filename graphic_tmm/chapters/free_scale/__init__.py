"""Velocities of a group of class III by another driving link, on a plan to a free scale.

A leg that turns about the frame is taken as the driving link: the mechanism is of class II then, and its plan
of velocities is drawn group by group. The velocity of that leg's pin is not known, so it is laid off as long as
it suits. From it and from the pole the second pin of the plate follows, the third by similarity, and from that
and from the pole the crank pin. Its velocity is known, ω₁·l_OA, and so is the scale then: μ_v = ω₁·l_OA/(pa),
by which every other vector is read. Ratios of velocities do not hang on what drives, so they are those of the
mechanism itself. Accelerations cannot be found so: ε of the leg is no multiple of anything known.

Draws: place ``free_scale``, in one position. Builds on the plans of positions and of velocities.

Sources: Артоболевский И. И., Теория механизмов и машин (планы скоростей групп III класса: замена ведущего
звена).
"""

from __future__ import annotations

from graphic_tmm.chapters.free_scale.task import FREE_SCALE, SECTIONS
from graphic_tmm.chapters.kinematics.task import KINEMATICS, VELOCITIES
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=FREE_SCALE,
    number=27,
    builds_on=(KINEMATICS,),
    places=(Place(FREE_SCALE, shows=(VELOCITIES,)),),
    sections=SECTIONS,
)
