"""Cams given by arcs: base circle, flanks, nose; what the follower does is found, not asked for.

A contour of arcs is easily turned and measured, so cams of engines and pumps were long given so: a harmonic cam
has convex flanks, a tangential one straight flanks. Here nothing is chosen but the arcs; the motion of the
follower follows.

The arcs touch: where one goes over into the next both centres and the place lie in one line. The centre of a
convex flank is therefore ρ − r1 from the cam's centre and ρ − r2 from the nose's (of a hollow one ρ + r1 and
ρ + r2); a straight flank is the common tangent of both circles (`contour`).

Reversed motion: the cam stands, the follower goes round it. As long as it is on one arc, the roller's centre
keeps its distance from that arc's centre K, so ruler and compass find it: the line of the rod cuts the circle
about K (of the lever: two circles meet). A link of that length in place of cam and roller moves the follower
alike: the replacing mechanism. A flat face touches where the arc's normal is parallel to the rod, that of a
lever where the line through its pivot touches a circle about the arc's centre (`follower`).

The displacements are laid off over the turn and differentiated twice by chords (`plan`). Where the follower
goes from arc to arc d²S/dφ² jumps; chords smooth the jump over an interval. dS/dφ is found once more without
differentiation: the normal KB and the line through O square to the rod meet in the instant centre P of cam and
follower, and OP is dS/dφ (of a lever: P on the line of pivots, dψ/dφ = OP/O1P). And both derivatives are found
by plans of velocities and accelerations of the replacing mechanism, at a change of arcs before and behind it
(`linkage`). The table holds all, and by how much chords are off.

A disc on a shaft beside its centre is the simplest cam of arcs: an eccentric, one arc all round (`geometry`).

Draws: place ``arc_cam``: the contour with its follower, diagrams, plans, a table, the stroke; on a board of its
own whose positions are angles of the cam, and the four at which the follower goes from arc to arc. Builds on
the chapter of cams, whose instruments it takes.

Sources: Артоболевский И. И., Теория механизмов и машин (кулачковые механизмы: заменяющие механизмы); Попов
С. А., Тимофеев Г. А., Курсовое проектирование.
"""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.task import ARC_CAM, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=ARC_CAM,
    number=13,
    board=ARC_CAM,
    builds_on=("cam",),
    places=(Place("arc_cam", 105), Place("arc_cam given", attends="arc_cam")),
    sections=SECTIONS,
)
