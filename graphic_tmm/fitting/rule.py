"""Sizes by rule, as a teacher tells them; one step a sheet where its views take more than it has, or far less.

Everything has a natural size, see `Size`: no larger is drawn what is measured on a sheet of that format. Then
each sheet ordered takes one step: up while it has room, down where that saves a sheet. Velocities, polygons and
diagrams give way before positions, groups and wheels do. A size that several sheets show takes the least step.
What one sheet holds then grows kind by kind as far as there is room.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.fitting.rooms import LESS, LETTERS, SPILL, Rooms
from graphic_tmm.fitting.sizes import Size, Sizes, usual
from graphic_tmm.fitting.tried import Board
from graphic_tmm.scene.records import Scene

STEPS: Mapping[int, tuple[float, float]] = {
    3: (1.7, 1.7),
    2: (1.4, 1.4),
    1: (1.2, 1.2),
    0: (1.0, 1.0),
    -1: (0.85, 1.0),
    -2: (0.7, 1.0),
    -3: (0.7, 0.85),
    -4: (0.6, 0.85),
    -5: (0.6, 0.72),
    -6: (0.5, 0.6),
}
"""By step: the share of their natural size that those take which give way first, and all others."""
FULL = 0.92
"""What takes a larger share of a sheet, gaps among it, fits never. Of the sheets of the gallery."""
SAVING = -2
"""The step to which what several sheets show gives way if that saves one: of forces the polygons alone."""
SMALL = -4
"""The step to which plans of positions give way where that saves a sheet of several: at the next a crank was
11 mm."""
GROWN = ((1.0, 0.85, 0.7), (1.7, 1.4, 1.2))
"""To which shares of its natural size a kind grows by itself where there is room for it: first to that."""
LEGIBLE = 45.0
"""Nothing gives way to less than so many mm for a sheet's sake: on an A4 vectors of 18 mm came of it."""
SPARE = 0.72
"""Of views that take no more of a sheet, which does not hold them all, tables may go to another sheet."""
THIRD = 1 / 3
"""No sheet is opened for less than this share of it."""
WORTH = 0.85
"""To no larger share of the sheets their number has to fall for all that they show to be drawn small."""
TRIALS = 20
"""How often what no sheet holds gives way."""


def by_rule(scene: Scene, boards: Sequence[Board]) -> tuple[Sizes, Rooms]:
    """Return the sizes in which boards are drawn, and the room that their views take."""
    natural: Sizes = usual(scene)
    own = {name: size for board in boards for name, size in board.sizes.items()}
    free = {name: size for name, size in own.items() if not size.fixed(scene)}
    sizes, rooms = natural, Rooms.of(scene, boards, natural)
    for _ in range(TRIALS):
        less = _held(rooms, sizes)
        if less == sizes:
            break
        # what is much smaller is measured again: not all of it grows with its size
        sizes, rooms = less, Rooms(scene, boards, less)
    most = {
        n: size.high * natural[n] if sizes[n] == natural[n] else sizes[n]
        for n, size in free.items()
    }
    rule = _Rule(rooms, free, most)
    return _held(rooms, rule.grown(*rule.steps())), rooms


