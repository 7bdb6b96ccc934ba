"""Hypotheses weighed: each by all readings, fine ones too, against the drawing as it should be."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Point
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations import columns
from graphic_tmm.checking.mutations.entries import EntryEvidence, Own, entry_of, weighed
from graphic_tmm.checking.mutations.execution import Executed, executed, figures_of
from graphic_tmm.checking.mutations.likelihood import BEYOND, explained
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.tables import Variation
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import Drawn

Array = NDArray[np.float64]
Given = Mapping[Mark, object]


class Evidence(NamedTuple):
    """What hypotheses gain on the base, (hypothesis, position and, last, what has none of the mechanism's).

    ``beyond``, ``lost``: how many readings each leaves unexplained, and how many it cannot draw. ``moved``,
    ``squares``: how many it moves and explains, and the sum of the squares of how far off these are.
    """

    gain: Array
    beyond: Array
    lost: Array
    moved: Array
    squares: Array


@dataclass(frozen=True)
class AssumedLog:
    """A log as it is taken to be drawn, and what is given."""

    board: Drawn
    log: Construction
    given: Given

    @cached_property
    def marks(self) -> tuple[Mark, ...]:
        """Everything that it makes."""
        return tuple(step.it for step in self.log.steps)


class Readings:
    """The readings of a drawing, ready to be weighed: those of marks, and those of tables."""

    def __init__(self, drawing: Comparison) -> None:
        self.drawing = drawing
        self.found = dict(drawing.read_marks[0])
        last: dict[tuple[Mark, int], int] = {}
        # links that turn alike share a mark: of what was read of it the last is the one that was taken
        rows = enumerate(drawing.rows)
        for k, taken in sorted(rows, key=lambda row: row[1].mm is not None):
            step, place = drawing.step(taken), drawing.place(taken)
            known = step is not None and (step.it, place) in drawing.by.steps
            if known and step is not None and drawing.stands(taken, step, place):
                last[step.it, place] = k
        self.marked = {k: at for at, k in sorted(last.items(), key=lambda row: row[1])}
        marked = [drawing.rows[k] for k in self.marked]
        self.columns = columns.readings(drawing, marked)
        self.keys = tuple(dict.fromkeys(one.at for one in self.columns))

    @property
    def count(self) -> int:
        """How many readings there are."""
        return len(self.marked) + len(self.columns)

    @property
    def places(self) -> int:
        """How many positions the mechanism has."""
        work = self.drawing.made.mechanism
        return len(work.names) if work is not None else 0

    @cached_property
    def by_mark(self) -> Mapping[tuple[Mark, int], Taken]:
        """The reading of a mark at a position."""
        return {at: self.drawing.rows[k] for k, at in self.marked.items()}

    def figures(self, board: Drawn, beside: Executed, rows: Any) -> dict[tuple[Key, bool], Any]:
        """Return what tables say in some rows."""
        if not self.keys:
            return {}
        return figures_of(self.drawing.made, board, beside, rows, self.keys)


def of_mutations(
    readings: Readings,
    base: AssumedLog,
    mutations: Sequence[Mutation],
    plain: Executed,
    rows: NDArray[np.intp],
    scatters: Mapping[Mark, Array] | None = None,
) -> tuple[Evidence, Any]:
    """Return the evidence for mutations of a board; ``plain``: they executed without readings, in ``rows``."""
    places, count = readings.places, len(mutations)
    work = readings.drawing.made.mechanism
    ways = [readings.figures(base.board, plain, rows)]
    evidence = nothing(count, places)
    told = None
    if work is not None and base.board is work and readings.found:
        wanted = base.marks if readings.keys else ()
        told = weighed(
            readings.drawing,
            readings.found,
            base.log,
            base.given,
            mutations,
            scatters,
            wanted,
        )
        its = told.gain, told.beyond, told.lost, told.moved, told.squares
        for total, more in zip(evidence, its, strict=True):
            total[:, :places] += more
        if readings.keys:
            ways.append(readings.figures(base.board, told.beside, np.arange(count)))
    of_columns = columns.gains(readings.columns, ways, count, places)
    for total, more in zip(evidence, of_columns, strict=True):
        total += more
    return evidence, told


def unexplained(
    readings: Readings, base: AssumedLog, scatters: Mapping[Mark, Array] | None = None
) -> set[tuple[Key, bool]]:
    """Return the readings that are beyond what a hand does on a board; ``scatters``: as `weighed`'s."""
    found: set[tuple[Key, bool]] = set()
    work = readings.drawing.made.mechanism
    marks = base.marks if readings.keys else ()
    ways: list[Mapping[tuple[Key, bool], Any]] = []
    if work is not None and base.board is work and readings.found:
        found_so = readings.drawing, readings.found, base.log, base.given
        told = weighed(*found_so, (), scatters, marks)
        at = readings.by_mark
        found |= {
            at[mark, int(place)].at
            for mark, off in told.off.items()
            for place in np.flatnonzero(off > BEYOND)
            if (mark, int(place)) in at
        }
        ways.append(readings.figures(base.board, told.beside, np.arange(1)) if marks else {})
    plain = executed(base.log, base.given, (), marks)
    ways.append(readings.figures(base.board, plain, np.arange(1)))
    for one in readings.columns:
        off = [float(np.ravel(one.evidence(way[one.at])[1])[0]) for way in ways if one.at in way]
        if off and min(off) > BEYOND and not one.beside:
            found.add(one.at)
    return found


def of_variations(
    readings: Readings,
    base: AssumedLog,
    some: Sequence[Variation],
    due: Mapping[tuple[Key, bool], Any],
) -> Evidence:
    """Return the evidence for readings written down otherwise; ``due``: figures not as they should be."""
    places, count = readings.places, len(some)
    evidence = nothing(count, places)
    if readings.found and readings.drawing.made.mechanism is not None:
        _of_marks(readings, base, some, evidence)
    copied = np.array([way.copied for way in some])
    index = {id(taken): k for k, taken in enumerate(readings.drawing.rows)}
    at = [index[id(one.taken)] for one in readings.columns]
    table = _written(
        some, len(index), dict(zip(at, (one.found for one in readings.columns), strict=True)), at
    )
    for one, read in zip(readings.columns, table.T, strict=True):
        figure = np.asarray(np.ravel(due[one.at])[0] if one.at in due else one.due)
        unknown = np.where(copied, one.nearest, one.unknown)
        _add(evidence, one.place, one.evidence(figure, read), unknown, one.evidence(figure), read)
    return evidence


def _written(
    some: Sequence[Variation], rows: int, found: Mapping[int, complex], at: Sequence[int]
) -> NDArray[np.complex128]:
    """Return what each way of writing puts into some rows of a table, (way, row); NaN where that is nothing.

    ``found``: what stands in rows; ``at``: the rows that are asked for.
    """
    stands = np.full(rows + 1, np.nan, dtype=np.complex128)  # the last one: nothing
    stands[list(found)] = list(found.values())
    ways = [(way.source[at], way.factor[at], way.plus[at]) for way in some]
    source, factor, plus = (np.stack(part) for part in zip(*ways, strict=True))
    return np.asarray(factor * stands[np.where(source < 0, rows, source)] + plus)


def nothing(count: int, places: int) -> Evidence:
    """Return the evidence for hypotheses before anything has been read."""
    return Evidence(*(np.zeros((count, places + 1)) for _ in Evidence._fields))


def _add(evidence: Evidence, at: Any, told: Any, unknown: Any, before: Any, written: Any) -> None:
    """Add readings written down otherwise: how likely, far off and gone they are, and were before.

    ``written``: what then stands there, NaN where nothing does. What stands there and cannot be drawn any
    more is lost.
    """
    likely, far, gone = told
    evidence.gain[:, at] += np.where(np.isnan(written), unknown, likely) - before[0]
    evidence.lost[:, at] += ~np.isnan(written) & (gone > before[2])
    evidence.beyond[:, at] += far > BEYOND
    moved, squares = explained(far, before[1])
    evidence.moved[:, at] += moved
    evidence.squares[:, at] += squares


def _of_marks(
    readings: Readings, base: AssumedLog, some: Sequence[Variation], evidence: Evidence
) -> None:
    drawing, count, places = readings.drawing, len(some), readings.places
    copied = np.array([way.copied for way in some])
    found: dict[Mark, Any] = {
        mark: np.full((count, places), np.nan, dtype=row.dtype)
        for mark, row in readings.found.items()
    }
    read = {k: readings.found[mark][0, place] for k, (mark, place) in readings.marked.items()}
    table = _written(some, len(drawing.rows), read, list(read))
    for (mark, place), row in zip(readings.marked.values(), table.T, strict=True):
        found[mark][:, place] = row if mark.kind is Point else row.real
    own = Own(drawing, found, base.log)
    executed(base.log, base.given, (), found, own.seen)
    right = Own(drawing, readings.found, base.log)
    executed(base.log, base.given, (), readings.found, right.seen)
    for mark, errors in own.base.items():
        due = right.base[mark]
        entry = entry_of(drawing, mark, due[:, 0], readings.found[mark][0], None)
        if entry is None:
            continue
        told = EntryEvidence(entry)
        rows = told.rows(np.broadcast_to(errors, (errors.shape[0], count, places)))
        unknown = np.where(copied[:, None], told.nearest, told.unknown)
        before = told.likely, told.off, ~told.entry.read
        _add(evidence, slice(places), rows, unknown, before, found[mark])
