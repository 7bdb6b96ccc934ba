"""From a drawn project to sheets: its views packed onto paper, each sheet in its frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.frame import SIZES, drawing_area, frame
from graphic_tmm.paper.layout import Room, bounds, pack
from graphic_tmm.paper.views import FOLLOWS, FREE_VIEWS, PART_VIEWS, VIEWS
from graphic_tmm.parts import Part
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.words import number
from graphic_tmm.work import Work


def compose(scene: Scene, drawn: Work | None, parts: Sequence[Part] = ()) -> tuple[Sheet, ...]:
    """Return the sheets of a scene, each order followed by the sheets it spills onto.

    ``drawn``: its mechanism as drawn, if it has one; ``parts``: what is drawn beside it.
    """
    laid = _laid(scene, lambda plan: _views(plan, scene, drawn, parts, True))
    count = len(laid)
    sheets = []
    for index, (format, placed) in enumerate(laid):
        edge = frame(
            format,
            language=scene.language,
            first=index == 0,
            number=index + 1,
            count=count,
            fields=_fields(scene, drawn, parts),
        )
        name = f"sheet-{index + 1}" if count > 1 else "sheet"
        width, height = SIZES[format]
        drawings = (edge, *placed)
        sheets.append(Sheet(name, scene.title, format, width, height, drawings, scene.language))
    return tuple(sheets)


Cells = dict[tuple[object, ...], list[Drawing]]
"""The room of the views of a plan, by its name and the μ that it depends on."""


def needed(scene: Scene, drawn: Work | None, parts: Sequence[Part], cells: Cells) -> int:
    """Return how many sheets a scene takes: tried with plans that only take the room they will need.

    ``cells``: what earlier trials of the same scene found, with other μ of the plans; kept up.
    """

    def room(plan: str) -> list[Drawing]:
        scales = drawn.scales if drawn is not None else {}
        follows = FOLLOWS.get(plan, ("velocities", "accelerations"))
        key = (plan, *(scales[name].value for name in follows if name in scales))
        if key not in cells:
            views = _views(plan, scene, drawn, parts, False)
            cells[key] = [Drawing(view.name, view.title, cell=bounds(view)) for view in views]
        return cells[key]

    return len(_laid(scene, room))


def _laid(
    scene: Scene, views: Callable[[str], Sequence[Drawing]]
) -> list[tuple[str, list[Drawing]]]:
    """Return the views placed, sheet by sheet, with the formats of the sheets."""
    laid: list[tuple[str, list[Drawing]]] = []
    for order in scene.sheets:
        rooms = (_room(order, scene, not laid), _room(order, scene, False))
        there = [view for plan in order.place for view in views(plan)]
        laid += [(order.format, placed) for placed in pack(there, rooms, order.format)]
    return laid


def _views(
    plan: str, scene: Scene, drawn: Work | None, parts: Sequence[Part], lettered: bool
) -> list[Drawing]:
    if plan in FREE_VIEWS:
        return FREE_VIEWS[plan](scene)
    if plan in PART_VIEWS:
        return [view for p in parts if p.kind == plan for view in PART_VIEWS[plan](p, lettered)]
    assert drawn is not None
    return VIEWS[plan](drawn, lettered)


def _room(order: SheetOrder, scene: Scene, first: bool) -> Room:
    area = drawing_area(order.format, scene.language, first)
    return Room(area.inner, area.occupied)


def _fields(scene: Scene, drawn: Work | None, parts: Sequence[Part]) -> dict[str, str]:
    fields = dict(scene.title_block)
    fields.setdefault("name", scene.title)
    scales = [drawn.scales["positions"]] if drawn is not None else []
    scales += [s for part in parts for s in part.scales().values() if s.symbol == "μ_l"]
    if scales:
        reduction = scales[0].value * 1000.0
        fields.setdefault("scale", _ratio(reduction, scene.language))
    return fields


def _ratio(reduction: float, language: str) -> str:
    """Return a scale as the title block writes it: 1:4, 2,5:1."""
    if reduction >= 1:
        return f"1:{number(reduction, language)}"
    return f"{number(1 / reduction, language)}:1"
