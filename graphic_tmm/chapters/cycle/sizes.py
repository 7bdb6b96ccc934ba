"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.cycle.names import CYCLE
from graphic_tmm.fitting.sizes import GRAPH, GRAPHS, Size, Sizing

SIZES = Sizing(
    sizes=(GRAPH, Size("cycle sketch", small=0.6, cap=0.4, step=1.6, seen=False)),
    depends={CYCLE: lambda scene, view: ("cycle sketch" if view == "flywheel" else GRAPHS,)},
)
