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
"""As large as usual on which format views are to find out whether one holds them."""
SMALL, SURE = 0.5, 0.8
"""Views take no less than these shares of what is reckoned for them on A2: on smaller formats, there itself."""
FORMATTED = "formatted"
"""What is kept beside a scene: the same with formats."""


def formatted(scene: Scene, given: Composition | None = None) -> Scene:
    """Return a scene in which every sheet has a format: for "auto" the smallest that holds its views.

    A composition that is ``given`` tells which.
    """
    told = {sheet.order: sheet.format for sheet in given.sheets} if given is not None else {}
    scene = _as_told(scene, told)
    if all(order.format != AUTO for order in scene.sheets):
        return scene
    kept: Scene | None = scene.cache.get(FORMATTED) if given is None else None
    if kept is not None:
        return kept
    tried = _Tried(scene)
    formats = (
        order.format if order.format != AUTO else told.get(k) or tried.smallest(k)
        for k, order in enumerate(scene.sheets)
    )
    made, _ = tried.on(tuple(formats))
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


class _Tried:
    """A scene with formats that are tried."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self._on: dict[tuple[str, ...], tuple[Scene, list[Board]]] = {}

    def on(self, formats: tuple[str, ...]) -> tuple[Scene, list[Board]]:
        """Return the scene with formats of its sheets, and its boards."""
        if formats not in self._on:
            sheets = (
                replace(order, format=format, chosen=order.chosen or order.format == AUTO)
                for order, format in zip(self.scene.sheets, formats, strict=True)
            )
            other = replace(self.scene, sheets=tuple(sheets))
            there = _boards(self.scene)
            pass_on(self.scene, other)
            self._on[formats] = other, _boards(other) if there else []
        return self._on[formats]

    def smallest(self, order: int) -> str:
        """Return the smallest format that holds what is ordered; the usual one if that takes several sheets.

        Views are drawn once more only where it is not clear from those on the usual format.
        """
        large, drawn = self.on((USUAL,) * len(self.scene.sheets))
        scene, boards = self.on((SENSIBLE,) * len(self.scene.sheets))
        rooms = Rooms.of(large, drawn, usual(large)).on(scene, boards)
        taken = rooms.share(order, usual(scene)) * rooms.sheets[order][0].area
        for format in growing():
            room, like = room_on(format, self.scene.language, True), TRIED[format.split()[0]]
            if (SURE if like == SENSIBLE else SMALL) * taken > room.area:
                continue
            scene, boards = self.on((like,) * len(self.scene.sheets))
            sizes = usual(scene)
            if fits(Rooms.of(scene, boards, sizes).outlines(order, sizes), room) is not None:
                return format
        return USUAL


def _boards(scene: Scene) -> list[Board]:
    """Return the boards of a scene; none if one of them cannot be made, which is refused later."""
    try:
        return boards_of(scene, mechanism=scene.mechanism is not None)
    except TmmError:
        return []
