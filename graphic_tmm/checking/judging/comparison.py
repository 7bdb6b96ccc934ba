"""A scene drawn exactly beside the readings of a drawing: dues, marks, own errors, where each comes from."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.checking.cells import RESULTS, Cell, Key, cells, longest, points, taken_figure
from graphic_tmm.checking.judging.equivalents import Limb, Off, crossings, offs, ways_of
from graphic_tmm.checking.judging.own_errors import Grain, Run, apart, exact, read_of, run
from graphic_tmm.checking.judging.step_scatter import share_of_slip
from graphic_tmm.checking.judging.taken_marks import as_marks, scale_of, steps_of
from graphic_tmm.checking.judging.yardstick import Yardstick
from graphic_tmm.checking.records import FINE, Taken
from graphic_tmm.drawn import DrawnScene

MOST_USUAL, FEW, MUCH_WORSE = 1.6, 20, 1.6
"""Of a hand's own errors four of five are below 1.3 times the usual one (of the larger of two: 1.6). Fewer
readings tell nothing of it; no hand is taken for more than so many times worse, else a mistake would hide."""

LARGEST = 5.0
"""No plan is drawn so many times larger than it should be: it would not find place on its sheet."""


def worse_of(times: Sequence[float]) -> float:
    """Return how many times worse than usual a hand is; ``times``: its errors in usual ones."""
    known = np.abs([one for one in times if np.isfinite(one)])
    if known.size < FEW:
        return 1.0
    return float(np.clip(np.quantile(known, 0.8) / MOST_USUAL, 1.0, MUCH_WORSE))


@dataclass(frozen=True)
class Comparison:
    """A scene drawn exactly, with the readings of a drawing; ``rows``: one kind of figure each.

    ``worse``: so many times farther off than usual this hand is found to be; see `worse_of`.
    """

    made: DrawnScene
    rows: Sequence[Taken]
    by: Yardstick
    worse: float = 1.0

    @property
    def names(self) -> tuple[str, ...]:
        """The positions of the mechanism; none without one."""
        return self.made.mechanism.names if self.made.mechanism is not None else ()

    @cached_property
    def due(self) -> Mapping[Key, Cell]:
        """What is due, figure by figure."""
        return cells(self.made)

    @cached_property
    def spots(self) -> Mapping[Key, complex]:
        """Where points are due, mm from the pole."""
        return points(self.made)

    @cached_property
    def whole(self) -> Mapping[tuple[str, str], float]:
        """The longest vector of every plan and position, mm."""
        return longest(self.due, self.spots)

    @cached_property
    def steps(self) -> Mapping[tuple[str, str], Step]:
        """The steps that can be read, by plan and name."""
        return steps_of(self.made.mechanism)

    @cached_property
    def read_marks(self) -> tuple[dict[Mark, Any], dict[Mark, Grain]]:
        """What was read of marks, and how far rounding alone may carry it; (1, position)."""
        if self.made.mechanism is None:
            return {}, {}
        return as_marks(self.made.mechanism, self.steps, self.rows, self.due, self.by.reader)

    @cached_property
    def signed_marks(self) -> Mapping[Mark, Any]:
        """Where the signs of what was read of marks are meant, (position,)."""
        found: dict[Mark, Any] = {}
        for taken in self.rows:
            step = self.step(taken) if taken.signed else None
            if step is not None and self.place(taken) >= 0:
                found.setdefault(step.it, np.zeros(len(self.names), bool))[self.place(taken)] = True
        return found

    @cached_property
    def run(self) -> Run:
        """The log run with what was read."""
        if self.made.mechanism is None:
            return Run({}, {}, {})
        return run(self.made.mechanism, *self.read_marks, signed=self.signed_marks)

    def step(self, taken: Taken) -> Step | None:
        """Return the step that a reading is of; None where it is no length, point or rate of a plan."""
        return self.steps.get((taken.plan, taken.segment))

    def step_of(self, mark: Mark) -> Step | None:
        """Return the step that leaves a mark that can be read."""
        return self._by_marks.get(mark)

    @cached_property
    def _by_marks(self) -> Mapping[Mark, Step]:
        return {step.it: step for step in self.steps.values()}

    def sense(self, taken: Taken) -> float:
        """Return the sign that a rate should have by what was read before it; 0 where that does not tell."""
        step, place = self.step(taken), self.place(taken)
        if step is None or place < 0 or step.it not in self.run.due:
            return 0.0
        return float(np.nan_to_num(np.sign(_at(self.run.due[step.it], place))))

    def larger(self, view: str, place: int) -> float:
        """Return how many times as large as due the longest of what was read of a view is; 1 at the least.

        A ray that reaches farther is farther off by the same swing of the hand.
        """
        return self.worse * min(max(1.0, self._larger.get((view, place), 1.0)), LARGEST)

    @cached_property
    def _larger(self) -> Mapping[tuple[str, int], float]:
        found: dict[tuple[str, int], tuple[float, float]] = {}
        for mark, row in self.read_marks[0].items():
            if mark.kind not in (Length, Point) or self.made.mechanism is None:
                continue
            due = np.abs(np.broadcast_to(exact(self.made.mechanism, mark), row.shape))[0]
            for place in np.flatnonzero(~np.isnan(row[0])):
                read, right = found.get((mark.view, int(place)), (0.0, 0.0))
                known = float(np.nan_to_num(due[place]))
                found[mark.view, int(place)] = (
                    max(read, abs(complex(row[0, place]))),
                    max(right, known),
                )
        return {at: read / right for at, (read, right) in found.items() if right > 0.0}

    def calculated(self, taken: Taken) -> bool:
        """Whether a reading is a length that its step lays off from a calculated number, in mm.

        It may be written as calculated or as measured: its digits do not tell which.
        """
        step = self.step(taken)
        return (
            step is not None
            and taken.mm is not None
            and step.it.kind is Length
            and not step.op.reads
        )

    def is_given(self, taken: Taken) -> bool:
        """Whether a figure of a plan follows from the givens alone: it is the same in every drawing."""
        seen = self.by.spread[taken.at].sorted
        return taken.plan != RESULTS and bool(seen.size) and float(np.ptp(seen)) == 0.0

    def place(self, taken: Taken) -> int:
        """Return the index of the position of a reading; -1 where it has none."""
        return self.names.index(taken.position) if taken.position in self.names else -1

    def scale(self, taken: Taken) -> float:
        """Return what a mm on paper means in the unit of a reading's figure; NaN if nothing is drawn of it."""
        cell = self.due.get(taken.key)
        if cell is None or cell.mm is None:
            return float("nan")
        if cell.mm and cell.value:
            return abs(cell.value / cell.mm)
        work = self.made.mechanism
        return scale_of(work, taken.plan) if work is not None else float("nan")

    def errors(self, taken: Taken) -> tuple[tuple[Step, float, float], ...]:
        """Return the errors of the steps that led to a reading: step, error, grain; none if they are not known.

        A point where two lines meet has the errors of both: how far it is off either of them.
        """
        step, place = self.step(taken), self.place(taken)
        if step is None or place < 0 or not self.stands(taken, step, place):
            return ()
        if step.it.kind is Number:
            # links that turn alike share a mark: each reading has its own error
            figure = taken_figure(taken, self.due[taken.key])
            error = float(apart(figure, _at(self.run.due[step.it], place)))
            return ((step, error, _at(self.run.errors[step.it][0].grain, place)),)
        told = [
            (own.step, float(own.error[0, place]), _at(own.grain, place))
            for own in self.run.errors[step.it]
        ]
        if not any(np.isfinite(error) for _, error, _ in told):
            return ()
        return tuple((by, float(np.nan_to_num(error)), grain) for by, error, grain in told)

    def otherwise(self, taken: Taken) -> Iterator[tuple[Off, ...]]:
        """Yield how far a point is off where each other construction of it leads, with the hand's sizes."""
        step, place = self.step(taken), self.place(taken)
        if step is None or place < 0 or not taken.pointed:
            return
        reader, values = self.by.reader, self.run.values
        due = complex(_single(self.run.due[step.it], place))
        off = abs(taken.spot - self.spots[taken.key])
        placed = self.by.spread[taken.at].verdict(off, 0.0) == FINE
        for way in (*ways_of(step, self.lines), *self._crossings.get(step.it, ())):
            if not all(mark.slot in values for limb in way for mark in (limb.centre, *limb.of)):
                continue
            yield offs(
                way,
                taken.spot,
                due,
                lambda mark: _single(values[mark.slot], place),
                reader.hand,
                self.share * reader.pointing,
                placed=placed,
            )

    @cached_property
    def _crossings(self) -> Mapping[Mark, tuple[tuple[Limb, Limb], ...]]:
        work = self.made.mechanism
        return {} if work is None else crossings(work.project)

    @cached_property
    def lines(self) -> Mapping[Mark, Step]:
        """The steps of the log, by their marks."""
        assert self.made.mechanism is not None
        return {step.it: step for step in self.made.mechanism.construction.steps}

    @cached_property
    def share(self) -> float:
        """With which share of the slip that is counted upon the points of this drawing were read."""
        seen = []
        for taken in self.rows:
            step = self.step(taken) if taken.pointed else None
            own = None if step is None else self.by.steps.get((step.it, self.place(taken)))
            if own is not None:
                errors = [error for _, error, _ in self.errors(taken)]
                seen += [(own, errors)] if errors else []
        return share_of_slip(seen)

    def stands(self, taken: Taken, step: Step, place: int) -> bool:
        """Whether a reading is the one that was taken for its mark: a length in mm goes before its quantity."""
        there = self.read_marks[0].get(step.it)
        if there is None or np.isnan(there[0, place]):
            return False
        return taken.in_mm or self.length_of(taken) is None

    def length_of(self, taken: Taken) -> Taken | None:
        """Return the length in mm whose quantity a reading is."""
        if taken.in_mm:
            return None
        return self._lengths.get(taken.key)

    @cached_property
    def _lengths(self) -> Mapping[Key, Taken]:
        return {taken.key: taken for taken in self.rows if taken.mm is not None}

    @cached_property
    def _by_mark(self) -> Mapping[tuple[Mark, int], Taken]:
        found = {}
        for taken in sorted(self.rows, key=lambda one: one.mm is not None):
            if (step := self.step(taken)) is not None:
                found[step.it, self.place(taken)] = taken
        return found

    def sources(self, taken: Taken) -> tuple[Taken, ...]:
        """Return the earlier readings that a reading was found from, nothing read being between."""
        if (length := self.length_of(taken)) is not None:
            return (length,)
        step, place = self.step(taken), self.place(taken)
        if step is None or self.made.mechanism is None:
            return ()
        marks = read_of(self.made.mechanism.construction, step, self.read_marks[0])
        return tuple(self._by_mark[m, place] for m in marks if (m, place) in self._by_mark)

    def carried(self, taken: Taken, source: Taken) -> float:
        """Return by how much a reading's due would differ, had an earlier one been right; mm or its unit."""
        if self.length_of(taken) is not None:
            return float("inf")
        step, of, place = self.step(taken), self.step(source), self.place(taken)
        if step is None or of is None:
            return 0.0
        if of.it not in self._corrected:
            self._corrected[of.it] = self._with_right(of.it)
        moved = np.abs(self._corrected[of.it].due[step.it] - self.run.due[step.it])
        return _at(moved, place)

    @cached_property
    def _corrected(self) -> dict[Mark, Run]:
        return {}

    def _with_right(self, mark: Mark) -> Run:
        """Return the log run with what was read, but for one mark, which is what is due."""
        assert self.made.mechanism is not None
        due = exact(self.made.mechanism, mark)
        due = np.where(np.isnan(self.read_marks[0][mark]), np.nan, due)
        due = np.abs(due) if mark.kind is Length else due
        signed = {one: where for one, where in self.signed_marks.items() if one is not mark}
        return run(self.made.mechanism, {**self.read_marks[0], mark: due}, {}, signed=signed)


def _single(value: Any, place: int) -> Any:
    """Return a value at a position: of a line or an arc each of its parts."""
    if isinstance(value, tuple):
        return type(value)(*(_single(part, place) for part in value))
    flat = np.ravel(value)
    return flat[place if flat.size > 1 else 0]


def _at(row: Any, place: int) -> float:
    """Return what an array (1, position) holds at a position; it may be a number, or the same everywhere."""
    flat = np.ravel(row)
    return float(flat[place if flat.size > 1 else 0])
