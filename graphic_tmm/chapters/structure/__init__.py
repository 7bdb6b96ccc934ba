"""Structure: links, pairs, mobility by Chebyshev, the formula of structure by Assur groups.

W = 3n − 2p₅ − p₄; what is left when the driving link and the frame are taken off comes apart into groups of mobility 0,
the last one to be attached first: I(1) → II(2-3) → II(4-5).

Sources: Ассур Л. В.; Артоболевский И. И., Теория механизмов и машин, гл. 1–3.
"""

from __future__ import annotations

from graphic_tmm.chapter import Chapter, Made, Place
from graphic_tmm.chapters.structure.tables import structure_views
from graphic_tmm.mechanism.structure import Structure, dissect
from graphic_tmm.project import Bench

STRUCTURE: Made[Structure] = Made("structure")


def _record(bench: Bench) -> Structure:
    """Return the structure; it leaves no step."""
    assert bench.scene.mechanism is not None
    return dissect(bench.scene.mechanism)


CHAPTER = Chapter(
    name=STRUCTURE.chapter,
    number=1,
    places=(Place("structure", 90, structure_views, shows=()),),
    asked=lambda scene: scene.mechanism is not None,
    always=True,
    record=_record,
    facts=lambda drawn: {
        "W": STRUCTURE.on(drawn).mobility,
        "formula": STRUCTURE.on(drawn).formula,
    },
)
