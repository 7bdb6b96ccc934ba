"""Boards in sizes that are tried: each is recorded once, and drawn with the exact hand in its natural sizes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Set
from dataclasses import replace
from typing import Any, Protocol

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import execute
from graphic_tmm.board.scales import common
from graphic_tmm.drawn import Drawn, doubted
from graphic_tmm.fitting.scales import chosen, executed, reach_of
from graphic_tmm.fitting.sizes import Size, Sizes, Sizing
from graphic_tmm.project import Plan, Project, own_boards, record
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.records import Scene

Lengths = Mapping[str, tuple[float, float]]
"""By view: how long 1 SI unit is drawn, and the base of a graph, mm."""
BOARDS = "boards"
"""What is kept beside a scene: its boards."""
NO_DOUBTS = Doubts((), {})
"""Nobody asks what rounding does to a part drawn with the exact hand."""


class Board(Protocol):
    """A board that can be drawn in any size."""

    name: str
    scene: Scene

    @property
    def sizes(self) -> dict[str, Size]:
        """The sizes on which what is drawn on it depends, by name."""

    def lengths(self, sizes: Sizes) -> Lengths:
        """Return how long 1 SI unit is drawn by view, mm, and the base of a graph."""

    def mm(self, size: str, sizes: Sizes) -> float:
        """Return how long the longest is that is drawn of a plan, mm; 0 if there is none."""

    def of(self, scene: Scene) -> Board:
        """Return the board of a scene that differs in its formats."""

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the board drawn with the exact hand."""

    def final(self, sizes: Sizes, wanted: Set[str] | None, *, exact: bool) -> Drawn | None:
        """Return the board as it is drawn in the end; None if it is none of what is ``wanted`` (None: all)."""


class Mechanism:
    """The board of a mechanism: one log, to whatever scale factors."""

    name = MECHANISM

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.whole = record(scene)
        shown = scene.called == scene.shown_places
        self.project = self.whole if shown else record(scene, wanted=scene.shown_places)
        self.doubts = doubted(self.project)
        self.reach = reach_of(self.project, self.doubts)
        self.sizes = _sizes(self.project)
        self._drawn: dict[object, Drawn] = {}
        self._known: dict[object, Lengths] = {}

    def of(self, scene: Scene) -> Mechanism:
        """Return the board of a scene that differs in its formats, or fixes other scale factors."""
        other: Mechanism = object.__new__(type(self))
        other.__dict__ |= self.__dict__
        other.scene, other.project = scene, replace(self.project, scene=scene)
        same = self.whole is self.project
        other.whole = other.project if same else replace(self.whole, scene=scene)
        other._drawn, other._known = {}, {}
        return other

    def lengths(self, sizes: Sizes) -> Lengths:
        """Return how long 1 SI unit is drawn by view, mm, and the base of a graph."""
        key = self._key(sizes)
        if key not in self._known:
            self._known[key] = _lengths(self.project, sizes, self.reach)
        return self._known[key]

    def _key(self, sizes: Sizes) -> object:
        return tuple(sizes[name] for name in self.sizes)

    def mm(self, size: str, sizes: Sizes) -> float:
        """Return how long the longest is that is drawn of a plan, mm; 0 if there is none."""
        known = self.lengths(sizes)
        return self.sizes[size].extent(self.reach) * known[size][0] if size in known else 0.0

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the mechanism with these sizes."""
        key = self._key(sizes)
        if key not in self._drawn:
            self._drawn[key] = executed(self.project, sizes, self.reach, self.doubts, exact=True)
        return self._drawn[key]

    def final(self, sizes: Sizes, wanted: Set[str] | None, *, exact: bool) -> Drawn:
        """Return what is drawn in the end, of more than the sheets show, too."""
        project = self.whole
        if wanted is not None:
            shown = wanted == self.scene.shown_places
            project = self.project if shown else record(self.scene, wanted=wanted)
        if project is self.project:
            return self.draw(sizes) if exact else self._executed(project, sizes)
        doubts = doubted(project)
        own = reach_of(project, doubts)
        reach = {name: _joined(self.reach.get(name), more) for name, more in own.items()}
        return executed(project, sizes, reach, doubts, exact=exact)

    def _executed(self, project: Project, sizes: Sizes) -> Drawn:
        return executed(project, sizes, self.reach, self.doubts, exact=False)


class PartBoard:
    """A part on a board of its own: in another size it may be another log."""

    def __init__(self, scene: Scene, board: str) -> None:
        self.scene, self.name = scene, board
        self.project = record(scene, board)
        self.sizes = _sizes(self.project)
        self._projects: dict[object, tuple[Project, Mapping[str, Any]]] = {}
        self._drawn: dict[object, Drawn] = {}
        self._known: dict[object, Lengths] = {}

    def lengths(self, sizes: Sizes) -> Lengths:
        """Return how long 1 SI unit is drawn by view, mm, and the base of a graph."""
        key = self._key(sizes)
        if key not in self._known:
            project, reach = self._recorded(sizes)
            self._known[key] = _lengths(project, sizes, reach)
        return self._known[key]

    def mm(self, size: str, sizes: Sizes) -> float:
        """Return that it has no plan."""
        return 0.0

    def of(self, scene: Scene) -> PartBoard:
        """Return the board of a scene that differs in its formats."""
        other: PartBoard = object.__new__(type(self))
        other.__dict__ |= self.__dict__
        other.scene, other.project = scene, replace(self.project, scene=scene)
        other._projects, other._drawn, other._known = {}, {}, {}
        return other

    def _recorded(self, sizes: Sizes) -> tuple[Project, Mapping[str, Any]]:
        """Return the log in these sizes, and what its scale factors go by."""
        key = self._key(sizes)
        if key not in self._projects:
            shares = {name: sizes[name] for name in self.sizes if sizes[name] != 1.0}
            project = self.project
            if shares:
                usual = self.draw({**sizes, **dict.fromkeys(self.sizes, 1.0)})
                project = record(self.scene, self.name, sizes=shares, usual=usual)
            self._projects[key] = project, reach_of(project, NO_DOUBTS)
        return self._projects[key]

    def _key(self, sizes: Sizes) -> object:
        return tuple(sizes[name] for name in self.sizes)

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the part in these sizes."""
        key = self._key(sizes)
        if key not in self._drawn:
            project, reach = self._recorded(sizes)
            self._drawn[key] = executed(project, sizes, reach, None, exact=True)
        return self._drawn[key]

    def final(self, sizes: Sizes, wanted: Set[str] | None, *, exact: bool) -> Drawn | None:
        """Return the part in these sizes, by the exact hand or the scene's own."""
        drawn = self.draw(sizes)
        own = {place.name for one in chapters(self.name) for place in one.places}
        if wanted is not None and not own & wanted:
            return None
        if exact:
            return drawn
        return executed(drawn.project, drawn.sizes, drawn.reach, drawn.doubts, exact=False)


