"""The room that views take: measured once in natural sizes, without letters, and reckoned for all others.

Of a view drawn r times larger the lines are r times larger, not what goes around: signs, letters, captions.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from copy import copy
from typing import NamedTuple

from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import ViewError
from graphic_tmm.fitting.compose import orders
from graphic_tmm.fitting.formats import views_of
from graphic_tmm.fitting.sizes import Sizes, all_sizes, sizes_of
from graphic_tmm.fitting.tried import Board
from graphic_tmm.paper.compose.search import fits
from graphic_tmm.paper.compose.sheets import Order, shared
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import EQUATIONS, GRAPH, TABLE, Drawing, Label, Within
from graphic_tmm.paper.packing import GAP, Room, bounds, in_pieces, share
from graphic_tmm.paper.shapes import corners
from graphic_tmm.scene.chapter import places
from graphic_tmm.scene.records import Scene

SIGNS = 10.0
"""What is as large in all sizes of the lines of a view, mm: pairs, arrows, hatching."""
AROUND = 12.0
"""What letters take on both sides of lines where a caption is wider than these, mm."""
LETTERS = 5.0
"""How much larger, mm, a view may come out with its letters: 19 in 20 of those of the gallery."""
SPILL = 5.0
"""By how much more to be sure of a sheet: of 1,700 views 19 in 20 are within 4 mm in width, 7 in height."""
LESS = 0.95
"""By how much at least a size gives way at a time."""
EDGE = 6.0
"""How much wider, mm, a view may come out with its letters where a sheet is hardly wide enough."""
FILLED = 0.7
"""What share of its free room a full sheet shows as boxes of views."""
ROOMS = "rooms"
"""What is kept beside a scene: the room of its views, by the sizes in which they were measured."""
FIXED = (TABLE, EQUATIONS)
"""What is as large in all sizes."""


class ViewBox(NamedTuple):
    """A view on a sheet: its place, its role, its box in natural sizes, the free sizes that it depends on.

    ``lines``: the width and the height of its lines, ``caption``: the width of its widest lettering, mm.
    """

    place: str
    role: str
    outline: Outline
    sizes: tuple[str, ...]
    lines: tuple[float, float] = (0.0, 0.0)
    caption: float = 0.0

    @classmethod
    def of(cls, place: str, view: Drawing, sizes: tuple[str, ...]) -> ViewBox:
        """Return the box of a view as drawn."""
        found = Outline.of(view)
        if view.role in FIXED or not view.strokes:
            return cls(place, view.role, found, ())
        left, low, right, top = bounds(view._replace(labels=(), cell=None))
        caption = max((_width(label) for label in view.labels), default=0.0)
        box = found._replace(width=found.width + LETTERS, height=found.height + LETTERS)
        return cls(place, view.role, box, sizes, (right - left, top - low), caption)

    def times(self, wide: float, high: float) -> Outline:
        """Return the box of it drawn so many times wider and higher."""
        box, (across, up) = self.outline, self.lines
        ruled = box.width - LETTERS <= self.caption + 1.0
        beside = min(box.width - across, AROUND) if ruled else box.width - across
        width = max(self.caption + LETTERS, _larger(across, wide) + beside)
        return box._replace(width=width, height=_larger(up, high) + box.height - up)


class Rooms:
    """The views of a scene's sheets as boxes; ``natural``: the sizes in which they were measured."""

    def __init__(self, scene: Scene, boards: Sequence[Board], natural: Sizes) -> None:
        self.scene, self.natural = scene, natural
        self.boards = self.others = {board.name: board for board in boards}
        self.sheets = [rooms for _, rooms in orders(scene)]
        drawn = {board.name: board.draw(natural) for board in boards}
        self.views = [
            list(self._boxes(order.place, drawn, rooms[0].within))
            for order, rooms in zip(scene.sheets, self.sheets, strict=True)
        ]

    def _boxes(
        self, ordered: Sequence[str], drawn: Mapping[str, Drawn], within: Within
    ) -> Iterator[ViewBox]:
        known = all_sizes(self.scene)
        single = (one for name in ordered for one in places()[name][1].together or (name,))
        for place in single:
            for whole in views_of(place, self.scene, list(drawn.values()), False):
                own = sizes_of(place, whole.role, self.scene) if whole.role not in FIXED else ()
                free = tuple(name for name in own if not known[name].fixed(self.scene))
                for view in in_pieces(whole, within):
                    yield ViewBox.of(place, view, free)

    @classmethod
    def of(cls, scene: Scene, boards: Sequence[Board], natural: Sizes) -> Rooms:
        """Return the room of a scene's views in natural sizes, drawn once."""
        key = (ROOMS, tuple(board.name for board in boards), tuple(natural.items()))
        if key not in scene.cache:
            scene.cache[key] = cls(scene, boards, natural)
        found: Rooms = scene.cache[key]
        return found

    def on(self, scene: Scene, boards: Sequence[Board]) -> Rooms:
        """Return the views as reckoned for other formats of a scene's sheets: they are not drawn again."""
        other = copy(self)
        other.scene, other.sheets = scene, [rooms for _, rooms in orders(scene)]
        other.others = {board.name: board for board in boards}
        return other

    def names(self, order: int) -> tuple[str, ...]:
        """Return the free sizes on which an order's views depend."""
        return tuple(dict.fromkeys(name for view in self.views[order] for name in view.sizes))

    def outlines(self, order: int, sizes: Sizes) -> list[Outline]:
        """Return the boxes of an order's views in some sizes."""
        return [self.outline(view, sizes) for view in self.views[order]]

    def outline(self, view: ViewBox, sizes: Sizes) -> Outline:
        """Return the box of a view in some sizes."""
        wide, high = self._times(view, sizes)
        return view.outline if wide == high == 1.0 else view.times(wide, high)

    def _times(self, view: ViewBox, sizes: Sizes) -> tuple[float, float]:
        """Return how many times wider and higher what a view shows is than in natural sizes."""
        if not view.sizes:
            return 1.0, 1.0
        share = sizes[view.sizes[0]] / self.natural[view.sizes[0]]
        board = self.boards.get(places()[view.place][0].board)
        if board is None:
            return share, share
        was, now = board.lengths(self.natural), self.others[board.name].lengths(sizes)
        shown = [name for name in view.outline.shows if name in was and name in now]
        if not shown:
            return share, share
        larger = [now[name][0] / was[name][0] for name in shown]
        if view.role != GRAPH:
            # a figure may show links beside what it is called by, to the scale of their own plan
            plans = (now[name][0] / was[name][0] for name in view.sizes if name in was)
            most = max([larger[0], *plans])
            return most, most
        bases = (now[name][1] / was[name][1] for name in shown if was[name][1])
        return next(bases, share), sum(larger) / len(larger)

    def fits(self, order: int, sizes: Sizes, *, tables: bool = True, letters: bool = True) -> bool:
        """Whether the first sheet of an order holds all its views.

        Or all but ``tables``, if these may go; without what is allowed for ``letters``, where all else fails.
        """
        views = [view for view in self.views[order] if tables or view.role != TABLE]
        boxes = [self.outline(view, sizes) for view in views]
        if not letters:
            boxes = [
                box._replace(width=box.width - LETTERS, height=box.height - LETTERS)
                if view.caption or view.sizes
                else box
                for view, box in zip(views, boxes, strict=True)
            ]
        return fits(boxes, self.sheets[order][0]) is not None

    def sheets_of(self, order: int, sizes: Sizes, spill: float = 0.0) -> float:
        """Return how many sheets an order takes by itself; without end if none holds one of its views.

        ``spill``: how much larger its views may come out than they are reckoned, mm.
        """
        try:
            return len(shared([self._order(order, sizes, spill)], even=False))
        except ViewError:
            return math.inf

    def emptiest(self, order: int, sizes: Sizes) -> float:
        """Return what share of the emptiest of the sheets of an order boxes take, by itself."""
        of = self._order(order, sizes)
        try:
            sheets = shared([of])
        except ViewError:
            return 0.0
        taken = [sum(of.outlines[k].width * of.outlines[k].height for k in s.boxes) for s in sheets]
        shares = (t / one.room.area for t, one in zip(taken, sheets, strict=True))
        return min(shares, default=0.0)

    def _order(self, order: int, sizes: Sizes, spill: float = 0.0) -> Order:
        boxes = (
            box._replace(width=box.width + spill, height=box.height + spill) if view.sizes else box
            for view, box in zip(self.views[order], self.outlines(order, sizes), strict=True)
        )
        return Order(tuple(boxes), self.sheets[order], self.scene.sheets[order].format)

    def share(self, order: int, sizes: Sizes) -> float:
        """Return what share of a sheet's free room the views of an order take, each with its gap."""
        taken = sum((b.width + GAP) * (b.height + GAP) for b in self.outlines(order, sizes))
        return taken / self.sheets[order][0].area

    def too_large(self, sizes: Sizes) -> Iterator[tuple[str, float]]:
        """Yield, for each view that no sheet of its format holds, the size to give way, and what share fits.

        That is the first that makes the view smaller where it is too large: an author may have fixed lengths.
        """
        known = all_sizes(self.scene)
        for boxes, rooms in zip(self.views, self.sheets, strict=True):
            for view in boxes:
                share = self._share(view, rooms[0], sizes)
                for name in view.sizes if share < 1.0 else ():
                    half = {**sizes, name: 0.5 * sizes[name]}
                    if (
                        sizes[name] > known[name].least
                        and self._share(view, rooms[0], half) > share
                    ):
                        yield name, share
                        break

    def _share(self, view: ViewBox, room: Room, sizes: Sizes) -> float:
        box = self.outline(view, sizes)
        return room.within.share(box.width + EDGE, box.height)

    def over(self) -> list[int]:
        """Return the orders (indices) of which a view fits no sheet in the sizes measured."""
        return [
            k
            for k, (boxes, rooms) in enumerate(zip(self.views, self.sheets, strict=True))
            if any(_alone(view.outline, rooms[0]) < 1.0 for view in boxes)
        ]

    def fill(self, size: str, sizes: Sizes) -> float:
        """Return how full the emptiest order is that shows something of a size: boxes by free room."""
        found = [1.0]
        for k, (views, rooms) in enumerate(zip(self.views, self.sheets, strict=True)):
            if any(size in sizes_of(view.place, view.role, self.scene) for view in views):
                boxes = self.outlines(k, sizes)
                taken = sum(box.width * box.height for box in boxes) / rooms[0].area
                found.append(taken / math.ceil(taken / FILLED))
        return min(found)

    def by_hand(self, drawn: Drawn, free: Set[str]) -> dict[str, float]:
        """Return, by plan, the share of its size at which a sheet holds what a hand drew, if it does not."""
        way: dict[str, float] = {}
        for order, rooms in zip(self.scene.sheets, self.sheets, strict=True):
            for place in free & set(order.place):
                for view in views_of(place, self.scene, [drawn], False):
                    name = sizes_of(place, view.role, self.scene)[:1]
                    held = share(view, rooms[0].within)
                    if held < 1.0 and name and name[0] in free:
                        way[name[0]] = min(way.get(name[0], LESS), held)
        return way


def _alone(box: Outline, room: Room) -> float:
    """Return how many times larger what was measured may be on a sheet of its own."""
    return room.within.share(box.width - LETTERS, box.height - LETTERS) * (1 + 1e-12)


def _larger(length: float, times: float) -> float:
    return length + max(length - SIGNS, 0.0) * (times - 1.0)


def _width(label: Label) -> float:
    across = [spot.real for spot in corners(label)]
    return max(across) - min(across)
