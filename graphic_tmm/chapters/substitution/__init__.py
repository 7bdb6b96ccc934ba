"""Accelerations of a group of class IV by substitution: ε of one of its links is taken as 0 first.

Two plates that two links join cannot be solved link by link. With ε = 0 of the first plate its points have
their normal accelerations alone; the second plate follows as a group of two links, with the first link that
joins them. The second joining link closes badly then: its ends differ along it by more than its normal
acceleration. If both pivots stood and that link were away, the first plate could turn by itself: the plan of
such velocities, to a free scale, shows by how much its ends would part along it. So many times this plan is
added as closes the gap, a = a(ε = 0) + k·(plan), and ε of the first plate is so many times its ω there.

Draws: place ``substitution``, in one position: the plan of velocities with the pivots held, then that of
accelerations. Builds on the plans of positions, velocities and accelerations.

Sources: Артоболевский И. И., Теория механизмов и машин (группы IV класса: замена ведущего звена).
"""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, KINEMATICS
from graphic_tmm.chapters.substitution.task import SECTIONS, SUBSTITUTION
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=SUBSTITUTION,
    number=28,
    builds_on=(KINEMATICS,),
    places=(Place(SUBSTITUTION, shows=(ACCELERATIONS,)),),
    sections=SECTIONS,
)
