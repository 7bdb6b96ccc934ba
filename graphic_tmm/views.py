"""What a sheet can show, view by view: plans with their captions, equations, tables, the lettering itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.cam.views import cam_views
from graphic_tmm.chapters.diagrams.table import (
    chart_columns,
)
from graphic_tmm.chapters.engine.views import engine_diagram_views, engine_views
from graphic_tmm.chapters.flywheel.views import flywheel_views, pole_texts
from graphic_tmm.chapters.forces.views import force_table, force_views, lever_views
from graphic_tmm.chapters.gears.views import (
    gear_views,
)
from graphic_tmm.chapters.kinematics.equations import equations
from graphic_tmm.chapters.kinematics.ink_equations import draw_equations
from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.chapters.kinematics.ink_positions import draw_positions_ink
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.lettering.specimen import specimen
from graphic_tmm.chapters.lettering.specimen_symbols import specimen_symbols
from graphic_tmm.chapters.planetary.views import (
    planetary_views,
)
from graphic_tmm.chapters.structure.tables import (
    link_table,
    pair_table,
    structure_lines,
)
from graphic_tmm.language.captions import CAPTIONS
from graphic_tmm.paper.arranging import captioned, in_cells, mu_text, stacked
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.graph import Names, draw_graph
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.result_table import (
    result_table,
)
from graphic_tmm.parts import Part
from graphic_tmm.readers.columns import UNITS, columns
from graphic_tmm.scene.records import Scene
from graphic_tmm.work import Work


def _positions(drawn: Work, lettered: bool) -> list[Drawing]:
    project, words = drawn.project, CAPTIONS[drawn.scene.language]
    body = project.positions.bodies[project.structure.driver]
    there = [k for k in range(len(project.names)) if k not in drawn.undrawn]
    wanted = [k for k in there if project.names[k] == drawn.scene.main]
    candidates = wanted or [k for k in project.accelerated if k in there] or there[1:] or there
    view = draw_positions_ink(
        project.construction,
        drawn.reading,
        drawn.reaches,
        main=candidates[0],
        names=project.names,
        skipped=drawn.undrawn,
        crank=(body.marks[project.structure.pivot], body.marks[project.structure.pin]),
        sense=1 if project.mechanism.drive.speed > 0 else -1,
        title=words["positions"],
        lettered=lettered,
    )
    return [
        captioned(
            view, words["positions"], mu_text(drawn.scales["positions"], drawn.scene.language)
        )
    ]


def _plans(plan: str, drawn: Work, lettered: bool) -> list[Drawing]:
    project, language = drawn.project, drawn.scene.language
    words = CAPTIONS[language]
    reading: Reading | None
    if plan == "velocities":
        reading, places = drawn.reading, list(range(len(project.names)))
        caption = words["velocities turned" if drawn.scene.turned else "velocities"]
    else:
        reading, places = drawn.accelerated, list(project.accelerated)
        caption = words["accelerations"]
    if reading is None or plan not in drawn.scales:
        return []
    scale = drawn.scales[plan]
    shown = [(k, project.names[p]) for k, p in enumerate(places) if p not in drawn.undrawn]
    if plan == "velocities" and drawn.scene.common_pole and len(shown) > 1:
        orders = [(plan, f"{caption}, {words['all positions']}", [Place(*one) for one in shown])]
    else:
        orders = [
            (f"{plan}-{name}", f"{caption}, {words['position']} {name}", [Place(k)])
            for k, name in shown
        ]
    views = [
        draw_plan(
            project.construction,
            reading,
            plan,
            stood,
            name,
            title,
            scale.value,
            UNITS[plan],
            lettered=lettered,
        )
        for name, title, stood in orders
    ]
    mu = mu_text(scale, language)
    titles = [view.title for view in views]
    return [
        captioned(view, escape(title), mu)
        for view, title in zip(in_cells(views), titles, strict=True)
    ]


def _equations(drawn: Work, lettered: bool) -> list[Drawing]:
    log, made = drawn.project.construction, []
    for plan in ("velocities", "accelerations"):
        turned = drawn.scene.turned and plan == "velocities"
        title = CAPTIONS[drawn.scene.language][f"equations {plan}"]
        found = list(equations(log, plan, turned=turned))
        if found:
            made.append(draw_equations(log, plan, title, found))
    return made


def _velocities(drawn: Work, lettered: bool) -> list[Drawing]:
    return _plans("velocities", drawn, lettered)


def _accelerations(drawn: Work, lettered: bool) -> list[Drawing]:
    return _plans("accelerations", drawn, lettered)


def _diagrams(drawn: Work, lettered: bool) -> list[Drawing]:
    """Return the kinematic diagrams one below the other, and their table."""
    project, language = drawn.project, drawn.scene.language
    kinematic = project.kinematic
    if kinematic is None:
        return []
    words, row = CAPTIONS[language], project.count
    along = "t" if kinematic.order.over == "time" else "φ"
    views = []
    for chart in kinematic.charts.values():
        title = words[chart.view].format(point=escape(kinematic.order.point))
        letters = Names([escape(name) for name in project.names], chart.symbol, along)
        view = draw_graph(
            project.construction, drawn.reading, chart.view, row, letters, title, lettered=lettered
        )
        scales = [mu_text(drawn.scales[key], language) for key in (chart.view, "base")]
        views.append(captioned(view, title, ", ".join([*scales, *pole_texts(drawn, chart.view)])))
    rows = chart_columns(project, drawn.reading, drawn.accelerated)
    return [
        stacked("diagrams", views),
        result_table("diagrams", rows, project.names, language),
    ]


def _structure(drawn: Work, lettered: bool) -> list[Drawing]:
    project, language = drawn.project, drawn.scene.language
    pairs = pair_table(project.mechanism, project.structure, language)
    return [
        link_table(project.mechanism, project.structure, language),
        captioned(pairs, *structure_lines(project.structure, language)),
    ]


def _velocity_table(drawn: Work, lettered: bool) -> list[Drawing]:
    project, everywhere = drawn.project, range(len(drawn.project.names))
    return _table("velocities", drawn, project.velocities, drawn.reading, everywhere)


def _acceleration_table(drawn: Work, lettered: bool) -> list[Drawing]:
    project = drawn.project
    places = project.accelerated
    return _table("accelerations", drawn, project.accelerations, drawn.accelerated, places)


def _table(
    plan: str, drawn: Work, motion: Motion | None, reading: Reading | None, places: Sequence[int]
) -> list[Drawing]:
    if motion is None or reading is None:
        return []
    log, names = drawn.project.construction, drawn.project.names
    rows = columns(log, reading, plan, list(places), len(names), motion.rates)
    return [result_table(plan, rows, names, drawn.scene.language)]


def _results(drawn: Work, lettered: bool) -> list[Drawing]:
    return [*_velocity_table(drawn, lettered), *_acceleration_table(drawn, lettered)]


VIEWS: Mapping[str, Callable[[Work, bool], list[Drawing]]] = {
    "positions": _positions,
    "velocities": _velocities,
    "accelerations": _accelerations,
    "equations": _equations,
    "diagrams": _diagrams,
    "flywheel": flywheel_views,
    "forces": force_views,
    "lever": lever_views,
    "force table": force_table,
    "engine": engine_views,
    "engine diagrams": engine_diagram_views,
    "structure": _structure,
    "results": _results,
    "velocity table": _velocity_table,
    "acceleration table": _acceleration_table,
}
"""What can be placed on a sheet of a mechanism: work, lettered? -> its drawings."""

FOLLOWS: Mapping[str, tuple[str, ...]] = {
    "velocities": ("velocities",),
    "velocity table": ("velocities",),
    "lever": ("velocities",),
    "accelerations": ("accelerations",),
    "acceleration table": ("accelerations",),
}
"""The plans, besides that of positions, whose μ the room of a view depends on."""
SEVERAL: Mapping[str, tuple[str, ...]] = {"results": ("velocity table", "acceleration table")}
"""Places that are others together."""

PART_VIEWS: Mapping[str, Callable[[Part, bool], list[Drawing]]] = {
    "cam": cam_views,
    "gears": gear_views,
    "planetary": planetary_views,
}
"""What can be placed of a part that is drawn by itself: part, lettered? -> its drawings."""

FREE_VIEWS: Mapping[str, Callable[[Scene], list[Drawing]]] = {
    "lettering": lambda scene: specimen(scene.language),
    "symbols": lambda scene: specimen_symbols(scene.language),
}
"""What can be placed on any sheet."""
