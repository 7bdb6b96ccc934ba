"""How large a gear pair may be drawn; its μ_l, the scale of its sliding, and how they were chosen."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.plan import GEARS_PLAN, gear_scales
from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, value_of
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return next((key for key in ("gears.mu_l", "gears.a_w") if key in scene.told), "")


SIZES = Sizing(
    sizes=(Size(GEARS, low=0.75, fixed=_fixed),),
    depends={"gears": lambda scene, role: (GEARS,)},
)


SCALES = ScaleFactors(
    scales=gear_scales,
    keys=lambda project: {"gear": "mu_l_gears", "sliding": "mu_theta"},
)


def factors(drawn: Drawn) -> Iterator[ScaleFactor]:
    """Yield both scale factors: by the distance of the axes, by the largest sliding."""
    gear = GEARS_PLAN.on(drawn)
    order, chart, axes = gear.order, gear.sliding.chart, value_of(drawn, gear.sizes.a_w)
    wanted = (f"[{gear.sizes.a_w.letter}]", order.axes)
    yield ScaleFactor(
        gear.line.mu, gear.sizes.a_w.letter, axes, fixed=order.mu, length=wanted, lengths=True
    )
    yield ScaleFactor(chart.mu, "ϑ_{max}", gear.sliding.floor, fixed=chart.wanted)


CHOICE = Choice(factors)
