"""What room the views of a scene take before they are lettered: how many sheets they need, what fits none."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.scales import Scale
from graphic_tmm.chapter import places
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.compose import Views, laid, orders, views_of
from graphic_tmm.fitting.scales import Sizes
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.packing import bounds, holds, settled, share
from graphic_tmm.scene.records import Scene

Cells = dict[tuple[object, ...], list[Drawing]]
"""The room of the views of a place, by its name, the sheet it stands on and the μ that it depends on."""
NEAR = 32.0
"""A view that is about so near, mm, to what a sheet holds is measured with its letters. Chosen by eye."""


class Trial(NamedTuple):
    """A drawing of a board that is tried: its μ, its sizes, and how to draw it."""

    board: str
    scales: Mapping[str, Scale]
    sizes: Sizes
    draw: Callable[[], Drawn]

    @classmethod
    def of(cls, drawn: Drawn) -> Trial:
        """Return a drawing that is made already."""
        return cls(drawn.board, drawn.scales, drawn.sizes, lambda: drawn)


class TooLarge(NamedTuple):
    """A view that no sheet of its format holds: the place it belongs to, its name, what share would fit."""

    place: str
    view: str
    share: float


def needed(scene: Scene, drawn: Trial | None, others: Sequence[Drawn], cells: Cells) -> int:
    """Return how many sheets a scene takes: tried with plans that only take the room they will need.

    ``others``: boards that are not tried; ``cells``: what earlier trials of the same scene found, with other μ
    of the plans; kept up.

    Raises
    ------
    ViewError
        If a view fits no sheet.
    """
    return len(laid(scene, _measure(scene, drawn, others, cells)))


def too_large(scene: Scene, drawn: Trial, cells: Cells) -> list[TooLarge]:
    """Return the views of a board that no sheet holds; see `needed`."""
    room = _measure(scene, drawn, (), cells)
    known = places()
    return [
        TooLarge(place, view.name, share(view, within))
        for order, rooms in orders(scene)
        for within in (rooms[0].within,)
        for place in order.place
        if known[place][0].board == drawn.board
        for view in room(place, within)
        if not holds(within, view)
    ]


def _measure(scene: Scene, drawn: Trial | None, others: Sequence[Drawn], cells: Cells) -> Views:
    """Return how the views of a place are measured, for a sheet: each a cell alone."""
    known = places()

    def room(place: str, within: Within) -> list[Drawing]:
        if several := known[place][1].together:
            return [view for one in several for view in room(one, within)]
        key = (place, within, *_depends(place, drawn))
        if key not in cells:
            views = _settled(place, scene, drawn, others, within)
            cells[key] = [
                Drawing(view.name, view.title, cell=bounds(view), stand=view.stand, foot=view.foot)
                for view in views
            ]
        return cells[key]

    return room


def _settled(
    place: str, scene: Scene, drawn: Trial | None, others: Sequence[Drawn], within: Within
) -> list[Drawing]:
    """Return the views of a place without letters; with them where only they tell whether a sheet holds it."""
    boards = [*([drawn.draw()] if drawn is not None else []), *others]
    for lettered in (False, True):
        whole = views_of(place, scene, boards, lettered)
        views = [part for view in whole for part in settled(view, within)]
        if not any(_at_the_edge(view, within) for view in views):
            break
    return views


def _at_the_edge(view: Drawing, within: Within) -> bool:
    left, low, right, top = bounds(view)
    wide, high = right - left, top - low
    smaller = within.share(wide - NEAR, high - NEAR) >= 1.0
    return smaller and within.share(wide + NEAR, high + NEAR) < 1.0


def _depends(place: str, drawn: Trial | None) -> list[object]:
    """Return what the room of a place's views depends on: the μ of plans, the sizes of all else."""
    if drawn is None:
        return []
    chapter, shown = places()[place]
    if chapter.board != drawn.board:
        return []
    scales = [drawn.scales[name].value for name in shown.follows if name in drawn.scales]
    return [*scales, *shares(drawn.sizes)]


def shares(sizes: Sizes) -> tuple[float, ...]:
    """Return the sizes that are shares of usual ones; the others are seen in the scale factors."""
    return tuple(value for name, value in sizes.items() if name not in in_mm())


def in_mm() -> frozenset[str]:
    """Return the names of the sizes that are room in mm, and set a scale factor."""
    from graphic_tmm.chapter import chapters

    return frozenset(size.name for one in chapters() for size in one.sizes if size.in_mm)
