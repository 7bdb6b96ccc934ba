"""A recorded construction and its numbers as ink sees them: places, lines and arcs in one position."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import ByIdentity, Construction, Mark, Step
from graphic_tmm.board.values import Complexes, Curve
from graphic_tmm.paper.drawing import Ink
from graphic_tmm.paper.formats import HEIGHTS, Heights
from graphic_tmm.paper.traced import value_at

Rule = Callable[["Seen", Step, int], Iterable[Ink]]
"""The log and its numbers, a step, a position (index) -> the strokes that it leaves there."""


class Seen:
    """Views of a log and their numbers, as ink sees them; ``positions`` (indices) of those that are drawn.

    ``reading`` holds one drawing; where a mark does not vary it has one position.
    """

    def __init__(
        self,
        construction: Construction,
        reading: Reading,
        views: Sequence[str],
        positions: Sequence[int],
    ) -> None:
        self.construction, self.reading = construction, reading
        self.views, self.positions = tuple(views), tuple(positions)

    @cached_property
    def by_mark(self) -> Mapping[Mark, Step]:
        """The steps of the whole log by the mark that each left."""
        return _by_mark(ByIdentity(self.construction))

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The steps of the views, in the order in which they were done."""
        return _steps(ByIdentity(self.construction), self.views)

    @cached_property
    def uses(self) -> Mapping[Mark, tuple[Step, ...]]:
        """The steps of the views that use a mark."""
        return _uses(self.steps)

    def point(self, mark: Mark, k: int) -> complex:
        """Return where a point is, mm; NaN where it cannot be drawn."""
        return value_at(self.reading[mark], k)

    def number(self, mark: Mark, k: int) -> float:
        """Return a length (mm), an angle (degrees) or a number."""
        return value_at(self.reading[mark], k).real

    def fixed_place(self, mark: Mark) -> complex:
        """Return where a point is that does not vary, mm."""
        return self.point(mark, 0)

    def fixed_number(self, mark: Mark) -> float:
        """Return a length (mm) or a number that does not vary."""
        return self.number(mark, 0)

    def all(self, mark: Mark) -> Complexes:
        """Return where a point is in all positions, mm, (position,)."""
        return np.broadcast_to(self.reading[mark][0], (len(self.positions),))

    def line(self, mark: Mark, k: int) -> tuple[complex, complex]:
        """Return where a line begins, mm, and its direction."""
        value = self.reading[mark]
        return value_at(value.at, k), value_at(value.along, k)

    def arc(self, mark: Mark, k: int) -> tuple[complex, float]:
        """Return the centre and the radius of an arc, mm."""
        value = self.reading[mark]
        return value_at(value.centre, k), value_at(value.radius, k).real

    def varies(self, step: Step) -> bool:
        """Whether what a step leaves differs from position to position."""
        if step.it.kind is Curve:
            return False
        value = self.reading[step.it]
        parts = value if isinstance(value, tuple) else (value,)
        return any(part.shape[1] > 1 for part in parts)


class Subject(NamedTuple):
    """What a view shows: a log with its numbers; how the view is titled, and lettered in which language.

    ``name``: of the view, "" where it is called as the view of the log that it shows.
    """

    construction: Construction
    reading: Reading
    title: str = ""
    heights: Heights = HEIGHTS["A1"]
    language: str = "en"
    name: str = ""

    def seen(self, views: Sequence[str], positions: Sequence[int]) -> Seen:
        """Return some views of the log at some positions (indices)."""
        return Seen(self.construction, self.reading, views, positions)


@lru_cache(maxsize=8)
def _by_mark(log: ByIdentity[Construction]) -> Mapping[Mark, Step]:
    return {step.it: step for step in log.it.steps}


@lru_cache(maxsize=64)
def _steps(log: ByIdentity[Construction], views: tuple[str, ...]) -> tuple[Step, ...]:
    return tuple(s for s in log.it.steps if s.it.view in views)


def _uses(steps: Sequence[Step]) -> Mapping[Mark, tuple[Step, ...]]:
    found: dict[Mark, tuple[Step, ...]] = {}
    for step in steps:
        for mark in dict.fromkeys(step.uses):
            found[mark] = (*found.get(mark, ()), step)
    return found


def finite(*spots: complex) -> bool:
    """Whether all of some places are there."""
    return all(cmath.isfinite(spot) for spot in spots)
