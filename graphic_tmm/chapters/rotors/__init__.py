"""Balance of a rotor: counterweights for masses off the axis, at rest in one plane, in motion in two.

Each mass off the axis pulls outward with m·r·ω². All turn together, so ω² is left out: what is laid off is the
unbalance D = m·r, at the angle of its mass. The axis is free of a force where the polygon of D closes; the side
that is missing is the counterweight's, D_k = m_k·r_k, and its angle is read off the sheet: r_k given, m_k
follows, and the other way round. That is balance at rest, in one plane.

Forces in several planes make a couple besides. Moments D·z are taken about plane I, where its counterweight has
none: their polygon (each drawn along its own radius, as is usual, not square to it) is closed by D_II·z_II
alone. With D_II known, the polygon of D is closed by D_I. A mass left of plane I has z negative, its side is
laid off backward. Planes that coincide have no distance, and are refused.

The bearings hold the unbalanced rotor as counterweights in their planes would: the same two polygons, about
bearing A, give D_B and D_A; times ω² these are the reactions, which turn with the rotor.

A polygon that closes by itself wants no counterweight: that is told, no angle is read off.

Draws: place ``rotor``: the rotor from the side and along its axis, its polygons, its table; on a board of its
own. Builds on no chapter.

Sources: Артоболевский И. И., Теория механизмов и машин (уравновешивание вращающихся масс); Фролов К. В. (ред.),
Теория механизмов и машин; Rattan S. S., Theory of Machines (balancing of several masses in different planes).
"""

from __future__ import annotations

from graphic_tmm.chapters.rotors.task import ROTOR, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name="rotors",
    number=17,
    board=ROTOR,
    places=(Place(ROTOR, 130), Place(f"{ROTOR} given", attends=ROTOR)),
    sections=SECTIONS,
)
