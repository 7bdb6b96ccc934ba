"""The formats of sheets: the room of each, the smallest for "auto", and what is told of one far too large."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.absent import chapter_title
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.fitting.tried import Board, Mechanism, PartBoard
from graphic_tmm.fitting.views import Views, drawing_of
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import AUTO, FORMATS, USUAL, growing, turned
from graphic_tmm.project import own_boards
from graphic_tmm.scene.chapter import Chapter, places
from graphic_tmm.scene.records import Scene, SheetOrder

if TYPE_CHECKING:
    from graphic_tmm.paper.compose.sheets import Order, Shared
    from graphic_tmm.paper.compose.units import Outline
    from graphic_tmm.paper.drawing import Drawing
    from graphic_tmm.paper.packing import Room

TRIED = {"A4": "A4", "A3": "A3", "A2": "A2", "A1": "A2"}
"""As large as usual on which format things are drawn to find out whether one holds them."""
WIDE = 150.0
"""How wide a sentence is that stands for a chapter, mm."""
NOTHING = said("There is no result")
FORMATTED = "formatted"
"""What is kept beside a scene: the same with formats."""
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
    """Return what a sheet shows of a chapter that is left out: a sentence, in the first of its places."""
    from graphic_tmm.paper.formats import heights
    from graphic_tmm.paper.lettering.letters import escape
    from graphic_tmm.paper.ruled import ruled_table
    from graphic_tmm.paper.views import wrapped

    order = [one for sheet in scene.sheets for one in sheet.place]
    if place != next(one for one in order if places()[one][0] is chapter):
        return []
    high, speech = heights(scene, place), speaking(scene.language)
    told = wrapped(escape(speech(scene.left_out[chapter.name])), high.number, WIDE)
    name, title = f"table-{chapter.name}-left-out", speech(chapter_title(chapter))
    rows = [[line] for line in told]
    sizes = {"size": high.number, "title_size": high.title}
    return [ruled_table(name, title, [speech(NOTHING)], rows, align=["left"], **sizes)]


def formatted(scene: Scene, given: Composition | None = None) -> Scene:
    """Return a scene in which every sheet has a format: for "auto" the smallest that holds its views.

    A composition that is ``given`` tells which. To find out, things are drawn in the size usual for a format.
    """
    told = {sheet.order: sheet.format for sheet in given.sheets} if given is not None else {}
    scene = _as_told(scene, told)
    if all(order.format != AUTO for order in scene.sheets):
        return scene
    kept: Scene | None = scene.cache.get(FORMATTED) if given is None else None
    if kept is not None:
        return kept
    drawn: dict[str, list[Drawn]] = {}
    found = [
        order
        if order.format != AUTO
        else replace(order, format=told.get(k) or _smallest(scene, order, drawn), chosen=True)
        for k, order in enumerate(scene.sheets)
    ]
    made = replace(scene, sheets=tuple(found))
    if given is None:
        scene.cache[FORMATTED] = made
    return made


def _as_told(scene: Scene, told: Mapping[int, str]) -> Scene:
    """Return a scene in which the sheets are turned that a composition (formats by order) has turned."""
    over = {
        k: replace(order, format=told[k])
        for k, order in enumerate(scene.sheets)
        if k in told and order.format != AUTO and told[k] == turned(order.format)
    }
    if not over:
        return scene
    return replace(scene, sheets=tuple(over.get(k, one) for k, one in enumerate(scene.sheets)))


def _smallest(scene: Scene, order: SheetOrder, drawn: dict[str, list[Drawn]]) -> str:
    """Return the smallest format that holds what is ordered; the usual one where that takes several sheets."""
    from graphic_tmm.paper.compose.search import fits
    from graphic_tmm.paper.compose.units import Outline
    from graphic_tmm.paper.packing import in_pieces

    for format in growing():
        like = TRIED[format.split()[0]]
        sheets = tuple(replace(one, format=like) for one in scene.sheets)
        tried = replace(scene, sheets=sheets)
        if like not in drawn:
            drawn[like] = list(_boards(tried))
        room = room_on(format, scene.language, True)
        views = [
            part
            for place in order.place
            for view in views_of(place, tried, drawn[like], False)
            for part in in_pieces(view, room.within)
        ]
        if fits([Outline.of(view) for view in views], room) is not None:
            return format
    return USUAL


def _boards(scene: Scene) -> Iterator[Drawn]:
    """Yield the boards of a scene drawn in their usual sizes; what cannot be drawn is refused later."""
    made: list[Callable[[], Board]] = [
        partial(PartBoard, scene, board) for board in own_boards(scene)
    ]
    if scene.mechanism is not None:
        made.append(partial(Mechanism, scene))
    for make in made:
        with suppress(TmmError):
            yield make().draw(usual(scene))


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
