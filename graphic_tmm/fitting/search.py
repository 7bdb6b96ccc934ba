"""How large things are drawn: as large as the sheets ordered hold, or on as few more as they need.

Everything begins in its usual size; where a view fits no sheet of its format, what its size depends on is made
smaller until it does. Then what is smallest, as a share of what it may take of its sheet, is lifted by one step
of the standard scales, and so on: a plan alone does not eat the sheet that others stand on too. What makes the
sheets more is put back, and not tried again.

Mechanism and parts go one road: all of them are tried together, on the sheets that they share.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence, Set

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.measuring import Rooms, TooLarge, cells
from graphic_tmm.fitting.sizes import Sizes, all_sizes, sizes_of, usual
from graphic_tmm.fitting.tried import Board, Mechanism
from graphic_tmm.paper.drawing import TABLE
from graphic_tmm.paper.packing import holds, share
from graphic_tmm.scene.records import Scene

MEASURABLE = 40.0
"""What begins small is no shorter, mm, if the choice of μ is free and a sheet holds it. Half a division of
0.5 mm is 0.6 % of that."""
STEP, TRIALS = 0.93, 40
"""By how much at least a size gives way at a time; how often. All of them leave a twentieth."""
MOST = 24
"""How often a size grows by its step, at most, until something comes of it."""
SAVING = 0.9
"""What gives way to save a sheet is no shorter than this share of what can be measured well."""
WAY = (0.93, 0.87, 0.81, 0.75, 0.7, 0.65, 0.6)
"""The shares of their sizes at which plans give way to save a sheet."""
OVER = (1.03, 1.3)
"""What is lifted takes no more than so many times its share of a sheet: first, and where there is room left."""
IDLE = 8
"""After so many steps in a row that make no view larger a size is left as it was: nothing is drawn in it."""


class Search:
    """The search for sizes: boards tried together on the sheets of a scene."""

    def __init__(self, scene: Scene, boards: Iterable[Board]) -> None:
        self.scene = scene
        self.boards = {board.name: board for board in boards}
        self.rooms = Rooms(scene, list(self.boards.values()))
        self.written = Rooms(scene, list(self.boards.values()), lettered=True)
        self.own = {
            name: (board, size)
            for board in self.boards.values()
            for name, size in board.sizes.items()
        }

    def sizes(self) -> Sizes:
        """Return the sizes in which everything is drawn."""
        least = self._held(self._least())
        if math.isinf(self.rooms.count(least)):
            # what is allowed for letters may be more than they take
            self.rooms = self.written
        free = [name for name, (_, size) in self.own.items() if not size.fixed(self.scene)]
        for rooms in (self.rooms, self.written):
            if rooms is self.written:
                # or less: of many positions they stand far out
                least = self._with_letters(least)
            least, saved = self._saving(least, free, rooms)
            if saved:
                return least
            most = max(len(self.scene.sheets), rooms.count(least))
            found = None if math.isinf(most) else self._lifted_all(least, free, most)
            if found is not None:
                return found
        return least

    def _lifted_all(self, sizes: Sizes, names: Sequence[str], most: float) -> Sizes | None:
        """Return sizes lifted as far as they may be on no more sheets, with all letters; None if none are so.

        Where letters take more than was allowed for them, the last steps are tried again with their letters.
        """
        steps = self.lifted(sizes, names, most)
        found = self.lettered(steps, most)
        if found is None or found is steps[-1]:
            return found
        allowed, self.rooms = self.rooms, self.written
        found = self.lifted(found, names, most)[-1]
        self.rooms = allowed
        return found

    def lettered(self, steps: list[Sizes], most: float) -> Sizes | None:
        """Return the largest of sizes, in order, that take no more sheets with their letters; None: all do."""
        held, back = -1, 1  # the last known to be, and how far before the last it is looked for
        over = len(steps)
        while over > 0 and held < 0:
            tried = max(len(steps) - back, 0)
            if self.written.takes_more(steps[tried], most):
                over, back = tried, 2 * back + 1
            else:
                held = tried
        while held >= 0 and over - held > 1:
            middle = (held + over) // 2
            if self.written.takes_more(steps[middle], most):
                over = middle
            else:
                held = middle
        return steps[held] if held >= 0 else None

    def _saving(self, sizes: Sizes, free: Sequence[str], rooms: Rooms) -> tuple[Sizes, bool]:
        """Return sizes to begin with: less than usual where that saves sheets that nobody ordered.

        And whether they stay so: what would stand on a sheet that is saved has just room on others.
        """
        count, ordered = rooms.count(sizes), len(self.scene.sheets)
        if count <= ordered or math.isinf(count):
            return sizes, False
        tried = [sizes]
        narrow = ordered > 1 and count == ordered + 1  # then what is left over may stand elsewhere
        for less in self._giving_way(sizes, free, rooms, math.inf if narrow else count - 1):
            if not rooms.takes_more(less, count - 1):
                sizes, count = less, rooms.count(less)
            if count <= ordered:
                return sizes, False
            tried.append(less)
        for less in tried if ordered > 1 and count == ordered + 1 else ():
            if rooms.together(less) <= ordered and self.written.together(less) <= ordered:
                return less, True
        return sizes, False

    def _giving_way(
        self, sizes: Sizes, free: Sequence[str], rooms: Rooms, most: float
    ) -> Iterator[Sizes]:
        """Yield smaller sizes: small ones, one of them step by step, all of them step by step.

        What takes more sheets than ``most`` where it is smallest is not tried in between.
        """
        small = {n: min(sizes[n], self.own[n][1].small) for n in free if self.own[n][1].small}
        yield {**sizes, **small}
        there = [name for name in free if self.own[name][1].cap > 0.0]
        groups = [*([name] for name in there), there]

        def smaller(names: Sequence[str], part: float) -> Sizes:
            less: Sizes = {**sizes, **small} if len(names) > 1 else sizes
            for name in names:
                less = self._less(name, part * sizes[name], less)
            return less

        if math.isfinite(most):
            groups = [g for g in groups if not rooms.takes_more(smaller(g, WAY[-1]), most)]
        tried = {self._come_of(sizes)}
        for part in WAY:
            for names in groups:
                less = smaller(names, part)
                if (known := self._come_of(less)) not in tried:
                    tried.add(known)
                    yield less

    def _come_of(self, sizes: Sizes) -> tuple[object, ...]:
        return tuple(board.known(name, sizes) for name, (board, _) in self.own.items())

    def _less(self, name: str, wanted: float, sizes: Sizes) -> Sizes:
        """Return sizes of which one has given way, if it can and what comes of it can still be measured."""
        size = self.own[name][1]
        least = size.least if size.in_mm else max(size.least, size.small)
        less = {**sizes, name: min(sizes[name], max(wanted, least))}
        return sizes if self._tiny(name, less) else less

    def with_board(self, board: Board) -> Search:
        """Return a search with another board of the same name, for its scene."""
        return Search(board.scene, {**self.boards, board.name: board}.values())

    def lifted(self, sizes: Sizes, names: Iterable[str], most: float) -> list[Sizes]:
        """Return sizes step by step, one lifted each time, the relatively smallest first, on no more sheets.

        All of them keep to their caps first; then those that have room go a little beyond. What a sheet had no
        room for once is not tried again, when it holds even more.
        """
        steps, names = [sizes], [name for name in names if self.own[name][1].cap > 0.0]
        for over in OVER:
            free = list(names)
            while free:
                name = min(free, key=lambda one: self._share(one, steps[-1]))
                larger = self._larger(name, steps[-1])
                if larger is None or not self._may(name, steps[-1], larger, over):
                    free.remove(name)
                elif self.rooms.takes_more(larger, most):
                    free.remove(name)
                    names.remove(name)
                else:
                    steps.append(larger)
                    if self._idle(name, steps):
                        del steps[-IDLE:]
                        free.remove(name)
                        names.remove(name)
        return steps

    def _idle(self, name: str, steps: Sequence[Sizes]) -> bool:
        """Whether the last steps lifted one size alone, and no view is larger for it."""
        if len(steps) <= IDLE:
            return False
        before, last = steps[-1 - IDLE], steps[-1]
        alone = last == {**before, name: last[name]}
        return alone and self._share(name, last) == self._share(name, before)

    def _share(self, name: str, sizes: Sizes) -> float:
        """Return what a size takes of what it may take of its sheets."""
        return self.rooms.large(name, sizes) / self.own[name][1].cap

    def _may(self, name: str, sizes: Sizes, larger: Sizes, over: float) -> bool:
        """Whether a size may be so much larger: no view comes apart, none takes too much."""
        if self.rooms.views(name, larger) > self.rooms.views(name, sizes):
            return False
        return 0.0 < self._share(name, larger) <= over

    def _larger(self, name: str, sizes: Sizes) -> Sizes | None:
        """Return sizes of which one is the next larger of which something else comes; None if there is none."""
        board, size = self.own[name]
        before, larger = board.known(name, sizes), sizes
        for _ in range(MOST):
            larger = {**larger, name: larger[name] * size.step}
            if board.known(name, larger) != before:
                return larger
        return None

    def _least(self) -> Sizes:
        """Return the usual sizes; of what begins small the least at which it can be measured.

        What no sheet shows is as large as one would draw it to read off its lengths.
        """
        known: Sizes = usual(self.scene)
        found = known
        for name, (board, size) in self.own.items():
            if size.small and size.in_mm:
                found = {**found, name: size.small}
                while found[name] < known[name] and board.mm(name, found) < MEASURABLE:
                    found = {**found, name: min(found[name] * size.step, known[name])}
        unseen = [n for n, (_, size) in self.own.items() if not self.rooms.views(n, found)]
        return {**found, **{n: self.own[n][1].unseen or known[n] for n in unseen}}

    def _held(self, sizes: Sizes) -> Sizes:
        """Return sizes at which a sheet holds every view, as far as the scene leaves them free."""
        for _ in range(TRIALS):
            rooms = self.written if self.rooms.near(sizes) else self.rooms
            less = _smaller(rooms.too_large(sizes), sizes, self.scene)
            if less == sizes:
                break
            sizes = less
        return sizes

    def _with_letters(self, sizes: Sizes) -> Sizes:
        """Return sizes at which a sheet holds every view with its letters; as they were if these are too small.

        Letters of many points stand the farther out the smaller their plan is.
        """
        tried = sizes
        while over := self.written.too_large(tried):
            less = _smaller(over, tried, self.scene)
            tiny = (n for n in less if n in self.own and less[n] < tried[n] and self._tiny(n, less))
            if less == tried or any(tiny):
                return sizes
            tried = less
        return tried

    def _tiny(self, name: str, sizes: Sizes) -> bool:
        """Whether a size leaves of a plan less than can be measured."""
        return self.own[name][0].mm(name, sizes) < SAVING * MEASURABLE

    def over(self, sizes: Sizes) -> list[int]:
        """Return the orders (indices) of which a view fits no sheet."""
        there = range(len(self.scene.sheets))
        return [k for k in there if not all(self.written.holding(k, sizes))]

    def by_hand(self, own: Mechanism, sizes: Sizes, wanted: Set[str] | None) -> tuple[Sizes, Drawn]:
        """Return the sizes, and what is drawn with them by the scene's own hand.

        Near a singular position a rounded reading may make a plan much larger than it is: it gives way too.
        """
        plans = {name for name, size in own.sizes.items() if size.in_mm}
        for _ in range(TRIALS):
            drawn = own.final(sizes, wanted, exact=False)
            found = [
                TooLarge(place, view.role, share(view, rooms[0].within))
                for order, rooms in self.rooms.orders
                for place in order.place
                if place in plans
                for view in cells(place, self.scene, [drawn], rooms[0].within, lettered=False)
                if not holds(rooms[0].within, view)
            ]
            less = _smaller(found, sizes, self.scene)
            if less == sizes:
                break
            sizes = less
        return sizes, drawn


def _smaller(found: Iterable[TooLarge], sizes: Sizes, scene: Scene) -> Sizes:
    """Return sizes of which those that views too large depend on have given way."""
    known = all_sizes()
    way: dict[str, float] = {}
    for one in found:
        names = depends(one.place, one.role, scene)
        name = next((n for n in names if sizes[n] > known[n].least), None)
        if name is not None:
            way[name] = min(way.get(name, STEP), one.share)
    return {**sizes, **{name: sizes[name] * share for name, share in way.items()}} if way else sizes


def depends(place: str, role: str, scene: Scene) -> tuple[str, ...]:
    """Return the sizes, left free by the scene, that views of a role depend on, in the order they give way."""
    if role == TABLE:
        return ()
    known = all_sizes()
    return tuple(name for name in sizes_of(place, role, scene) if not known[name].fixed(scene))
