"""What people call the construction of all places of a plate; why its steps are done."""

from __future__ import annotations

from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import Named

TITLE = said("Places of link {plate} in position {at}: the locus of {pin}")
CAPTIONS: dict[str, str] = {
    "chapter loci": said("Places of a plate on three legs"),
    LOCI: said("Places of a plate by a locus"),
    "loci-tracing": said("The same place by tracing paper"),
}

ON_CIRCLE = said("One leg is loosened: the pin goes round on the circle of its own leg.")
BY_ARCS = said(
    "The second pin is the plate's length from the first, and on what its own leg leaves it."
)
OF_TRIANGLE = said("The plate is rigid: its third pin stands on its triangle.")
LOCUS = said("On two legs the plate has one freedom: its third pin goes on this curve.")
BACK = said("The plate is rigid: from its third pin another is found on what its leg leaves it.")

WORDS = Named(captions=CAPTIONS, plans=(LOCI,), sources=("artobolevsky",))
