"""Why the moment of inertia of a flywheel is found as it is: the arguments of the book."""

from __future__ import annotations

from graphic_tmm.language.said import said

STRAIGHT = said(
    "In steady motion the driving and the resisting forces do the same work in a turn, and the work of a "
    "constant moment grows evenly: a straight line between the ends of the other work."
)
STRAIGHT_AT = said(
    "The ordinate of the straight line in the same position is the work of the constant moment."
)
SURPLUS = said(
    "By how much the driving work is ahead of the resisting one is what the kinetic energy of the machine "
    "has gained: ΔT."
)
CONSTANT_RAY = said(
    "A ray with the slope of the straight line cuts off, on the axis of moments, the constant moment."
)
CONSTANT = said("The constant moment is read on the axis of moments, to the same scale.")
LEVEL = said(
    "From a pole on the level of the constant moment that moment has a level ray, so the rays to the other "
    "one have the slopes of ΔT."
)
OF_FLYWHEEL = said(
    "The gain ΔT is shared by links and flywheel: what the links do not have the flywheel has."
)
EXTREME_LEVEL = said("The level of this extreme is carried to the axis of ordinates.")
CD = said(
    "Between its least and its greatest the energy of the flywheel changes by cd: this is what it has to "
    "store."
)
LINKS_ENERGY = said("The kinetic energy of the links is the sum of the energies of all of them.")
MOMENTS_SUM = said("The powers of all loads add up, so their moments on the lever do.")
JT_POINT = said(
    "The point of a position has its reduced moment of inertia as abscissa and its ΔT as ordinate."
)
JT_CUT = said("Both tangents cut off on the axis of ΔT the segment by which the flywheel follows.")
