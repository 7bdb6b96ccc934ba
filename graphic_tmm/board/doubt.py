"""How much rounding does to a drawing: the log is run again, each step shaken by some units in the last place.

Whatever a step makes is moved by a random `SHAKE` of itself, and what comes out is laid over the unshaken
drawing. So an error is magnified, passed on, compensated and lost as in the drawing itself, over any number of
steps and plans: where two loci meet at a small angle 1/κ, a direction taken from their point is off by κ, a
velocity along it by κ², an acceleration by κ³, a force by more. No operation has to tell how it magnifies.

A figure is judged by its own bound at its own position. If the bound leaves a digit of it, it is itself, to the
digits that are sure. If it leaves none, and is small against what such a figure is computed from, the figure is
nothing: the velocity at a dead centre. Else it is not known, and is not there. What is so small against what it
is computed from that nobody could read it is nothing too, whatever digits of it are sure.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.shaking import NOTHING, Shaken, shaken
from graphic_tmm.board.sizes import DIGIT, FIGURES, Sizes
from graphic_tmm.board.values import Curve, Length, Point, Reals, Side, at
from graphic_tmm.board.values import given as as_value
from graphic_tmm.board.values import places as width

DOUBTFUL = 1e-6
"""What rounding moves by more than this share of its natural size is doubtful: no zero is told of it."""
WRITTEN = 1e-12
"""A bound below this share of a figure shows in no digit that is written."""
SHEET = 1000.0
"""No plan that is drawn is larger, mm."""
UNREAD = 1e-9
"""What is a smaller share of its plan is nothing: a nanometre on a plan of a metre."""
SHAKEN = 1e-8
"""A number so small beside its natural size is a difference: its bound is a larger share of it."""

Mask = NDArray[np.bool_]


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
    coarse
        For some marks by slot: doubts that leave fewer digits of their figures.
    ruler
        Instead of rounding, what a ruler of this division (mm) does: each reading is moved by up to half of it.
    """

    def __init__(
        self,
        steps: Sequence[Step],
        given: Mapping[Mark, object],
        lost: Mapping[int, Mask] | None = None,
        to_scale: bool = True,
        coarse: Mapping[int, Doubts] | None = None,
        ruler: float | None = None,
    ) -> None:
        self.steps = {step.it.slot: step for step in steps}
        made = self.steps.keys()
        begun = {mark for step in steps for mark in step.uses if mark.slot not in made}
        self._given = {mark: as_value(given[mark], mark.kind) for mark in sorted(begun, key=_slot)}
        self._coarse = coarse or {}
        self._known, self.to_scale, self._ruler = lost, to_scale, ruler
        self._positions = max(map(width, self._given.values()), default=1)

    def coarsened(self, coarse: Mapping[int, Doubts]) -> Doubts:
        """Return the same doubts where those by slot leave fewer digits; nothing is shaken again."""
        other = copy(self)
        other.__dict__ |= {"_coarse": coarse, "lost": self.lost}
        return other

    @property
    def drawn(self) -> Mapping[int, Any]:
        """What an exact hand draws of what is given here, by slot, at all positions; nothing of no steps."""
        return self._shaken_log.values if self.steps else {}

    def bound(self, mark: Mark) -> Reals:
        """Return how far a mark may be off, in its own unit, (1, position); of a line its direction."""
        return self._shaken_log.bounds.get(mark.slot, NOTHING)

    def share(self, mark: Mark) -> Reals:
        """Return how far a point may be off as a share of its plan's extent, (1, position); 0 of others."""
        if mark.kind is not Point or mark.slot not in self._shaken_log.bounds:
            return NOTHING
        bound = self.bound(mark)
        return np.where(bound == 0.0, 0.0, bound / self._sizes.extent(mark.view))

    def figure(self, mark: Mark, value: Any, by: Any = 1.0, places: Any = None) -> Any:
        """Return a mark's value times a scale factor as a figure that may be told.

        It has as many digits as are sure; it is 0 where it is nothing but rounding, NaN where it is lost.
        ``places``: the indices of the value's positions; None for all.
        """
        told = self._by_ruler(mark, value, places) * by
        if mark.slot not in self._shaken_log.bounds or mark.kind is Side:
            return told
        with np.errstate(all="ignore"):
            bound = self._bound_of(told, mark, by, places)
            seen = bound > WRITTEN * np.abs(told)
            unit = 10.0 ** np.floor(np.log10(np.where(seen & np.isfinite(bound), bound, 1.0)))
            nothing = seen & (np.abs(told) <= bound)
            told = np.where(seen, np.round(told / unit) * unit, told)
            if nothing.any():
                told = np.where(nothing, self._nought(mark, places), told)
            if mark.kind in FIGURES and self.to_scale:
                told = np.where(self._unread(told, mark, by, places), 0.0 * told, told)
        gone = self.lost.get(mark.slot)
        return told if gone is None else np.where(at(gone, places), np.nan, told)

    def size(self, mark: Mark) -> Reals:
        """Return the natural size of a mark, that of what it is computed from, (1, position)."""
        with np.errstate(all="ignore"):
            return self._sizes.of(mark)

    def nothing(self, mark: Mark) -> Mask:
        """Where a figure is nothing but rounding, drawn exactly, (1, position)."""
        value = self._shaken_log.values[mark.slot]
        return np.asarray(self.figure(mark, value) == 0.0)

    def _unread(self, told: Any, mark: Mark, by: Any, places: Any) -> Mask:
        """Return where a figure is too small for its plan, or for what it is the difference of, to be read.

        A plan counts as no larger than a sheet: a point that lies far off tells nothing of the others. A length
        that is calculated to be laid off is what its quantity is, however small.
        """
        if mark.kind is Length and self.steps[mark.slot].op.formula:
            return np.zeros(told.shape, dtype=bool)
        if mark.kind is Length:
            size = np.fmin(self._sizes.reach(mark.view), SHEET)
        else:
            shaken = self.bound(mark) > SHAKEN * np.abs(self._shaken_log.values[mark.slot])
            size = np.where(shaken, self._sizes.of(mark), 0.0) if shaken.any() else np.zeros((1, 1))
        size = at(size, places)
        if told.shape[1] == 1:
            size = np.fmin.reduce(size, axis=1, keepdims=True)
        least = UNREAD * size * np.abs(by)
        return np.asarray(np.isfinite(least) & (np.abs(told) < least))

    def _nought(self, mark: Mark, places: Any) -> Reals:
        """Return 0 where a bound is small against what a mark is computed from, NaN where it is not."""
        if mark.kind not in FIGURES:
            return np.zeros((1, 1))
        return np.asarray(at(np.where(self._small(mark), 0.0, np.nan), places))

    def _small(self, mark: Mark) -> Mask:
        """Where a bound, if there is one, is small against what a mark is computed from."""
        bound = self.bound(mark)
        return np.asarray((bound <= DOUBTFUL * self._sizes.of(mark)) & np.isfinite(bound))

    def _by_ruler(self, mark: Mark, value: Any, places: Any) -> Any:
        """Return a value to the digits that the ruler leaves of it, but whole at least."""
        if mark.slot not in self._coarse:
            return value
        bound = at(self._coarse[mark.slot].bound(mark), places)
        with np.errstate(all="ignore"):
            unit = np.minimum(10.0 ** np.floor(np.log10(bound)), 1.0)
            return np.where(unit > 0.0, np.round(value / unit) * unit, value)

    def _bound_of(self, told: Any, mark: Mark, by: Any, places: Any) -> Reals:
        bound = self.bound(mark)
        if self.to_scale:
            return np.asarray(at(bound, places) * np.abs(by))
        drawn = np.abs(self._shaken_log.values[mark.slot])
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
            value = self._shaken_log.values[mark.slot]
            unsure = ~(bound <= DIGIT * np.abs(value)) & np.isfinite(value)
            if not unsure.any():
                return None
            unclean = ~self._small(mark)
            figures = [
                use.slot for use in step.uses if use.kind in FIGURES and use.slot in self.steps
            ]
            if figures and all(slot in before for slot in figures):
                # that figures of which nothing is known are alike says nothing
                masks = np.broadcast_arrays(*(before[slot] for slot in figures))
                unclean = unclean | np.logical_and.reduce(masks)
            return np.asarray(unsure & unclean)
        used = [before[use.slot] for use in step.uses if use.slot in before]
        if mark.kind is Curve:
            # what a curve goes through is lost at some place or other of its row
            row = step.choice.get("row")
            used = [np.atleast_2d(mask[:, :row].any()) for mask in used]
        own = bound > DIGIT
        return np.asarray(np.logical_or.reduce(np.broadcast_arrays(own, *used)))

    @cached_property
    def _shaken_log(self) -> Shaken:
        return shaken(list(self.steps.values()), self._given, self._positions, self._ruler)

    @cached_property
    def _sizes(self) -> Sizes:
        return Sizes(self.steps, self._shaken_log)


def _slot(mark: Mark) -> int:
    return mark.slot
