"""What a sheet shows of a cylinder: its indicator diagram."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.indicator.diagram import NAMES
from graphic_tmm.chapters.indicator.ink import draw_indicator_ink
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN, Cylinder
from graphic_tmm.chapters.indicator.record import BESIDE
from graphic_tmm.chapters.indicator.stretches import indexed
from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.chapters.indicator.words import called
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import mu_text
from graphic_tmm.scene.captions import captions


def indicator_views(drawn: Drawn, lettered: bool, by: str) -> list[Drawing]:
    """Return the indicator diagram, captioned, if it stands with the views of the chapter ``by``."""
    cylinder = INDICATOR_PLAN.of(drawn)
    if cylinder is None or cylinder.shown_by != by:
        return []
    scales = BESIDE.on(drawn).scales
    return [
        _view(drawn, some, mu, lettered, by)
        for some, mu in zip(cylinder.diagrams, scales, strict=True)
    ]


def _view(drawn: Drawn, some: Sequence[Cylinder], mu: Mark, lettered: bool, by: str) -> Drawing:
    """Return the diagram of some cylinders; ``mu``: the scale of its base."""
    language, indicator = drawn.scene.language, some[0].indicator
    names = [escape(name) for name in drawn.names[: drawn.project.count]]
    axes = (on_axis("p", unit("Pa", language)), on_axis("S", unit("m", language)))
    sides = indicator.sides
    means = {m: symbol(m.name, language) for m in (side.mean for side in sides) if m is not None}
    several = sides if len(sides) > 1 else ()
    pistons = {one.tag: one.indicator for one in some} if len(some) > 1 else {"": indicator}
    sign = indicator.tag.replace(" ", "") if len(some) > 1 else some[0].tag
    curves = {
        side.curve: symbol(indexed("p", NAMES[side.name] + sign), language) for side in several
    }
    name = indicator.chart.view
    title = called(name, speaking(language)) or captions(language)[VIEW]
    on = subject(drawn, title, by, name="-".join((VIEW, *indicator.tag.split())))
    view = draw_indicator_ink(on, pistons, names, axes, means, curves)
    scales = (drawn.scales[name], Scale(mu.name, drawn.value(mu), mu.unit))
    told = ", ".join(mu_text(scale, language) for scale in scales)
    return with_caption(view, on, lettered, told)
