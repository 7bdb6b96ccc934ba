"""What a sheet of a format shows: its room, the views of its places; what is told of one far too large."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.absent import chapter_title
from graphic_tmm.fitting.views import Views, drawing_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import FORMATS, growing
from graphic_tmm.scene.chapter import Chapter, places
from graphic_tmm.scene.records import Scene

if TYPE_CHECKING:
    from graphic_tmm.paper.compose.sheets import Order, Shared
    from graphic_tmm.paper.compose.units import Outline
    from graphic_tmm.paper.drawing import Drawing
    from graphic_tmm.paper.packing import Room

WIDE = 150.0
"""How wide a sentence is that stands for a chapter, mm."""
NOTHING = said("There is no result")
FAR_TOO_LARGE = 0.55
"""A format is far too large if one of no more than this share of its area holds the same views."""


def room_on(format: str, language: str, first: bool) -> Room:
    """Return the room of a sheet, the first of a set or one that follows."""
    from graphic_tmm.paper.packing import Room
    from graphic_tmm.paper.sheet_frame import drawing_area

    area = drawing_area(format, language, first)
    return Room(area.inner, area.occupied)


def views_of(place: str, scene: Scene, boards: Sequence[Drawn], lettered: bool) -> list[Drawing]:
    """Return the views of a place as they are drawn, before any of them comes apart."""
    chapter = places()[place][0]
    if chapter.name in scene.left_out:
        return left_out(scene, chapter, place)
    if not chapter.board:
        plain = Views.of(chapter).plain.get(place)
        return plain(scene) if plain is not None else []
    there = [one for one in boards if one.board == chapter.board]
    return [view for one in there for view in drawing_of(place)(one, lettered)]


def left_out(scene: Scene, chapter: Chapter, place: str) -> list[Drawing]:
    """Return what a sheet shows of a chapter that is left out: a sentence, in the first of its places.

    No sheet is drawn for the sake of it: where nothing else is ordered there is none.
    """
    from graphic_tmm.paper.formats import heights
    from graphic_tmm.paper.lettering.letters import escape
    from graphic_tmm.paper.ruled import ruled_table
    from graphic_tmm.paper.views import wrapped

    known = places()
    orders = [[known[name][0].name for name in sheet.place] for sheet in scene.sheets]
    drawn = [k for k, names in enumerate(orders) if not scene.left_out.keys() >= set(names)]
    own = (one for k in drawn for one in scene.sheets[k].place if known[one][0] is chapter)
    if place != next(own, ""):
        return []
    high, speech = heights(scene, place), speaking(scene.language)
    told = wrapped(escape(speech(scene.left_out[chapter.name])), high.number, WIDE)
    name, title = f"table-{chapter.name}-left-out", speech(chapter_title(chapter))
    rows = [[line] for line in told]
    sizes = {"size": high.number, "title_size": high.title}
    return [ruled_table(name, title, [speech(NOTHING)], rows, align=["left"], **sizes)]


def oversized(
    orders: Sequence[Order], laid: Sequence[tuple[Shared, object]], language: str
) -> tuple[str, ...]:
    """Return what is told of sheets ordered far too large: a format of half the area holds the same views."""
    boxes = [outline for order in orders for outline in order.outlines]
    told = []
    for sheet, _ in laid:
        ordered = orders[sheet.order].format
        smaller = _holding([boxes[k] for k in sheet.boxes], ordered, language)
        if smaller:
            told.append(
                said(
                    "sheet {number}: {ordered} is far too large for it: {smaller} holds the same views; "
                    'write format = "{smaller2}", or "auto"',
                    number=sheet.order + 1,
                    ordered=ordered,
                    smaller=smaller,
                    smaller2=smaller,
                )
            )
    return tuple(dict.fromkeys(told))


def _holding(boxes: Sequence[Outline], ordered: str, language: str) -> str:
    """Return the smallest format that holds boxes, if the one ordered is far larger; "" if none is."""
    from graphic_tmm.paper.compose.search import fits

    area = FORMATS[ordered].width * FORMATS[ordered].height
    for format in growing():
        one = FORMATS[format]
        if one.width * one.height > FAR_TOO_LARGE * area:
            return ""
        if fits(boxes, room_on(format, language, True)) is not None:
            return format
    return ""
