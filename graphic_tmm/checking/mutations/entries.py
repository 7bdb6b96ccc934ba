"""What readings tell for and against mutations: how likely each is by the base, and by rows beside it.

Where a reading's step is known it is weighed by the step's own error, with the earlier readings as they were
found. Readings of no mark of their own (diagrams, forces, results, parts) are weighed by the tables' figures,
which hang on many that were read before: such a figure may have been found from these, or from what the student
had without writing it down; of both what the readings are more likely with is taken.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.checking.cells import Key, due_figure, taken_figure
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.judging.own_errors import apart, errors_at, exact
from graphic_tmm.checking.mutations.execution import AssumedLog, Executed, Rows, executed
from graphic_tmm.checking.mutations.likelihood import (
    LOST,
    PLAN,
    Evidence,
    Likelihood,
    broad,
    log_density,
    multiple,
    size_of,
)
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.records import Taken

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


class Own:
    """Own errors of the base and of mutated rows: a log executed with what was read.

    ``found``: by mark, (1, position) or a row for each variation; ``wanted``: further marks to find.
    """

    def __init__(
        self,
        drawing: Comparison,
        found: Mapping[Mark, Any],
        base: AssumedLog,
        mutations: Sequence[Mutation] = (),
        wanted: Sequence[Mark] = (),
    ) -> None:
        assert drawing.made.mechanism is not None
        self.work, self.found = drawing.made.mechanism, found
        self.signed = drawing.signed_marks
        self.lines = {step.it: step for step in base.log.steps}
        self.due: dict[Mark, Any] = {}
        self.base: dict[Mark, Array] = {}
        """Of the base, (part, trial, position)."""
        self.rows: dict[Mark, list[tuple[Rows, Array]]] = defaultdict(list)
        marks = (*found, *wanted)
        self.beside = executed(base.log, base.given, mutations, marks, self._seen)

    def _seen(self, step: Step, rows: Rows | None, drawn: list[Any], value: Any) -> Any:
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
        return np.where(np.isnan(read), value, self._going(step, read, value))

    def _going(self, step: Step, read: Any, value: Any) -> Any:
        """Return a figure as others start from it."""
        if step.it.kind is Point:
            return read
        sure = self.signed.get(step.it, False) if step.it.kind is Number else False
        return np.where(sure, read, slips.directed(read, value))

    def _errors(self, step: Step, drawn: list[Any], value: Any, read: Any) -> Array:
        """Return errors, (part, row, position)."""
        if step.it.kind is not Point:
            return np.asarray(apart(read, value, self.signed.get(step.it, False)))[None]
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
        base = self._of(entry.error[:, None], self.size[:, None])
        self.base = Likelihood(*(part[0] for part in base))
        with np.errstate(all="ignore"):
            nothing = np.log(broad(np.abs(entry.error), self.size, self.figure)).sum(axis=0)
            free = np.logaddexp(self.base.likely, nothing) - np.log(2.0)
            nearest = log_density(np.zeros_like(self.size), self.size, self.figure).sum(axis=0)
        self.unknown = np.where(entry.read, free, 0.0)
        self.nearest = np.where(entry.read, nearest, 0.0)

    def rows(self, errors: Array) -> Likelihood:
        """Return how likely rows of errors are, (part, row, position); (row, position)."""
        if errors.shape[0] != self.entry.error.shape[0]:
            errors = np.max(np.abs(errors), axis=0)[None]
            entry = self.entry._replace(
                error=np.max(np.abs(self.entry.error), axis=0)[None],
                scatter=np.max(self.entry.scatter, axis=0)[None],
            )
            return EntryEvidence(entry).rows(errors)
        change = np.nan_to_num(errors - self.entry.error[:, None], posinf=0.0, neginf=0.0)
        change = np.abs(change * self.entry.drawn)
        size = size_of(self.entry.scatter[:, None], self.entry.figure, self.entry.mm, change)
        return self._of(errors, size)

    def _of(self, errors: Array, size: Array) -> Likelihood:
        errors = np.where(np.isfinite(errors), errors, np.nan)
        with np.errstate(all="ignore"):
            likely = log_density(errors, size, self.figure)
            off = np.max(np.abs(errors) / size, axis=0)
        read = self.entry.read
        gone = np.isnan(errors).any(axis=0) & read
        likely = np.where(np.isnan(likely), 0.0, likely).sum(axis=0)
        likely = np.where(gone, LOST, np.where(read, likely, 0.0))
        return Likelihood(likely, np.where(read, np.nan_to_num(off), 0.0), gone.astype(np.float64))


class Weighed(NamedTuple):
    """The evidence for mutations of a log, that of the base by mark, and the log executed with them.

    ``multiples``: what the readings of a segment gain by being so many times what is due.
    """

    evidence: Evidence
    entries: Mapping[Mark, EntryEvidence]
    multiples: Mapping[Mark, float]
    beside: Executed


def weighed(
    drawing: Comparison,
    found: Mapping[Mark, Any],
    base: AssumedLog,
    mutations: Sequence[Mutation],
    scatters: Mapping[Mark, Array] | None = None,
    wanted: Sequence[Mark] = (),
) -> Weighed:
    """Return the evidence of what was read for mutations of a log.

    ``found``: by mark, (1, position); ``scatters``: of the hand's own errors, (part, position), else as the
    drawing's yardstick has them. ``wanted``: further marks to find.
    """
    own = Own(drawing, found, base, mutations, wanted)
    places = len(own.work.names)
    evidence, every = Evidence.none(len(mutations), places), slice(places)
    entries: dict[Mark, EntryEvidence] = {}
    multiples: dict[Mark, float] = {}
    for mark, error in own.base.items():
        read = found[mark][0]
        entry = entry_of(drawing, mark, error[:, 0], read, scatters)
        if entry is None:
            continue
        told = entries[mark] = EntryEvidence(entry)
        if mark.kind is not Point:
            due = read - entry.error[0]
            multiples[mark] = multiple(read, due, entry.scatter[0], entry.figure, entry.mm)
        evidence.begin(every, told.base)
        for rows, errors in own.rows.get(mark, ()):
            evidence.add(rows, every, told.rows(errors), told.base)
    return Weighed(evidence, entries, multiples, own.beside)


class Reading(NamedTuple):
    """A reading of such a figure: what was found and is due, by what it scatters, what a mm is in its unit.

    ``place``: the index of its position, the number of positions where it has none of the mechanism's;
    ``beside``: it is the quantity of a length that was read, too.
    """

    taken: Taken
    found: complex
    due: complex
    scatter: float
    mm: float
    place: int
    beside: bool = False

    @property
    def at(self) -> tuple[Key, bool]:
        """By what its figure is known."""
        return self.taken.at

    def evidence(self, figures: Any, found: Any = None) -> Likelihood:
        """Return how likely it is by figures, (row,); ``found``: what was read, if otherwise."""
        read = self.found if found is None else found
        if self.taken.pointed:
            error = np.abs(np.asarray(read) - figures)
        else:
            written, signed = np.asarray(read, complex).real, self.taken.signed and not self.beside
            error = apart(written, np.asarray(figures).real, signed)
        change = np.abs(np.asarray(figures) - self.due)
        gone = ~np.isfinite(error)
        whole = PLAN if self.taken.pointed else abs(self.found)
        figure = 0.0 if self.taken.pointed else whole
        size = size_of(self.scatter, figure, self.mm, np.nan_to_num(change))
        with np.errstate(all="ignore"):
            likely = log_density(error, size, whole)
            off = np.abs(error) / size
        return Likelihood(np.where(gone, LOST, likely), np.where(gone, 0.0, off), gone * 1.0)

    @property
    def nearest(self) -> float:
        """The logarithm of how likely it is if it is exactly what it was expected to be."""
        return float(self.evidence(self.found).likely)

    @property
    def unknown(self) -> float:
        """The logarithm of how likely it is if nothing is known of how it was found."""
        size = size_of(self.scatter, abs(self.found), self.mm)
        known = self.evidence(self.due).likely
        free = broad(abs(self.found - self.due), size, abs(self.found))
        return float(np.log(0.5 * np.exp(known) + 0.5 * free))


def column_readings(drawing: Comparison, marked: Sequence[Taken]) -> list[Reading]:
    """Return the readings of a drawing that no step of their own is known of; ``marked``: the others."""
    known = set(marked)
    names = drawing.names
    found = []
    for taken in drawing.rows:
        limit = drawing.by.spread.get(taken.at)
        if taken in known or limit is None or not limit.sorted.size:
            continue
        place = names.index(taken.position) if taken.position in names else len(names)
        scatter = drawing.worse * limit.rms
        if taken.pointed:
            found.append(Reading(taken, taken.spot, drawing.spots[taken.key], scatter, 1.0, place))
            continue
        cell = drawing.due[taken.key]
        mu = 1.0 if taken.mm is not None else drawing.scale(taken)
        mm = mu if np.isfinite(mu) else 0.0
        beside = drawing.length_of(taken)
        due = due_figure(cell, taken)
        if beside is not None and np.isfinite(mu):
            due, scatter = abs(beside.mm or 0.0) * mu, 0.0
        figure, length = taken_figure(taken, cell), beside is not None
        figure = abs(figure) if length else figure  # a length has no sign to compare
        found.append(Reading(taken, figure, due, scatter, mm, place, length))
    return found


def column_multiples(
    rows: Sequence[Reading], *, whole: bool = False, own: bool = False
) -> list[float]:
    """Return what the readings of each segment, or ``whole`` plan, gain by being so many times what is due.

    ``own``: by a scale factor of the student's own.
    """
    segments: dict[tuple[str, str, bool], list[Reading]] = {}
    for one in rows:
        if not one.beside and not one.taken.pointed:
            segment = "" if whole else one.taken.segment
            key = one.taken.plan, segment, one.taken.mm is not None
            segments.setdefault(key, []).append(one)
    found = []
    for some in segments.values():
        read = np.array([one.found.real for one in some])
        due = read - np.array(
            [float(apart(one.found.real, one.due.real, one.taken.signed)) for one in some]
        )
        scatter = np.array([one.scatter for one in some])
        mm = max(one.mm for one in some)
        found.append(multiple(read, due, scatter, np.abs(read), mm, own=own))
    return found


def column_gains(
    rows: Sequence[Reading], ways: Sequence[Mapping[tuple[Key, bool], Any]], count: int, places: int
) -> Evidence:
    """Return the evidence of readings for so many hypotheses, at so many positions.

    ``ways``: the figures of hypotheses, each way they may have been found; the first row is the base.
    """
    evidence = Evidence.none(count, places)
    for one in rows:
        found = [one.evidence(figures[one.at]) for figures in ways if one.at in figures]
        if one.beside or not found:
            evidence.begin(one.place, one.evidence(one.due))
            continue
        best, *others = found
        for other in others:
            better, pairs = other.likely > best.likely, zip(other, best, strict=True)
            best = Likelihood(*(np.where(better, new, old) for new, old in pairs))
        base = Likelihood(*(np.ravel(part)[0] for part in best))
        evidence.begin(one.place, base)
        evidence.add(slice(None), one.place, best, base)
    return evidence
