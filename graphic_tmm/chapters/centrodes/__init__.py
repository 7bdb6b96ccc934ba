"""Centrodes: the curves on which the motion of a link rolls.

In every position a link that moves in the plane turns about its instantaneous centre P: it lies where the
normals to the velocities of two of its points meet. A pin that turns about a pivot of the frame has its normal
along the line of both, a slider square to its guide; elsewhere the normal is square to the vector of the plan
of velocities. The centres of all positions, joined on the frame, make the fixed centrode; joined in the axes of
the link, the moving one. A centre is carried into the link by its distances from two points of it.

In every position both curves have the point P and their tangent there in common, and from one position to the
next the same arc: the moving centrode rolls on the fixed one without slipping, and this rolling is the motion
of the link. Where the link only shifts for a moment P is at infinity, and the curves go on in another branch.

Draws: place ``centrodes``: both centrodes of a link, their points in a table. Builds on the plan of positions,
and on that of velocities where pivots and guides do not give the normals.

Sources: Артоболевский И. И., Теория механизмов и машин (центроиды в относительном движении звеньев).
"""

from __future__ import annotations

from graphic_tmm.chapters.centrodes.task import CENTRODES, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=CENTRODES,
    number=21,
    builds_on=("kinematics",),
    places=(Place(CENTRODES, 26),),
    sections=SECTIONS,
)
