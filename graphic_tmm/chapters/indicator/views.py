"""What a sheet shows of a cylinder: its indicator diagram."""

from __future__ import annotations

from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.indicator.ink import draw_indicator_ink
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.chapters.indicator.record import BESIDE
from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import mu_text
from graphic_tmm.scene.captions import captions


def indicator_views(drawn: Drawn, lettered: bool, by: str) -> list[Drawing]:
    """Return the indicator diagram, captioned, if it stands with the views of the chapter ``by``."""
    cylinder, language = INDICATOR_PLAN.of(drawn), drawn.scene.language
    if cylinder is None or cylinder.shown_by != by:
        return []
    names = [escape(name) for name in drawn.names[: drawn.project.count]]
    axes = (on_axis("p", unit("Pa", language)), on_axis("S", unit("m", language)))
    sides = cylinder.indicator.sides
    means = {m: symbol(m.name, language) for m in (side.mean for side in sides) if m is not None}
    several = sides if len(sides) > 1 else ()
    curves = {side.curve: symbol(side.pressure.name, language) for side in several}
    on = subject(drawn, captions(language)[VIEW], by)
    view = draw_indicator_ink(on, cylinder.indicator, names, axes, means, curves)
    scales = (drawn.scales[VIEW], _scale_of_stroke(drawn))
    told = ", ".join(mu_text(scale, language) for scale in scales)
    return [with_caption(view, on, lettered, told)]


def _scale_of_stroke(drawn: Drawn) -> Scale:
    """Return the scale of the base."""
    mu = BESIDE.on(drawn).mu
    return Scale(mu.name, drawn.value(mu), mu.unit)
