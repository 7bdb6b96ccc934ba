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
