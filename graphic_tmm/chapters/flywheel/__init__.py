"""The flywheel: the moment of inertia that keeps a machine's speed within a coefficient of irregularity δ.

All forces are reduced to the crank by their powers: M·ω = P·v, so M = P·(v_B/v_A)·l_OA for the gas on a
piston, and for any loads their moment on Zhukovsky's lever. Graphical integration of M over φ (see the
chapter of diagrams) gives the work. In a steady cycle the work of the driving side equals that of the
resisting side at its end; where one moment is constant its work is the straight line from the beginning to
the end of the other.

Why T_м = ΔT − T_зв: the work that the driving forces have done more than the resisting ones, ΔT = A_дв −
A_с, is what the kinetic energy of the whole machine has gained. The links' part of it, T_зв = Σ(m·v²/2 +
J·ω²/2), is known from the plan of velocities; the rest went into the flywheel. It spins with the crank, so
its energy runs between J·ω_max²/2 and J·ω_min²/2, and their difference is J·ω²·δ (ω the mean speed, δ =
(ω_max − ω_min)/ω). The segment cd between the extremes of T_м, carried to the axis of ordinates, therefore
gives

    J = cd·μ_T/(δ·ω²).

T_зв is taken at the mean speed, an approximation for small δ (at δ = 0.23 it is some 12 % on the safe
side). Wittenbauer's diagram does without that: ΔT over the reduced inertia J_пр = 2·T_зв/ω² is a closed
curve; a ray to it from the (unknown) origin has the slope ω²/2. So the two tangents with the slopes tg ψ =
μ_J·ω²·(1 ± δ)/(2·μ_T) touch it where the speed is largest and smallest, and cut off ab on the axis of
energies: J = ab·μ_T/(δ·ω²), without an origin having to be on the sheet.

The rim: the largest diameter by the speed that its material stands; m = 4·J/D_m², its width from the
density.

Draws: place ``flywheel`` (moment, works, energies, energy–mass curve, sketch, tables). Builds on
kinematics, on indicator (the gas) or forces (loads on the lever).

Sources: Артоболевский И. И., Теория механизмов и машин (неравномерность движения, диаграмма Виттенбауэра);
Попов С. А., Тимофеев Г. А., Курсовое проектирование; the course project of the flywheel of a
single-cylinder engine (scene ``engine``).
"""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.task import FLYWHEEL, SECTIONS
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.chapters.indicator.task import INDICATOR
from graphic_tmm.chapters.kinematics.task import KINEMATICS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=FLYWHEEL,
    number=5,
    drive="crank",
    builds_on=(KINEMATICS, INDICATOR, FORCES),
    places=(Place(FLYWHEEL, 50),),
    sections=SECTIONS,
)
