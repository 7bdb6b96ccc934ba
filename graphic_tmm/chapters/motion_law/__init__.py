"""The law of motion: how a machine with one degree of freedom moves under given forces.

All forces are reduced to the crank by their powers, all masses by their energies (see the chapter of the
flywheel). What the forces have done since the first position, ΣA = ∫M·dφ, is what the kinetic energy has
gained: T = T_0 + ΣA, T_0 = J_0·ω_0²/2, nothing where the machine starts from rest. So the moments that depend
on the position alone tell the motion without a differential equation: ω = √(2·T/J).

Wittenbauer's diagram draws T over the reduced moment of inertia J, here with its true origin: the ray from
there to the point of a position has the slope

    tan ψ = T/J · μ_J/μ_T = ω²·μ_J/(2·μ_T).

Where T would become negative the energy is used up: the machine stands, and does not reach what is behind.

ε = dω/dt = ω·dω/dφ: that product is the subnormal of the graph of ω(φ). The normal in the middle of a chord
cuts it off on the base, so that no graph of dω/dφ is needed; ε = s·μ_ω²/μ_φ is the mean of the interval. The
same chords tell the time: over an interval with an even ε the mean speed is that in the middle, ω_m = (ω_1 +
ω_2)/2, so Δt = Δφ/ω_m. From rest this is the book's 2·Δφ/ω_1, and nothing is divided by ω = 0. The graph of
1/ω_m is integrated to t(φ).

With N positions ω errs by what the curve of the moment is off between them, as N⁻², and so does t. The same
with every other position is off four times as much: a third of the difference is told as the error of ω.

Plans of velocities, accelerations and forces take what is read off these graphs where ``drive.speed`` is
"motion law": ω of each position in the last turn, and ε half-way between the middles of its intervals.

Draws: place ``motion_law`` (moment, works, energy, energy–mass diagram, ω, ε, 1/ω, t, tables). Builds on the
flywheel's reductions, and on kinematics, indicator (the gas) or forces (loads on the lever).

Sources: Артоболевский И. И., Теория механизмов и машин (исследование движения машинного агрегата, диаграмма
Виттенбауэра); Попов С. А., Тимофеев Г. А., Курсовое проектирование.
"""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.task import FLYWHEEL
from graphic_tmm.chapters.motion_law.task import MOTION_LAW, SECTIONS
from graphic_tmm.chapters.motor.task import MOTOR
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=MOTION_LAW,
    number=15,
    drive="crank",
    builds_on=(FLYWHEEL, MOTOR),
    places=(Place(MOTION_LAW, 52),),
    sections=SECTIONS,
)
