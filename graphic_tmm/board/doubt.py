"""How much rounding does to a drawing: the log is run again, each step shaken by some units in the last place.

Whatever a step makes is moved by a random `SHAKE` of itself, and what comes out is laid over the unshaken
drawing. So an error is magnified, passed on, compensated and lost as in the drawing itself, over any number of
steps and plans: where two loci meet at a small angle 1/κ, a direction taken from their point is off by κ, a
velocity along it by κ², an acceleration by κ³, a force by more. No operation has to tell how it magnifies.

A figure is judged by its own bound at its own position. If the bound leaves a digit of it, it is itself, to the
digits that are sure. If it leaves none, and is small against what such a figure is computed from, the figure is
nothing: the velocity at a dead centre. Else it is not known, and is not there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import part_of, spread
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import (
    Angle,
    Arc,
    Curve,
    Length,
    Line,
    Number,
    Point,
    Reals,
    Side,
    at,
)
from graphic_tmm.board.values import given as as_value

SHAKE = 64 * EPS
"""More than a step's own rounding, so that a few shakes stand for the worst of it."""
SHAKES = 4
"""Each once to and once fro: where one leaves two figures apart, the other brings them together.

Two that cancel each other in one shake seldom do in all of them.
"""
DIGIT = 0.1
"""A figure whose bound is a larger share of it has no digit that is sure."""
DOUBTFUL = 1e-6
"""What rounding moves by more than this share of its natural size is doubtful: no zero is told of it."""
WRITTEN = 1e-12
"""A bound below this share of a figure shows in no digit that is written."""
HALF_TURN = 180.0
"""The natural size of an angle that is measured, degrees."""
BLOCK = 1024
"""Positions shaken at once."""
FIGURES = (Length, Number, Angle)

Mask = NDArray[np.bool_]


class _Found(NamedTuple):
    """By slot: what a mark is unshaken, and how far shaking moves it: a point's place, a line's direction."""

    values: dict[int, Any]
    bounds: dict[int, Reals]


