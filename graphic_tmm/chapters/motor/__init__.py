"""Motors: the moment that an electric motor gives at a speed, and what a machine does with it.

An asynchronous motor pulls by its slip s = 1 − ω/ω_s. Its catalogue gives the power P, the nominal and the
synchronous speed, and how many times the nominal moment its greatest is, λ = M_k/M_n. Kloss's formula

    M = 2·M_k/(s/s_k + s_k/s),   s_k = s_n·(λ + √(λ² − 1)),

goes through the nominal point. A direct-current motor has a straight characteristic, by its speed without load
and its moment at rest, or its nominal point. On the crank, i times slower, the moment counts i times and the
rotor's moment of inertia i² times.

The moment hangs on the speed that is sought, so the energy of a machine grows step by step: over an interval
J·ω²/2 = T + ΔA + M_m(ω)·Δφ with the mean moment of both ends. The parabola on the left is crossed with the
motor's curve, raised by what is known and to the scale of energies. From rest ω grows as √φ, and two thirds of
the mean are the end's. A step errs by Δφ·|dM/dω|/(J·ω), squared; from 2 on the speed swings to and fro.

A cycle is steady that ends with the speed with which it began; from any speed the run-up comes to that. How
even it is, δ = (ω_max − ω_min)/ω_m, hangs on the motor, too: a soft one gives way, a stiff one fights.

Draws: its characteristic, in the place ``motion_law``. Builds on no plan.

Sources: Kloss M., Drehmoment und Schlüpfung des Drehstrommotors (1909); Артоболевский И. И., Теория механизмов
и машин (исследование движения машинного агрегата).
"""

from __future__ import annotations

from graphic_tmm.chapters.motor.task import MOTOR, SECTIONS
from graphic_tmm.scene.chapter import Chapter

CHAPTER = Chapter(name=MOTOR, number=16, sections=SECTIONS)
