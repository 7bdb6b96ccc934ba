"""The inertia of several cylinders: forces and moments of the first and the second order, and what remains.

A piston with its share of the rod is driven to and fro with m·r·ω²·(cos φ + λ·cos 2φ), λ = r/l; φ is the
crank's angle from the cylinder's axis, further orders are small. Each part is the shadow, on that axis, of a
vector that turns: m·r·ω² with the crank, λ·m·r·ω² twice as fast. Vectors of all cylinders in line are laid off
at their cranks' angles, of the second order at twice these, measured from the axis; what goes from the first
vertex to the last turns as they do, and its shadow is what shakes the engine. Times the place along the shaft,
from its middle, they are moments; a negative one is laid off backward.

Cylinders that stand in two banks have axes of their own. A shadow on an axis is two vectors of half the size
that turn opposite ways and meet on it: the direct one, at the crank's angle, and the reverse one, its mirror
image in the axis (ψ): θ and 2ψ − θ, of the second order 2θ − ψ and 3ψ − 2θ. Direct and reverse ones have a
polygon each. What remains of both adds up where they meet and is their difference a quarter of their turn
later. Where only the direct one remains the force keeps its size and turns with the shaft, and counterweights
on it can take it away.

An order of even firing gives the cranks: the cylinder that fires as the j-th has its crank j intervals before
its axis. What is nothing is told as 0, to the size that half a division of the ruler stands for. The rotating
part of each crank is balanced by itself, or is a rotor.

Draws: place ``cylinders``: the crankshaft from both sides, its polygons, the table by cranks, what remains; on
a board of its own. Uses the polygons of the chapter of rotors.

Sources: Артоболевский И. И., Теория механизмов и машин (уравновешивание многоцилиндровых двигателей); Rattan
S. S., Theory of Machines (in-line, V and radial engines, direct and reverse cranks); Bevan T., The Theory of
Machines.
"""

from __future__ import annotations

from graphic_tmm.chapters.cylinders.task import CYLINDERS, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=CYLINDERS,
    number=19,
    board=CYLINDERS,
    builds_on=("rotors",),
    places=(Place(CYLINDERS, 132), Place(f"{CYLINDERS} given", attends=CYLINDERS)),
    sections=SECTIONS,
)
