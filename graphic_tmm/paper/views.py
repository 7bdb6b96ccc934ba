"""What a sheet can show, view by view: plans with their captions, equations, tables, the lettering itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations import lay_off
from graphic_tmm.board.scales import Scale
from graphic_tmm.equations import equations
from graphic_tmm.paper.drawing import Drawing, Label
from graphic_tmm.paper.ink_equations import draw_equations
from graphic_tmm.paper.ink_graphs import Names, draw_graph
from graphic_tmm.paper.ink_plans import Place, draw_plan
from graphic_tmm.paper.ink_positions import draw_positions_ink
from graphic_tmm.paper.ink_tables import link_table, pair_table, result_table, structure_lines
from graphic_tmm.paper.layout import bounds
from graphic_tmm.paper.letters import escape, letter
from graphic_tmm.paper.specimen import specimen
from graphic_tmm.paper.specimen_symbols import specimen_symbols
from graphic_tmm.plans.motion import Motion
from graphic_tmm.scene.records import Scene
from graphic_tmm.tables import UNITS, chart_columns, columns
from graphic_tmm.words import CAPTIONS, number, unit
from graphic_tmm.work import Work

CAPTION = 5.0
SMALL = 3.5
STACK = 5.0
"""Clear height between two diagrams of a stack, mm."""


def _mu(scale: Scale, language: str) -> str:
    return f"{scale.symbol} = {number(scale.value, language)} {unit(scale.unit, language)}"


def in_cells(views: Sequence[Drawing]) -> list[Drawing]:
    """Return views that each take a cell of one size, with their ink in the middle, so that rows align."""
    boxes = [bounds(view) for view in views]
    width = max((right - left for left, _, right, _ in boxes), default=0.0)
    height = max((top - low for _, low, _, top in boxes), default=0.0)
    made = []
    for view, (left, low, right, top) in zip(views, boxes, strict=True):
        x, y = (left + right - width) / 2, (low + top - height) / 2
        made.append(view._replace(cell=(x, y, x + width, y + height)))
    return made


def captioned(view: Drawing, *lines: str) -> Drawing:
    """Return a view with lines of lettering below it: in the middle, below a table from its left edge."""
    left, low, right, top = bounds(view)
    middle, labels = (left + right) / 2, list(view.labels)
    for k, text in enumerate(lines):
        size = CAPTION if k == 0 and view.name == "positions" else SMALL
        low -= letter(text, size=size).ascent + 2.5
        at, anchor = (left, "start") if view.name.startswith("table") else (middle, "middle")
        labels.append(Label(text, complex(at, low), size, anchor))
        low -= letter(text, size=size).descent
    widths = [letter(label.text, size=label.size).width for label in labels[len(view.labels) :]]
    if view.name.startswith("table"):
        cell = (left, low, max(right, left + max(widths)), top)
    else:
        reach = max([right - left, *widths]) / 2
        cell = (middle - reach, low, middle + reach, top)
    return view._replace(labels=tuple(labels), cell=cell)


def _positions(drawn: Work, lettered: bool) -> list[Drawing]:
    project, words = drawn.project, CAPTIONS[drawn.scene.language]
    body = project.positions.bodies[project.structure.driver]
    there = [k for k in range(len(project.names)) if k not in drawn.undrawn]
    wanted = [k for k in there if project.names[k] == drawn.scene.main]
    candidates = wanted or [k for k in project.accelerated if k in there] or there[1:] or there
    view = draw_positions_ink(
        project.construction,
        drawn.reading,
        main=candidates[0],
        names=project.names,
        skipped=drawn.undrawn,
        crank=(body.marks[project.structure.pivot], body.marks[project.structure.pin]),
        sense=1 if project.mechanism.drive.speed > 0 else -1,
        title=words["positions"],
        lettered=lettered,
    )
    return [
        captioned(view, words["positions"], _mu(drawn.scales["positions"], drawn.scene.language))
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
    mu = _mu(scale, language)
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
        scales = [_mu(drawn.scales[key], language) for key in (chart.view, "base")]
        views.append(captioned(view, title, ", ".join([*scales, *_poles(drawn, chart.view)])))
    narrow = all(o.format == "A4" for o in drawn.scene.sheets if "diagrams" in o.place)
    if not narrow:
        views = [stacked("diagrams", views)]
    rows = chart_columns(project, drawn.reading, drawn.accelerated)
    return [*views, result_table("diagrams", rows, project.names, language, upright=narrow)]


def _poles(drawn: Work, view: str) -> list[str]:
    """Return the pole distances of a view as they are written: H_V = 20 mm."""
    language, found = drawn.scene.language, []
    for step in drawn.project.construction.steps:
        if step.it.view == view and step.op is lay_off and step.it.letter == "P":
            distance = step.uses[1]
            value = float(drawn.reading[distance][0, 0])
            found.append(f"{distance.letter} = {number(value, language)} {unit('mm', language)}")
    return found


def stacked(name: str, views: Sequence[Drawing]) -> Drawing:
    """Return drawings one below the other as one, their origins above each other."""
    moved, top = [], 0.0
    for view in views:
        _, low, _, high = bounds(view)
        moved.append(view.moved(1j * (top - high)))
        top -= high - low + STACK
    boxes = [bounds(view) for view in moved]
    cell = (
        min(b[0] for b in boxes),
        min(b[1] for b in boxes),
        max(b[2] for b in boxes),
        max(b[3] for b in boxes),
    )
    strokes = tuple(stroke for view in moved for stroke in view.strokes)
    labels = tuple(label for view in moved for label in view.labels)
    return Drawing(name, "; ".join(view.title for view in views), strokes, labels, cell)


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
    "structure": _structure,
    "results": _results,
    "velocity table": _velocity_table,
    "acceleration table": _acceleration_table,
}
"""What can be placed on a sheet of a mechanism: work, lettered? -> its drawings."""

FREE_VIEWS: Mapping[str, Callable[[Scene], list[Drawing]]] = {
    "lettering": lambda scene: specimen(scene.language),
    "symbols": lambda scene: specimen_symbols(scene.language),
}
"""What can be placed on any sheet."""
