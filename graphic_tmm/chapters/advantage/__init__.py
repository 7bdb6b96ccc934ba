"""Forces by instantaneous centres: what balances the drive, and the mechanical advantage.

At each moment a link turns about its centre P_i0, so the power of a force on it is F·h·ω_i, where h is the arm
of the force about P_i0, measured on the scheme of centres; that of a couple is M·ω_i. Powers come to 0: of a
crank M_b = −Σ F·h·μ_l·ω_i/ω_1 − Σ M·ω_i/ω_1, where ω_i/ω_1 = P_1i P_10/(P_1i P_i0) was found by the centres.
Inertia forces and couples, weights, springs, friction of the last pass count alike: all that stands on the
lever of Zhukovsky. A crank whose balancing force is wanted has it at its pin, square to it; a slider or a rod
that drives has its force by ω_i/v_1 in 1/m. A link whose P_i0 lies at infinity translates: its points move as
the common centre with a link that turns, P_1i, so the force is carried there, parallel, and turns that link.

The mechanical advantage of an external load is that of the books: output force over input force, without losses
(ω_in·r_in)/(ω_out·r_out); r_in is the crank, r_out the arm h of the force about its centre. Of a moment it is
ω_in/ω_out. Each load has its own, as if it acted alone; where a force is sought at a tool, it is that force's.

Nothing of this knows of the plans of forces and the lever, so both are held against it. Where P_i0 is not
there (parallel lines of centres), or the load does not move (a dead place), there is no figure, and a finding
says so.

Draws: place ``advantage``, behind the centres: the forces in the scheme of centres with their arms, tables.
Builds on centres and on forces, and is there where a scene calls for both.

Sources: Norton R. L., Design of Machinery (mechanical advantage; using instant centers to calculate it);
Khurmi R. S., Gupta J. K., Theory of Machines; Артоболевский И. И., Теория механизмов и машин.
"""

from __future__ import annotations

from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=ADVANTAGE,
    number=25,
    builds_on=(CENTRES, FORCES),
    places=(Place(ADVANTAGE, attends=CENTRES),),
    always=True,
)