def _lengths(project: Project, sizes: Sizes, reach: Mapping[str, Any]) -> Lengths:
    """Return how long 1 SI unit is by view, mm, and the base of a graph, mm, 0 if none is taken there."""
    log = project.construction
    given, _ = chosen(project, sizes, reach)
    views = {view.name: view.scale for view in log.views if view.scale is not None}
    bases = {view: log.roles(view, roles.BASE)[:1] for view in views}
    for chapter in project.chapters:
        # graphs of a chapter stand over one base, which may be taken in the chapter's own view
        own = [c.view for c in Plan.of(chapter).charts(project.recorded[chapter.name])]
        shared = next((bases[view] for view in (*own, chapter.name) if bases.get(view)), ())
        bases |= {view: shared for view in own if view in bases and not bases[view]}
    marks = [*views.values(), *(mark for base in bases.values() for mark in base)]
    reading = execute(log, {**dict.fromkeys(log.given, 1.0), **given}, marks)
    return {
        view: (1.0 / common(reading[mu]), sum(_first(reading[m]) for m in bases[view]))
        for view, mu in views.items()
    }


def _first(values: Any) -> float:
    return float(np.ravel(np.asarray(values))[0])


def boards_of(scene: Scene, *, mechanism: bool) -> list[Board]:
    """Return the boards of a scene, that of its ``mechanism`` first if it has one; recorded once."""
    key = (BOARDS, mechanism)
    if key not in scene.cache:
        parts: list[Board] = [PartBoard(scene, board) for board in own_boards(scene)]
        scene.cache[key] = [*([Mechanism(scene)] if mechanism else []), *parts]
    found: list[Board] = scene.cache[key]
    return found


def pass_on(scene: Scene, other: Scene) -> None:
    """Let a scene that differs in its formats have the boards that were recorded for it."""
    for mechanism in (True, False):
        if (BOARDS, mechanism) in scene.cache:
            boards = scene.cache[BOARDS, mechanism]
            other.cache[BOARDS, mechanism] = [board.of(other) for board in boards]


def _sizes(project: Project) -> dict[str, Size]:
    return {size.name: size for one in project.chapters for size in Sizing.of(one).sizes}


def _joined(tried: object, more: object) -> object:
    """Return the reach that was tried, where it is there, and what else there is."""
    if not isinstance(tried, tuple) or not isinstance(more, tuple):
        return {**tried, **more} if isinstance(tried, dict) and isinstance(more, dict) else more
    make: Callable[..., object] = type(more)
    return make(*(_either(one, other) for one, other in zip(tried, more, strict=True)))


def _either(tried: Any, more: Any) -> Any:
    return (
        {**more, **tried} if isinstance(tried, dict) and isinstance(more, dict) else tried or more
    )
