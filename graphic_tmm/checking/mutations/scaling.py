"""Names that are like a scale factor of the student's own: one number, by which a plan is larger."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from graphic_tmm.checking.mutations.hypotheses import UNSURE, Hypothesis, Told
from graphic_tmm.checking.mutations.mutation import FACTOR, GIVEN, POWER, SCALE, Mutation
from graphic_tmm.checking.mutations.tables import TIMES
from graphic_tmm.checking.records import OwnScale

STATED, ROWS, LENGTHS = "stated", "rows", ("lengths", "round", "supposed")
"""What says a scale factor: a row of readings or an option; that lengths agree, no more."""
POSITIONS = "positions"
NUMBERS = (FACTOR, POWER, SCALE, GIVEN)
"""Families that make lengths so many times larger by one number."""


class Scaling(NamedTuple):
    """What is known of scale factors, by plans and views.

    ``stated``: where somebody states it; ``agreed``: where only lengths say that it is the student's own;
    ``written``: where mm and values in one row say it.
    """

    stated: frozenset[str] = frozenset()
    agreed: frozenset[str] = frozenset()
    written: frozenset[str] = frozenset()

    def free(self, plan: str) -> bool:
        """Whether lengths of a plan may be in another scale factor for all that is known."""
        return plan not in self.stated and plan not in self.written

    @classmethod
    def of(cls, scales: Iterable[OwnScale]) -> Scaling:
        """Return what is known of scale factors in which plans are judged."""
        by = [(one.by, name) for one in scales for name in (one.plan, one.view)]
        stated = frozenset(name for what, name in by if what == STATED)
        written = frozenset(name for what, name in by if what == ROWS)
        return cls(stated, frozenset(name for what, name in by if what in LENGTHS), written)

    def weighed(self, said: Iterable[Told]) -> tuple[Told, ...]:
        """Return names, none of them sure where a scale factor may be what is told as a mistake.

        Two mistakes at once, one of which is a number, are a plan in another scale factor with another mistake.
        """
        some = tuple(said)
        if not any(self._doubtful(one, len(some)) for group, _ in some for one in group):
            return some
        return tuple((group, min(sure, UNSURE)) for group, sure in some)

    def _doubtful(self, one: Hypothesis, count: int) -> bool:
        what = one.what
        if one.place is not None:
            return False
        if not isinstance(what, Mutation):
            return count > 1 and what.says == TIMES and what.plan not in self.stated
        if what.family == GIVEN:
            return count > 1 or POSITIONS in self.agreed  # its lengths say both
        view = what.at.it.view if what.at is not None else ""
        free = view not in self.stated
        return free and (what.family == SCALE or (count > 1 and what.family in NUMBERS))
