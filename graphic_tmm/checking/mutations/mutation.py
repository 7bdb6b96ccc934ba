"""A mutation: what a student may have done instead of a step, or with what was given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark, Step

OPERAND, PREVIOUS, FACTOR, POWER = "operand", "previous", "factor", "power"
LEFT_OUT, DIRECTION, SENSE, WRONG_END = "left out", "direction", "sense", "wrong end"
MEETING, MIRRORED, START, SCALE = "meeting", "mirrored", "start", "scale"
EXCHANGED, CRANK, GIVEN, TABLE = "exchanged", "crank", "given", "table"
FAMILIES = (
    *(LEFT_OUT, SENSE, WRONG_END, OPERAND, FACTOR, POWER, DIRECTION, START, MEETING, MIRRORED),
    *(SCALE, EXCHANGED, CRANK, GIVEN, PREVIOUS, TABLE),
)
"""What mistakes are of: a family has the same share of what is expected beforehand as any other.

In the order in which they are told where nothing else tells mistakes apart."""

UNUSUAL = 3.0
"""A mark squared that is not, or a scale factor doubled, is this much less usual than what is left out."""
Key = tuple[Any, ...]
"""By what mutations of several steps are of one kind: made everywhere, they are one mistake."""


class Change(NamedTuple):
    """What is done instead of a step.

    ``step``: the operation, what it uses and its choice, as they are then; ``before``: which of its uses is
    that of the position before (-1: none); ``factor``: how many times its result is taken.
    """

    step: Step
    before: int = -1
    factor: float = 1.0


class Amiss(NamedTuple):
    """What becomes of a given mark: ``factor`` times that of ``source``, and ``plus``, (1, position) or one."""

    source: Mark
    factor: float = 1.0
    plus: float | NDArray[np.float64] = 0.0


class Mutation(NamedTuple):
    """A mutation of a log.

    ``changes``: by the slots of steps; ``amiss``: by the slots of given marks. What tells it in words:
    ``at`` its first step (None of one of the givens), ``was`` and ``now`` the marks, ``times`` the factor,
    ``formula`` as it was calculated; ``says``: a sentence with these as names. ``usual``: how usual it is
    among those of its family, 1 the most.
    """

    family: str
    says: str
    changes: Mapping[int, Change]
    amiss: Mapping[int, Amiss]
    at: Step | None = None
    was: Mark | None = None
    now: Mark | None = None
    times: float = 1.0
    formula: str = ""
    usual: float = 1.0
    wide: bool = False

    @property
    def slots(self) -> frozenset[int]:
        """The slots of what it changes."""
        return frozenset({*self.changes, *self.amiss})


def at_step(step: Step, family: str, says: str, change: Change, **told: Any) -> Mutation:
    """Return the mutation of one step."""
    return Mutation(family, says, {step.it.slot: change}, {}, step, **told)


def using(step: Step, k: int, mark: Mark) -> Step:
    """Return a step whose use ``k`` is another mark."""
    return step._replace(uses=(*step.uses[:k], mark, *step.uses[k + 1 :]))
