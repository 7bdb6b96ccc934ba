"""From a scene to its boards drawn in sizes by rule; what a fixed scale factor leaves half white."""

from __future__ import annotations

from collections.abc import Iterator, Set
from dataclasses import replace
from functools import partial

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.rooms import Rooms
from graphic_tmm.fitting.rule import TRIALS, by_rule
from graphic_tmm.fitting.sizes import Sizes
from graphic_tmm.fitting.tried import Board, Mechanism, boards_of, pass_on
from graphic_tmm.language.said import Said, said
from graphic_tmm.paper.formats import turned as other_way
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.records import Scene

WHITE = 0.5
"""Sheets whose views take less of their free room are half white."""
WORTH = 1.2
"""So many times larger a plan has to come out for anybody to be told of it."""


def half_white(rooms: Rooms, own: Mechanism, sizes: Sizes) -> Iterator[Said]:
    """Yield, for each μ of a plan that the scene fixes, what would fill sheets that it leaves half white."""
    scene = own.scene
    for name, size in own.sizes.items():
        key, now = size.fixed(scene), own.mm(name, sizes)
        if not (key and size.plan and now and rooms.fill(name, sizes) < WHITE):
            continue
        free = own.of(size.freed(scene))
        large = free.mm(name, sizes)
        if large < WORTH * now:
            continue
        section, _, short = key.rpartition(".")
        yield said(
            '{name} in [{section}] leaves its sheet half white: {name} = "{value}" would draw the plan '
            "{large:.0f} mm large, not {now:.0f} mm",
            name=short,
            value=size.remedy(free.draw(sizes), short),
            section=section,
            large=large,
            now=now,
        )


FITTED = "fitted"
"""What is kept beside a scene: its boards, the room that they take, the sizes found."""
TURNED = "turned"
"""What is kept beside a scene: the same with sheets turned where that holds what they do not."""


def fitted(scene: Scene, *, exact: bool = False, wanted: Set[str] | None = None) -> Drawn:
    """Draw a mechanism in the sizes of `rule`.

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
    boards, rooms, sizes = _fitted(scene, mechanism)
    own = boards[0] if mechanism else None
    parts = boards[1:] if mechanism else boards
    found = [board.final(sizes, wanted, exact=exact) for board in parts]
    if isinstance(own, Mechanism):
        of = (FITTED, mechanism, None if wanted is None else frozenset(wanted))
        if of not in scene.cache:
            scene.cache[of] = _by_hand(own, rooms, sizes, wanted)
        sizes, by_hand = scene.cache[of]
        whole = own.final(sizes, wanted, exact=True) if exact else by_hand
        told = partial(half_white, rooms, own, sizes)
        found = [replace(whole, advice=told), *found]
    return tuple(one for one in found if one is not None)


def _by_hand(
    own: Mechanism, rooms: Rooms, sizes: Sizes, wanted: Set[str] | None
) -> tuple[Sizes, Drawn]:
    """Return the sizes, and what is drawn with them by the scene's own hand.

    Near a singular position a rounded reading may make a plan much larger than it is: it gives way too.
    """
    free = {name for name, size in own.sizes.items() if size.plan and not size.fixed(own.scene)}
    for _ in range(TRIALS):
        drawn = own.final(sizes, wanted, exact=False)
        way = rooms.by_hand(drawn, free)
        if not way:
            break
        sizes = {**sizes, **{name: sizes[name] * share for name, share in way.items()}}
    return sizes, drawn


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
    _, rooms, _ = _fitted(scene, mechanism)
    if not (over := rooms.over()):
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
    pass_on(scene, tried)
    _, rooms, _ = _fitted(tried, mechanism)
    return scene if rooms.over() else tried


def _fitted(scene: Scene, mechanism: bool) -> tuple[list[Board], Rooms, Sizes]:
    """Return the boards of a scene, their room, their sizes: they hang on no hand, nor on what is wanted."""
    key = (FITTED, mechanism)
    if key not in scene.cache:
        boards = boards_of(scene, mechanism=mechanism)
        sizes, rooms = by_rule(scene, boards)
        scene.cache[key] = boards, rooms, sizes
    found: tuple[list[Board], Rooms, Sizes] = scene.cache[key]
    return found
