"""What a sheet shows of a cam given by arcs: its contour, the diagrams one below the other, table, results."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.arc_cam.ink import ArcNames, draw_contour_ink
from graphic_tmm.chapters.arc_cam.ink_plans import draw_plan
from graphic_tmm.chapters.arc_cam.linkage import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, LETTERS, VIEWS, ArcCam
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.table import PLAN, arc_columns
from graphic_tmm.chapters.arc_cam.table import results as figures
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.axes import on_axis
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.views import mu_text, pole_figures, stacked, wrapped
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions

SPEEDS = ("arc_v_", "arc_a_", "arc_omega_", "arc_eps_")
"""What results of speeds and accelerations begin with."""


def arc_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the views of a cam given by arcs."""
    made, language = ARC_CAM_PLAN.on(drawn), drawn.scene.language
    high = heights(drawn.scene, PLAN)
    rows = arc_columns(drawn)
    return [
        _contour(drawn, made, lettered),
        _diagrams(drawn, made, lettered),
        *_plans(drawn, lettered),
        result_table(PLAN, rows, drawn.names, language, upright=True, heights=high),
        _results(drawn),
    ]


def _contour(drawn: Drawn, made: ArcCam, lettered: bool) -> Drawing:
    language, order = drawn.scene.language, made.order
    sizes = {"base": ("r_{1}", order.base), "nose": ("r_{2}", order.nose)}
    if order.eccentric:
        sizes = {"nose": ("R", order.nose)}
    if order.rise.radius is not None:
        sizes["rise"] = ("r_{3}", order.rise.radius)
    if order.fall.radius is not None and order.fall != order.rise:
        sizes["return"] = ("r_{4}", order.fall.radius)
    told = {
        name: f"{letter} = {_mm(value, language)}"
        for name, (letter, value) in sizes.items()
        if value
    }
    on = subject(drawn, captions(language)["arc cam profile"], PLAN)
    view = draw_contour_ink(on, made, ArcNames(drawn.names, told))
    mu = drawn.value(made.contour.mu)
    scale = f"μ_l = {number(mu, language)} {unit('m/mm', language)}"
    return with_caption(view, on, lettered, scale)


def _mm(metres: float, language: str) -> str:
    return f"{number(1000.0 * metres, language)} {unit('mm', language)}"


def _diagrams(drawn: Drawn, made: ArcCam, lettered: bool) -> Drawing:
    language, log, reading = drawn.scene.language, drawn.construction, drawn.reading
    words, high = captions(language), heights(drawn.scene, PLAN)
    views, scales = [], []
    for which, chart in made.charts.items():
        told = Names(
            drawn.names,
            on_axis(LETTERS[which], unit(chart.unit, language)),
            on_axis("φ", "°"),
            lengths=pole_figures(log, reading, chart.view, language),
        )
        on = subject(drawn, words[VIEWS[which]], PLAN)
        graph = draw_graph(on, chart.view, made.order.parts + 1, told)
        views.append(finished(graph, lettered))
        scale = drawn.scales[chart.view]._replace(symbol=f"μ_{{{LETTERS[which]}}}")
        scales.append(mu_text(scale, language))
    along = math.degrees(drawn.value(made.base.mu))
    common = f"μ_φ = {number(along, language)} {unit('°/mm', language)}"

    def told_of(chosen: Sequence[int]) -> list[str]:
        """The scales of some of the diagrams; that of the base once, at the end."""
        line = ", ".join([*(scales[k] for k in chosen), common])
        return [words["table arc_cam"], *wrapped(line, high.point, made.order.length)]

    return stacked("arc_cam-diagrams", views, told_of, high)


def _plans(drawn: Drawn, lettered: bool) -> Iterator[Drawing]:
    """Yield the plans of the replacing linkage, if they are asked for; with a speed their real scales, too."""
    beside, language = BESIDE.on(drawn), drawn.scene.language
    plans, real = beside.plans, beside.scales or (None, None)
    for view, mu, own in zip((VELOCITIES, ACCELERATIONS), plans.scales, real, strict=True):
        if plans.asked:
            on = subject(drawn, captions(language)[view], PLAN)
            picture = draw_plan(on, view, plans, plans.asked, drawn.value(mu))
            scales = [
                mu_text(Scale(one.name, drawn.value(one), one.unit), language)
                for one in (mu, own)
                if one is not None
            ]
            yield with_caption(picture, on, lettered, *scales)


def _results(drawn: Drawn) -> Drawing:
    language = drawn.scene.language
    words, rows = captions(language), []
    for name, (value, of) in single(figures(drawn)).items():
        in_mm = of == "m"
        speed = name.startswith(SPEEDS)
        figure = fixed(1000.0 * value if in_mm else value, 2 if in_mm or speed else 4, language)
        rows.append([words[name], figure, unit("mm" if in_mm else of, language)])
    high = heights(drawn.scene, PLAN)
    return results("table-arc_cam-results", words["arc_cam"], rows, language, high)


SHOWN = Views(draw={"arc_cam": arc_views, **given_views("arc_cam")})
