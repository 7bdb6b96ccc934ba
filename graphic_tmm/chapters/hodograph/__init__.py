"""Hodographs of velocity and acceleration, and what both come to for ω_1 = 1, the analogues.

The vectors pk of a point on the plans of velocities of all positions are carried to one pole, parallel and
equal, so to the scale of the plans. A smooth curve joins their ends in the order of the positions: the
hodograph. Its arc from one moment to the next is the change of the velocity, so its tangent at an end has
the direction of the acceleration there, which is πk of the plan of accelerations: both plans are held
against each other by the angle between the two. The hodograph of accelerations is drawn alike.

The tangent of a curve through the ends is that of the hodograph but for a share θ⁴/180 for a harmonic that
turns by θ from one end to the next (the error of a cubic spline's slope); differences of the fourth order
are off by θ⁴/30. Three times what both are apart there or at a neighbour, and a protractor that is read to
a degree, make the limit up to which an angle is explained; more is a mistake of a plan. It falls with the
fourth power of the number of positions. At the ends of a row that does not come back there are no
neighbours on one side: nothing is said there. Nor is it of a point that slides on the frame: its hodograph
is a straight line. Nor where one ω with an ε is given for all positions: they are no moments of one motion.

By the turn of a crank that turns evenly v = ω·dS/dφ and a = ω²·d²S/dφ²: the analogues dS/dφ and d²S/dφ² are
read off the same plans to the scales μ_v/ω_1 and μ_a/ω_1², as if the crank turned by one radian a second.
They hang on the lengths alone. ``motion(plans="hodograph")`` gives them, as vectors, at any angle.

Draws: places ``hodograph`` (the hodographs) and ``hodograph table``. Builds on the plans of velocities and
accelerations.

Sources: Артоболевский И. И., Теория механизмов и машин (годограф скорости, аналоги скоростей и ускорений).
"""

from __future__ import annotations

from graphic_tmm.chapters.hodograph.task import HODOGRAPH, SECTIONS, TABLE
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, KINEMATICS, VELOCITIES
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=HODOGRAPH,
    number=23,
    builds_on=(KINEMATICS,),
    places=(
        Place(HODOGRAPH, 24, shows=(VELOCITIES,), beside=(ACCELERATIONS,)),
        Place(TABLE, shows=(VELOCITIES,), beside=(ACCELERATIONS,), attends=HODOGRAPH),
    ),
    sections=SECTIONS,
)
