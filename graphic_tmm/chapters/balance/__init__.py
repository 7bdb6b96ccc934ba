"""Balance of a mechanism: the force with which it shakes its frame, without and with counterweights.

The frame bears what all links press on their pairs with it. The part of this that motion alone causes is the
sum of the inertia forces of all links, −Σ m·a_S, for inside the mechanism action and reaction cancel: the
shaking force Φ. Its vectors are those of the plans of accelerations, reversed; in each position they are laid
off one after another from a pole, and the line from the pole to the end of the polygon is Φ there. The ends of
all positions joined by a curve are the polar diagram (the hodograph) of Φ over the turn: it shows at once how
far, and which way, the frame is shaken. Its moment about a point of the frame is the sum of the moments of the
inertia forces, measured by their arms on the plan of positions, and of the couples −J·ε.

Where the centre of all masses stands still Φ is nothing in every position, and the polar diagram shrinks to a
point. A counterweight adds to the mass of a link: where it stands on the plan of positions follows from its
radius and its angle to the link, its acceleration from similarity on the plan of accelerations. Its force is
laid on behind those of the links, so that one polygon tells Φ without and with counterweights. Their weight
on the frame is no part of Φ; a mechanism whose Φ is nothing shakes by its moment still.

Counterweights are found by replacing masses. The mass m of a coupler AB is put into its pins, m·BS/AB at A and
m·AS/AB at B: sum and common centre stay, so the inertia forces do. Off the line AB the same lengths hold, and
the static moments of both are turned by the angles at A and B. A link that turns about a pin of the frame then
bears only masses whose static moments, m·r, turn with it: laid off one after another they are a polygon, whose
closing side is the static moment of the counterweight, m_c·r_c, and shows where it stands. On crank and rocker
of a four-bar that balances all. A slider's mass is drawn to the crank's pin by a counterweight on the rod, and
from there to the pivot by one on the crank. Of a partial balance the crank's counterweight answers what is put
into its pin and a share k of what slides: along the guide (1 − k) of that stays, across it k comes in.

Draws: place ``balance``: polygons of static moments, the polar diagram, the graph of the moment, the mechanism
with its counterweights, tables. Builds on kinematics (plans of positions and accelerations), on forces (inertia
forces, the polygon) and on rotors (polygons of static moments).

Sources: Артоболевский И. И., Теория механизмов и машин (уравновешивание масс звеньев на фундаменте);
Попов С. А., Тимофеев Г. А., Курсовое проектирование (главный вектор и главный момент сил инерции).
"""

from __future__ import annotations

from graphic_tmm.chapters.balance.task import BALANCE, SECTIONS
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, KINEMATICS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=BALANCE,
    number=18,
    drive="crank",
    builds_on=(KINEMATICS, FORCES, "rotors"),
    places=(Place(BALANCE, 66, beside=(ACCELERATIONS,)),),
    sections=SECTIONS,
)
