"""Natural sizes: how large a figure is that is computed from such things, whatever its own value.

They tell a figure that is nothing (a velocity at a dead centre, small against its plan) from one of which
nothing is known. Of what is unknown itself, a natural size makes no use.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.shaking import NOTHING, Shaken
from graphic_tmm.board.values import Angle, Length, Number, Point, Reals

DIGIT = 0.1
"""A figure whose bound is a larger share of it has no digit that is sure."""
FIGURES = (Length, Number, Angle)
HALF_TURN = 180.0
"""The natural size of an angle, degrees."""


class Sizes:
    """The natural sizes of the marks of some steps (by slot), found when they are asked for."""

    def __init__(self, steps: Mapping[int, Step], found: Shaken) -> None:
        self.steps, self.found = steps, found
        self._sizes: dict[int, Reals] = {}
        self._extents: dict[str, Reals] = {}
        self._reaches: dict[str, Reals] = {}

    def of(self, mark: Mark) -> Reals:
        """Return the natural size of a mark: that of what it is computed from, (1, position).

        Of a point and of what is read off a plan, the plan's extent at that position; of what is calculated,
        the largest that its formula gives of the sizes of what it takes, whatever their signs.
        """
        for one in self._unsized(mark):
            self._sizes[one.slot] = self._size(one)
        return self._sizes[mark.slot]

    def _unsized(self, mark: Mark) -> list[Mark]:
        """Return what has to be sized for a mark, itself the last."""
        found: dict[int, Mark] = {}
        left = [mark]
        while left:
            one = left.pop()
            if one.slot not in self._sizes and one.slot not in found:
                found[one.slot] = one
                step = self.steps.get(one.slot)
                left += [use for use in step.uses if use.kind in FIGURES] if step else []
        return [found[slot] for slot in sorted(found)]

    def reach(self, view: str) -> Reals:
        """Return how far the points of a plan lie apart that are drawn, (1, position); 0 without points."""
        if view not in self._reaches:
            self._reaches[view] = self._apart(view)
        return self._reaches[view]

    def _apart(self, view: str) -> Reals:
        if not self._points.get(view):
            return NOTHING
        rows = np.broadcast_arrays(*(self.found.values[mark.slot] for mark in self._points[view]))
        x, y = ([part(z) for z in rows] for part in (np.real, np.imag))
        sides = [np.fmax.reduce(row) - np.fmin.reduce(row) for row in (x, y)]
        found: Reals = np.hypot(*sides)
        return found

    def extent(self, view: str) -> Reals:
        """Return how far a plan reaches, (1, position): its known points, what is laid off for the others."""
        if view not in self._extents:
            self._extents[view] = self._reach(view)
        return self._extents[view]

    def _reach(self, view: str) -> Reals:
        marks = self._points[view]
        bounds = [self._bound(mark) for mark in marks]
        rows = [self.found.values[mark.slot] for mark in marks]
        known = [b <= DIGIT * np.abs(z) for b, z in zip(bounds, rows, strict=True)]
        all_known = np.logical_and.reduce(np.broadcast_arrays(*known))
        if not all_known.all():
            rows = [np.where(k, z, np.nan) for k, z in zip(known, rows, strict=True)]
        x, y = ([part(z) for z in np.broadcast_arrays(*rows)] for part in (np.real, np.imag))
        low = np.fmin.reduce(x) + 1j * np.fmin.reduce(y)
        high = np.fmax.reduce(x) + 1j * np.fmax.reduce(y)
        reach: Reals = np.abs(np.where(high == low, high, high - low))
        if all_known.all() and (reach > 0.0).all():
            return reach
        # what is laid off may be measured in this plan
        self._extents[view] = reach
        laid = [
            np.where(np.isfinite(self.found.values[mark.slot]), self.of(mark), 0.0)
            for step in self.steps.values()
            if step.it.view == view and step.it.kind is Point
            for mark in step.uses
            if mark.kind is Length
        ]
        natural = np.fmax.reduce(np.broadcast_arrays(NOTHING, *laid))
        found: Reals = np.where(all_known & (reach > 0.0), reach, np.fmax(reach, natural))
        return found

    @cached_property
    def _points(self) -> dict[str, tuple[Mark, ...]]:
        """Return the points of each plan."""
        points: dict[str, dict[Mark, None]] = {}
        for step in self.steps.values():
            for mark in (step.it, *step.uses):
                if mark.kind is Point:
                    points.setdefault(mark.view, {})[mark] = None
        return {view: tuple(marks) for view, marks in points.items()}

    def _size(self, mark: Mark) -> Reals:
        step, value = self.steps.get(mark.slot), self.found.values[mark.slot]
        with np.errstate(all="ignore"):
            if mark.kind is Point:
                return self.extent(mark.view)
            if mark.kind not in FIGURES:
                return NOTHING
            size: Reals = np.abs(value)
            if step is None:
                return size
            natural = self._natural(step)
            known = np.where(self._bound(mark) <= DIGIT * size, size, 0.0)
            return np.asarray(np.fmax(natural, known))

    def _natural(self, step: Step) -> Reals:
        mark = step.it
        if step.op.across:
            alike = [self.of(use) for use in step.uses if use.kind is mark.kind]
            rows = [np.fmax.reduce(size, axis=1, keepdims=True) for size in (*alike, NOTHING)]
            return np.asarray(np.fmax.reduce(rows))
        if mark.kind is Angle:
            return np.full((1, 1), HALF_TURN)
        if all(use.kind in FIGURES for use in step.uses):
            return self._by_formula(step)
        seen = next((use for use in step.uses if use.kind is Point), None)
        return NOTHING if seen is None else self.extent(seen.view)

    def _by_formula(self, step: Step) -> Reals:
        """Return how much a formula gives of the natural sizes, each with its sign and once without."""
        sizes = [self.of(use) for use in step.uses]
        count = len(sizes) + 1
        trials = [np.repeat(size, count, axis=0) for size in sizes]
        for k, trial in enumerate(trials):
            trial[k + 1] *= -1.0
        told = step.op.run(*trials, **step.choice)
        turned = np.fmax.reduce(np.abs(told - told[:1]), axis=0, keepdims=True)
        return np.asarray(np.fmax(np.abs(told[:1]), turned))

    def _bound(self, mark: Mark) -> Reals:
        return self.found.bounds.get(mark.slot, NOTHING)
