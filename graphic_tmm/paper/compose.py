"""From a drawn project to sheets: views with their captions, tables, frame, packed onto paper."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.scales import Scale
from graphic_tmm.paper.drawing import Drawing, Label, Sheet
from graphic_tmm.paper.frame import SIZES, drawing_area, frame
from graphic_tmm.paper.ink_plans import draw_plan
from graphic_tmm.paper.ink_positions import draw_positions_ink
from graphic_tmm.paper.ink_tables import link_table, pair_table, result_table, structure_lines
from graphic_tmm.paper.layout import Room, bounds, pack
from graphic_tmm.paper.letters import escape, letter
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.tables import UNITS, columns
from graphic_tmm.words import CAPTIONS, number, unit
from graphic_tmm.work import Work

CAPTION = 5.0
SMALL = 3.5


def compose(drawn: Work, *, lettered: bool = True) -> tuple[Sheet, ...]:
    """Return the sheets of a scene, each order followed by the sheets it spills onto.

    Unlettered plans only take the room that they will need: layout is tried with them.
    """
    scene = drawn.scene
    laid: list[tuple[str, list[Drawing]]] = []
    for order in scene.sheets:
        views = [view for plan in order.place for view in _VIEWS[plan](drawn, lettered)]
        rooms = (_room(order, scene, not laid), _room(order, scene, False))
        laid += [(order.format, placed) for placed in pack(views, rooms, order.format)]
    count = len(laid)
    sheets = []
    for index, (format, placed) in enumerate(laid):
        edge = frame(
            format,
            language=scene.language,
            first=index == 0,
            number=index + 1,
            count=count,
            fields=_fields(drawn),
        )
        name = f"sheet-{index + 1}" if count > 1 else "sheet"
        width, height = SIZES[format]
        sheets.append(Sheet(name, scene.title, format, width, height, (edge, *placed)))
    return tuple(sheets)


def _room(order: SheetOrder, scene: Scene, first: bool) -> Room:
    area = drawing_area(order.format, scene.language, first)
    return Room(area.inner, area.occupied)


def _fields(drawn: Work) -> dict[str, str]:
    fields = dict(drawn.scene.title_block)
    fields.setdefault("name", drawn.scene.title)
    scale = drawn.scales["positions"].value * 1000.0
    fields.setdefault("scale", _ratio(scale, drawn.scene.language))
    return fields


def _ratio(reduction: float, language: str) -> str:
    """Return a scale as the title block writes it: 1:4, 2,5:1."""
    if reduction >= 1:
        return f"1:{number(reduction, language)}"
    return f"{number(1 / reduction, language)}:1"


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
    candidates = [k for k in project.accelerated if k in there] or there[1:] or there
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
    views = []
    for index, position in enumerate(places):
        if position in drawn.undrawn:
            continue
        name = project.names[position]
        title = f"{caption}, {words['position']} {name}"
        view = draw_plan(
            project.construction,
            reading,
            plan,
            index,
            f"{plan}-{name}",
            title,
            scale.value,
            UNITS[plan],
            lettered=lettered,
        )
        views.append(view)
    captions = [view.title for view in views]
    return [
        captioned(view, escape(caption), _mu(scale, language))
        for view, caption in zip(in_cells(views), captions, strict=True)
    ]


def _velocities(drawn: Work, lettered: bool) -> list[Drawing]:
    return _plans("velocities", drawn, lettered)


def _accelerations(drawn: Work, lettered: bool) -> list[Drawing]:
    return _plans("accelerations", drawn, lettered)


def _structure(drawn: Work, lettered: bool) -> list[Drawing]:
    project, language = drawn.project, drawn.scene.language
    pairs = pair_table(project.mechanism, project.structure, language)
    return [
        link_table(project.mechanism, project.structure, language),
        captioned(pairs, *structure_lines(project.structure, language)),
    ]


def _results(drawn: Work, lettered: bool) -> list[Drawing]:
    project, language = drawn.project, drawn.scene.language
    count, made = len(project.names), []
    for plan, motion, reading, places in (
        ("velocities", project.velocities, drawn.reading, range(count)),
        ("accelerations", project.accelerations, drawn.accelerated, project.accelerated),
    ):
        if motion is None or reading is None:
            continue
        rows = columns(project.construction, reading, plan, list(places), count, motion.rates)
        made.append(result_table(plan, rows, project.names, language))
    return made


_VIEWS = {
    "positions": _positions,
    "velocities": _velocities,
    "accelerations": _accelerations,
    "structure": _structure,
    "results": _results,
}
