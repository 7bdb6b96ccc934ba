"""From a scene to its boards drawn as large as its sheets hold; what a fixed scale factor leaves half white."""

from __future__ import annotations

from collections.abc import Iterator, Set
from dataclasses import replace
from functools import partial

from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.search import Search
from graphic_tmm.fitting.sizes import Sizes
from graphic_tmm.fitting.tried import Board, Mechanism, PartBoard
from graphic_tmm.language.said import Said, said
from graphic_tmm.paper.formats import turned as other_way
from graphic_tmm.project import own_boards
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.records import Scene

WHITE = 0.5
"""Sheets whose views take less of their free room are half white."""
WORTH = 1.2
"""So many times larger a plan has to come out for anybody to be told of it."""


def half_white(search: Search, own: Mechanism, sizes: Sizes) -> Iterator[Said]:
    """Yield, for each μ of a plan that the scene fixes, what would fill the sheets that it leaves half white.

    Everything else stays as large as it is, and the sheets are no more.
    """
    for name, size in own.sizes.items():
        key = size.fixed(search.scene)
        if not (key and size.in_mm and search.rooms.fill(name, sizes) < WHITE):
            continue
        now = own.mm(name, sizes)
        free = own.freed(size.freed(search.scene))
        tried = search.with_board(free)
        begin = {**sizes, name: now * (1 + 1e-9)}
        try:
            most = max(len(search.scene.sheets), tried.rooms.count(begin))
            found = tried.lettered(tried.lifted(begin, [name], most), most) or begin
            large = free.mm(name, found)
            if large < WORTH * now:
                continue
            section, _, short = key.rpartition(".")
            value = size.remedy(free.draw(found), short)
        except TmmError:
            continue
        yield said(
            '{name} in [{section}] leaves its sheet half white: {name} = "{value}" would draw the plan '
            "{large:.0f} mm large, not {now:.0f} mm",
            name=short,
            value=value,
            section=section,
            large=large,
            now=now,
        )


SEARCHED = "searched"
"""What is kept beside a scene: the search for its sizes, and what it found."""
TURNED = "turned"
"""What is kept beside a scene: the same with sheets turned where that holds what they do not."""


def fitted(scene: Scene, *, exact: bool = False, wanted: Set[str] | None = None) -> Drawn:
    """Draw a mechanism with its plans as large as fit on the sheets ordered, or on as few more as they need.

    Every reader of a scene takes this μ, so that a table speaks of the sheet that is drawn. ``wanted``: places
    of sheets, if not all is drawn that the scene calls for.

    Raises
    ------
    SceneError
        If the scene has none.
    """
    drawn = fitted_boards(scene, exact=exact, wanted=wanted, mechanism=True)
    return next(one for one in drawn if one.board == MECHANISM)


def fitted_boards(
    scene: Scene, *, exact: bool = False, wanted: Set[str] | None = None, mechanism: bool
) -> tuple[Drawn, ...]:
    """Draw the boards of a scene, that of its ``mechanism`` first if it has one; see `fitted`.

    Raises
    ------
    StructureError
        If one of them cannot be made, even if nobody wants it.
    """
    key = (SEARCHED, mechanism)
    own, parts, search, sizes = _searched(scene, mechanism)
    found = [board.final(sizes, wanted, exact=exact) for board in parts]
    if own is not None:
        of = (*key, None if wanted is None else frozenset(wanted))
        if of not in scene.cache:
            scene.cache[of] = search.by_hand(own, sizes, wanted)
        sizes, by_hand = scene.cache[of]
        whole = own.final(sizes, wanted, exact=True) if exact else by_hand
        told = partial(half_white, search, own, sizes)
        found = [replace(whole, advice=told), *found]
    return tuple(one for one in found if one is not None)


def sheets_taken(scene: Scene, *, mechanism: bool) -> float:
    """Return how many sheets a scene takes in the sizes found for it, with all letters; inf: no number does.

    ``mechanism``: as for `fitted_boards`, which has found them.
    """
    *_, search, sizes = _searched(scene, mechanism)
    return search.written.count(sizes)


def turned(scene: Scene, *, mechanism: bool) -> Scene:
    """Return a scene of which sheets are turned that hold one of their views only so, whatever its size.

    Where that does not help it is the scene as it is.
    """
    key = (TURNED, mechanism)
    if key not in scene.cache:
        scene.cache[key] = _turned(scene, mechanism)
    found: Scene = scene.cache[key]
    return found


def _turned(scene: Scene, mechanism: bool) -> Scene:
    *_, search, sizes = _searched(scene, mechanism)
    if not (over := search.over(sizes)):
        return scene
    other = [
        replace(order, format=other_way(order.format)) if k in over else order
        for k, order in enumerate(scene.sheets)
    ]
    told = (
        said(
            "sheet {number}: {ordered} does not hold one of its views: it is turned, {other}",
            number=k + 1,
            ordered=scene.sheets[k].format,
            other=other[k].format,
        )
        for k in over
    )
    tried = replace(scene, sheets=tuple(other), remarks=(*scene.remarks, *told))
    *_, search, sizes = _searched(tried, mechanism)
    return scene if search.over(sizes) else tried


def _searched(scene: Scene, mechanism: bool) -> tuple[Mechanism | None, list[Board], Search, Sizes]:
    """Return the boards of a scene, and the search for sizes: they hang on no hand, nor on what is wanted."""
    key = (SEARCHED, mechanism)
    if key not in scene.cache:
        scene.cache[key] = _search(scene, mechanism)
    found: tuple[Mechanism | None, list[Board], Search, Sizes] = scene.cache[key]
    return found


def _search(scene: Scene, mechanism: bool) -> tuple[Mechanism | None, list[Board], Search, Sizes]:
    parts: list[Board] = [PartBoard(scene, board) for board in own_boards(scene)]
    own = Mechanism(scene) if mechanism else None
    search = Search(scene, [*([own] if own is not None else []), *parts])
    return own, parts, search, search.sizes()
