"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.engine.names import TRANSFER, TRANSFER_PLACE
from graphic_tmm.chapters.kinematics.names import POSITIONS
from graphic_tmm.fitting.sizes import GRAPH, GRAPHS, Size, Sizing
from graphic_tmm.scene.records import Scene


def _plan(scene: Scene, view: str) -> tuple[str, ...]:
    return (GRAPHS,) if view.startswith("indicator") else ("engine", POSITIONS)


SIZES = Sizing(
    sizes=(
        GRAPH,
        Size("engine", least=0.5, small=0.7, cap=0.4),
        Size(TRANSFER, least=0.5, small=0.7),
    ),
    depends={
        "engine": _plan,
        TRANSFER_PLACE: lambda scene, view: (TRANSFER, POSITIONS),
        "engine diagrams": lambda scene, view: (GRAPHS,),
    },
)
