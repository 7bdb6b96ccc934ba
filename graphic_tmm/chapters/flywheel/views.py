"""What a sheet shows of a flywheel: indicator diagram, graphs, energy–mass diagram, sketch, tables."""

from __future__ import annotations

import math

from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import REDUCTIONS
from graphic_tmm.chapters.flywheel.ink_energy import (
    draw_energy_mass_ink,
)
from graphic_tmm.chapters.flywheel.ink_sketch import Sizes, draw_flywheel
from graphic_tmm.chapters.flywheel.plan import VIEWS, Flywheel
from graphic_tmm.chapters.flywheel.table import (
    flywheel_columns,
    flywheel_results,
    rim_too_wide,
)
from graphic_tmm.chapters.indicator.ink import (
    draw_indicator_ink,
)
from graphic_tmm.chapters.indicator.plan import Indicator
from graphic_tmm.language import symbols
from graphic_tmm.language.captions import CAPTIONS
from graphic_tmm.language.words import flywheel_title, number, unit
from graphic_tmm.paper.arranging import captioned, mu_text, stacked
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.result_table import (
    SIZE,
    result_table,
)
from graphic_tmm.paper.ruled import table
from graphic_tmm.work import Work

SKETCH = 110.0
"""Room for the outer diameter of the sketch, mm."""
SYMBOLS = {"D_max": "D_{max}", "D_e": "D_{e}", "D_i": "D_{i}", "rim_width": "b"}
"""The letters of results that are the same in both languages."""


def flywheel_views(drawn: Work, lettered: bool) -> list[Drawing]:
    """Return the views of the flywheel, none if the scene asks for none."""
    made = drawn.project.flywheel
    if made is None:
        return []
    language, project = drawn.scene.language, drawn.project
    words = CAPTIONS[language]
    names = [escape(name) for name in project.names[: project.count]]
    log, reading = project.construction, drawn.reading
    views = [] if made.indicator is None else [indicator_view(drawn, made.indicator, lettered)]
    views.append(stacked("flywheel-graphs", _graphs(drawn, made, lettered)))
    if made.energy_mass is not None:
        segment = number(_value(drawn, made.energy_mass.segment), language)
        found = draw_energy_mass_ink(
            log,
            reading,
            made.energy_mass,
            names,
            words["energy-mass"],
            segment,
            along=symbols.symbol("J_r", language),
            lettered=lettered,
        )
        scales = [mu_text(drawn.scales[key], language) for key in ("energy", "energy-mass")]
        angles = [_angle(drawn, name) for name in ("ψ_{max}", "ψ_{min}")]
        views.append(captioned(found, words["energy-mass"], ", ".join(scales), ", ".join(angles)))
    if made.rim is not None and math.isfinite(_value(drawn, made.rim.width)):
        views.append(_sketch(drawn, made))
    rows = flywheel_columns(project, reading)
    return [*views, result_table("flywheel", rows, project.names, language), _results(drawn)]


def cylinder_view(drawn: Work, lettered: bool) -> list[Drawing]:
    """Return the indicator diagram of a cylinder, if there is one that the flywheel does not show."""
    cylinder, flywheel = drawn.project.cylinder, drawn.project.flywheel
    shown = flywheel is not None and flywheel.indicator is not None
    if cylinder is None or shown:
        return []
    return [indicator_view(drawn, cylinder.indicator, lettered)]


def indicator_view(drawn: Work, indicator: Indicator, lettered: bool) -> Drawing:
    """Return the indicator diagram, captioned."""
    project, language = drawn.project, drawn.scene.language
    title = CAPTIONS[language]["indicator"]
    names = [escape(name) for name in project.names[: project.count]]
    view = draw_indicator_ink(
        project.construction, drawn.reading, indicator, names, title, lettered=lettered
    )
    return captioned(view, title, mu_text(drawn.scales["indicator"], language))


