"""What a sheet shows of a cylinder: its indicator diagram."""

from __future__ import annotations

from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.indicator.ink import draw_indicator_ink
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.chapters.indicator.record import BESIDE
from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.views import captioned, mu_text
from graphic_tmm.scene.captions import captions


def indicator_views(drawn: Drawn, lettered: bool, by: str) -> list[Drawing]:
    """Return the indicator diagram, captioned, if it stands with the views of the chapter ``by``."""
    cylinder, language = INDICATOR_PLAN.of(drawn), drawn.scene.language
    if cylinder is None or cylinder.shown_by != by:
        return []
    title = captions(language)[VIEW]
    names = [escape(name) for name in drawn.names[: drawn.project.count]]
    axes = (on_axis("p", unit("Pa", language)), on_axis("S", unit("m", language)))
    sides = cylinder.indicator.sides
    means = {m: symbol(m.name, language) for m in (side.mean for side in sides) if m is not None}
    several = sides if len(sides) > 1 else ()
    curves = {side.curve: symbol(side.pressure.name, language) for side in several}
    high = heights(drawn.scene, by)
    view = draw_indicator_ink(
        drawn.construction,
        drawn.reading,
        cylinder.indicator,
        names,
        title,
        axes,
        means,
        high,
        curves,
    )
    scales = (drawn.scales[VIEW], _scale_of_stroke(drawn))
    told = ", ".join(mu_text(scale, language) for scale in scales)
    return [captioned(finished(view, lettered), title, told, heights=high)]


def _scale_of_stroke(drawn: Drawn) -> Scale:
    """Return the scale of the base."""
    mu = BESIDE.on(drawn).mu
    return Scale(mu.name, float(drawn.reading[mu][0, 0]), mu.unit)
