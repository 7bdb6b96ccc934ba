"""Hypotheses weighed: each by all readings, fine ones too, against the drawing as it should be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.entries import (
    EntryEvidence,
    Own,
    Weighed,
    column_gains,
    column_readings,
    entry_of,
    weighed,
)
from graphic_tmm.checking.mutations.execution import AssumedLog, Executed, executed, figures_of
from graphic_tmm.checking.mutations.likelihood import BEYOND, Evidence, Likelihood
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.tables import ReadingTable, Variation, copied, variations
from graphic_tmm.checking.records import Judged, Taken
from graphic_tmm.drawn import Drawn

Array = NDArray[np.float64]


VISIBLE = 0.5
"""A mistake must move some reading that is not fine by this share of what a hand scatters by, with no
reading put in: else it explains noise."""
FAR = 3.0, 0.01
"""Two readings are told apart if they should differ by so many deviations, and by such a share."""


class Readings:
    """The readings of a drawing, ready to be weighed: those of marks, and those of tables.

    ``least``: by how much a mistake must move one of those that are ``doubtful`` or wrong; ``signed``: the
    lengths that bear signs.
    """

    def __init__(self, drawing: Comparison, doubtful: Sequence[Judged]) -> None:
        self.drawing = drawing
        self.least = self.visible(one.taken.at for one in doubtful)
        self.signed = frozenset(one.at for one in drawing.rows if one.signed and one.mm is not None)
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
        self.columns = column_readings(drawing, marked)
        self.keys = tuple(dict.fromkeys(one.at for one in self.columns))

    def visible(self, some: Iterable[tuple[Key, bool]]) -> dict[tuple[Key, bool], float]:
        """Return by how much a mistake must move figures to be seen in them."""
        by = self.drawing.by.spread
        return {at: VISIBLE * by[at].rms for at in some if at in by}

    @property
    def count(self) -> int:
        """How many readings there are."""
        return len(self.marked) + len(self.columns)

    @property
    def places(self) -> int:
        """How many positions the mechanism has."""
        return len(self.drawing.names)

    @cached_property
    def by_mark(self) -> Mapping[tuple[Mark, int], Taken]:
        """The reading of a mark at a position."""
        return {at: self.drawing.rows[k] for k, at in self.marked.items()}

    def figures(self, board: Drawn, beside: Executed, rows: Any) -> dict[tuple[Key, bool], Any]:
        """Return what tables say in some rows."""
        if not self.keys:
            return {}
        return figures_of(self.drawing.made, board, beside, rows, self.keys)

    def weighed(
        self,
        base: AssumedLog,
        mutations: Sequence[Mutation],
        scatters: Mapping[Mark, Array] | None,
        *,
        tables: bool = True,
    ) -> Weighed | None:
        """Return what readings of marks tell; None where a board has none that was read.

        ``tables``: go on to the marks that figures of tables are found from.
        """
        if not self.found or base.board is not self.drawing.made.mechanism:
            return None
        marks = base.marks if self.keys and tables else ()
        return weighed(self.drawing, self.found, base, mutations, scatters, marks)

    @cached_property
    def written(self) -> tuple[ReadingTable, tuple[Variation, ...]]:
        """The table of readings, and all that it may have been written down otherwise."""
        drawing = self.drawing
        rows = drawing.rows
        positions = drawing.names or tuple(dict.fromkeys(t.position for t in rows))
        table, dues = ReadingTable(rows, positions), [self._due(taken) for taken in rows]

        def off(k: int) -> complex:
            return rows[k].spot - drawing.spots.get(rows[k].key, rows[k].spot)

        def apart(k: int, j: int) -> bool:
            one = rows[k]
            if one.pointed:
                return abs(drawing.spots[one.key] - drawing.spots[rows[j].key]) > 1.0
            scatters, share = FAR
            least = scatters * drawing.by.spread[one.at].rms + share * abs(dues[k])
            return abs(dues[k] - dues[j]) > least

        scales = {
            one.symbol: one.value for board in drawing.made.boards for one in board.scales.values()
        }
        varied = variations(table, drawing.scale, off, scales, apart, dues)
        return table, (*varied, *copied(table, apart))

    def _due(self, taken: Taken) -> float:
        if taken.pointed:
            return abs(self.drawing.spots.get(taken.key, 0.0))
        cell = self.drawing.due[taken.key]
        return float((cell.mm if taken.mm is not None else cell.value) or 0.0)

    def ways_of(
        self, base: AssumedLog, told: Weighed | None = None
    ) -> tuple[Mapping[tuple[Key, bool], Any], ...]:
        """Return what tables say by a log: drawn without readings, and with them where its marks were read.

        ``told``: what readings of marks tell, if that is known.
        """
        plain = executed(base.log, base.given, (), base.marks if self.keys else ())
        told = told or self.weighed(base, (), None)
        every = (plain,) if told is None else (plain, told.beside)
        return tuple(self.figures(base.board, one, np.arange(1)) for one in every)


def of_mutations(
    readings: Readings,
    base: AssumedLog,
    mutations: Sequence[Mutation],
    plain: Mapping[tuple[Key, bool], Any],
) -> tuple[Evidence, Weighed | None]:
    """Return the evidence for mutations of a board; ``plain``: what tables say, found without readings."""
    places, count = readings.places, len(mutations)
    ways = [plain]
    told = readings.weighed(base, mutations, None)
    if told is not None:
        ways.append(readings.figures(base.board, told.beside, np.arange(count)))
    evidence = column_gains(readings.columns, ways, count, places)
    return evidence if told is None else told.evidence.plus(evidence), told


def unexplained(
    readings: Readings, base: AssumedLog, scatters: Mapping[Mark, Array] | None = None
) -> set[tuple[Key, bool]]:
    """Return the readings that are beyond what a hand does on a board; ``scatters``: as `weighed`'s."""
    return {at for at, _, off in _plainly(readings, base, scatters) if off > BEYOND}


