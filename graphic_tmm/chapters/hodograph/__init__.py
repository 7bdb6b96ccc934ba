"""Hodographs of velocity and acceleration, and what both come to for ω_1 = 1, the analogues.

The vectors pk of a point on the plans of velocities of all positions are carried to one pole, parallel and
equal, so to the scale of the plans. A smooth curve joins their ends in the order of the positions: the
hodograph. Its arc from one moment to the next is the change of the velocity, so its tangent at an end has
the direction of the acceleration there, which is πk of the plan of accelerations: both plans are held
against each other by the angle between the two. The hodograph of accelerations is drawn alike.

The tangent of a curve through n ends of a turn is that of the hodograph but for a share θ⁴/180 of the
greatest acceleration, for a harmonic that turns by θ = 2π·m/n from one end to the next (that is the error
of a cubic spline's slope). The third harmonic of the crank and a protractor that is read to a degree make
the limit up to which an angle is explained, τ_i = 1° + (6π/n)⁴/180·(πk)_max/(πk)_i; more is a mistake of a
plan, or a row that is too coarse for the mechanism. At the ends of a row that does not come back the curve
has no neighbour on one side: nothing is said there.

By the turn of a crank that turns evenly v = ω·dS/dφ and a = ω²·d²S/dφ²: the analogues dS/dφ and d²S/dφ² are
read off the same plans to the scales μ_v/ω_1 and μ_a/ω_1², as if the crank turned by one radian a second.
They hang on the lengths alone.

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
