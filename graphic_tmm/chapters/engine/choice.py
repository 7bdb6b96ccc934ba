"""How μ_F of the force triangles and of the rotating vectors were chosen, step by step."""

from __future__ import annotations

from graphic_tmm.chapters.engine.harmonics import VIEW as HARMONICS
from graphic_tmm.chapters.engine.plan import ENGINE, VIEW
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Ledger


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how both scale factors were chosen: by the largest force."""
    made, known = ENGINE.on(drawn), drawn.reach[ENGINE.chapter]
    for view, mu in ((VIEW, made.mu), (HARMONICS, made.harmonics.mu)):
        ledger.of(view)
        most = ledger.quantity("F_{max}", known[view], mu.unit.removesuffix("/mm"))
        ledger.fitting(mu, most, ledger.value_of(drawn, mu))
