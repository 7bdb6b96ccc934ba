"""How large what the chapter draws may be."""

from __future__ import annotations

from graphic_tmm.chapters.cam.names import CAM, GRAPHS
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene

FIGURES = ("cam profile", "cam scheme", "cam centre", "profile", "centre")
"""What is drawn of a cam besides graphs."""
CAPS = {"cam.mu_l": 0.6, "cam.base": 0.94}
"""What share of a sheet's height what a key sizes may take."""


def _depends(scene: Scene, view: str) -> tuple[str, ...]:
    return (CAM,) if view.startswith(FIGURES) else (GRAPHS,)


def _size(name: str, key: str) -> Size:
    return Size(
        name,
        small=0.75,
        cap=CAPS[key],
        step=1.25,
        fixed=lambda scene: key if key in scene.told else "",
    )


SIZES = Sizing(
    sizes=(_size(CAM, "cam.mu_l"), _size(GRAPHS, "cam.base")),
    depends={"cam": _depends, "cam scheme": _depends},
)
