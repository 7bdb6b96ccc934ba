"""What a sheet shows of an engine: indicator, force triangles, rotating vectors, diagrams, tables."""

from __future__ import annotations

from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.engine.ink import draw_rotating, draw_triangles
from graphic_tmm.chapters.engine.ink_transfer import TransferFigure, draw_all_forces
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN, Engine
from graphic_tmm.chapters.engine.record import BESIDE, WORKS
from graphic_tmm.chapters.engine.table import PRESSURES, engine_columns, engine_results
from graphic_tmm.chapters.engine.task import ENGINE, TRANSFER, TRANSFER_PLACE, VIEW
from graphic_tmm.chapters.forces.ink_polygons import bar
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.graph_rules import axes_of
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import captioned, in_rows, mu_text, stacked
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.scene.captions import captions

SUMS = ", ".join(
    f"{bar(whole)} = {bar(one)} + {bar(other)}"
    for whole, one, other in (("P′", "Q", "N"), ("Q", "K", "T"))
)
"""What the force triangles say: P′ of the rod's Q and the pressure N on the guide, Q of K and T."""
COUPLES = "M = T·R = Q·h, M′ = N·OB"
"""What the couples of that figure are."""


def engine_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the indicator diagram, the force triangles and the rotating vectors of an engine."""
    made = ENGINE_PLAN.of(drawn)
    if made is None:
        return []
    return [
        *indicator_views(drawn, lettered, ENGINE),
        *_triangles(drawn, made, lettered),
        _rotating(drawn, made, lettered),
    ]


def transfer_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the figure of all forces of the crank mechanism, in the position that is worked."""
    made, language = ENGINE_PLAN.of(drawn), drawn.scene.language
    if made is None:
        return []
    plans, place = KINEMATICS_PLAN.on(drawn), _worked(drawn)
    scale, words = drawn.scales[TRANSFER], captions(language)
    title = f"{words[TRANSFER]}, {words['position']} {drawn.names[place]}"
    on = subject(drawn, title, TRANSFER_PLACE)
    shown = TransferFigure(place, scale.value, made.order.unit, plans.sense)
    view = finished(draw_all_forces(on, BESIDE.on(drawn).transfer, shown), lettered)
    scales = f"{mu_text(drawn.scales[POSITIONS], language)}, {mu_text(scale, language)}"
    inertia = bar(symbol("P_{in}", language))
    told = (f"{scales}; {bar('P′')} = {bar('P')} + {inertia}", f"{SUMS}; {COUPLES}")
    return [captioned(view, escape(title), *told, heights=on.heights)]


def _worked(drawn: Drawn) -> int:
    """Return the position (index) that is drawn alone: the first that has a plan of accelerations."""
    there = _positions_on_sheet(drawn)
    first = [k for k in KINEMATICS_PLAN.on(drawn).accelerated if k in there]
    return first[0] if first else there[min(1, len(there) - 1)]


def engine_diagram_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagrams of an engine's forces over the turn, and their tables."""
    made, project, language = ENGINE_PLAN.of(drawn), drawn.project, drawn.scene.language
    if made is None:
        return []
    _ = speaking(language)
    rows = [one for one in engine_columns(drawn) if one.segment not in PRESSURES]
    high = heights(drawn.scene, "engine diagrams")
    forces = result_table("engine", rows, project.names, language, heights=high)
    carried = _(
        "the frame carries P (P and −P close in it); the bearings carry Q = K + T; "
        "the foundation carries P_{in} and the couple N·OB, which equals M"
    ).split("; ")
    return [
        *_diagrams(drawn, made, lettered),
        captioned(forces, *carried, heights=high),
        _results(drawn),
    ]


def _positions_on_sheet(drawn: Drawn) -> list[int]:
    return [k for k in range(drawn.project.count) if k not in drawn.undrawn]


def _triangles(drawn: Drawn, made: Engine, lettered: bool) -> list[Drawing]:
    project, language = drawn.project, drawn.scene.language
    _, words, scale = speaking(language), captions(language), drawn.scales[VIEW]
    plans = KINEMATICS_PLAN.on(drawn)
    pivot, high = plans.positions.point(plans.structure.origin), heights(drawn.scene, ENGINE)
    views = []
    for place in _positions_on_sheet(drawn):
        title = f"{_('Force triangles')}, {words['position']} {project.names[place]}"
        on = subject(drawn, title, ENGINE, name=f"engine-{project.names[place]}")
        views.append(finished(draw_triangles(on, made, pivot, place, scale.value), lettered))
    mu = f"{mu_text(scale, language)}; {SUMS}"
    told = [(escape(project.names[place]), mu) for place in _positions_on_sheet(drawn)]
    return in_rows(views, VIEW, _("Force triangles"), told, high)


def _rotating(drawn: Drawn, made: Engine, lettered: bool) -> Drawing:
    project, language = drawn.project, drawn.scene.language
    _, words, scale = speaking(language), captions(language), drawn.scales["harmonics"]
    place = _worked(drawn)
    at = f"{words['position']} {escape(project.names[place])}"
    title = f"{_('Inertia forces of first and second order')}, {at}"
    on = subject(drawn, title, ENGINE, name="rotating")
    view = draw_rotating(on, made, place, scale.value)
    return with_caption(view, on, lettered, mu_text(scale, language))


def _diagrams(drawn: Drawn, made: Engine, lettered: bool) -> list[Drawing]:
    """Return the diagrams over the turn in two columns."""
    project, language = drawn.project, drawn.scene.language
    words = captions(language)
    names = [escape(name) for name in project.names]
    views = []
    for chart in made.charts:
        view, symbol = chart.view, chart.symbol
        letters = [words[f"engine {k}"] for k in made.curves[view]]
        curves = dict(zip(chart.ordinates, letters, strict=True))
        up = on_axis(words[f"engine {symbol}"], unit(chart.unit, language))
        told = Names(
            names, up, on_axis("φ", unit("rad", language)), curves if len(curves) > 1 else {}
        )
        on = subject(drawn, words[f"view engine {symbol}"], "engine diagrams")
        graph = draw_graph(on, view, project.count, told)
        scales = [mu_text(drawn.scales[view], language), _base_text(drawn, view)]
        views.append(with_caption(graph, on, lettered, ", ".join(scales)))
    half = (len(views) + 1) // 2
    return [stacked("engine-diagrams-1", views[:half]), stacked("engine-diagrams-2", views[half:])]


def _base_text(drawn: Drawn, view: str) -> str:
    """Return the scale of the base of a diagram over the turn: μ_φ = 0.05236 rad/mm."""
    mark, language = axes_of(drawn.construction, view).mu_along, drawn.scene.language
    value = drawn.value(mark)
    return mu_text(Scale(mark.name, value, mark.unit), language)


def _results(drawn: Drawn) -> Drawing:
    language = drawn.scene.language
    _, words = speaking(language), captions(language)
    rows = [
        [words[name], number(value, language), unit(of, language)]
        for name, (value, of) in single(engine_results(drawn)).items()
        if name not in WORKS
    ]
    high = heights(drawn.scene, "engine diagrams")
    return results("table-lumping", _("The rod's mass lumped"), rows, language, high)


SHOWN = Views(
    draw={
        "engine": engine_views,
        TRANSFER_PLACE: transfer_views,
        "engine diagrams": engine_diagram_views,
    }
)
