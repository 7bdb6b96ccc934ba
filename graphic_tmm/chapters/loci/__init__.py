"""All places of a plate on three legs (class III) in one position, and why there are so many.

One leg is loosened. On the two others the plate is the coupler of a four-bar (of a slider-crank where one of
them slides) and has one freedom: its first pin goes on the circle of its leg, the second follows by an arc of
the plate's length, the third by the plate's triangle. The third pin's locus is a coupler curve, of the sixth
degree. The leg that was loosened leaves that pin a circle, or a guide: the plate lies where both cross. A
circle meets the curve in twelve points at the most, of which six are at infinity, so there are up to six
places; a guide meets it in up to six.

The first pin is taken at 36 places, evenly all round, or, where it goes to and fro, the closer the nearer to
the ends, so that the curve of both sides is one and smooth; where it goes all round the two sides have a curve
each. From each crossing the plate is found back. The place of the mechanism itself is drawn heavy.

Beside it the place of the mechanism is laid by tracing paper on the same loci: how true both ways are, and what
they cost, `accuracy` tells.

Draws: place ``loci``, on a board of its own. Needs the plan of positions, of which it takes one position.

Sources: Артоболевский И. И., Теория механизмов и машин (планы положений групп III класса: ложные положения);
Ассур Л. В., Исследование плоских стержневых механизмов.
"""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.task import KINEMATICS
from graphic_tmm.chapters.loci.task import LOCI, SECTIONS
from graphic_tmm.scene.chapter import Chapter, Place

CHAPTER = Chapter(
    name=LOCI,
    number=26,
    board=LOCI,
    builds_on=(KINEMATICS,),
    places=(Place(LOCI, 26),),
    sections=SECTIONS,
)
