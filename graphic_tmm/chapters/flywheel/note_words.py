"""What the section of a flywheel says besides its steps: why it is found as it is, step after step."""

from __future__ import annotations

from graphic_tmm.language.said import said

AIM = said(
    "The moment of inertia of the flywheel is sought at which the coefficient of irregularity is δ = {delta}."
)
AIM_J = said(
    "The flywheel has the moment of inertia J = {J}; the coefficient of irregularity that it keeps is sought."
)
BY_GAS = said(
    "The force of the gas is reduced to the crank pin by its power, and the reduced moment is that force on "
    "the arm of the crank: M = P·({ratio})·l with P = p·F. The velocities are those of the plans: v = "
    "[pb]·{mu}."
)
BY_LOADS = said(
    "The loads of the links are reduced to the crank by their powers: their moment on the lever is a power, to "
    "scale. Inertia forces are none of them: they belong to the kinetic energies of the links."
)
READ = said("Read off the plans and the indicator diagram")
SIGNS = said(
    "In positions {drives} the moment drives and stands above the axis, in positions {resists} it resists and "
    "stands below."
)
CYCLE = said(
    "The working cycle takes {turns} turns of the crank, so the base of the graphs stands for all of them; in"
    " later turns the mechanism stands as in the first one, but the gas is another."
)
STEADY = said(
    "In a cycle of steady motion both works are equal at its end. The {constant} moment is constant, so its "
    "work is the straight line from the beginning to the end of the other."
)
DRIVING, RESISTING = said("driving", context="moment"), said("resisting", context="moment")
SAME = said(
    "ΔT, the energy of the links and that of the flywheel stand on the same axes, to the same scale as the "
    "works."
)
ALONE = said("There are no links that have energies, so ΔT is the energy of the flywheel alone.")
RIM = said("The rim of the flywheel")
LIMIT = said(
    "A rim of this material may run at {speed} at most, so its outer diameter is {most} at most. For "
    "constructive reasons it is made {outer}."
)
MADE = said(
    "Made in whole millimetres the rim has other sizes than those calculated; what it does then:"
)
POWER = said("Mean moment, power, excess work")
SECOND = said("Mean moment, power, excess work; the two methods")
