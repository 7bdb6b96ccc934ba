"""How large a gear pair may be drawn; its μ_l, the scale of its sliding, and how they were chosen."""

from __future__ import annotations

from graphic_tmm.chapters.gears.plan import GEARS_PLAN, gear_scales
from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return next((key for key in ("gears.mu_l", "gears.a_w") if key in scene.told), "")


SIZES = Sizing(
    sizes=(Size(GEARS, small=0.75, cap=0.9, step=1.25, fixed=_fixed),),
    depends={"gears": lambda scene, role: (GEARS,)},
)


SCALES = ScaleFactors(
    scales=gear_scales,
    keys=lambda project: {"gear": "mu_l_gears", "sliding": "mu_theta"},
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how both scale factors were chosen: by the distance of the axes, by the largest sliding."""
    gear = GEARS_PLAN.on(drawn)
    line, chart = gear.line.mu, gear.sliding.chart
    ledger.of(line.view)
    axes = ledger.quantity("a_{w}", ledger.value_of(drawn, gear.sizes.a_w), "m")
    if gear.order.mu:
        ledger.given(line, gear.order.mu)
    elif gear.order.axes:
        ledger.by_length(line, axes, "[a_{w}]", gear.order.axes)
    else:
        ledger.fitting(line, axes, ledger.value_of(drawn, line), lengths=True)
    ledger.of(chart.view)
    if chart.wanted:
        ledger.given(chart.mu, chart.wanted)
        return
    most = ledger.quantity("ϑ_{max}", gear.sliding.floor, "")
    ledger.fitting(chart.mu, most, ledger.value_of(drawn, chart.mu))


CHOICE = Choice(choose)
