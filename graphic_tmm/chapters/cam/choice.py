"""How the scale factors of a cam that are no diagram's were chosen, step by step."""

from __future__ import annotations

from graphic_tmm.chapters.cam.plan import CAM
from graphic_tmm.chapters.cam.task import ASKED
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Ledger
from graphic_tmm.language.said import said

_HANDY = said("A millimetre for a degree: the angle is read off the ruler as it is.")


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how the scale factors of dS/dφ, of the centre with the profile, of the pressure angle came."""
    cam, order = CAM.on(drawn), ASKED.of(drawn.scene)
    for chart in cam.charts:
        if chart.unit == "°" and chart.wanted:
            ledger.of(chart.view)
            ledger.told(chart.mu, chart.wanted, why=_HANDY)
    if order is not None and order.mu_V:
        ledger.of(cam.diagrams.V.chart.view)
        ledger.told(cam.diagrams.V.chart.mu, order.mu_V)
    mu = cam.profile.mu
    if mu not in drawn.given or order is None:
        return
    ledger.of(cam.profile.view)
    if order.mu_l:
        ledger.told(mu, order.mu_l)
        return
    radius, stroke = (ledger.value_of(drawn, mark) for mark in (cam.r0, cam.diagrams.stroke))
    most = ledger.quantity("r_{max}", radius + stroke, "m")
    ledger.fitting(mu, most, ledger.value_of(drawn, mu), lengths=True)
