"""The results of a synthesis, measured and calculated; its plan in protocols."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.linkage_synthesis.plan import SYNTHESIS_PLAN
from graphic_tmm.chapters.linkage_synthesis.record import CALCULATED
from graphic_tmm.chapters.linkage_synthesis.task import SYNTHESIS
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.chapter import Holder


def marks(holder: Holder) -> dict[str, Mark]:
    """Return what results are, by name: each length as measured and as calculated, angles of transmission."""
    made, calculated = SYNTHESIS_PLAN.of(holder), CALCULATED.of(holder) or {}
    if made is None:
        return {}
    found = {}
    for name, mark in calculated.items():
        if name in made.measured:
            found[f"synthesis_{name}"] = made.measured[name]
        found[f"synthesis_{name}_calculated"] = mark
    for k, angle in enumerate(made.transmission, 1):
        found[f"synthesis_transmission_{k}"] = angle
    return found


def results(drawn: Drawn) -> Results:
    """Return the lengths found, m, and the angles of transmission, degrees."""
    return {
        name: (drawn.reading.figure(mark)[:, 0].copy(), mark.unit)
        for name, mark in marks(drawn).items()
    }


TABLE = Tabled(results=results, marks=marks)
PROTOCOL = Protocols(views=lambda project: {SYNTHESIS: (SYNTHESIS,)})
