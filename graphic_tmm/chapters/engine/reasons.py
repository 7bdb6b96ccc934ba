"""Why the forces of an engine are resolved as they are: the arguments of the book."""

from __future__ import annotations

from graphic_tmm.language.said import said

P_LINE = said("P′ acts on the crosshead along the cylinder.")
N_LINE = said(
    "Without friction the guide can only press square to itself: this is the direction of N."
)
Q_LINE = said(
    "The rod is hinged at both ends and without load between them: it takes a force only along itself."
)
P_RESOLVED = said(
    "P′ is resolved into Q along the rod and N square to the guide: the triangle closes here."
)
FORCE_READ = said("The side of the triangle, times the scale factor, is the force.")
Q_CARRIED = said(
    "A force may be carried along its line: Q acts on the crank pin as it acts at the crosshead."
)
T_LINE = said("T, square to the crank, is the part of Q that turns it.")
K_LINE = said("K, along the crank, only stretches or presses it.")
Q_RESOLVED = said(
    "Q is resolved into T square to the crank and K along it: the triangle closes here."
)
DISTANCE = said(
    "N on the guide and the equal force on the bearing of the shaft are this far apart."
)
TOGETHER = said(
    "The force along the cylinder is that of the gas and that of the inertia, with their signs."
)
AXIS = said("The inertia force acts along the cylinder: on this line the vectors are projected.")
ONCE = said("The vector of the first order turns with the crank.")
PROJECTED = said("The projection of the turning vector changes as the cosine of its angle.")
BOTH_ORDERS = said("Both orders together are the inertia force, but for what is smaller than λ².")

PISTON = said(
    "The piston stands on its rod, which carries the force of the gas to the crosshead; how long it is drawn "
    "does not matter, for a force may be carried along its line."
)
COVER = said("The cover stands still, off the piston at its dead centre.")
GAS = said("The gas presses on the piston: P is the difference of both sides.")
COVER_LOAD = said(
    "The gas presses on the cover as much as on the piston: −P acts on the cylinder, and both close in a frame "
    "of one piece."
)
BY_PARALLELS = said(
    "The parts of a force are the sides of the parallelogram whose diagonal it is: they are cut off by "
    "parallels through its end."
)
TWO_ADDED = said(
    "Two equal and opposite forces in one point change nothing: Q and −Q are added at the bearing. −Q with Q "
    "on the crank pin is a couple, Q is left."
)
ALONG_CYLINDER = said(
    "What is left at the bearing is resolved: along the cylinder it is P′, as the rod makes the angle β with "
    "the guide."
)
ACROSS_CYLINDER = said(
    "Across the cylinder it is equal to the pressure on the guide and against it, hence −N: with N it is a "
    "couple."
)
ARM_OF_Q = said(
    "The arm of a couple is the distance between the lines of its forces, here R·sin(φ + β)."
)
