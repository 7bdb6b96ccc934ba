"""The forces of an engine's crank mechanism, position by position: from the gas to the turning moment.

The rod's mass is shared between its two pins by the lever rule (or a given share), so that the rod carries
force along itself only: what is at the crosshead goes to and fro, what is at the crank pin turns with it
and has no moment about O. Its moment of inertia is not kept by that; how much is missed is told.

At B: the gas P = p_k·F_k − p_v·F_v and the inertia P_in = −m·a_B make P′ = P + P_in. The crosshead is in
equilibrium under P′, the force Q along the rod and the pressure N of the guide, so P′ resolves into N =
P′·tan β and Q = P′/cos β: a right triangle. Q, carried along the rod to A, resolves again, along the
tangent of the crank circle and along the crank: T = Q·sin(φ + β), K = Q·cos(φ + β). M = T·R turns the
crank; N on the arm OB is the couple that tips the frame, opposite to M. Forces are positive towards the
crank.

The two-term series: a = ω²·R·(cos φ + λ·cos 2φ) with λ = R/l. Its terms are the projections of a vector
m·ω²·R that turns with the crank and of m·ω²·R·λ that turns twice as fast (first and second order); the
exact acceleration off the plan has more terms, and both stand side by side. A task in kgf is drawn and
tabulated in kgf, with SI beside it.

Draws: places ``engine`` (indicator diagram, force triangles, rotating vectors) and ``engine diagrams`` (P,
N, Q, T, K, M over the turn). Builds on kinematics and indicator; on forces for how vectors of force are
inked and what is told of a moment's accuracy.

Sources: the book chapter on the forces in the crank mechanism of a steam engine, formulas (338)–(344) and
(349)–(352), with the locomobile P-25 (scene ``locomobile``); Артоболевский И. И., Теория механизмов и машин
(кинетостатика).
"""

from __future__ import annotations

from graphic_tmm.chapters.engine.task import ENGINE, SECTIONS, TRANSFER_PLACE
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.chapters.indicator.task import INDICATOR
from graphic_tmm.chapters.kinematics.task import KINEMATICS
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_PLAN = said(
    "The indicator diagram is drawn; the forces of the gas and of inertia on the piston are "
    "resolved into the pressure on the guide N, the force along the rod Q, the tangential force T "
    "and the radial force K in every position."
)
_TRANSFER = said("The transfer of forces in the crank mechanism is shown in one position.")
_DIAGRAMS = said(
    "Diagrams of the forces and of the turning moment over a turn of the crank are drawn."
)

CHAPTER = Chapter(
    name=ENGINE,
    number=7,
    drive="crank",
    builds_on=(KINEMATICS, INDICATOR, FORCES),
    places=(
        Place("engine", 70, asks=(_PLAN,)),
        Place(TRANSFER_PLACE, asks=(_TRANSFER,)),
        Place("engine diagrams", 71, asks=(_DIAGRAMS,)),
    ),
    sections=SECTIONS,
)
