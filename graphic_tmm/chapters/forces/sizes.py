"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.fitting.sizes import GRAPH, GRAPHS, Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    order = ASKED.of(scene)
    return "forces.mu_F" if order is not None and order.mu is not None else ""


def _polygons(scene: Scene, view: str) -> tuple[str, ...]:
    if view.startswith("indicator"):
        return (GRAPHS,)
    return ("groups",) if view.startswith("group") else ("forces",)


SIZES = Sizing(
    sizes=(
        GRAPH,
        Size("forces", least=0.1, small=0.5, cap=0.42, fixed=_fixed),
        Size("groups", least=0.05, small=0.6, cap=0.42),
        Size("lever", least=0.05, small=0.6, cap=0.45),
    ),
    depends={"forces": _polygons, "lever": lambda scene, view: ("lever",)},
)
"""Of polygons, of detached groups, of the lever: shares of the usual room."""