def _graphs(drawn: Work, made: Flywheel, lettered: bool) -> list[Drawing]:
    """Return the graphs of moment, works and energies with their captions."""
    language, project = drawn.scene.language, drawn.project
    words = CAPTIONS[language]
    sides = (words["A driving"], words["A resisting"])
    found, straight = sides if made.order.constant == "resisting" else reversed(sides)
    works = {"(A–A)": found, "(A′)": straight}
    curves = {key: symbols.symbol(key, language) for key in ("ΔT", "T_L", "T_F")}
    views = []
    for key, symbol in (("moment", "M"), ("work", "A"), ("energy", "T")):
        view = VIEWS[key]
        title = flywheel_title(key, made.order.constant, language)
        letters = Names(
            [escape(name) for name in project.names],
            symbol,
            "φ",
            {"energy": curves, "work": works}.get(key, {}),
            {"cd": number(_value(drawn, made.segment), language)},
        )
        graph = draw_graph(
            project.construction,
            drawn.reading,
            view,
            project.count,
            letters,
            title,
            lettered=lettered,
        )
        phi = made.base.mu
        scales = [
            mu_text(drawn.scales[view], language),
            f"{phi.name} = {number(_value(drawn, phi), language)} {unit(phi.unit, language)}",
            *pole_texts(drawn, view),
        ]
        views.append(captioned(graph, title, ", ".join(scales)))
    return views


def pole_texts(drawn: Work, view: str) -> list[str]:
    """Return the pole distances of a view as they are written: H_V = 20 mm."""
    language, found = drawn.scene.language, []
    for step in drawn.project.construction.steps:
        if step.it.view == view and step.op is lay_off and step.it.name == "P":
            distance = step.uses[1]
            value = number(_value(drawn, distance), language)
            found.append(f"{distance.name} = {value} {unit('mm', language)}")
    return found


def _value(drawn: Work, mark: Mark) -> float:
    return float(drawn.reading[mark][0, 0])


def _angle(drawn: Work, letter: str) -> str:
    mark = drawn.project.construction.mark("energy-mass", letter)
    assert mark is not None
    return f"{letter} = {number(_value(drawn, mark), drawn.scene.language)}°"


def _sketch(drawn: Work, made: Flywheel) -> Drawing:
    """Return the sketch of the flywheel to the largest standard scale that has room."""
    rim, language = made.rim, drawn.scene.language
    assert rim is not None
    order = rim.order
    outer, inner, width = (_value(drawn, mark) for mark in (rim.outer, rim.inner, rim.width))
    # made in whole millimetres: the thinnest rim is one
    width = max(round(width, 3), 0.001)
    sizes = Sizes(outer, inner, width, order.shaft, order.studs, order.stud)
    large, room = 1000 * max(outer, width), SKETCH * drawn.sizes.sketch
    reduction = next((r for r in (1, *REDUCTIONS) if large / r <= room), REDUCTIONS[-1])
    title = CAPTIONS[language]["sketch"]
    drawing = draw_flywheel(sizes, reduction, title, language)
    told = rim_too_wide(drawn.project, drawn.reading, language)
    scale = f"1:{number(reduction, language)}"
    return captioned(drawing, title, scale, *(told.split(": ") if told else ()))


def _results(drawn: Work) -> Drawing:
    """Return the table of results, both methods and what they differ by."""
    language = drawn.scene.language
    words, found = CAPTIONS[language], flywheel_results(drawn.project, drawn.reading)
    rows = [
        [words.get(name, SYMBOLS.get(name, name)), number(value, language), unit(of, language)]
        for name, (value, of) in found.items()
    ]
    if {"J_fly", "J_fly_energy_mass"} <= set(found):
        first, second = found["J_fly"][0], found["J_fly_energy_mass"][0]
        rows.append(
            [words["J difference"], number(100.0 * (first - second) / first, language, 3), "%"]
        )
    heads = [words["value"], words["results of"], words["unit"]]
    align = ["left", "centre", "left"]
    return table("table-results", words["flywheel"], heads, rows, size=SIZE, align=align)
