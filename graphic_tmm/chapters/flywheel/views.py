"""What a sheet shows of a flywheel: indicator diagram, graphs, energy–mass diagram, sketch, tables."""

from __future__ import annotations

import math
from collections.abc import Mapping

from graphic_tmm.board import roles
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import REDUCTIONS
from graphic_tmm.chapters.flywheel.energy import EnergyMass
from graphic_tmm.chapters.flywheel.ink_energy import draw_energy_mass_ink
from graphic_tmm.chapters.flywheel.ink_projected import draw_projected
from graphic_tmm.chapters.flywheel.ink_sketch import Sizes, draw_flywheel
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.flywheel.rim import DrawnRim
from graphic_tmm.chapters.flywheel.table import (
    OFF_SHEET,
    PLAN,
    flywheel_columns,
    flywheel_results,
)
from graphic_tmm.chapters.flywheel.task import FLYWHEEL, PROJECTED, VIEWS
from graphic_tmm.chapters.flywheel.words import graph_title
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Pieces, Views
from graphic_tmm.language import symbols
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import millimetres, unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import captioned, mu_text, pole_figures, stacked
from graphic_tmm.readers.position_count import told_off
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.scene.captions import captions

SKETCH = 110.0
"""Room for the outer diameter of the sketch, mm."""


def _graph_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagrams and graphs of the flywheel, none if the scene asks for none."""
    made = FLYWHEEL_PLAN.of(drawn)
    if made is None:
        return []
    views = indicator_views(drawn, lettered, FLYWHEEL)
    column = stacked("flywheel-graphs", graphs(drawn, made, lettered))
    if made.energy_mass is None:
        return [*views, column]
    curve = _energy_mass(drawn, made.energy_mass, lettered)
    if made.order.energy_mass == PROJECTED:
        return [*views, _projected(drawn, made, made.energy_mass, (column, curve), lettered)]
    return [*views, column, curve]


def _projected(
    drawn: Drawn,
    made: Flywheel,
    second: EnergyMass,
    views: tuple[Drawing, Drawing],
    lettered: bool,
) -> Drawing:
    """Return the graphs, the curve and J turned by 90° as one view."""
    language, phi = drawn.scene.language, made.base.mu
    axes = (
        on_axis(symbols.symbol("J_r", language), unit("kg·m²", language)),
        on_axis("φ", unit(phi.unit.removesuffix("/mm"), language)),
    )
    names = [escape(name) for name in drawn.names[: drawn.project.count]]
    on, length = subject(drawn, views[1].title, PLAN), drawn.value(made.base.length)
    return draw_projected(on, second, views, names, length, axes, lettered)


def _sketch_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the sketch of the flywheel, if it has a rim."""
    made = FLYWHEEL_PLAN.of(drawn)
    if made is None or made.rim is None or not math.isfinite(drawn.value(made.rim.width)):
        return []
    return [sketch(drawn, made.rim)]


