"""Curvature of paths: centres of curvature of a link's points, inflection circle, pole of accelerations.

A point K that goes along a curve at v has the normal acceleration v²/ρ towards its centre of curvature K_0. On
the plan of accelerations the vector πk is projected on the normal to pk; ρ_K = (pk·μ_v)²/(n·μ_a) is laid off
from K on that normal, the way that n points.

Where two points A and B of a link go on circles or straight guides, A_0 and B_0 are known without any plan: the
pivots, or infinitely far on the normals to the guides; of other points they come from the plans. The normals
AA_0 and BB_0 meet in the instantaneous centre P. Bobillier's construction: Q is where AB and A_0B_0 meet, PQ
the axis of the rays PA and PB; the common tangent t of the centrodes is to PB as PA is to the axis. So the axis
of PA and PK is turned from that of PA and PB by the angle BPK; where it meets AK is Q_K, and A_0Q_K meets PK in
K_0. Where a centre is infinitely far, parallels stand for the lines to it.

Euler and Savary: on each ray from P the point I of the inflection circle has AI·AA_0 = AP², both laid off from
A the same way. By Thales the squares on two rays in their points I meet at the other end J of its diameter PJ:
its points have no normal acceleration, their paths are straight there for a moment. The tangent t is square to
PJ.

The pole of accelerations Π, whose acceleration is zero, is found by similarity: the triangle ABΠ is similar to
abπ of the plan. Points without a tangential acceleration lie on a second circle through P and Π with its centre
on t: the circles of Bresse. They meet in Π, for there both parts are zero: the drawing is checked by that.

Ball's point, whose path is straight to a higher order, is where the inflection circle meets the cubic of
stationary curvature. That wants how curvatures of two points change; velocities and accelerations do not tell
it. It is known where A and B turn about pivots of the frame: there it does not change (`bresse.draw_ball`).

Draws: place ``curvature``: the constructions at each position, their table (scene ``coupler-curvature``).
Builds on the plans of kinematics.

Sources: Артоболевский И. И., Теория механизмов и машин (мгновенный центр ускорений, поворотный круг); Bottema
O., Roth B., Theoretical Kinematics (Euler–Savary, Bobillier, Ball's point); Hartenberg R. S., Denavit J.,
Kinematic Synthesis of Linkages.
"""

from __future__ import annotations

from graphic_tmm.chapters.curvature.task import CURVATURE, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=CURVATURE,
    number=22,
    builds_on=("kinematics",),
    places=(Place(CURVATURE, 23),),
    sections=SECTIONS,
)
