"""What room the views of a scene take before they are lettered: how many sheets they need, what fits none."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import ViewError
from graphic_tmm.fitting.compose import orders
from graphic_tmm.fitting.formats import views_of
from graphic_tmm.fitting.sizes import Sizes, sizes_of
from graphic_tmm.fitting.tried import Board
from graphic_tmm.fitting.views import pieces
from graphic_tmm.paper.compose.search import fits
from graphic_tmm.paper.compose.sheets import Order, shared
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.paper.packing import bounds, holds, in_pieces, share
from graphic_tmm.scene.chapter import places
from graphic_tmm.scene.records import Scene

NEAR = 32.0
"""A view that is about so near, mm, to what a sheet holds is measured with its letters. Chosen by eye."""
WIDE = 0.7
"""What a view's width counts against its height: sheets that lie are so much higher than wide."""

SLACK = 0.5
"""How much larger, mm, than with the exact hand a view may come out by the scene's own."""

Key = tuple[object, ...]
Draw = Callable[[Drawn, bool], list[Drawing]]
Cells = list[Drawing]
"""The room of views: each a cell alone."""


class TooLarge(NamedTuple):
    """A view that no sheet of its format holds: the place it belongs to, its role, what share would fit."""

    place: str
    role: str
    share: float


class SheetView(NamedTuple):
    """A view on a sheet: its place, its cell, what a sheet of its order offers, how high that is (mm)."""

    place: str
    view: Drawing
    within: Within
    height: float


class Rooms:
    """The room that the views of a scene take in sizes that are tried; each is drawn and measured once.

    ``lettered``: with their letters, which takes most of the time; else those are only allowed for.
    """

    def __init__(self, scene: Scene, boards: Sequence[Board], *, lettered: bool = False) -> None:
        self.scene, self.lettered = scene, lettered
        self.boards = {board.name: board for board in boards}
        self.orders = orders(scene)
        self._cells: dict[Key, Cells] = {}
        self._depends: dict[tuple[str, Draw], tuple[str, ...]] = {}
        self._counts: dict[Key, float] = {}
        self._several: set[Key] = set()
        self._last: dict[tuple[str, Draw], tuple[Key, list[Drawing]]] = {}

    def count(self, sizes: Sizes) -> float:
        """Return how many sheets the scene takes; without end if one of its views fits none."""
        return sum(self._sheets(k, sizes) for k in range(len(self.orders)))

    def takes_more(self, sizes: Sizes, most: float) -> bool:
        """Whether the scene takes more sheets than ``most``; how many more nobody is told."""
        left = most
        for number in range(len(self.orders)):
            later = range(number + 1, len(self.orders))
            others = sum(any(True for _ in self._of(k, sizes)) for k in later)
            left -= self._sheets(number, sizes, left - others)
            if left < 0:
                return True
        return False

    def _sheets(self, number: int, sizes: Sizes, most: float = math.inf) -> float:
        """Return how many sheets an order takes; without end if that is more than ``most`` and soon known."""
        order, rooms = self.orders[number]
        key = (number, *(self._key(place, sizes) for place in self._single(order.place)))
        if key in self._several and most <= 1:
            return math.inf
        if key not in self._counts:
            outlines = self._outlines(number, sizes)
            if most <= 1 and len(outlines) > 1:
                if fits(outlines, rooms[0]) is None:
                    self._several.add(key)
                    return math.inf
                self._counts[key] = 1
                return 1
            try:
                wanted = [Order(tuple(outlines), rooms, order.format)]
                enough = most if math.isfinite(most) else 0.0
                self._counts[key] = len(shared(wanted, enough=enough))
            except ViewError:
                self._counts[key] = math.inf
        return self._counts[key]

    def _outlines(self, number: int, sizes: Sizes) -> list[Outline]:
        within = self.orders[number][1][0].within
        return [_wider(Outline.of(one.view), within) for one in self._of(number, sizes)]

    def together(self, sizes: Sizes) -> float:
        """Return how many sheets the scene takes if what is left over of an order may stand on another's.

        That is what is composed in the end; `count` is sooner known, and never less.
        """
        wanted = [
            Order(tuple(self._outlines(k, sizes)), rooms, order.format)
            for k, (order, rooms) in enumerate(self.orders)
        ]
        try:
            return len(shared(wanted))
        except ViewError:
            return math.inf

    def too_large(self, sizes: Sizes) -> list[TooLarge]:
        """Return the views of boards that no sheet holds."""
        return [
            TooLarge(one.place, one.view.role, share(one.view, one.within))
            for one in self.sheet_views(sizes)
            if places()[one.place][0].board in self.boards and not holds(one.within, one.view)
        ]

    def holding(self, number: int, sizes: Sizes) -> Iterator[bool]:
        """Yield of each view of an order whether a sheet of it holds the view."""
        return (holds(one.within, one.view) for one in self._of(number, sizes))

    def near(self, sizes: Sizes) -> bool:
        """Whether a view is about as large as what a sheet holds: then its letters tell whether it does."""
        return any(_at_the_edge(one.view, one.within) for one in self.sheet_views(sizes))

    def large(self, size: str, sizes: Sizes) -> float:
        """Return what share of their sheet's height the views take that depend on a size, at most."""
        return max((_share(one) for one in self._depending(size, sizes)), default=0.0)

    def views(self, size: str, sizes: Sizes) -> int:
        """Return how many views depend on a size."""
        return len(list(self._depending(size, sizes)))

    def _depending(self, size: str, sizes: Sizes) -> Iterator[SheetView]:
        for one in self.sheet_views(sizes):
            if size in sizes_of(one.place, one.view.role, self.scene):
                yield one

    def fill(self, size: str, sizes: Sizes) -> float:
        """Return how full the emptiest order is of which a view depends on a size: boxes by free room."""
        found = [1.0]
        for number, (_, rooms) in enumerate(self.orders):
            views = list(self._of(number, sizes))
            if any(size in sizes_of(v.place, v.view.role, self.scene) for v in views):
                taken = sum(_area(bounds(one.view)) for one in views)
                room = _area(rooms[0].inner) - sum(map(_area, rooms[0].occupied))
                found.append(taken / (self._sheets(number, sizes) * room))
        return float(min(found))

    def sheet_views(self, sizes: Sizes) -> Iterator[SheetView]:
        """Yield the views of all sheets."""
        for number in range(len(self.orders)):
            yield from self._of(number, sizes)

    def _of(self, number: int, sizes: Sizes) -> Iterator[SheetView]:
        order, rooms = self.orders[number]
        within, format = rooms[0].within, FORMATS[order.format]
        height = min(format.height, format.width / WIDE)
        for place in self._single(order.place):
            for view in self._room(place, within, sizes):
                yield SheetView(place, view, within, height)

    def _single(self, named: Sequence[str]) -> Iterator[str]:
        known = places()
        for place in named:
            yield from known[place][1].together or (place,)

    def _room(self, place: str, within: Within, sizes: Sizes) -> Cells:
        found: Cells = []
        for piece in pieces(place):
            key = (within, *self._of_piece(place, piece, sizes))
            if key not in self._cells:
                whole = self._views(place, piece, sizes)
                self._cells[key] = [part for view in whole for part in _parts(view, within)]
            found += self._cells[key]
        return found

    def _views(self, place: str, piece: Draw, sizes: Sizes) -> list[Drawing]:
        """Return the views of a piece of a place as they are drawn, before any of them comes apart."""
        board = self._board(place)
        if board is None:
            return views_of(place, self.scene, (), self.lettered)
        key = tuple(sizes[name] for name in board.sizes)
        own = (place, piece)
        if own not in self._last or self._last[own][0] != key:
            self._last[own] = (key, piece(board.draw(sizes), self.lettered))
        return self._last[own][1]

    def _board(self, place: str) -> Board | None:
        """Return the board on which a place stands; None if its chapter has none, or is left out."""
        chapter = places()[place][0]
        return None if chapter.name in self.scene.left_out else self.boards.get(chapter.board)

    def _key(self, place: str, sizes: Sizes) -> Key:
        """Return what the room of a place's views depends on."""
        return tuple(self._of_piece(place, piece, sizes) for piece in pieces(place))

    def _of_piece(self, place: str, piece: Draw, sizes: Sizes) -> Key:
        """Return what the room of a piece of a place depends on."""
        shown = places()[place][1]
        board, own = self._board(place), (place, piece)
        if board is None:
            return own
        if own not in self._depends:
            views = self._views(place, piece, sizes)
            found = [*shown.follows]
            found += [name for view in views for name in sizes_of(place, view.role, self.scene)]
            self._depends[own] = tuple(n for n in dict.fromkeys(found) if n in board.sizes)
        return (*own, *(board.comes_of(name, sizes) for name in self._depends[own]))


