"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.names import ARC_CAM
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "arc_cam.mu_l" if "arc_cam.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(ARC_CAM, small=0.75, cap=0.6, step=1.25, fixed=_fixed),),
    depends={"arc_cam": lambda scene, view: (ARC_CAM,)},
)
