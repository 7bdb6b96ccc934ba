"""Planetary trains: tooth numbers by three conditions, two views, the pictures of speeds.

Willis: seen from the carrier, the train is a plain one with fixed axes, so (ω₁ − ω_H)/(ω₄ − ω_H) is the
ratio of its tooth numbers with the carrier held. The wheel 4 (3 of a single row) being fixed, U_1H = 1 −
U_14^(H): 1 + z₃/z₁ for a single row, 1 ± z₂·z₄/(z₁·z₃) for two. The four schemes differ by which central
wheels are rings. Any of the three coaxial members may stand and any other drive; of a differential none
stands, and two of the three angular velocities are given.

Two wheels on an arm have one mesh: the satellite's own angular velocity is what is sought. Of three central
wheels (3K), which share satellites of two rims, the carrier runs idle: U_15 = (1 − U_13^(H))/(1 − U_53^(H))
where 3 stands. With the carrier held power flows to the satellites and from them, and each mesh takes its
share: that, and the balance of the three torques, gives torques and efficiency.

Bevel wheels are taken by the mean radii of their teeth. The axis of the satellites crosses the main one where
all pitch cones have their tips; between wheels that differ it leans, cos φ = (z₁ − z₃)/(2·z₂). Willis with the
sign −: (ω₁ − ω_H)/(ω₃ − ω_H) = −z₃/z₁, of satellites of two rims −z₂·z₄/(z₁·z₃). Angular velocities are
vectors along the axes, ω₂ = ω_H + ω_2H, and the triangle of them gives how the satellites turn (`bevel`). Of
the conditions that of assembly is calculated; cones wider than 90°, satellites that touch and rims that cut
into wheels are told.

Wheels with fixed axes may close a differential: they join two of its members, ω_q = u·ω_p, so that one shaft
drives. Willis gives the ratio, with 1 and u for both. In the picture any velocities in that ratio are laid off
and the satellite drawn through them; what they give the driving point tells how many times all are too large
(false position, `rates`). The wheels hand on torque, too, and may send power round (`closed_torques`).

Torques: those on the three shafts balance, and the carrier being held the two central wheels have the
torques of a plain train, M₄ = −M₁·U_14^(H)·η₀^(±1), where + stands if wheel 1 drives in that motion. A train
in which the losses take all that is put in locks itself.

Tooth numbers that are sought have to meet more than the ratio, all in whole numbers (`tooth_conditions`,
`tooth_search`): coaxiality, both rows have one distance of axes (single row: z₃ = z₁ + 2·z₂); assembly, with k
satellites all alike the train goes together evenly only where (z₁ + z₃)/k is whole; of two rows z₁·z₃ ± z₂·z₄
over k and the common divisor of the satellite's rims; neighbourhood, 2·a_w·sin(180°/k) is more than a
satellite's tip diameter. No wheel may be undercut, no ring foul its satellites. Of all trains that pass, the
smallest comes first. Given teeth are drawn as they are, and the conditions that they break are told. One wide
satellite, z₂ = z₃, meshes with outer wheels that differ by some teeth, the last cut with a shift (Ferguson).

Picture of linear velocities: at the level of every point on the line of centres its velocity is laid off;
the points of one body end in a straight line through the level where it stands. The satellite has three, A in
the first mesh, its axis B and C in the other: two known velocities, of which that in the mesh with a fixed
wheel is 0, give the third. Rays from a pole, parallel to these lines, cut off segments proportional to ω on a
line parallel to the axis: the plan of angular velocities, from which the ratio is measured once more, and told
beside the one by Willis (`rates`).

Draws: place ``planetary``: pitch circles, kinematic scheme (with the pair of wheels behind the train, of its
module), pictures, conditions, the choice of trains; on a board of its own whose positions are the
satellites. Builds on no chapter.

Sources: Артоболевский И. И., Теория механизмов и машин (планетарные механизмы: кинематика, подбор чисел
зубьев); Попов С. А., Тимофеев Г. А., Курсовое проектирование; the course project of the windrower (scene
``windrower``).
"""

from __future__ import annotations

from graphic_tmm.chapters.trains.task import PLANETARY_TRAIN, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

_NAME = PLANETARY_TRAIN
CHAPTER = Chapter(
    name=_NAME,
    number=10,
    board=_NAME,
    places=(Place("planetary", 120), Place("planetary given", attends="planetary")),
    sections=SECTIONS,
)