def _tables(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the tables of the flywheel."""
    if FLYWHEEL_PLAN.of(drawn) is None:
        return []
    language, high = drawn.scene.language, heights(drawn.scene, PLAN)
    rows = tuple(flywheel_columns(drawn))
    told = result_table(PLAN, rows, drawn.names, language, heights=high)
    return [told, results_of(drawn, single(flywheel_results(drawn)))]


FIGURES = (_graph_views, _sketch_views)
"""What draws the views of the flywheel that are no tables."""
flywheel_views = Pieces((*FIGURES, _tables))
"""The views of the flywheel, none if the scene asks for none."""


def graphs(drawn: Drawn, made: Flywheel, lettered: bool, place: str = PLAN) -> list[Drawing]:
    """Return the graphs of moment, works and energies with their captions, as a place of sheets shows them."""
    language, project = drawn.scene.language, drawn.project
    _ = speaking(language)
    sides = (_("A_{drv}"), _("A_{res}"))
    found, straight = sides if made.order.constant == "resisting" else reversed(sides)
    works = dict(zip(made.sides, (found, straight), strict=True))
    equal = _("{driving} = {resisting} over the cycle", driving=sides[0], resisting=sides[1])
    curves = {
        mark: symbols.symbol(mark.name, language)
        for chart in made.charts
        if chart.view == VIEWS["energy"]
        for mark in chart.ordinates
    }
    parts = {mark: symbols.symbol(mark.name, language) for mark in made.parts}
    if parts:
        chart = next(chart for chart in made.charts if chart.view == VIEWS["moment"])
        parts[chart.ordinates[0]] = symbols.symbol("M_r", language)
    log, reading, phi = project.construction, drawn.reading, made.base.mu
    names = [escape(name) for name in project.names]
    along = on_axis("φ", unit(phi.unit.removesuffix("/mm"), language))
    views = []
    for key, symbol, of in (("moment", "M", "N·m"), ("work", "A", "J"), ("energy", "T", "J")):
        view = VIEWS[key]
        title = graph_title(key, made.order.constant, _, given=made.energies is None)
        letters = Names(
            names,
            on_axis(symbol, unit(of, language)),
            along,
            {"energy": curves, "work": works, "moment": parts}.get(key, {}),
            {mark: symbols.symbol(mark.name, language) for mark in log.roles(view, roles.MEAN)},
            pole_figures(log, reading, view, language)
            | {made.segment: _segment_figure(drawn, made.segment)},
        )
        on = subject(drawn, title, place)
        graph = draw_graph(on, view, project.count, letters)
        scales = [
            mu_text(drawn.scales[view], language),
            f"{phi.name} = {number(drawn.value(phi), language)} {unit(phi.unit, language)}",
        ]
        told = [", ".join(scales), *([equal] if key == "work" else [])]
        views.append(with_caption(graph, on, lettered, *told))
    return views


def _energy_mass(drawn: Drawn, second: EnergyMass, lettered: bool) -> Drawing:
    """Return the energy–mass curve with its caption."""
    language = drawn.scene.language
    names = [escape(name) for name in drawn.names[: drawn.project.count]]
    least, most = (_angle(drawn, mark) for mark in second.angles)
    figures = (_segment_figure(drawn, second.segment), least, most)
    axes = (
        on_axis("ΔT", unit("J", language)),
        on_axis(symbols.symbol("J_r", language), unit("kg·m²", language)),
    )
    on = subject(drawn, captions(language)["energy-mass"], PLAN)
    view = draw_energy_mass_ink(on, second, names, figures, axes)
    scales = [mu_text(drawn.scales[key], language) for key in ("energy", "energy-mass")]
    return with_caption(view, on, lettered, ", ".join(scales))


def _segment_figure(drawn: Drawn, segment: Mark) -> str:
    """Return a segment as it is dimensioned: [cd] = 60.7."""
    return f"[{segment.name}] = {number(drawn.value(segment), drawn.scene.language)}"


def _angle(drawn: Drawn, mark: Mark) -> str:
    return f"{mark.name} = {number(drawn.value(mark), drawn.scene.language)}°"


def sketch(drawn: Drawn, rim: DrawnRim, place: str = PLAN, size: str = "sketch") -> Drawing:
    """Return the sketch of the flywheel to the largest standard scale that has room.

    ``size``: by what name its room goes.
    """
    language = drawn.scene.language
    _ = speaking(language)
    order = rim.order
    metre = millimetres(1.0, language) / 1000.0
    read = (metre * drawn.value(mark) for mark in (rim.outer, rim.inner, rim.width))
    outer, inner, width = read
    # made in whole millimetres: the thinnest rim is one
    width = max(round(width, 3), 0.001)
    sizes = Sizes(outer, inner, width, metre * order.shaft, order.studs, metre * order.stud)
    large, room = 1000 * max(outer, width), SKETCH * drawn.sizes[size]
    reduction = next((r for r in (1, *REDUCTIONS) if large / r <= room), REDUCTIONS[-1])
    title = _("Sketch of the flywheel")
    marks = (rim.outer, rim.inner, rim.width)
    drawing = draw_flywheel(sizes, reduction, title, language, marks)
    scale = f"1:{number(reduction, language)}"
    return captioned(drawing, title, scale, heights=heights(drawn.scene, place))


def results_of(drawn: Drawn, found: Mapping[str, tuple[float, str]], place: str = PLAN) -> Drawing:
    """Return the table of results."""
    language = drawn.scene.language
    words = captions(language)
    rows = [
        [words[name], number(value, language, 3 if of == "%" else 4), unit(of, language)]
        for name, (value, of) in found.items()
        if name not in OFF_SHEET
    ]
    high = heights(drawn.scene, place)
    made = results("table-results", words["flywheel"], rows, language, high)
    off = told_off(drawn, language, remedies=False)
    return captioned(made, *off, heights=high) if off else made


SHOWN = Views(draw={FLYWHEEL: flywheel_views})
