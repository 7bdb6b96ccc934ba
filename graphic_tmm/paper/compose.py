"""From a drawn project to sheets: its views packed onto paper, each sheet in its frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from graphic_tmm.paper.drawing import Drawing, Sheet, Within
from graphic_tmm.paper.frame import SIZES, drawing_area, frame
from graphic_tmm.paper.layout import Room, bounds, holds, pack, settled, share
from graphic_tmm.paper.views import FOLLOWS, FREE_VIEWS, PART_VIEWS, VIEWS
from graphic_tmm.parts import Part
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.words import number
from graphic_tmm.work import Work


def compose(scene: Scene, drawn: Work | None, parts: Sequence[Part] = ()) -> tuple[Sheet, ...]:
    """Return the sheets of a scene, each order followed by the sheets it spills onto.

    ``drawn``: its mechanism as drawn, if it has one; ``parts``: what is drawn beside it.
    """

    def views(plan: str, within: Within) -> list[Drawing]:
        whole = _views(plan, scene, drawn, parts, True)
        return [part for view in whole for part in settled(view, within)]

    laid = _laid(scene, views)
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
        sheets.append(Sheet(name, scene.title, format, width, height, (edge, *placed)))
    return tuple(sheets)


Cells = dict[tuple[object, ...], list[Drawing]]
"""The room of the views of a place, by its name, the sheet it stands on and the μ that it depends on."""
NEAR = 20.0
"""A view that is about so near, mm, to what a sheet holds is measured with its letters."""


class TooLarge(NamedTuple):
    """A view that no sheet of its format holds: the place it belongs to, its name, what share would fit."""

    place: str
    view: str
    share: float


def needed(scene: Scene, drawn: Work | None, parts: Sequence[Part], cells: Cells) -> int:
    """Return how many sheets a scene takes: tried with plans that only take the room they will need.

    ``cells``: what earlier trials of the same scene found, with other μ of the plans; kept up.

    Raises
    ------
    ViewError
        If a view fits no sheet.
    """
    return len(_laid(scene, _measure(scene, drawn, parts, cells)))


def too_large(
    scene: Scene, drawn: Work | None, parts: Sequence[Part], cells: Cells
) -> list[TooLarge]:
    """Return the views that no sheet holds: of the mechanism if it is drawn, and of the parts; see `needed`."""
    room = _measure(scene, drawn, parts, cells)
    kinds = {part.kind for part in parts} | (set(VIEWS) if drawn is not None else set())
    return [
        TooLarge(plan, view.name, share(view, within))
        for order, rooms in _orders(scene)
        for within in (rooms[0].within,)
        for plan in order.place
        if plan in kinds
        for view in room(plan, within)
        if not holds(within, view)
    ]


Measure = Callable[[str, Within], Sequence[Drawing]]


def _measure(scene: Scene, drawn: Work | None, parts: Sequence[Part], cells: Cells) -> Measure:
    """Return how the views of a place are measured, for a sheet: each a cell alone."""

    def room(plan: str, within: Within) -> list[Drawing]:
        key = (plan, within, *_depends(plan, drawn))
        if key not in cells:
            views = _settled(plan, scene, drawn, parts, within)
            cells[key] = [Drawing(view.name, view.title, cell=bounds(view)) for view in views]
        return cells[key]

    return room


def _settled(
    plan: str, scene: Scene, drawn: Work | None, parts: Sequence[Part], within: Within
) -> list[Drawing]:
    """Return the views of a place without letters; with them where only they tell whether a sheet holds it."""
    views = [
        part for view in _views(plan, scene, drawn, parts, False) for part in settled(view, within)
    ]
    if any(_at_the_edge(view, within) for view in views):
        whole = _views(plan, scene, drawn, parts, True)
        views = [part for view in whole for part in settled(view, within)]
    return views


def _at_the_edge(view: Drawing, within: Within) -> bool:
    left, low, right, top = bounds(view)
    wide, high = right - left, top - low
    smaller = within.share(wide - NEAR, high - NEAR) >= 1.0
    return smaller and within.share(wide + NEAR, high + NEAR) < 1.0


def _depends(plan: str, drawn: Work | None) -> list[object]:
    """Return what the room of a place's views depends on: the μ of plans, the sizes of all else."""
    if drawn is None:
        return []
    follows = ("positions", *FOLLOWS.get(plan, ("velocities", "accelerations")))
    scales = [drawn.scales[name].value for name in follows if name in drawn.scales]
    return [*scales, *drawn.sizes.shares]


def _orders(scene: Scene) -> list[tuple[SheetOrder, tuple[Room, Room]]]:
    """Return the sheets ordered, each with the room of its first sheet and of those that follow it."""
    return [
        (order, (_room(order, scene, k == 0), _room(order, scene, False)))
        for k, order in enumerate(scene.sheets)
    ]


def _laid(scene: Scene, views: Measure) -> list[tuple[str, list[Drawing]]]:
    """Return the views placed, sheet by sheet, with the formats of the sheets."""
    laid: list[tuple[str, list[Drawing]]] = []
    for order, rooms in _orders(scene):
        within = rooms[0].within
        there = [view for plan in order.place for view in views(plan, within)]
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
