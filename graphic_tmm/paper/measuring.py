"""What room the views of a scene take before they are lettered: how many sheets they need, what fits none."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.scales import Scale
from graphic_tmm.paper.compose import Views, laid, orders, views_of
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.paper.layout import bounds, holds, settled, share
from graphic_tmm.parts import Part
from graphic_tmm.scaling import Sizes
from graphic_tmm.scene.records import Scene
from graphic_tmm.views import FOLLOWS, SEVERAL, VIEWS
from graphic_tmm.work import Work

Cells = dict[tuple[object, ...], list[Drawing]]
"""The room of the views of a place, by its name, the sheet it stands on and the μ that it depends on."""
NEAR = 32.0
"""A view that is about so near, mm, to what a sheet holds is measured with its letters."""


class Trial(NamedTuple):
    """A drawing of the mechanism that is tried: its μ, its sizes, and how to draw it."""

    scales: Mapping[str, Scale]
    sizes: Sizes
    work: Callable[[], Work]

    @classmethod
    def of(cls, work: Work) -> Trial:
        """Return a drawing that is made already."""
        return cls(work.scales, work.sizes, lambda: work)


class TooLarge(NamedTuple):
    """A view that no sheet of its format holds: the place it belongs to, its name, what share would fit."""

    place: str
    view: str
    share: float


def needed(scene: Scene, drawn: Trial | None, parts: Sequence[Part], cells: Cells) -> int:
    """Return how many sheets a scene takes: tried with plans that only take the room they will need.

    ``cells``: what earlier trials of the same scene found, with other μ of the plans; kept up.

    Raises
    ------
    ViewError
        If a view fits no sheet.
    """
    return len(laid(scene, _measure(scene, drawn, parts, cells)))


def too_large(
    scene: Scene, drawn: Trial | None, parts: Sequence[Part], cells: Cells
) -> list[TooLarge]:
    """Return the views that no sheet holds: of the mechanism if it is drawn, and of the parts; see `needed`."""
    room = _measure(scene, drawn, parts, cells)
    kinds = {part.kind for part in parts} | (set(VIEWS) if drawn is not None else set())
    return [
        TooLarge(plan, view.name, share(view, within))
        for order, rooms in orders(scene)
        for within in (rooms[0].within,)
        for plan in order.place
        if plan in kinds
        for view in room(plan, within)
        if not holds(within, view)
    ]


def _measure(scene: Scene, drawn: Trial | None, parts: Sequence[Part], cells: Cells) -> Views:
    """Return how the views of a place are measured, for a sheet: each a cell alone."""

    def room(plan: str, within: Within) -> list[Drawing]:
        if plan in SEVERAL:
            return [view for one in SEVERAL[plan] for view in room(one, within)]
        key = (plan, within, *_depends(plan, drawn))
        if key not in cells:
            views = _settled(plan, scene, drawn, parts, within)
            cells[key] = [Drawing(view.name, view.title, cell=bounds(view)) for view in views]
        return cells[key]

    return room


def _settled(
    plan: str, scene: Scene, drawn: Trial | None, parts: Sequence[Part], within: Within
) -> list[Drawing]:
    """Return the views of a place without letters; with them where only they tell whether a sheet holds it."""
    work = drawn.work() if drawn is not None else None
    for lettered in (False, True):
        whole = views_of(plan, scene, work, parts, lettered)
        views = [part for view in whole for part in settled(view, within)]
        if not any(_at_the_edge(view, within) for view in views):
            break
    return views


def _at_the_edge(view: Drawing, within: Within) -> bool:
    left, low, right, top = bounds(view)
    wide, high = right - left, top - low
    smaller = within.share(wide - NEAR, high - NEAR) >= 1.0
    return smaller and within.share(wide + NEAR, high + NEAR) < 1.0


def _depends(plan: str, drawn: Trial | None) -> list[object]:
    """Return what the room of a place's views depends on: the μ of plans, the sizes of all else."""
    if drawn is None:
        return []
    follows = ("positions", *FOLLOWS.get(plan, ()))
    scales = [drawn.scales[name].value for name in follows if name in drawn.scales]
    return [*scales, *drawn.sizes.shares]