def likely(readings: Readings, base: AssumedLog) -> float:
    """Return how likely all readings are on a board without a mistake (logarithm)."""
    return sum(one for _, one, _ in _plainly(readings, base, None))


def _plainly(
    readings: Readings, base: AssumedLog, scatters: Mapping[Mark, Array] | None
) -> Iterator[tuple[tuple[Key, bool], float, float]]:
    """Yield each reading, how likely it is (logarithm), and how far off, standard deviations."""
    told = readings.weighed(base, (), scatters)
    if told is not None:
        for (mark, place), taken in readings.by_mark.items():
            if mark in told.entries:
                here = told.entries[mark].base
                yield taken.at, float(here.likely[place]), float(here.off[place])
    ways = readings.ways_of(base, told)
    for one in readings.columns:
        some = [one.evidence(way[one.at]) for way in ways if one.at in way]
        if some and not one.beside:
            most = max(float(np.ravel(each.likely)[0]) for each in some)
            yield one.at, most, min(float(np.ravel(each.off)[0]) for each in some)


def of_variations(
    readings: Readings,
    base: AssumedLog,
    some: Sequence[Variation],
    due: Mapping[tuple[Key, bool], Any],
) -> Evidence:
    """Return the evidence for readings written down otherwise; ``due``: figures not as they should be."""
    evidence = Evidence.none(len(some), readings.places)
    if readings.found and readings.drawing.made.mechanism is not None:
        _of_marks(readings, base, some, evidence)
    copied = np.array([way.copied for way in some])
    index = {id(taken): k for k, taken in enumerate(readings.drawing.rows)}
    at = [index[id(one.taken)] for one in readings.columns]
    stands = dict(zip(at, (one.found for one in readings.columns), strict=True))
    table = _written(some, len(index), stands, at)
    for one, read in zip(readings.columns, table.T, strict=True):
        figure = np.asarray(np.ravel(due[one.at])[0] if one.at in due else one.due)
        unknown = np.where(copied, one.nearest, one.unknown)
        _add(evidence, one.place, one.evidence(figure, read), one.evidence(figure), read, unknown)
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


def _add(
    evidence: Evidence, at: Any, now: Likelihood, base: Likelihood, written: Any, unknown: Any
) -> None:
    """Add readings written down otherwise, as likely as ``unknown`` where nothing is ``written`` then (NaN).

    ``base``: as they are written.
    """
    likely = np.where(np.isnan(written), unknown, now.likely)
    evidence.begin(at, base)
    evidence.add(slice(None), at, now._replace(likely=likely), base)


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
    right = Own(drawing, readings.found, base)
    for mark, errors in Own(drawing, found, base).base.items():
        due = right.base[mark]
        entry = entry_of(drawing, mark, due[:, 0], readings.found[mark][0], None)
        if entry is None:
            continue
        told = EntryEvidence(entry)
        rows = told.rows(np.broadcast_to(errors, (errors.shape[0], count, places)))
        unknown = np.where(copied[:, None], told.nearest, told.unknown)
        _add(evidence, slice(places), rows, told.base, found[mark], unknown)