class Doubts:
    """How far rounding moves every mark of some steps at every position; found when first asked for.

    Parameters
    ----------
    steps
        The steps, in the order of the log.
    given
        Values of the marks that they begin with.
    lost
        What is lost, if it is known from a drawing to other scale factors: it does not depend on them.
    to_scale
        Whether the figures to be told are drawn to the scale factors that are given; else they are to
        others, and drawn as exactly.
    ruler
        Instead of rounding, what a ruler of this division (mm) does: each reading is moved by up to half of it.
    """

    def __init__(
        self,
        steps: Sequence[Step],
        given: Mapping[Mark, object],
        lost: Mapping[int, Mask] | None = None,
        to_scale: bool = True,
        ruler: float | None = None,
    ) -> None:
        self.steps = {step.it.slot: step for step in steps}
        made = self.steps.keys()
        begun = {mark for step in steps for mark in step.uses if mark.slot not in made}
        self._given = {mark: as_value(given[mark], mark.kind) for mark in sorted(begun, key=_slot)}
        self._known, self._to_scale, self._ruler = lost, to_scale, ruler
        self._sizes: dict[int, Reals] = {}
        self._extents: dict[str, Reals] = {}
        self.positions = max((v.shape[1] for v in self._given.values()), default=1)

    def bound(self, mark: Mark) -> Reals:
        """Return how far a mark may be off, in its own unit, (1, position); of a line its direction."""
        return self._found.bounds.get(mark.slot, _NOTHING)

    def share(self, mark: Mark) -> Reals:
        """Return how far a point may be off as a share of its plan's extent, (1, position); 0 of others."""
        if mark.kind is not Point or mark.slot not in self._found.bounds:
            return _NOTHING
        bound = self.bound(mark)
        return np.where(bound == 0.0, 0.0, bound / self._extent(mark.view))

    def size(self, mark: Mark) -> Reals:
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

    def figure(self, mark: Mark, value: Any, by: Any = 1.0, places: Any = None) -> Any:
        """Return a mark's value times a scale factor as a figure that may be told.

        It has as many digits as are sure; it is 0 where it is nothing but rounding, NaN where it is lost.
        ``places``: the indices of the value's positions; None for all.
        """
        told = value * by
        if mark.slot not in self._found.bounds or mark.kind is Side:
            return told
        with np.errstate(all="ignore"):
            bound = self._bound_of(told, mark, by, places)
            seen = bound > WRITTEN * np.abs(told)
            if not seen.any():
                return told
            unit = 10.0 ** np.floor(np.log10(np.where(seen & np.isfinite(bound), bound, 1.0)))
            short = np.where(np.abs(told) <= bound, 0.0 * told, np.round(told / unit) * unit)
            told = np.where(seen, short, told)
        gone = self.lost.get(mark.slot)
        return told if gone is None else np.where(at(gone, places), np.nan, told)

    def _bound_of(self, told: Any, mark: Mark, by: Any, places: Any) -> Reals:
        bound = self.bound(mark)
        if self._to_scale:
            return np.asarray(at(bound, places) * np.abs(by))
        drawn = np.abs(self._found.values[mark.slot])
        share = np.where(bound < drawn, bound / drawn, np.where(bound > 0.0, np.inf, 0.0))
        return np.asarray(np.where(told == 0.0, 0.0, at(share, places) * np.abs(told)))

    @cached_property
    def lost(self) -> dict[int, Mask]:
        """Where no digit of a mark is sure though it was drawn, (1, position), by slot; none is left out."""
        if self._known is not None:
            return dict(self._known)
        found: dict[int, Mask] = {}
        with np.errstate(all="ignore"):
            for slot, step in self.steps.items():
                mask = self._lost(step, found)
                if mask is not None and mask.any():
                    found[slot] = mask
        return found

    def _lost(self, step: Step, before: Mapping[int, Mask]) -> Mask | None:
        mark, bound = step.it, self.bound(step.it)
        if mark.kind is Point:
            return self.share(mark) > DIGIT
        if mark.kind in FIGURES:
            value = self._found.values[mark.slot]
            unsure = ~(bound <= DIGIT * np.abs(value)) & np.isfinite(value)
            if not unsure.any():
                return None
            unclean = ~(bound <= DOUBTFUL * self.size(mark))
            figures = [use.slot for use in step.uses if use.kind in FIGURES and use.slot in self.steps]
            if figures and all(slot in before for slot in figures):
                # that figures of which nothing is known are alike says nothing
                masks = np.broadcast_arrays(*(before[slot] for slot in figures))
                unclean = unclean | np.logical_and.reduce(masks)
            return np.asarray(unsure & unclean)
        used = [before[use.slot] for use in step.uses if use.slot in before]
        if mark.kind is Curve:
            # what a curve goes through is lost at some place or other
            used = [np.atleast_2d(mask.any()) for mask in used]
        own = bound > DIGIT
        return np.asarray(np.logical_or.reduce(np.broadcast_arrays(own, *used)))

    # sizes

    def _extent(self, view: str) -> Reals:
        """Return how far a plan reaches at each position: its known points, and what is laid off for others."""
        if view not in self._extents:
            self._extents[view] = self._reach(view)
        return self._extents[view]

    def _reach(self, view: str) -> Reals:
        marks = self._points[view]
        bounds = [self.bound(mark) for mark in marks]
        rows = [self._found.values[mark.slot] for mark in marks]
        known = [b <= DIGIT * np.abs(z) for b, z in zip(bounds, rows, strict=True)]
        all_known = np.logical_and.reduce(np.broadcast_arrays(*known))
        if not all_known.all():
            rows = [np.where(k, z, np.nan) for k, z in zip(known, rows, strict=True)]
        rows = np.broadcast_arrays(*rows)
        x, y = ([part(z) for z in rows] for part in (np.real, np.imag))
        low = np.fmin.reduce(x) + 1j * np.fmin.reduce(y)
        high = np.fmax.reduce(x) + 1j * np.fmax.reduce(y)
        reach = np.abs(np.where(high == low, high, high - low))
        if all_known.all() and (reach > 0.0).all():
            return reach
        # what is laid off may be measured in this plan
        self._extents[view] = reach
        laid = [
            self.size(mark)
            for step in self.steps.values()
            if step.it.view == view and step.it.kind is Point
            for mark in step.uses
            if mark.kind is Length
        ]
        natural = np.fmax.reduce(np.broadcast_arrays(_NOTHING, *laid))
        return np.where(all_known & (reach > 0.0), reach, np.fmax(reach, natural))

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
        step = self.steps.get(mark.slot)
        value = self._found.values[mark.slot]
        with np.errstate(all="ignore"):
            if mark.kind is Point:
                return self._extent(mark.view)
            if step is None or mark.kind not in FIGURES:
                return np.abs(value) if mark.kind in FIGURES else _NOTHING
            if step.op.across:
                alike = [self.size(use) for use in step.uses if use.kind is mark.kind]
                largest = np.fmax.reduce([np.fmax.reduce(size, axis=1) for size in alike], initial=0.0)
                return np.fmax(np.abs(value), np.atleast_2d(largest))
            if all(use.kind in FIGURES for use in step.uses):
                return np.fmax(np.abs(value), self._by_formula(step))
            if mark.kind is Angle:
                return np.full((1, 1), HALF_TURN)
            off = next((use for use in step.uses if use.kind is Point), None)
            return np.abs(value) if off is None else self._extent(off.view)

    def _by_formula(self, step: Step) -> Reals:
        """Return how much a formula gives of the natural sizes, each with its sign and once without."""
        sizes = [self.size(use) for use in step.uses]
        count = len(sizes) + 1
        trials = [np.repeat(size, count, axis=0) for size in sizes]
        for k, trial in enumerate(trials):
            trial[k + 1] *= -1.0
        told = step.op.run(*trials, **step.choice)
        return np.fmax(
            np.abs(told[:1]), np.fmax.reduce(np.abs(told - told[:1]), axis=0, keepdims=True)
        )

    # shaking

    @cached_property
    def _found(self) -> _Found:
        across = any(step.op.across for step in self.steps.values())
        size = self.positions if across else BLOCK
        blocks = []
        with np.errstate(all="ignore"):
            for start in range(0, self.positions, size):
                part = slice(start, min(start + size, self.positions))
                blocks.append(self._shaken({m.slot: part_of(v, part) for m, v in self._given.items()}))
        if len(blocks) == 1:
            return blocks[0]
        return _Found(*(_joined(parts) for parts in zip(*blocks, strict=True)))

    def _shaken(self, values: dict[int, Any]) -> _Found:
        """Run the steps, the values in the first trial unshaken."""
        shakes = iter(_shakes(len(self.steps) + len(self._given)))
        still, bounds = dict(values), dict[int, Reals]()
        count = max((v.shape[1] for v in values.values()), default=1)
        for mark in self._given:
            if mark.kind in (Point, Length, Angle) and self._ruler is None:
                values[mark.slot] = _moved(values[mark.slot], next(shakes))
        for slot, step in self.steps.items():
            takes = [values[mark.slot] for mark in step.uses]
            if step.op.across:
                takes = [spread(value, count) for value in takes]
            value = step.op.run(*takes, **step.choice)
            values[slot] = value = self._with_error(step, value, next(shakes))
            still[slot] = _first(value)
            bounds[slot] = _off(value)
        return _Found(still, bounds)

    def _with_error(self, step: Step, value: Any, shakes: Reals) -> Any:
        if step.op.leaves is Side:
            return value
        if self._ruler is None:
            return _moved(value, shakes)
        return value + shakes[0] / SHAKE * (self._ruler / 2.0) if step.op.reads else value