class _Rule(NamedTuple):
    """What the steps of sheets are found by: the room of views, sizes that are free, and the most of each."""

    rooms: Rooms
    free: Mapping[str, Size]
    most: Sizes

    def steps(self) -> tuple[Sizes, list[bool]]:
        """Return sizes, and of each order whether one sheet holds it.

        Orders take their steps one after another. None opens a second sheet because others have grown: groups
        are no smaller than the plan, wherever that stands.
        """
        count = len(self.rooms.views)
        steps: list[int | None] = [0 if self.rooms.names(k) else None for k in range(count)]
        single = [True] * count
        for k in range(count):
            steps[k], single[k] = self._step(k, steps)
        for k in range(count):
            less = [step if step is None else min(step, 0) for step in steps]
            if not single[k] and less != steps:
                found = self._on_one(k, self._tried(k, less))
                if found is not None:
                    steps, single[k] = [*less[:k], found, *less[k + 1 :]], True
        sizes = self.sizes(steps)
        return sizes, [one and self.rooms.fits(k, sizes) for k, one in enumerate(single)]

    def sizes(self, steps: Sequence[int | None]) -> Sizes:
        """Return sizes of which each takes the least step of the sheets (None: of no views) that show it."""
        least: dict[str, int] = {}
        for k, step in enumerate(steps):
            if step is not None:
                least |= {n: min(step, least.get(n, step)) for n in self.rooms.names(k)}
        return {**self.rooms.natural, **{name: self._size(name, k) for name, k in least.items()}}

    def _size(self, name: str, step: int) -> float:
        size = self.free[name]
        natural, share = self.rooms.natural[name], STEPS[step][0 if size.first else 1]
        least = min(LEGIBLE, natural) if size.in_mm else 0.0
        return min(max(natural * max(share, size.low), least), self.most[name])

    def _step(self, order: int, steps: Sequence[int | None]) -> tuple[int | None, bool]:
        """Return the largest step at which an order takes no more sheets than it has to; whether one.

        ``steps``: of all others.
        """
        if not self.rooms.names(order):
            return None, True
        at = self._tried(order, steps)
        found = self._on_one(order, at)
        return (self._on_several(order, at), False) if found is None else (found, True)

    def _tried(self, order: int, steps: Sequence[int | None]) -> dict[int, Sizes]:
        """Return the sizes by step of an order, the largest first; ``steps``: of all others."""
        return {
            step: self.sizes([*steps[:order], step, *steps[order + 1 :]])
            for step in sorted(STEPS, reverse=True)
        }

    def _on_one(self, order: int, at: Mapping[int, Sizes]) -> int | None:
        """Return the largest step at which one sheet holds an order, or all but its tables; else None."""
        rooms, least = self.rooms, min(at)
        if rooms.share(order, at[least]) <= FULL:
            for step, sizes in at.items():
                if rooms.share(order, sizes) <= FULL and rooms.fits(order, sizes):
                    return step
            if rooms.fits(order, at[least], letters=False):
                return least
        if len(rooms.views) > 1 and rooms.share(order, at[0]) <= SPARE:
            return next((k for k in (0, -1, -2) if rooms.fits(order, at[k], tables=False)), None)
        return None

    def _on_several(self, order: int, at: Mapping[int, Sizes]) -> int:
        """Return the largest step at which an order surely takes no more sheets than where polygons give way.

        Where that leaves less than a third on one, than where all is small, if that saves a sheet in seven:
        plans of positions are not drawn so small.
        """
        rooms, names = self.rooms, self.rooms.names(order)
        positions = any(self.free[name].plan and not self.free[name].first for name in names)
        small = SMALL if positions else min(at)
        least = rooms.sheets_of(order, at[SAVING], -LETTERS)
        if rooms.emptiest(order, at[SAVING]) < THIRD:
            fewer = rooms.sheets_of(order, at[small], -LETTERS)
            least = fewer if fewer <= WORTH * least else least
        tried = [step for step in at if step >= small]
        for spill in (SPILL, 0.0, -LETTERS):

            def held(step: int, spill: float = spill) -> bool:
                return rooms.sheets_of(order, at[step], spill) <= least

            found = bisect_left(tried, True, key=held)
            if found < len(tried):
                return tried[found]
        return SAVING

    def grown(self, sizes: Sizes, single: Sequence[bool]) -> Sizes:
        """Return sizes of which each by itself has grown on sheets that had room for it, ``single`` ones."""
        names = [n for k, one in enumerate(single) if one for n in self.rooms.names(k)]
        for shares in GROWN:
            for name in dict.fromkeys(names):
                for share in shares:
                    size = min(share * self.rooms.natural[name], self.most[name])
                    larger = {**sizes, name: size}
                    if size > sizes[name] and self._held(sizes, larger, single):
                        sizes = larger
                        break
        return sizes

    def _held(self, sizes: Sizes, larger: Sizes, single: Sequence[bool]) -> bool:
        """Whether larger sizes take no further sheet."""
        for k, one in enumerate(single):
            if self.rooms.outlines(k, larger) == self.rooms.outlines(k, sizes):
                continue
            if not one or not self.rooms.fits(k, larger):
                return False
        return True


def _held(rooms: Rooms, sizes: Sizes) -> Sizes:
    """Return sizes at which a sheet holds every view, as far as the scene leaves them free."""
    for _ in range(TRIALS):
        way: dict[str, float] = {}
        for name, share in rooms.too_large(sizes):
            way[name] = min(way.get(name, LESS), share)
        if not way:
            break
        sizes = {**sizes, **{name: sizes[name] * share for name, share in way.items()}}
    return sizes
