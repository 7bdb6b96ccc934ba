"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.gears.names import GEARS
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return next((key for key in ("gears.mu_l", "gears.a_w") if key in scene.told), "")


SIZES = Sizing(
    sizes=(Size(GEARS, small=0.75, cap=0.9, step=1.25, fixed=_fixed),),
    depends={"gears": lambda scene, view: (GEARS,)},
)
