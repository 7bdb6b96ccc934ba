"""A mutation: what a student may have done instead of a step, or with what was given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

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
