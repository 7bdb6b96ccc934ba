"""What a sheet shows of an engine: indicator, force triangles, rotating vectors, diagrams, tables."""

from __future__ import annotations

from graphic_tmm.captions import captions
from graphic_tmm.chapters.engine.ink import draw_rotating, draw_triangles
from graphic_tmm.chapters.engine.plan import ENGINE, VIEW, Engine
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.chapters.forces.ink_polygons import bar
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.chapters.kinematics.plan import KINEMATICS
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.ruled import table
from graphic_tmm.paper.views import captioned, in_rows, mu_text, stacked
from graphic_tmm.readers.result_table import (
    SIZE,
    result_table,
)

SUMS = ", ".join(
    f"{bar(whole)} = {bar(one)} + {bar(other)}"
    for whole, one, other in (("P′", "Q", "N"), ("Q", "K", "T"))
)
"""What the force triangles say: P′ of the rod's Q and the pressure N on the guide, Q of K and T."""


def engine_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the indicator diagram, the force triangles and the rotating vectors of an engine."""
    made = ENGINE.of(drawn)
    if made is None:
        return []
    return [
        *indicator_views(drawn, lettered, ENGINE.chapter),
        *_triangles(drawn, made, lettered),
        _rotating(drawn, made, lettered),
    ]


def engine_diagram_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the diagrams of an engine's forces over the turn, and their tables."""
    made, project, language = ENGINE.of(drawn), drawn.project, drawn.scene.language
    if made is None:
        return []
    _, rows = speaking(language), engine_columns(drawn)
    forces = result_table("engine", rows, project.names, language)
    carried = _(
        "the frame carries P (P and −P close in it); the bearings carry Q = K + T; "
        "the foundation carries P_{in} and the couple N·OB, which equals M"
    ).split("; ")
    return [*_diagrams(drawn, made, lettered), captioned(forces, *carried), _results(drawn)]


def _shown(drawn: Drawn) -> list[int]:
    return [k for k in range(drawn.project.count) if k not in drawn.undrawn]


def _triangles(drawn: Drawn, made: Engine, lettered: bool) -> list[Drawing]:
    project, language = drawn.project, drawn.scene.language
    _, words, scale = speaking(language), captions(language), drawn.scales[VIEW]
    plans = KINEMATICS.on(drawn)
    pivot = plans.positions.point(plans.structure.pivot)
    views = [
        draw_triangles(
            drawn.reading,
            made,
            pivot,
            place,
            f"engine-{project.names[place]}",
            f"{_('Force triangles')}, {words['position']} {project.names[place]}",
            scale.value,
            lettered=lettered,
        )
        for place in _shown(drawn)
    ]
    titles = [view.title for view in views]
    told = f"{mu_text(scale, language)}; {SUMS}"
    shown = [
        captioned(view, escape(title), told) for view, title in zip(views, titles, strict=True)
    ]
    return in_rows(shown, VIEW)


def _rotating(drawn: Drawn, made: Engine, lettered: bool) -> Drawing:
    project, language = drawn.project, drawn.scene.language
    _, words, scale = speaking(language), captions(language), drawn.scales["harmonics"]
    there = _shown(drawn)
    place = next(
        (k for k in KINEMATICS.on(drawn).accelerated if k in there), there[min(1, len(there) - 1)]
    )
    at = f"{words['position']} {escape(project.names[place])}"
    title = f"{_('Inertia forces of first and second order')}, {at}"
    view = draw_rotating(
        drawn.reading, made, place, "rotating", title, scale.value, lettered=lettered
    )
    return captioned(view, title, mu_text(scale, language))


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
        title = words[f"view engine {symbol}"]
        graph = draw_graph(
            project.construction,
            drawn.reading,
            view,
            project.count,
            Names(names, words[f"engine {symbol}"], "φ", curves if len(curves) > 1 else {}),
            title,
            lettered=lettered,
        )
        views.append(captioned(graph, title, mu_text(drawn.scales[view], language)))
    half = (len(views) + 1) // 2
    return [stacked("engine-diagrams-1", views[:half]), stacked("engine-diagrams-2", views[half:])]


def _results(drawn: Drawn) -> Drawing:
    language = drawn.scene.language
    _, words = speaking(language), captions(language)
    rows = [
        [words[name], number(value, language), unit(of, language)]
        for name, (value, of) in single(engine_results(drawn)).items()
    ]
    heads = [words["value"], words["results"], words["unit"]]
    align = ["left", "centre", "left"]
    return table(
        "table-lumping",
        _("The rod's mass lumped"),
        heads,
        rows,
        size=SIZE,
        align=align,
    )
