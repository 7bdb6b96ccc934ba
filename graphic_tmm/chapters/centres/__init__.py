"""Instantaneous centres: of any two links the point in which both have the same velocity.

Of n links, the frame among them, there are N = n·(n − 1)/2 centres P_ij. Those of pairs are known at once: a
pin is one (of k links in a pin, of each two of them), of a guide it lies at infinity, square to the guide, of
wheels that roll it is the pitch point. The others follow by the theorem of Aronhold and Kennedy: the centres
of any three links lie on one straight line. So P_ij lies on P_ik P_kj and on P_il P_lj, where both lines
meet. The polygon of links keeps the order: its corners are links, its sides centres that are known; a side
that closes two triangles of known sides is the next one. Where several pairs of lines would do, those are
taken that cross most squarely.

A centre at infinity is a direction. A line through it is a parallel; two parallel lines meet there, and a
link whose P_i0 lies there does not turn. Where the polygon does not close (several drives; lines that
coincide), P_i0 is found by the plan of velocities: where the normals to the velocities of two points meet.

About P_i0 a link turns at this moment, and in P_1i it goes as link 1: ω_i/ω_1 = P_1i P_10/(P_1i P_i0), of one
sense where both centres lie on one side of P_1i; v_X = ω_i·P_i0 X. Both are held against the plan of
velocities.

Draws: place ``centres``: the scheme of centres of each position asked for, the polygon of links, tables. On the
page the scheme moves with the crank.
Builds on the plans of positions and of velocities.

Sources: Артоболевский И. И., Теория механизмов и машин (мгновенные центры скоростей); Norton R. L., Design of
Machinery (instant centers of velocity).
"""

from __future__ import annotations

from graphic_tmm.chapters.centres.task import CENTRES, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=CENTRES,
    number=20,
    builds_on=("kinematics",),
    places=(Place(CENTRES, 24),),
    sections=SECTIONS,
)
