"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.flywheel.names import FLYWHEEL
from graphic_tmm.fitting.sizes import GRAPH, GRAPHS, Size, Sizing

SIZES = Sizing(
    sizes=(GRAPH, Size("sketch", small=0.6, cap=0.4, step=1.6, seen=False)),
    depends={FLYWHEEL: lambda scene, view: ("sketch" if view == FLYWHEEL else GRAPHS,)},
)
