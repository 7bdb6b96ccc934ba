"""Boards in sizes that are tried: each is recorded and drawn once with the exact hand, whatever the sizes."""

from __future__ import annotations

import math
from collections.abc import Callable, Set
from dataclasses import replace
from typing import Any, Protocol

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.scales import Scale
from graphic_tmm.drawn import Drawn, doubted
from graphic_tmm.fitting.rescaled import Rescaling
from graphic_tmm.fitting.scales import Fitting, chosen, executed, reach_of
from graphic_tmm.fitting.sizes import Size, Sizes, Sizing
from graphic_tmm.project import Project, record
from graphic_tmm.scene.chapter import MECHANISM, chapters
from graphic_tmm.scene.records import Scene

NO_DOUBTS = Doubts((), {})
"""Nobody asks what rounding does to a drawing that is only tried."""


class Board(Protocol):
    """A board that can be drawn in any size."""

    name: str
    scene: Scene

    @property
    def sizes(self) -> dict[str, Size]:
        """The sizes on which what is drawn on it depends, by name."""

    def known(self, size: str, sizes: Sizes) -> object:
        """Return what comes of a size: two sizes of which the same comes are drawn alike."""

    def comes_of(self, size: str, sizes: Sizes) -> object:
        """Return that of it that the views which depend on the size are drawn by."""

    def mm(self, size: str, sizes: Sizes) -> float:
        """Return how long the longest is that is drawn of a plan, mm; without end if nobody knows."""

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the board drawn with the exact hand."""

    def final(self, sizes: Sizes, wanted: Set[str] | None, *, exact: bool) -> Drawn | None:
        """Return the board as it is drawn in the end; None if it is none of what is ``wanted`` (None: all)."""


class Mechanism:
    """The board of a mechanism: its millimetres follow from one drawing, see `rescaled`."""

    name = MECHANISM

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.whole = record(scene)
        shown = scene.called == scene.shown_places
        self.project = self.whole if shown else record(scene, wanted=scene.shown_places)
        self.doubts = doubted(self.project)
        self.reach = reach_of(self.project, self.doubts)
        self.rescaling = Rescaling(self.project, self.doubts)
        self.sizes = {
            size.name: size for one in self.project.chapters for size in Sizing.of(one).sizes
        }
        self._drawn: dict[object, Drawn] = {}
        self._scales: dict[object, dict[str, Scale]] = {}
        self._chosen: dict[object, tuple[tuple[object, float], ...]] = {}

    def freed(self, scene: Scene) -> Mechanism:
        """Return the board for a scene that fixes other scale factors, or orders other sheets."""
        other: Mechanism = object.__new__(type(self))
        other.__dict__ |= self.__dict__
        other.scene, other.project = scene, replace(self.project, scene=scene)
        other.whole = (
            other.project if self.whole is self.project else replace(self.whole, scene=scene)
        )
        other._drawn, other._scales, other._chosen = {}, {}, {}
        return other

    def chosen(self, sizes: Sizes) -> tuple[tuple[object, float], ...]:
        """Return all scale factors, and what else comes of sizes."""
        key = tuple(sizes[name] for name in self.sizes)
        if key not in self._chosen:
            given, _ = chosen(self.project, sizes, self.reach)
            fixed = self.project.given
            found = ((m, v) for m, v in given.items() if v is not fixed.get(m))
            self._chosen[key] = tuple(found)  # type: ignore[arg-type]
        return self._chosen[key]

    def known(self, size: str, sizes: Sizes) -> object:
        """Return the scale factors that come of sizes; of what is not seen in them the size itself."""
        return self.chosen(sizes) if self.sizes[size].seen else sizes[size]

    def comes_of(self, size: str, sizes: Sizes) -> object:
        """Return μ of a plan; of all else the size itself."""
        scales = self._plans(sizes) if self.sizes[size].in_mm else {}
        return scales[size].value if size in scales else sizes[size]

    def mm(self, size: str, sizes: Sizes) -> float:
        """Return how long the longest is that is drawn of a plan, mm; without end if there is none."""
        scales, found = self._plans(sizes), self.sizes[size].extent(self.reach)
        return found / scales[size].value if size in scales and found > 0.0 else math.inf

    def _plans(self, sizes: Sizes) -> dict[str, Scale]:
        key = tuple(sizes[name] for name, size in self.sizes.items() if size.in_mm)
        if key not in self._scales:
            self._scales[key] = Fitting(self.project, sizes, self.reach).plan_scales()
        return self._scales[key]

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the mechanism with these sizes."""
        key = (self.chosen(sizes), tuple(sizes[name] for name in self.sizes))
        if key not in self._drawn:
            self._drawn[key] = self._executed(self.project, sizes, self.rescaling)
        return self._drawn[key]

    def _executed(self, project: Project, sizes: Sizes, by: Rescaling) -> Drawn:
        return executed(project, sizes, self.reach, self.doubts, exact=True, numbers=by.numbers)

    def final(self, sizes: Sizes, wanted: Set[str] | None, *, exact: bool) -> Drawn:
        """Return what is drawn in the end, of more than the sheets show, too."""
        project = self.whole
        if wanted is not None:
            shown = wanted == self.scene.shown_places
            project = self.project if shown else record(self.scene, wanted=wanted)
        doubts, reach = self.doubts, self.reach
        if project is not self.project:
            doubts = doubted(project)
            own = reach_of(project, doubts)
            reach = {name: _joined(self.reach.get(name), more) for name, more in own.items()}
        return executed(project, sizes, reach, doubts, exact=exact)


class PartBoard:
    """A part on a board of its own: in another size it may be another log."""

    def __init__(self, scene: Scene, board: str) -> None:
        self.scene, self.name = scene, board
        self.project = record(scene, board)
        self.sizes = {
            size.name: size for one in self.project.chapters for size in Sizing.of(one).sizes
        }
        self._projects: dict[object, tuple[Project, dict[str, Any]]] = {}
        self._drawn: dict[object, Drawn] = {}
        self._known: dict[object, object] = {}

    def known(self, size: str, sizes: Sizes) -> object:
        """Return the scale factors and lengths that come of sizes."""
        key = tuple(sizes[name] for name in self.sizes)
        if key not in self._known:
            project, reach = self._recorded(sizes)
            given, _ = chosen(project, sizes, reach)
            plain = ((m.key, value) for m, value in given.items() if np.ndim(value) == 0)  # type: ignore[arg-type]
            self._known[key] = tuple(plain)
        return self._known[key]

    def comes_of(self, size: str, sizes: Sizes) -> object:
        """Return what comes of all sizes."""
        return self.known(size, sizes)

    def mm(self, size: str, sizes: Sizes) -> float:
        """Return that nobody knows how long it is drawn."""
        return math.inf

    def _recorded(self, sizes: Sizes) -> tuple[Project, dict[str, Any]]:
        """Return the log in these sizes, and what its scale factors go by."""
        key = tuple(sizes[name] for name in self.sizes)
        if key not in self._projects:
            shares = {name: sizes[name] for name in self.sizes if sizes[name] != 1.0}
            project, usual = self.project, None
            if shares:
                usual = self.draw({**sizes, **dict.fromkeys(self.sizes, 1.0)})
                project = record(self.scene, self.name, sizes=shares, usual=usual)
            self._projects[key] = project, reach_of(project, NO_DOUBTS)
        return self._projects[key]

    def draw(self, sizes: Sizes) -> Drawn:
        """Return the part in these sizes."""
        key = self.known("", sizes)
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
        return executed(drawn.project, drawn.sizes, drawn.reach, None, exact=False)


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
