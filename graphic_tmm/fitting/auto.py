"""The formats of sheets that leave theirs open: for "auto" the smallest that holds what is ordered."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.formats import room_on
from graphic_tmm.fitting.rooms import Rooms
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.fitting.tried import Board, boards_of, pass_on
from graphic_tmm.paper.compose.search import fits
from graphic_tmm.paper.formats import AUTO, SENSIBLE, USUAL, growing, turned
from graphic_tmm.scene.records import Scene

TRIED = {"A4": "A4", "A3": "A3", "A2": "A2", "A1": "A2"}
"""As large as usual on which format views are measured to find out whether one holds them."""
SMALL = 0.5
"""On the smallest format views take no less than this share of what they take on the middle one."""
FORMATTED = "formatted"
"""What is kept beside a scene: the same with formats."""


def formatted(scene: Scene, given: Composition | None = None) -> Scene:
    """Return a scene in which every sheet has a format: for "auto" the smallest that holds its views.

    A composition that is ``given`` tells which. To find out, views are measured in sizes usual on it.
    """
    told = {sheet.order: sheet.format for sheet in given.sheets} if given is not None else {}
    scene = _as_told(scene, told)
    if all(order.format != AUTO for order in scene.sheets):
        return scene
    kept: Scene | None = scene.cache.get(FORMATTED) if given is None else None
    if kept is not None:
        return kept
    measured: dict[str, Rooms] = {}
    found = [
        order
        if order.format != AUTO
        else replace(order, format=told.get(k) or _smallest(scene, k, measured), chosen=True)
        for k, order in enumerate(scene.sheets)
    ]
    made = replace(scene, sheets=tuple(found))
    pass_on(scene, made)
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


def _smallest(scene: Scene, order: int, measured: dict[str, Rooms]) -> str:
    """Return the smallest format that holds what is ordered; the usual one where that takes several sheets."""
    large = _measured(scene, SENSIBLE, measured)
    taken = SMALL * large.share(order, large.natural) * large.sheets[order][0].area
    for format in growing():
        room = room_on(format, scene.language, True)
        if taken > room.area:
            continue
        rooms = _measured(scene, TRIED[format.split()[0]], measured)
        if fits(rooms.outlines(order, rooms.natural), room) is not None:
            return format
    return USUAL


def _measured(scene: Scene, format: str, measured: dict[str, Rooms]) -> Rooms:
    """Return the room of a scene's views in the sizes usual on a format."""
    if format not in measured:
        tried = replace(scene, sheets=tuple(replace(one, format=format) for one in scene.sheets))
        boards = (board.of(tried) for board in _boards(scene))
        measured[format] = Rooms(tried, list(boards), usual(tried))
    return measured[format]


def _boards(scene: Scene) -> list[Board]:
    """Return the boards of a scene; none if one of them cannot be made, which is refused later."""
    try:
        return boards_of(scene, mechanism=scene.mechanism is not None)
    except TmmError:
        return []
