"""From a scene to its boards drawn as large as its sheets hold."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace
from functools import partial

from graphic_tmm.chapter import MECHANISM
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.advice import half_white
from graphic_tmm.fitting.scales import Sizes
from graphic_tmm.fitting.search import Search
from graphic_tmm.fitting.tried import Board, Mechanism, Part
from graphic_tmm.project import own_boards
from graphic_tmm.scene.records import Scene

SEARCHED = "searched"
"""What is kept beside a scene: the search for its sizes, and what it found."""


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
    if key not in scene.cache:
        scene.cache[key] = _searched(scene, mechanism)
    own, parts, search, sizes = scene.cache[key]
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


def _searched(scene: Scene, mechanism: bool) -> tuple[Mechanism | None, list[Board], Search, Sizes]:
    """Return the boards of a scene, and the search for sizes: they hang on no hand, nor on what is wanted."""
    parts: list[Board] = [Part(scene, board) for board in own_boards(scene)]
    own = Mechanism(scene) if mechanism else None
    search = Search(scene, [*([own] if own is not None else []), *parts])
    return own, parts, search, search.sizes()
