"""From drawn boards to sheets: their views packed onto paper, each sheet in its frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from graphic_tmm.chapter import places
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.numbers import number
from graphic_tmm.paper.compose.sheets import Order, composed, moved, shared
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import Drawing, Sheet, Within
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.frame.frame import drawing_area, frame
from graphic_tmm.paper.packing import Room, settled
from graphic_tmm.scene.records import Scene, SheetOrder

LENGTHS = "μ_l"
"""The symbol of the scale factors of which the title block tells the first."""


def compose(scene: Scene, boards: Sequence[Drawn]) -> tuple[Sheet, ...]:
    """Return the sheets of a scene, each order followed by the sheets it spills onto."""

    def views(place: str, within: Within) -> list[Drawing]:
        whole = views_of(place, scene, boards, True)
        return [part for view in whole for part in settled(view, within)]

    placed_views = laid(scene, views)
    count = len(placed_views)
    sheets = []
    for index, (format, placed) in enumerate(placed_views):
        edge = frame(
            format,
            language=scene.language,
            first=index == 0,
            number=index + 1,
            count=count,
            fields=_fields(scene, boards),
        )
        name = f"sheet-{index + 1}" if count > 1 else "sheet"
        width, height = size_of(format)
        drawings = (edge, *placed)
        sheets.append(Sheet(name, scene.title, format, width, height, drawings, scene.language))
    return tuple(sheets)


Views = Callable[[str, Within], Sequence[Drawing]]
"""The views of a place, for what a sheet offers."""


def orders(scene: Scene) -> list[tuple[SheetOrder, tuple[Room, Room]]]:
    """Return the sheets ordered, each with the room of its first sheet and of those that follow it."""
    return [
        (order, (_room(order, scene, k == 0), _room(order, scene, False)))
        for k, order in enumerate(scene.sheets)
    ]


def laid(scene: Scene, views: Views) -> list[tuple[str, list[Drawing]]]:
    """Return the views placed, sheet by sheet, with the formats of the sheets."""
    wanted, there = _wanted(scene, views)
    boxes = [outline for order in wanted for outline in order.outlines]
    return [
        (
            wanted[sheet.order].format,
            [moved(there[k], boxes[k], at) for k, at in sorted(places.items())],
        )
        for sheet, places in composed(wanted)
    ]


def counted(scene: Scene, views: Views) -> int:
    """Return how many sheets views take, found fast; raises as `laid`."""
    wanted, _ = _wanted(scene, views)
    return len(shared(wanted))


def _wanted(scene: Scene, views: Views) -> tuple[list[Order], list[Drawing]]:
    """Return the orders of a scene's sheets as boxes, and the views of all of them in the same order."""
    found, there = list[Order](), list[Drawing]()
    for order, rooms in orders(scene):
        within = rooms[0].within
        own = [view for place in order.place for view in views(place, within)]
        found.append(Order(tuple(Outline.of(view) for view in own), rooms, order.format))
        there += own
    return found, there


def views_of(place: str, scene: Scene, boards: Sequence[Drawn], lettered: bool) -> list[Drawing]:
    """Return the views of a place as they are drawn, before any of them comes apart."""
    chapter, shown = places()[place]
    if not chapter.board:
        return shown.plain(scene)
    there = [one for one in boards if one.board == chapter.board]
    return [view for one in there for view in shown.draw(one, lettered)]


def _room(order: SheetOrder, scene: Scene, first: bool) -> Room:
    area = drawing_area(order.format, scene.language, first)
    return Room(area.inner, area.occupied)


def _fields(scene: Scene, boards: Sequence[Drawn]) -> dict[str, str]:
    fields = dict(scene.title_block)
    fields.setdefault("name", scene.title)
    scales = [s for one in boards for s in one.scales.values() if s.symbol == LENGTHS]
    if scales:
        reduction = scales[0].value * 1000.0
        fields.setdefault("scale", _ratio(reduction, scene.language))
    return fields


def _ratio(reduction: float, language: str) -> str:
    """Return a scale as the title block writes it: 1:4, 2,5:1."""
    if reduction >= 1:
        return f"1:{number(reduction, language)}"
    return f"{number(1 / reduction, language)}:1"
