"""What a sheet shows of a law of motion: its graphs, the energy–mass diagram, tables."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.indicator.views import indicator_views
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
from graphic_tmm.chapters.motor.ink import Diagram, Spot, draw_diagram
from graphic_tmm.chapters.motor.plan import SPEEDS
from graphic_tmm.chapters.motor.task import MOTOR, STEP
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
OF_LOADS = {MOMENT: "motion-loads", WORK: "motion-loads-work"}
"""What graphs are called where a motor drives besides."""


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
    views[-2:-2] = _diagrams(drawn, law, lettered)
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
    title = OF_LOADS.get(view, view) if law.motor is not None else view
    on = subject(drawn, captions(language)[title], MOTION_LAW)
    letters = Names(
        [escape(name) for name in project.names],
        on_axis(
            symbols.symbol(chart.symbol, language),
            unit(chart.unit, language),
        ),
        on_axis("φ", unit(phi.unit.removesuffix("/mm"), language)),
        lengths=pole_figures(drawn.construction, drawn.reading, view, language),
    )
    graph = draw_graph(on, view, project.count, letters)
    along = f"{phi.name} = {number(drawn.value(phi), language)} {unit(phi.unit, language)}"
    return with_caption(graph, on, lettered, f"{mu_text(drawn.scales[view], language)}, {along}")


def _diagrams(drawn: Drawn, law: MotionLaw, lettered: bool) -> Iterator[Drawing]:
    """Yield the energy–mass diagram with its rays; with a motor its characteristic and one crossing."""
    language, scales = drawn.scene.language, drawn.scales
    count = drawn.project.count
    names = [escape(name) for name in drawn.names[:count]]
    own = law.inertia
    spots = [Spot(law.points.row, k, name) for k, name in enumerate(names)]
    names.append(f"{names[0]} ({count})")
    spots.append(Spot(law.points.end, 0, names[-1]))
    ends = names[law.order.motor.step :][:2] if law.order.motor is not None else []
    energy = on_axis("T", unit("J", language))
    red = on_axis(symbols.symbol("J_r", language), unit("kg·m²", language))
    omega = on_axis("ω", unit("1/s", language))
    mu_omega = mu_text(scales[SPEEDS], language) if law.motor is not None else ""
    found = [
        (
            Diagram(MASS, own.along, own.up, [(law.curve, "")], spots, law.rays),
            (energy, red),
            [mu_text(scales[key], language) for key in (ENERGY, MASS)],
        )
    ]
    if law.motor is not None:
        cross, moment = law.motor.axes, on_axis("M", unit("N·m", language))
        at = [Spot(law.step.moment, 0, ends[0])] if law.step is not None else []
        one = Diagram(MOTOR, cross.along, cross.up, [(law.motor.curve, "")], at)
        found.append((one, (moment, omega), [mu_text(scales[MOTOR], language), mu_omega]))
    if law.step is not None and math.isfinite(drawn.value(law.step.omega)):
        step = law.step
        curves = [(step.parabola, "Jω²/2"), (step.energy, "T + ΔA + A_{m}")]
        one = Diagram(
            STEP,
            step.axes.along,
            step.axes.up,
            curves,
            [Spot(step.point, 0, ends[1])],
        )
        found.append((one, (energy, omega), [mu_text(scales[ENERGY], language), mu_omega]))
    for one, axes, texts in found:
        on = subject(drawn, captions(language)[one.view], MOTION_LAW)
        yield with_caption(draw_diagram(on, one, count, axes), on, lettered, ", ".join(texts))


SHOWN = Views(draw={MOTION_LAW: law_views})
