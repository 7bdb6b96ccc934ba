"""Kinematic diagrams: displacement, velocity and acceleration of a slider's point over time or angle.

One of them is laid off over a base from what the plans give; the others follow from it on the board,
without calculation. A diagram of y over x drawn to μ_y and μ_x has the slope (μ_x/μ_y)·dy/dx on paper. From
a pole at the distance H to the left of the next diagram's origin a ray with that slope cuts off
H·(μ_x/μ_y)·dy/dx on the axis of ordinates: that is the derivative to the scale

    μ_V = μ_S/(μ_t·H),      and backwards, for integration,      μ_S = μ_V·μ_t·H.

So H is the only freedom: either H is chosen and the scale follows, or a standard scale is wanted and H
follows from it (H = μ_S/(μ_V·μ_t)).

- Chords: the slope of a chord is the mean derivative over its interval, so what it gives belongs to the
  interval's *middle* (a `Middles`, never a `Boundaries`); a smooth curve through the middles is read at the
  boundaries.
- Tangents: the smooth curve is drawn first; what its tangents give belongs to the boundaries.
- Integration: over each interval the curve is replaced by its mean ordinate (by the area under the curve,
  or by the ordinate at the middle), and rays from the pole give the segments of the integral, one after
  another.

A row that does not come back to where it began (a stroke, a lever that turns in part) has an interval less
than positions, and the last of them stands at the end of the base.

Both kinds of mistakes of the method, that of chords on few intervals and that of the ruler enlarged by the
pole, are measured in `graphic_tmm/accuracy`. Over the angle of the crank μ_φ stands for μ_t, and ω is left
to the reader.

Draws: place ``diagrams`` (graphs one below the other, and their table). Builds on kinematics: a point that
slides on the frame (`plan.sliding_leg`), its plans of velocities or positions.

Sources: Артоболевский И. И., Теория механизмов и машин (кинематические диаграммы, графическое
дифференцирование и интегрирование); as worked in the course project with chords on 8 intervals (scene
``slider-diagrams``).
"""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.task import DIAGRAMS, SECTIONS
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, KINEMATICS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=DIAGRAMS,
    number=3,
    drive="even",
    builds_on=(KINEMATICS,),
    places=(Place(DIAGRAMS, 30, beside=(ACCELERATIONS,)),),
    sections=SECTIONS,
)
