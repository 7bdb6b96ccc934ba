"""What the section of an engine says besides its steps: the arguments of the book, in their order."""

from __future__ import annotations

from graphic_tmm.language.said import said

GAS = said(
    "The motion to and fro of the piston becomes an even turning of the shaft through the forces that the "
    "mechanism passes on; what drives it is the pressure on the piston."
)
BOTH_SIDES = said(
    "Its force is the difference of the forces on both sides, each the pressure from the indicator diagram "
    "times its area, formula (338); it is positive towards the crank."
)
TRANSFER, FIVE = said("Transfer of forces"), said("What acts on the machine")
PASSED = said(
    "In position {position} the force {force} acts along the cylinder on the crosshead. It slides between "
    "guides and is hinged to the rod, so that this force can go to the rod and to the guides only."
)
AT_B = said(
    "The rod, hinged at both ends, takes a force along itself only; the guide, without friction, presses "
    "square to itself. So P′ is resolved into Q along the rod and N square to the guide, the pressure on it. "
    "N = P′·tan β is nought where β is, and grows with λ = R/l, as β does."
)
AT_A = said(
    "Q may be carried along its line from B to A, to the crank pin. There it is resolved into T square to the"
    " crank, which turns it and is tangential to the circle of A, and K along the crank, which only stretches"
    " or presses it. The angle between rod and crank is φ + β, an outer angle of the triangle OAB."
)
AT_O = said(
    "At the bearing O two forces are added that balance one another, Q and −Q. −Q and the force Q on the "
    "crank pin are a couple with the arm h = R·sin(φ + β). The force Q that is left is resolved into P′ along"
    " the cylinder and −N across it; −N and N on the guide are a couple with the arm OB."
)
WITH_INERTIA = said("P′ is the force of the gas with that of the inertia, which is found below.")
ON_COVER = said("on the cylinder acts the pressure on its cover, −P = {force};")
ON_BEARING = said(
    "on the bearings of the shaft, along the cylinder, acts P′ = {force}, the force on the crosshead;"
)
TURNED = said("the crank is turned by the couple Q, −Q with Q = {force}: M = {moment};")
ON_GUIDE = said("on the guide acts the pressure N = {force};")
BACK = said("on the bearings, across the cylinder, acts −N, equal to it and opposite.")
FRAME = said(
    "P and −P are in balance where one frame joins cylinder and bearings; they do not reach the foundation "
    "then. N and −N are a couple with the arm OB = {arm} that tips the frame against the turning of the "
    "crank: M′ = −M. M is balanced by the moment of the machine that is driven, M′ by that of the base. All "
    "this holds for a level cylinder, an upright one and an inclined one."
)
INERTIA = said("Inertia of the moving parts")
METHOD = said(
    "The parts do not move evenly. In dynamics the acceleration of a mass centre is the sum of the forces "
    "divided by the mass, formula (345). The other way is that of kinetostatics: the parts are stopped in "
    "thought, and to the real forces is added {P_in} = −m·a, formula (346), so that their sum is nought, "
    "formula (347)."
)
TWO_MASSES = said(
    "The rod moves in both ways at once, so its mass is replaced by two: one on the crank pin, one on the "
    "crosshead. The big end is the heavier one: usually 0.67 … 0.75 of the mass belong to the crank pin."
)
BY_PLAN = said("By the plan of accelerations in position {position}:")
BY_SERIES = said(
    "By the book a = ω²·R·(cos φ + λ·cos 2φ) and {P_in} = −m·a, formula (349), which is the sum of two "
    "orders, formulas (350) and (351): projections of vectors that turn once and twice as fast as the crank, "
    "with periods of a turn and of half a turn. The minus holds as φ is counted from the dead centre at the "
    "cover."
)
USUAL = said("Here {share} of it is counted at the crosshead, as is usual.")
UNUSUAL = said(
    "Here {share} of it is counted at the crosshead, which is out of the usual 0.25 … 0.33."
)
WORKED = said("Inertia at the dead centres and at right angles")
RESULTING = said("Force on the crosshead with inertia; triangles of forces")
INSTEAD = said(
    "In formulas (339)–(344) P′ = P + {P_in} stands for P, formula (352); forces are positive towards the "
    "crank."
)
BASE_TAKES = said(
    "The cylinder carries −P, the bearings P′: the base takes the difference, the inertia force {force} in "
    "position {position}."
)
OVER_A_TURN = said("Forces over a turn")
GRAPHS = said("Forces over a turn of the crank: {letters}")
