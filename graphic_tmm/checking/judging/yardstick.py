"""By what readings are judged: a hand's own drawings of the same scene, drawn once for all its readings.

So are the errors of its own steps, whatever was read before them (`OwnScatters`).
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Point
from graphic_tmm.checking.cells import Key, cells, points
from graphic_tmm.checking.judging.covariance import Covariances
from graphic_tmm.checking.judging.own_errors import Found, Own, run
from graphic_tmm.checking.judging.scatter import Limits, Sample, Scatter, joined, sample, scatter
from graphic_tmm.checking.judging.step_scatter import StepScatter, as_read, step_scatter, where_read
from graphic_tmm.checking.judging.taken_marks import Reader, as_marks, reader, steps_of
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import Drawn, DrawnScene

Case = tuple[Mark, int, frozenset[Mark]]
"""A mark that was read, in a position (its index), and the marks read that it was found from."""


class OwnScatters:
    """The own errors of a hand that draws a scene; ``work``: as the exact hand draws it."""

    def __init__(self, work: Drawn, by: Reader, limits: Limits) -> None:
        self.work, self.by, self.limits = work, by, limits
        self.steps = {step.it: step for step in work.construction.steps}
        self._kept: dict[Case, StepScatter] = {}
        self._read: dict[tuple[Mark, bool], Any] = {}

    def of(self, found: Found, drawn: Found) -> dict[tuple[Mark, int], StepScatter]:
        """Return how far off the hand's own steps are, by mark and position (its index), where they were read.

        ``found``: what was read, (1, position), NaN where it was not; ``drawn``: the numbers of the same marks
        in the hand's drawings.
        """
        cases = self._cases(found)
        new = [case for case in cases.values() if case not in self._kept]
        if new:
            self._find(new, found, drawn)
        return {at: self._kept[case] for at, case in cases.items()}

    def lacks(self, found: Found) -> bool:
        """Whether there is a case among what was read that has not been found yet."""
        return any(case not in self._kept for case in self._cases(found).values())

    def forget(self) -> None:
        """Keep what was found out, but not what the hand's drawings have of the marks."""
        self._read.clear()

    def _cases(self, found: Found) -> dict[tuple[Mark, int], Case]:
        """Return the case of each mark that was read, by mark and position."""
        there = {mark: ~np.isnan(row[0]) for mark, row in found.items()}
        alike: defaultdict[frozenset[Mark], list[int]] = defaultdict(list)
        for place in range(len(self.work.names)):
            alike[frozenset(mark for mark, row in there.items() if row[place])].append(place)
        cases: dict[tuple[Mark, int], Case] = {}
        for read, places in alike.items():
            before = self._before(read)
            cases |= {(mark, at): (mark, at, before[mark]) for mark in read for at in places}
        return cases

    def _before(self, read: frozenset[Mark]) -> dict[Mark, frozenset[Mark]]:
        """Return the marks that were read and that each of them was found from, no point read being between.

        A length or a rate that was read does not hide what it was found from: by that it gets its sense, and is
        right either as it was laid off or as it was due.
        """
        nothing: frozenset[Mark] = frozenset()
        behind: dict[Mark, frozenset[Mark]] = {}
        found: dict[Mark, frozenset[Mark]] = {}
        for step in self.work.construction.steps:
            whole = nothing.union(*(behind.get(mark, nothing) for mark in step.uses))
            if step.it in read:
                found[step.it] = whole
                whole = nothing if step.it.kind is Point else whole
                whole |= {step.it}
            behind[step.it] = whole
        return found

    def _find(self, new: list[Case], found: Found, drawn: Found) -> None:
        """Run the log with the hand's own readings, once as they are and once with coordinates read exactly."""
        wanted = {mark for mark, _, _ in new}
        taken = wanted.union(*(before for _, _, before in new))
        blunt, sharp = (
            self._errors(wanted, taken, found, drawn, exactly=one) for one in (False, True)
        )
        for case in new:
            mark, place, _ = case
            self._kept[case] = step_scatter(blunt[mark], sharp[mark], place, self.limits)

    def _errors(
        self, wanted: set[Mark], taken: set[Mark], found: Found, drawn: Found, *, exactly: bool
    ) -> Mapping[Mark, tuple[Own, ...]]:
        rows = {
            mark: where_read(self._as_read(mark, drawn, exactly=exactly), found[mark])
            for mark in taken
        }
        return run(self.work, rows, {}, wanted).errors

    def _as_read(self, mark: Mark, drawn: Found, *, exactly: bool) -> Any:
        if (mark, exactly) not in self._read:
            by = self.by.sharp if exactly else self.by
            self._read[mark, exactly] = as_read(self.steps[mark], drawn[mark], by)
        return self._read[mark, exactly]


