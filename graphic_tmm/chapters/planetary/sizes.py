"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.planetary.names import PLANETARY_TRAIN
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "planetary.mu_l" if "planetary.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(PLANETARY_TRAIN, small=0.75, cap=0.65, step=1.25, fixed=_fixed),),
    depends={"planetary": lambda scene, view: (PLANETARY_TRAIN,)},
)
