"""A drawing to other scale factors: its millimetres follow from one exact drawing, which is not executed again.

Where everything in a view is drawn to its μ, its points and lengths are those drawn with μ = 1, over μ. Where
lengths have been chosen in mm too (the base of a graph, the distance of its pole), and for what is calculated,
the step is done again when somebody asks for it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.blocks import spread
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, cut
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Arc, Curve, Length, Line, Point, at, blank
from graphic_tmm.board.values import given as as_value
from graphic_tmm.drawn import Findings, Numbers
from graphic_tmm.project import Project

PLACED = (Point, Length, Arc)
"""Kinds that are so many mm large, or stand somewhere."""
SCALED = (*PLACED, Line)
"""Kinds that follow from μ in a view in which everything is drawn to it."""
ALONG = ("parallel", "square", "measure_along", "at_friction_angle")
"""Operations that take no more from a line than its direction: it may be one of another view."""

SHAPE = "similar"
"""An operation that takes no more from points of another view than the shape of their figure."""


def to_scale(project: Project) -> frozenset[str]:
    """Return the views in which everything is drawn to the view's own μ, which may be chosen."""
    log = project.construction
    scales = {view.name: view.scale for view in log.views if view.scale in log.given}
    fixed = {m.view for m in log.given if m.kind in PLACED and np.any(_of(project, m))}
    return frozenset(
        name
        for name, mu in scales.items()
        if mu is not None and name not in fixed and _follows(log, name, mu)
    )


def _of(project: Project, mark: Mark) -> Any:
    return np.asarray(project.given.get(mark, 1.0))


def _follows(log: Construction, view: str, mu: Mark) -> bool:
    return all(
        _drawn_to(step, view, mu)
        for step in log.steps
        if step.it.view == view and step.it.kind in SCALED
    )


def _drawn_to(step: Step, view: str, mu: Mark) -> bool:
    """Whether a step's mark grows with its view: it is made of such, or calculated by its μ."""
    if mu in step.uses:
        return True
    strange = [mark for mark in step.uses if mark.view != view]
    if step.op.formula and not any(mark.kind in PLACED for mark in step.uses):
        return False
    if any(mark.kind in (*PLACED, Curve) for mark in strange):
        return step.op.name == SHAPE and len({mark.view for mark in strange}) == 1
    return step.op.name in ALONG or not any(mark.kind is Line for mark in strange)


class Rescaled(Mapping[int, Any]):
    """The values of a log with what is ``given``, by slot, each found when it is asked for.

    ``drawn``: those drawn with every free scale factor 1; ``views``: in which everything is drawn to μ.
    """

    def __init__(
        self,
        project: Project,
        drawn: Mapping[int, Any],
        given: Mapping[Mark, object],
        views: frozenset[str],
    ) -> None:
        log = project.construction
        self.drawn, self.count = drawn, len(project.names)
        self.steps = {step.it.slot: step for step in log.steps}
        self.given = {mark.slot: (mark, given[mark]) for mark in log.given if mark in given}
        scales = {view.name: view.scale for view in log.views if view.name in views}
        self.mu = {
            view: float(np.ravel(np.asarray(given[mu]))[0])
            for view, mu in scales.items()
            if mu is not None and mu in given
        }
        self.found: dict[int, Any] = {}

    def __getitem__(self, slot: int) -> Any:
        waiting = [slot]
        while waiting:
            last = waiting[-1]
            missing = [] if last in self.found else self._missing(last)
            if missing:
                waiting += missing
                continue
            waiting.pop()
            if last not in self.found:
                self.found[last] = self._value(last)
        return self.found[slot]

    def _missing(self, slot: int) -> list[int]:
        """Return what has to be found before a value: nothing where it follows from μ."""
        if slot in self.given or self._scaled(slot):
            return []
        return [mark.slot for mark in self.steps[slot].uses if mark.slot not in self.found]

    def _scaled(self, slot: int) -> bool:
        mark = self.steps[slot].it
        return mark.kind in SCALED and mark.view in self.mu

    def _value(self, slot: int) -> Any:
        if slot in self.given:
            mark, value = self.given[slot]
            return as_value(value, mark.kind)
        step = self.steps[slot]
        if self._scaled(slot):
            return _larger(self.drawn[slot], 1.0 / self.mu[step.it.view])
        takes = [self.found[mark.slot] for mark in step.uses]
        if step.op.across:
            takes = [spread(value, self.count) for value in takes]
        with np.errstate(all="ignore"):
            return step.op.run(*takes, **step.choice)

    def __iter__(self) -> Iterator[int]:
        return iter((*self.given, *self.steps))

    def __len__(self) -> int:
        return len(self.given) + len(self.steps)

    def __contains__(self, slot: object) -> bool:
        return slot in self.given or slot in self.steps


def _larger(value: Any, times: float) -> Any:
    if isinstance(value, Line):
        return Line(value.at * times, value.along)
    if isinstance(value, Arc):
        return Arc(value.centre * times, value.radius * times)
    return value * times


class _Rescaled(Mapping[int, Any]):
    """Values of which some are not there, at some positions; each found when it is asked for."""

    def __init__(
        self,
        values: Mapping[int, Any],
        gone: Mapping[int, Any],
        places: tuple[int, ...] | None = None,
    ) -> None:
        self.values_, self.gone, self.places = values, gone, places

    def __getitem__(self, slot: int) -> Any:
        value = self.values_[slot]
        if self.places is not None:
            value = cut(value, self.places)
        if slot in self.gone:
            value = blank(value, at(self.gone[slot], self.places))
        return value

    def __iter__(self) -> Iterator[int]:
        return iter(self.values_)

    def __len__(self) -> int:
        return len(self.values_)

    def __contains__(self, slot: object) -> bool:
        return slot in self.values_


class Rescaling:
    """The drawings of a log to all scale factors that are tried, by the exact hand; it is executed for none."""

    def __init__(self, project: Project, doubts: Doubts) -> None:
        self.project, self.doubts = project, doubts
        self.views = to_scale(project)
        self.nothing: dict[int, Any] = {}
        for chapter in project.chapters:
            self.nothing |= Findings.of(chapter).nothing(project, doubts)

    def numbers(self, given: Mapping[Mark, object]) -> Numbers:
        """Return the numbers with what is given."""
        project, doubts = self.project, self.doubts
        values = Rescaled(project, doubts.drawn, given, self.views)
        count = len(project.names)
        gone = {**doubts.lost, **self.nothing}
        own = {
            view: Reading(_Rescaled(values, doubts.lost, places), len(places), doubts, places)
            for view, places in project.rows.items()
            if places
        }
        whole = Reading(_Rescaled(values, gone), count, doubts)
        return Numbers(whole, own, Reading(values, count))
