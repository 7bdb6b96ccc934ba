"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.names import DIAGRAMS
from graphic_tmm.fitting.sizes import GRAPH, GRAPHS, Sizing

SIZES = Sizing(sizes=(GRAPH,), depends={DIAGRAMS: lambda scene, view: (GRAPHS,)})
