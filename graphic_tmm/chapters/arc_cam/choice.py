"""How μ_l of a cam given by arcs was chosen; the scales of its diagrams are told as those of other graphs."""

from __future__ import annotations

from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, reach_of
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record the choice: by how far the contour with its follower reaches."""
    made = ARC_CAM_PLAN.on(drawn)
    mu = made.contour.mu
    ledger.of(mu.view)
    if made.order.mu_l:
        ledger.told(mu, made.order.mu_l)
        return
    most = ledger.quantity("r_{max}", reach_of(made.order), "m")
    ledger.fitting(mu, most, ledger.value_of(drawn, mu), lengths=True)


CHOICE = Choice(choose)
