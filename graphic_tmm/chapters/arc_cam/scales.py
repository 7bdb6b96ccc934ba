"""How large a cam of arcs may be drawn, and how its μ_l was chosen."""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, reach_of
from graphic_tmm.chapters.arc_cam.task import ARC_CAM
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "arc_cam.mu_l" if "arc_cam.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(ARC_CAM, small=0.75, cap=0.6, step=1.25, fixed=_fixed),),
    depends={"arc_cam": lambda scene, role: (ARC_CAM,)},
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record the choice: by how far the contour with its follower reaches."""
    made = ARC_CAM_PLAN.on(drawn)
    mu = made.contour.mu
    ledger.of(mu.view)
    if made.order.mu_l:
        ledger.given(mu, made.order.mu_l)
        return
    most = ledger.quantity("r_{max}", reach_of(made.order), "m")
    ledger.fitting(mu, most, ledger.value_of(drawn, mu), lengths=True)


CHOICE = Choice(choose)
