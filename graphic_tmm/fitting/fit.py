"""From a scene to its boards drawn as large as its sheets hold."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace
from functools import partial

from graphic_tmm.chapter import MECHANISM
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.advice import half_white
from graphic_tmm.fitting.search import Search
from graphic_tmm.fitting.tried import Board, Mechanism, Part
from graphic_tmm.project import own_boards
from graphic_tmm.scene.records import Scene


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
    parts: list[Board] = [Part(scene, board, wanted) for board in own_boards(scene)]
    own = Mechanism(scene, wanted) if mechanism else None
    boards = [*([own] if own is not None else []), *parts]
    search = Search(scene, boards)
    sizes = search.sizes()
    found = [board.final(sizes, exact=exact) for board in parts]
    if own is not None:
        sizes, by_hand = search.by_hand(own, sizes)
        whole = own.final(sizes, exact=exact) if exact or by_hand is None else by_hand
        told = partial(half_white, search, own, sizes)
        found = [replace(whole, advice=told), *found]
    return tuple(one for one in found if one is not None)
