"""How μ_F of the triangles, the rotating vectors and the figure of all forces were chosen, step by step."""

from __future__ import annotations

from graphic_tmm.chapters.engine.beside import BESIDE
from graphic_tmm.chapters.engine.names import ENGINE, HARMONICS, TRANSFER, VIEW
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how each scale factor was chosen: by the largest force."""
    made, known = ENGINE_PLAN.on(drawn), drawn.reach[ENGINE]
    marks = {VIEW: made.mu, HARMONICS: made.harmonics.mu, TRANSFER: BESIDE.on(drawn).transfer.mu}
    for view, mu in marks.items():
        ledger.of(view)
        most = ledger.quantity("F_{max}", known[view], mu.unit.removesuffix("/mm"))
        ledger.fitting(mu, most, ledger.value_of(drawn, mu))


CHOICE = Choice(choose)
