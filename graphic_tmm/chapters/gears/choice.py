"""How μ_l of a gear pair and the scale of its sliding were chosen, step by step."""

from __future__ import annotations

from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how both scale factors were chosen: by the distance of the axes, by the largest sliding."""
    gear = GEARS_PLAN.on(drawn)
    line, chart = gear.line.mu, gear.sliding.chart
    ledger.of(line.view)
    axes = ledger.quantity("a_{w}", ledger.value_of(drawn, gear.sizes.a_w), "m")
    if gear.order.mu:
        ledger.told(line, gear.order.mu)
    elif gear.order.axes:
        ledger.by_length(line, axes, "[a_{w}]", gear.order.axes)
    else:
        ledger.fitting(line, axes, ledger.value_of(drawn, line), lengths=True)
    ledger.of(chart.view)
    if chart.wanted:
        ledger.told(chart.mu, chart.wanted)
        return
    most = ledger.quantity("ϑ_{max}", gear.sliding.floor, "")
    ledger.fitting(chart.mu, most, ledger.value_of(drawn, chart.mu))


CHOICE = Choice(choose)
