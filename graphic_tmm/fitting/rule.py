"""Sizes by rule, as a teacher tells them; one step a sheet where its views take more than it has, or far less.

Everything has a natural size, see `Size`: no larger is drawn what is measured on a sheet of that format. Then
each sheet ordered takes one step: up while it has room, down where that saves a sheet. Velocities, polygons and
diagrams give way before positions, groups and wheels do. A size that several sheets show takes the least step.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from graphic_tmm.fitting.rooms import LESS, Rooms
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
PACKED = 0.66
"""What share of a row of sheets is taken, gaps among it, where views are spread over several."""
SPARE = 0.72
"""Of views that take no more of a sheet, which does not hold them all, tables may go to another sheet."""
THIRD = 1 / 3
"""No sheet is opened for less than this share of it."""
TRIALS = 20
"""How often what no sheet holds gives way."""


def by_rule(scene: Scene, boards: Sequence[Board]) -> tuple[Sizes, Rooms]:
    """Return the sizes in which boards are drawn, and the room that their views take."""
    natural: Sizes = usual(scene)
    own = {name: size for board in boards for name, size in board.sizes.items()}
    free = {name: size for name, size in own.items() if not size.fixed(scene)}
    sizes, rooms = natural, Rooms(scene, boards, natural)
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
    steps = [_step(rooms, k, most, free) for k in range(len(scene.sheets))]
    return _held(rooms, _stepped(rooms, steps, most, free)), rooms


def _stepped(
    rooms: Rooms, steps: Sequence[int | None], most: Sizes, free: Mapping[str, Size]
) -> Sizes:
    """Return sizes of which each takes the least step of the sheets (None: of no views) that show it."""
    least: dict[str, int] = {}
    for step, views in zip(steps, rooms.views, strict=True):
        for name in {name for view in views for name in view.sizes}:
            if step is not None:
                least[name] = min(step, least.get(name, step))
    return {
        **rooms.natural,
        **{n: _size(free[n], rooms.natural[n], most[n], k) for n, k in least.items()},
    }


def _size(size: Size, natural: float, most: float, step: int) -> float:
    share = STEPS[step][0 if size.first else 1]
    return min(natural * max(share, size.low), most)


def _step(rooms: Rooms, order: int, most: Sizes, free: Mapping[str, Size]) -> int | None:
    """Return the largest step at which the views of an order take no more sheets than they have to."""
    names = {name for view in rooms.views[order] for name in view.sizes}
    natural = rooms.natural
    at = {
        step: {**natural, **{n: _size(free[n], natural[n], most[n], step) for n in names}}
        for step in sorted(STEPS, reverse=True)
    }
    if not names:
        return None
    found = _on_one(rooms, order, at)
    return _on_several(rooms, order, at) if found is None else found


def _on_one(rooms: Rooms, order: int, at: Mapping[int, Sizes]) -> int | None:
    """Return the largest step at which one sheet holds an order, or all but its tables; None if none does."""
    least = min(at)
    if rooms.share(order, at[least]) <= FULL:
        for step, sizes in at.items():
            if rooms.share(order, sizes) <= FULL and rooms.fits(order, sizes):
                return step
        if rooms.fits(order, at[least], letters=False):
            return least
    if len(rooms.views) > 1 and rooms.share(order, at[0]) <= SPARE:
        return next((k for k in (0, -1, -2) if rooms.fits(order, at[k], tables=False)), None)
    return None


def _on_several(rooms: Rooms, order: int, at: Mapping[int, Sizes]) -> int:
    """Return the largest step at which an order takes as many sheets as in natural sizes, by areas."""
    sheets = {k: math.ceil(rooms.share(order, sizes) / PACKED) for k, sizes in at.items()}
    count = max(sheets[0], 2)
    if rooms.share(order, at[0]) / PACKED - (count - 1) < THIRD:
        count = max(min(count, sheets[-2]), 2)
    return max((step for step in at if sheets[step] <= count), default=-1)


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