_NOTHING = np.zeros((1, 1))


def _slot(mark: Mark) -> int:
    return mark.slot


def _joined(parts: Sequence[dict[int, Any]]) -> dict[int, Any]:
    """Join what was found by blocks; what does not vary along the first block varies nowhere."""
    return {slot: _row([part[slot] for part in parts]) for slot in parts[0]}


def _row(parts: Sequence[Any]) -> Any:
    first = parts[0]
    if isinstance(first, tuple):
        return type(first)(*(_row(arrays) for arrays in zip(*parts, strict=True)))
    return first if first.shape[1] == 1 else np.concatenate(parts, axis=1)


def _shakes(count: int) -> Reals:
    """Return shakes (value, part, trial, 1): none in the first trial, then half to whole ones to and fro."""
    random = np.random.default_rng(0)
    shape = (count, 3, SHAKES)
    sizes = random.uniform(0.5, 1.0, shape) * random.choice((-1.0, 1.0), shape)
    return SHAKE * np.concatenate((np.zeros((count, 3, 1)), sizes, -sizes), axis=2)[..., None]


def _moved(value: Any, shakes: Reals) -> Any:
    """Move the parts of a value."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, Line):
        at, along = value
        return Line(_moved(at, shakes), along * (1.0 + 1j * shakes[2]))
    if isinstance(value, Arc):
        return Arc(_moved(value.centre, shakes), value.radius * (1.0 + shakes[2]))
    if np.iscomplexobj(value):
        return value * (1.0 + shakes[0] + 1j * shakes[1])
    return value * (1.0 + shakes[0])


def _first(value: Any) -> Any:
    """Return a value of the unshaken trial, without holding the others."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*map(_first, value))
    return value[:1].copy()


def _off(value: Any) -> Reals:
    """Return how far the shaken trials are from the first, at most; without end where none is there."""
    if isinstance(value, Curve):
        return _NOTHING
    if isinstance(value, Line):
        value = value.along
    elif isinstance(value, Arc):
        value = value.radius / np.abs(value.radius[:1])
    off = np.abs(value - value[:1])[1:]
    if not off.size:
        return _NOTHING
    lost = np.isnan(off).all(axis=0)
    return np.atleast_2d(np.where(lost, np.inf, np.fmax.reduce(off, axis=0)))
