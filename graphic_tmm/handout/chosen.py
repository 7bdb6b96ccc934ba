"""Which views are handed out: those of the plans asked for, in one position, graphs of a stack one by one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import groupby
from typing import NamedTuple

from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.handout.ink import in_hand
from graphic_tmm.handout.series import Draw
from graphic_tmm.handout.story import places_of
from graphic_tmm.paper.drawing import Drawing, Within
from graphic_tmm.readers.protocol import Protocols, position_of
from graphic_tmm.scene.captions import Named
from graphic_tmm.scene.chapter import MECHANISM, Place

LOW = Within(((1e4, 1.0),))
"""A sheet that is as wide as one likes and holds no graph above another."""


class Chosen(NamedTuple):
    """A view to hand out: its board, its position (index), how it is drawn.

    ``untold``: slots of the steps that other views tell.
    """

    drawn: Drawn
    view: Drawing
    place: int
    draw: Draw
    untold: frozenset[int] = frozenset()


def chosen(made: DrawnScene, plans: Sequence[str], position: str | None) -> list[Chosen]:
    """Return the views of some plans; those drawn for one position in the one asked for, else in the first.

    Raises
    ------
    SceneError
        If there is no such position.
    """
    found: list[Chosen] = []
    for board in made.boards:
        own = board.board == MECHANISM
        name = position if own or made.mechanism is None else None
        wanted = _views(board, plans)
        there = [one for one in _there(board) if wanted.intersection(one[0].shows)]
        found += _shared(list(_at(board, there, position_of(board, name), strict=name is not None)))
    return found


def _views(drawn: Drawn, plans: Iterable[str]) -> set[str]:
    """Return the views of the log that plans are drawn in; all of them of a chapter that does not say."""
    found: set[str] = set()
    for one in drawn.project.chapters:
        views = Protocols.of(one).views(drawn.project)
        for plan in plans:
            if plan in Named.of(one).plans:
                every = (step.it.view for step in drawn.construction.steps)
                found.update(views.get(plan, () if views else every))
    return found


Drawable = tuple[Drawing, Draw]


def _there(drawn: Drawn) -> Iterator[Drawable]:
    """Yield the views of a board that have steps, each once, and how they are drawn."""
    seen: set[str] = set()
    for chapter in drawn.project.chapters:
        for place in chapter.places:
            if place.together:
                continue
            views = _Views(drawn, place)
            for name, one in views.at(1.0, lettered=False).items():
                if one.shows and name not in seen:
                    seen.add(name)
                    yield one, partial(views.named, name)


class _Views:
    """The views of a place, drawn once for each factor."""

    def __init__(self, drawn: Drawn, place: Place) -> None:
        self.drawn, self.place = drawn, place
        self.made: dict[tuple[float, bool], dict[str, Drawing]] = {}

    def at(self, factor: float, *, lettered: bool) -> Mapping[str, Drawing]:
        """Return the views by name, with letters for pictures so many times as large."""
        key = factor, lettered
        if key not in self.made:
            views = drawing_of(self.place.name)(in_hand(self.drawn, factor), lettered)
            parts = (part for view in views for part in apart(view))
            self.made[key] = {part.name: part for part in parts}
        return self.made[key]

    def named(self, name: str, factor: float, lettered: bool) -> Drawing:
        """Return a view."""
        return self.at(factor, lettered=lettered)[name]


def apart(view: Drawing) -> Sequence[Drawing]:
    """Return the graphs that stand one above another in a view; any other view as it is."""
    if view.apart is None or len(view.shows) < 2:
        return (view,)
    parts = list(view.apart(LOW))
    shown = [name for part in parts for name in part.shows]
    if len(parts) < 2 or sorted(shown) != sorted(view.shows) or not all(p.shows for p in parts):
        return (view,)
    return [part._replace(name=f"{view.name} {part.shows[0]}") for part in parts]


def _at(drawn: Drawn, there: Sequence[Drawable], place: int, *, strict: bool) -> Iterator[Chosen]:
    """Yield views in a position; of those that are drawn for one each, that of ``place``.

    ``strict``: none where it is not there; else the first.
    """
    for _, some in groupby(there, key=lambda one: one[0].shows):
        family = [(view, draw, list(places_of(drawn, view))) for view, draw in some]
        alone = [one for one in family if len(one[2]) == 1]
        if len(alone) < len(family) or len(drawn.names) == 1:
            for view, draw, places in family:
                yield Chosen(drawn, view, place if place in places else [*places, place][0], draw)
            continue
        own = [one for one in alone if one[2] == [place]]
        for view, draw, places in own[:1] or ([] if strict else alone[:1]):
            yield Chosen(drawn, view, places[0], draw)


def _shared(some: Sequence[Chosen]) -> list[Chosen]:
    """Return views that know what of the plans that several of them show the others tell."""
    return [one._replace(untold=_untold(one, some)) for one in some]


def _untold(one: Chosen, some: Sequence[Chosen]) -> frozenset[int]:
    """Return the slots of steps that a view does not tell, for another that shows their plan does."""
    log = one.drawn.construction
    views = {name for other in some if other is not one for name in other.view.shows}.intersection(
        one.view.shows
    )
    if not views:
        return frozenset()
    sharing = [other for other in some if views.intersection(other.view.shows)]
    inked = [_inked(other.view) for other in sharing]
    own = inked[sharing.index(one)]
    owner = _owners(log, views, inked)
    mine = sharing.index(one)
    return frozenset(
        step.it.slot
        for step in log.steps
        if step.it.view in views and step.it.slot not in own and owner.get(step.it, 0) != mine
    )


def _inked(view: Drawing) -> set[int]:
    return {slot for one in (*view.strokes, *view.rubbed) for slot in one.of}


def _owners(log: Construction, views: set[str], inked: Sequence[set[int]]) -> dict[Mark, int]:
    """Return by which of some views the steps of plans are told: what inks them, needs them, or is read of."""
    found: dict[Mark, int] = {}
    for step in reversed(log.steps):
        owner = next((n for n, slots in enumerate(inked) if step.it.slot in slots), None)
        if owner is not None:
            found[step.it] = owner
        if step.it in found:
            for mark in step.uses:
                found.setdefault(mark, found[step.it])
    for step in log.steps:
        if step.it not in found:
            used = [found[mark] for mark in step.uses if mark in found and mark.view in views]
            if used:
                found[step.it] = used[-1]
    return found
