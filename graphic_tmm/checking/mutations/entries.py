"""What readings tell for and against mutations: entry by entry how likely each is, base and rows.

An entry is a reading against what it should be. Where its step is known it is the step's own error, with the
earlier readings as they were found; else (a diagram, a force) the figure that the log leads to, with what
was read put in.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Length, Point
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.judging.own_errors import apart, errors_at, exact
from graphic_tmm.checking.mutations.execution import Executed, Rows, executed
from graphic_tmm.checking.mutations.likelihood import (
    BEYOND,
    LOST,
    PLAN,
    broad,
    explained,
    log_density,
    multiple,
    size_of,
)
from graphic_tmm.checking.mutations.mutation import Mutation

Array = NDArray[np.float64]


class MarkErrors(NamedTuple):
    """The errors of one mark where it was read, (part, position), NaN where it was not; with their sizes.

    ``figure``: what was read, its size; ``mm``: what a millimetre is in its unit; ``drawn``: it is drawn and
    read off the paper, so that a longer line is farther off; what is calculated is not.
    """

    mark: Mark
    error: Array
    scatter: Array
    figure: Array
    mm: float
    drawn: bool = True

    @property
    def read(self) -> NDArray[np.bool_]:
        """Where it was read and can be drawn from the points before it, (position,): else it tells nothing."""
        return np.asarray(np.isfinite(self.scatter[0]) & np.isfinite(self.error).all(axis=0))


class Weighed(NamedTuple):
    """The evidence: of the base by entry, (position,), and what rows gain on it.

    ``base``, ``unknown``: logarithms of likelihoods by mark, (position,), as the base has them, and if nothing
    were known of that step. ``gain``: (row, position) of all entries together; ``beyond``, ``lost``: how many
    readings are unexplained, and how many cannot be drawn, (row, position). ``moved``, ``squares``: how many
    are moved and explained, and the sum of the squares of how far off these are. ``errors``: what differs, by
    mark: rows and their errors in sizes, (row, position). ``off``: the base's, (position,). ``multiples``: what
    the readings of a segment gain by being so many times what is due.
    """

    base: Mapping[Mark, Array]
    unknown: Mapping[Mark, Array]
    gain: Array
    beyond: Array
    lost: Array
    moved: Array
    squares: Array
    errors: Mapping[Mark, tuple[tuple[Rows, Array], ...]]
    off: Mapping[Mark, Array]
    multiples: Mapping[Mark, float]
    beside: Executed


class Own:
    """Own errors of the base and of rows, while the log is executed with what was read."""

    def __init__(self, drawing: Comparison, found: Mapping[Mark, Any], log: Construction) -> None:
        assert drawing.made.mechanism is not None
        self.work, self.found, self.drawing = drawing.made.mechanism, found, drawing
        self.lines = {step.it: step for step in log.steps}
        self.due: dict[Mark, Any] = {}
        self.base: dict[Mark, Array] = {}
        """Of the base, (part, trial, position)."""
        self.rows: dict[Mark, list[tuple[Rows, Array]]] = defaultdict(list)

    def seen(self, step: Step, rows: Rows | None, drawn: list[Any], value: Any) -> Any:
        """Take the errors of a step that was read; go on with what was read."""
        read = self.found.get(step.it)
        if read is None:
            return value
        if rows is None:
            self.due[step.it] = value
        errors = self._errors(step, drawn, value, read)
        if rows is None:
            self.base[step.it] = errors
        else:
            drawn_at_all = np.isfinite(value)  # any point of two lines in one is on both of them
            self.rows[step.it].append((rows, np.where(drawn_at_all, errors, np.nan)))
        going = read if step.it.kind is Point else slips.directed(read, value)
        return np.where(np.isnan(read), value, going)

    def _errors(self, step: Step, drawn: list[Any], value: Any, read: Any) -> Array:
        """Return errors, (part, row, position)."""
        if step.it.kind is not Point:
            return np.asarray(apart(read, value))[None]
        known = OPERATIONS.get(step.op.name)
        if known is None or known.run is not step.op.run:
            # lines and lengths tell nothing of what was done with them otherwise
            return np.asarray(slips.off_place(read, value))[None]
        values = {mark.slot: one for mark, one in zip(step.uses, drawn, strict=True)}
        parts = errors_at(
            lambda mark: exact(self.work, mark), self.lines, step, read, value, values, self.due
        )
        found = [np.asarray(part.error) for part in parts]
        return np.stack(np.broadcast_arrays(*found))


def weighed(
    drawing: Comparison,
    found: Mapping[Mark, Any],
    log: Construction,
    given: Mapping[Mark, object],
    mutations: Sequence[Mutation],
    scatters: Mapping[Mark, Array] | None = None,
    wanted: Sequence[Mark] = (),
) -> Weighed:
    """Return the evidence of what was read for mutations of a log.

    ``found``: by mark, (1, position); ``scatters``: of the hand's own errors, (part, position), else as the
    drawing's yardstick has them. ``wanted``: further marks to find.
    """
    own = Own(drawing, found, log)
    beside = executed(log, given, mutations, (*found, *wanted), own.seen)
    places = len(own.work.names)
    gain = np.zeros((len(mutations), places))
    beyond, lost, moved, squares = (np.zeros_like(gain) for _ in range(4))
    base: dict[Mark, Array] = {}
    unknown: dict[Mark, Array] = {}
    off: dict[Mark, Array] = {}
    multiples: dict[Mark, float] = {}
    errors: dict[Mark, tuple[tuple[Rows, Array], ...]] = {}
    for mark, error in own.base.items():
        entry = entry_of(drawing, mark, error[:, 0], found[mark][0], scatters)
        if entry is None:
            continue
        told = EntryEvidence(entry)
        base[mark], off[mark] = told.likely, told.off
        unknown[mark] = told.unknown
        if mark.kind is not Point:
            read = found[mark][0]
            due = read - entry.error[0]
            multiples[mark] = multiple(read, due, entry.scatter[0], entry.figure, entry.mm)
        told_rows = []
        for rows, some in own.rows.get(mark, ()):
            likely, far, gone = told.rows(some)
            gain[rows] += likely - told.likely
            beyond[rows] += (far > BEYOND) * 1.0 - (told.off > BEYOND)
            lost[rows] += gone
            some_moved, some_squares = explained(far, told.off)
            moved[rows] += some_moved
            squares[rows] += some_squares
            told_rows.append((rows, far))
        errors[mark] = tuple(told_rows)
    whole = sum((one > BEYOND) * 1.0 for one in off.values())
    gain_and_lost = gain, beyond + whole, lost, moved, squares
    return Weighed(base, unknown, *gain_and_lost, errors, off, multiples, beside)


def entry_of(
    drawing: Comparison,
    mark: Mark,
    error: Array,
    read: Any,
    scatters: Mapping[Mark, Array] | None,
) -> MarkErrors | None:
    """Return the errors of a mark with how a hand makes them; None where nothing is known of that."""
    places = read.shape[0]
    scatter = np.full((error.shape[0], places), np.nan)
    share = drawing.share if mark.kind is Point else 1.0
    grain = drawing.read_marks[1].get(mark)
    for place in np.flatnonzero(~np.isnan(read)):
        own = drawing.by.steps.get((mark, int(place)))
        if own is None:
            continue
        sizes = np.array(own.at(share))
        if scatters is not None and mark in scatters:
            sizes = scatters[mark][:, place]
        sizes = sizes if sizes.size == error.shape[0] else np.full(error.shape[0], sizes.max())
        rounding = 0.0 if grain is None else float(grain.read[0, place])
        larger = drawing.larger(mark.view, int(place))
        scatter[:, place] = np.hypot(larger * sizes, rounding / np.sqrt(3.0))
    if not np.isfinite(scatter).any():
        return None
    mm = 1.0 if mark.kind in (Length, Point) else 0.0
    figure = np.abs(np.asarray(read))
    step = drawing.step_of(mark)
    drawn = mark.kind is Point or step is None or step.op.reads
    whole = np.broadcast_to(error, scatter.shape)
    return MarkErrors(mark, whole, scatter, np.nan_to_num(figure), mm, drawn)


class EntryEvidence:
    """An entry's evidence, of the base once, then of rows."""

    def __init__(self, entry: MarkErrors) -> None:
        self.entry = entry
        self.figure = np.full_like(entry.figure, PLAN) if entry.mark.kind is Point else entry.figure
        self.size = size_of(entry.scatter, entry.figure, entry.mm)
        self.likely, self.off, _ = (
            one[0] for one in self._of(entry.error[:, None], self.size[:, None])
        )
        with np.errstate(all="ignore"):
            nothing = np.log(broad(np.abs(entry.error), self.size, self.figure)).sum(axis=0)
            free = np.logaddexp(self.likely, nothing) - np.log(2.0)
            nearest = log_density(np.zeros_like(self.size), self.size, self.figure).sum(axis=0)
        self.unknown = np.where(entry.read, free, 0.0)
        self.nearest = np.where(entry.read, nearest, 0.0)

    def rows(self, errors: Array) -> tuple[Array, Array, Array]:
        """Return how likely, how far off, how lost rows of errors (part, row, position) are."""
        if errors.shape[0] != self.entry.error.shape[0]:
            errors = np.max(np.abs(errors), axis=0)[None]
            entry = self.entry._replace(
                error=np.max(np.abs(self.entry.error), axis=0)[None],
                scatter=np.max(self.entry.scatter, axis=0)[None],
            )
            return EntryEvidence(entry).rows(errors)
        change = np.nan_to_num(errors - self.entry.error[:, None], posinf=0.0, neginf=0.0)
        change = change * self.entry.drawn
        size = size_of(
            self.entry.scatter[:, None], self.entry.figure, self.entry.mm, np.abs(change)
        )
        return self._of(errors, size)

    def _of(self, errors: Array, size: Array) -> tuple[Array, Array, Array]:
        errors = np.where(np.isfinite(errors), errors, np.nan)
        with np.errstate(all="ignore"):
            likely = log_density(errors, size, self.figure)
            off = np.max(np.abs(errors) / size, axis=0)
        gone = np.isnan(errors).any(axis=0) & self.entry.read
        likely = np.where(np.isnan(likely), 0.0, likely).sum(axis=0)
        likely = np.where(gone, LOST, likely)
        read = self.entry.read
        return (
            np.where(read, likely, 0.0),
            np.where(read, np.nan_to_num(off), 0.0),
            np.where(read, gone, False) * 1.0,
        )
