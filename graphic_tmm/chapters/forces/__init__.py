"""Kinetostatics: loads and inertia, groups in reverse order, the balancing force; Zhukovsky's lever.

By d'Alembert the moving mechanism is in equilibrium once inertia is added to the loads: −m·a_S at the mass
centre and the couple −J·ε. Groups are taken in the reverse of the order of attachment, for only the last
one carries nothing but its own loads: 3n = 2p₅ makes each statically determinate.

A dyad is two legs here too (`statics`). A leg that turns: the moments of its link about the closing point
give the part of the outer reaction square to the leg, R^t = ΣM/l; the rest of it lies along the leg. A leg
that slides: the reaction is square to the guide. So the polygon (known part of one reaction, loads of both
links, known part of the other) lacks two vectors of known directions, and closes where their lines meet.
The reaction in the inner pair runs from there to between the loads of the two links. Where the inner pair
slides it is square to that guide, and the line for it is drawn through the corner between the loads of both
links. The driving link is left with the reaction of the first group and the balancing force at the crank
pin, or a balancing moment.

A plate on three legs (class III, `special`) has three such legs. Where the lines of what holds two of them
cross, in Assur's special point, neither has a moment; so moments of the whole group about it, the known
parts of the reactions among them, give what holds the third leg along its line. Then the polygon lacks two
vectors again, and closes. Each leg stands in it between what holds it and its loads: the side from there to
there is what it does to the plate. The line of a leg that slides is square to its guide; what turns it about
its pin the guide holds by a couple. A leg that slides along the plate does to it a force square to the guide,
with a couple that its own moments about its pivot give; in the polygon its loads and what holds it add up to
that force.

Two plates that two links join (class IV, `special`) are solved like the two legs of a dyad. Moments of each
of the links give what holds it across; what it bears along its line passes through the point where the lines
of both cross, so about that point each plate is balanced as a leg is about its inner pin: the first one by
itself, the second one with both links. The polygon of the group closes as that of a dyad. The sides of the
first plate are a polygon too: in it the two links act on it with what they bear across, which is known, and
along their lines, which meet in the last vertex.

Where the loads are given, that of the drive among them, and a force at a tool is sought, the lever comes
first: its moment is that of all loads, reversed, and its arm the velocity of its point along it, so that one
division gives it; as the arm of the crank pin is to its arm, so it is to the force there (mechanical
advantage). Then groups are solved with it as a load. What they leave at the drive, as a share of what the
loads are there, shows whether both methods agree.

A load may keep the direction of a link (drawn from the plan of positions), and come from another link, where
the opposite acts. A spring pulls by its length as measured on that plan, a damper by the rate of that length
on the plan of velocities.

Friction is taken from the reactions of the pass before: on guides the reaction leans by the angle of
friction, pins get the couple ρ·R (circle of friction); what further passes can change is a step of the log.

Zhukovsky: the powers of all forces, inertia included, sum to 0: Σ P·v·cos = 0. On the velocity plan turned
by 90° the arm of a force about the pole, when it is applied at the image of its point, is v·cos to the
scale; so the same sum is the sum of moments of the plan as a rigid lever about its pole. A couple on a link
becomes M·ab/l. It gives the balancing force once more by one equation without reactions: both must agree
(usually within 5 % by hand). Each of several drives has a lever of its own, the plan of velocities as it alone
causes them: the powers of what holds the others are 0 there.

Results have their signs, on sheets as in tables and notes: a couple, and what balances a crank, is positive
counter-clockwise, the force that drives a rod where it pushes it out, that on a slider along its guide. In a
sum of moments only what is sought has a sign of its own; all else stands by its size, with the sign of the
sense in which it is drawn.

Draws: places ``forces`` (groups detached with their polygons and equations, the driving link), ``lever``,
``force table``, ``load diagram``. Builds on kinematics; on diagrams (loads by the travel of a slider); on
indicator (gas on a piston).

Sources: Артоболевский И. И., Теория механизмов и машин (кинетостатический анализ; теорема Жуковского о
жёстком рычаге); Попов С. А., Тимофеев Г. А., Курсовое проектирование; the course project of the windrower
(scene ``windrower``), and of the lever of a six-link mechanism.
"""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.task import DIAGRAMS
from graphic_tmm.chapters.forces.sections import SECTIONS
from graphic_tmm.chapters.forces.task import FORCES, LOADS
from graphic_tmm.chapters.indicator.task import INDICATOR
from graphic_tmm.chapters.kinematics.task import KINEMATICS, POSITIONS
from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

_TABLE = said("Reactions and balancing forces are set in a table.")

CHAPTER = Chapter(
    name=FORCES,
    number=6,
    builds_on=(KINEMATICS, DIAGRAMS, INDICATOR),
    places=(
        Place("forces", 60),
        Place("lever", 61),
        Place("force table", 62, asks=(_TABLE,)),
        Place(LOADS, attends=POSITIONS),
    ),
    sections=SECTIONS,
)
