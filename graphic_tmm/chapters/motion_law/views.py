"""What a sheet shows of a law of motion: its graphs, the energy–mass diagram, tables."""

from __future__ import annotations

from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.chapters.motion_law.ink import draw_rays
from graphic_tmm.chapters.motion_law.plan import LAW_PLAN, MotionLaw
from graphic_tmm.chapters.motion_law.table import law_columns, law_results
from graphic_tmm.chapters.motion_law.task import (
    ACCELERATION,
    ENERGY,
    MASS,
    MOMENT,
    MOTION_LAW,
    SLOWNESS,
    SPEED,
    TIME,
    WORK,
)
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language import symbols
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import mu_text, pole_figures, stacked
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.scene.captions import captions

STACKS = {
    "forces": (MOMENT, WORK, ENERGY),
    "motion": (SPEED, ACCELERATION),
    "times": (SLOWNESS, TIME),
}
"""Which graphs stand one below the other."""


def law_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the graphs, the diagram and the tables; none where a scene asks for none."""
    law = LAW_PLAN.of(drawn)
    if law is None:
        return []
    language, high = drawn.scene.language, heights(drawn.scene, MOTION_LAW)
    words = captions(language)
    views = indicator_views(drawn, lettered, MOTION_LAW)
    for name, own in STACKS.items():
        views.append(stacked(f"motion-{name}", [_graph(drawn, law, one, lettered) for one in own]))
    views.insert(-2, _diagram(drawn, law, lettered))
    rows = tuple(law_columns(drawn))
    views.append(result_table(MOTION_LAW, rows, drawn.names, language, heights=high))
    found = [
        [words[name], number(value, language, 4), unit(of, language)]
        for name, (value, of) in single(law_results(drawn)).items()
    ]
    return [*views, results("table-motion-results", words[MOTION_LAW], found, language, high)]


def _graph(drawn: Drawn, law: MotionLaw, view: str, lettered: bool) -> Drawing:
    """Return a graph over the angle with its caption."""
    language, project = drawn.scene.language, drawn.project
    chart = next(one for one in law.charts if one.view == view)
    phi = law.base.mu
    on = subject(drawn, captions(language)[view], MOTION_LAW)
    letters = Names(
        [escape(name) for name in project.names],
        on_axis(
            symbols.symbol("1/ω" if view == SLOWNESS else chart.symbol, language),
            unit(chart.unit, language),
        ),
        on_axis("φ", unit(phi.unit.removesuffix("/mm"), language)),
        lengths=pole_figures(drawn.construction, drawn.reading, view, language),
    )
    graph = draw_graph(on, view, project.count, letters)
    along = f"{phi.name} = {number(drawn.value(phi), language)} {unit(phi.unit, language)}"
    return with_caption(graph, on, lettered, f"{mu_text(drawn.scales[view], language)}, {along}")


def _diagram(drawn: Drawn, law: MotionLaw, lettered: bool) -> Drawing:
    """Return the energy–mass diagram with its rays."""
    language = drawn.scene.language
    axes = (
        on_axis("T", unit("J", language)),
        on_axis(symbols.symbol("J_r", language), unit("kg·m²", language)),
    )
    on = subject(drawn, captions(language)[MASS], MOTION_LAW)
    names = [escape(name) for name in drawn.names[: drawn.project.count]]
    view = draw_rays(on, law, names, axes)
    scales = [mu_text(drawn.scales[key], language) for key in (ENERGY, MASS)]
    return with_caption(view, on, lettered, ", ".join(scales))


SHOWN = Views(draw={MOTION_LAW: law_views})
