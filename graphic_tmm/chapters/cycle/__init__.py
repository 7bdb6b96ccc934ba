"""A cycle of moments: the flywheel of a machine of which nothing is known but its moment over the turns.

A four-stroke engine repeats after two turns, a press or a pump may after three: the base of the graphs stands
for the whole cycle, 2π rad for each turn. The moments are given as they are read off a diagram, over the angle
of the shaft; they add up, and the other side is constant over the cycle. Integration, the segment cd and J =
cd·μ_T/(δ·ω²), or δ of a given J, are those of the chapter of the flywheel. There are no links and hence no
masses: ΔT is the energy of the flywheel alone.

Between positions the moment runs as the curve through its ordinates does; at a jump the ordinate is the mean
of both sides, so that the area is kept where jumps stand at positions.

Draws: place ``cycle`` (moment, works, energy, sketch, tables), on a board of its own. Uses the graphs, the rim
and the tables of the flywheel.

Sources: Артоболевский И. И., Теория механизмов и машин (неравномерность движения).
"""

from __future__ import annotations

from graphic_tmm.chapters.cycle.task import CYCLE, SECTIONS
from graphic_tmm.chapters.flywheel.task import FLYWHEEL
from graphic_tmm.scene.chapter import Chapter, Place

_NAME = CYCLE
CHAPTER = Chapter(
    name=_NAME,
    number=12,
    board=_NAME,
    builds_on=(FLYWHEEL,),
    places=(Place(_NAME, 55), Place(f"{_NAME} given", attends=_NAME)),
    sections=SECTIONS,
)
