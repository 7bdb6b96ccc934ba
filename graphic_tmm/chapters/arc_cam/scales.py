"""How large a cam of arcs may be drawn, and how its μ_l was chosen."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, reach_of
from graphic_tmm.chapters.arc_cam.task import ARC_CAM
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice
from graphic_tmm.fitting.scales import ScaleFactor
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "arc_cam.mu_l" if "arc_cam.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(ARC_CAM, low=0.75, fixed=_fixed),),
    depends={"arc_cam": lambda scene, role: (ARC_CAM,)},
)


def factors(drawn: Drawn) -> Iterator[ScaleFactor]:
    """Yield μ_l: by how far the contour with its follower reaches."""
    made = ARC_CAM_PLAN.on(drawn)
    far, mu_l = reach_of(made.order), made.order.mu_l
    yield ScaleFactor(made.contour.mu, "r_{max}", far, fixed=mu_l, lengths=True)


CHOICE = Choice(factors)