def sheets_of(scene: Scene, boards: Sequence[Drawn]) -> int:
    """Return how many sheets the boards of a scene take.

    Raises
    ------
    ViewError
        If a view fits no sheet.
    """
    wanted = []
    for order, rooms in orders(scene):
        there = [
            Outline.of(view)
            for place in order.place
            for view in cells(place, scene, boards, rooms[0].within, lettered=True)
        ]
        wanted.append(Order(tuple(there), rooms, order.format))
    return len(shared(wanted))


def cells(
    place: str, scene: Scene, boards: Sequence[Drawn], within: Within, lettered: bool
) -> Cells:
    """Return the room of the views of a place, each as it comes apart where no sheet holds it."""
    if several := places()[place][1].together:
        return [view for one in several for view in cells(one, scene, boards, within, lettered)]
    whole = views_of(place, scene, boards, lettered)
    return [part for view in whole for part in _parts(view, within)]


def _parts(view: Drawing, within: Within) -> Cells:
    return [
        Drawing(
            part.name,
            part.title,
            cell=bounds(part),
            stand=part.stand,
            foot=part.foot,
            role=part.role,
        )
        for part in in_pieces(view, within)
    ]


def _wider(outline: Outline, within: Within) -> Outline:
    """Return a box as large as it may come out by the scene's own hand, if a sheet holds it then."""
    wide, high = outline.width + SLACK, outline.height + SLACK
    return outline._replace(width=wide, height=high) if within.share(wide, high) >= 1.0 else outline


def _at_the_edge(view: Drawing, within: Within) -> bool:
    left, low, right, top = bounds(view)
    wide, high = right - left, top - low
    smaller = within.share(wide - NEAR, high - NEAR) >= 1.0
    return smaller and within.share(wide + NEAR, high + NEAR) < 1.0


def _area(box: tuple[float, float, float, float]) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])


def _share(shown: SheetView) -> float:
    left, low, right, top = bounds(shown.view)
    return max(top - low, WIDE * (right - left)) / shown.height