KEPT = 4_000_000
"""So many numbers of a hand's drawings are kept at the most (32 MB): all that can be read of a scene with 10
positions is 0.1 to 1.2 million in 400 drawings. Of a larger one what was read is drawn, and drawn again for
other figures; how they scatter is kept."""


class Yardstick(NamedTuple):
    """By what readings are judged: how the hand's drawings scatter, and what errors its own steps make.

    ``covariances``: how both go together.
    """

    reader: Reader
    limits: Limits
    spread: Mapping[tuple[Key, bool], Scatter]
    steps: Mapping[tuple[Mark, int], StepScatter]
    covariances: Covariances


class Yardsticks:
    """The yardsticks of a scene: its drawings by a hand are drawn once, whatever is then read of others.

    What is found out of a figure, or of a step's own errors where certain marks before it were read, is kept.
    """

    def __init__(
        self, made: DrawnScene, hand: Hand, limits: Limits, points_by: str = "paper"
    ) -> None:
        """Take a scene as the exact hand draws it.

        ``hand``: by whose drawings readings are judged, so many as its ``trials``; ``points_by``: how points
        were read, one of `POINTS`.
        """
        self.made, self.limits = made, limits
        self.reader = reader(made.scene, hand, points_by)
        self.steps: Mapping[tuple[str, str], Step] = steps_of(made.mechanism)
        self._drawn = Sample({}, {}, {})
        self._spread: dict[tuple[Key, bool], Scatter] = {}
        self._none: set[tuple[Key, bool]] = set()
        self._covariances, self._own = Covariances(), None
        if made.mechanism is not None:
            self._own = OwnScatters(made.mechanism, self.reader, limits)

    def of(self, readings: Sequence[Taken]) -> Yardstick:
        """Return by what readings of these figures are judged."""
        rows = [part for taken in readings for part in taken.parts()]
        asked = dict.fromkeys(taken.at for taken in rows)
        found: Mapping[Mark, Any] = {}
        work = self.made.mechanism
        if work is not None:
            found, _ = as_marks(work, self.steps, rows, cells(self.made), self.reader)
        self._draw(asked, found)
        self._measure([at for at in asked if at not in self._spread and at not in self._none])
        spread = {at: self._spread[at] for at in asked if at in self._spread}
        own: Mapping[tuple[Mark, int], StepScatter] = {}
        if self._own is not None and found:
            own = self._own.of(found, self._drawn.marks)
        if not self._little:
            self._drawn = Sample({}, {}, {})
            if self._own is not None:
                self._own.forget()
        return Yardstick(self.reader, self.limits, spread, own, self._covariances)

    def _draw(self, asked: Collection[tuple[Key, bool]], marks: Mapping[Mark, Any]) -> None:
        """Have drawings with these figures and marks: all of their kind, if that is little."""
        drawn = self._drawn
        missing = [mark for mark in marks if mark not in drawn.marks]
        if not self._little and self._own is not None:
            missing = missing if self._own.lacks(marks) else []
        new = [at for at in asked if at not in self._spread and at not in self._none]
        new = [at for at in new if at not in drawn.figures and at[0] not in drawn.spots]
        if not (new or missing):
            return
        if self._little:
            kinds = {mark.kind for mark in missing}
            missing = [step.it for step in self.steps.values() if step.it.kind in kinds]
            spots = points(self.made)
            if any(key in spots for key, _ in new):
                new += [(key, True) for key in spots]
            if any(key not in spots for key, _ in new):
                new += [(key, in_mm) for key in cells(self.made) for in_mm in (True, False)]
        more = sample(self.made, self.reader.hand, _by_figure(new), dict.fromkeys(missing))
        self._drawn = joined(drawn, more)

    @cached_property
    def _little(self) -> bool:
        """Whether all that can be read in the hand's drawings is so few numbers that they are kept."""
        work = self.made.mechanism
        row = 0 if work is None else len(work.names)
        figures = 2 * len(cells(self.made)) + 2 * len(points(self.made))
        return self.reader.hand.trials * (figures + 2 * row * len(self.steps)) <= KEPT

    def _measure(self, new: Sequence[tuple[Key, bool]]) -> None:
        """Find how these figures scatter; of some there is none."""
        self._spread |= scatter(self.made, self._drawn, self.reader, _by_figure(new), self.limits)
        self._none |= {at for at in new if at not in self._spread}


def _by_figure(asked: Collection[tuple[Key, bool]]) -> dict[Key, set[bool]]:
    """Return, by figure, whether it is asked for in mm, as a quantity, or both."""
    wanted: dict[Key, set[bool]] = {}
    for key, in_mm in asked:
        wanted.setdefault(key, set()).add(in_mm)
    return wanted
