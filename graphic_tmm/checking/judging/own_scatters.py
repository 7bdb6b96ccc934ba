"""What errors the hand's own steps make, whatever was read before them: found once for each such case."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.checking.judging.own_errors import Found, Own, run
from graphic_tmm.checking.judging.reader import Reader
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.step_scatter import (
    StepScatter,
    as_read,
    step_scatter,
    where_read,
)
from graphic_tmm.drawn import Drawn

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
