"""By what readings are judged: a hand's own drawings of the same scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.checking.cells import Key, cells
from graphic_tmm.checking.judging.reader import Reader, reader
from graphic_tmm.checking.judging.sample import sample
from graphic_tmm.checking.judging.scatter import Limits, Scatter, scatter
from graphic_tmm.checking.judging.step_scatter import StepScatter, step_scatters
from graphic_tmm.checking.judging.taken_marks import as_marks, steps_of
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene


class Yardstick(NamedTuple):
    """By what readings are judged: how the hand's drawings scatter, and what errors its own steps make."""

    reader: Reader
    limits: Limits
    spread: Mapping[tuple[Key, bool], Scatter]
    steps: Mapping[tuple[Mark, int], StepScatter]


def yardstick(
    made: DrawnScene, readings: Sequence[Taken], hand: Hand, limits: Limits, points: str = "paper"
) -> Yardstick:
    """Return by what readings of these figures are judged.

    Parameters
    ----------
    made
        The scene as the exact hand draws it.
    readings
        Which figures were read; other readings of the same figures are judged by the same yardstick.
    hand
        By whose drawings they are judged, so many as its ``trials``.
    limits
        Where doubt begins, and wrong.
    points
        How points were read, one of ``POINTS``.
    """
    by = reader(made.scene, hand, points)
    wanted: dict[Key, set[bool]] = {}
    rows = [part for taken in readings for part in taken.parts()]
    for taken in rows:
        wanted.setdefault(taken.key, set()).add(taken.in_mm)
    found: dict[Mark, Any] = {}
    if made.mechanism is not None:
        found, _ = as_marks(made.mechanism, steps_of(made.mechanism), rows, cells(made), by)
    drawn = sample(made, hand=by.hand, wanted=wanted, marks=found)
    own: dict[tuple[Mark, int], StepScatter] = {}
    if made.mechanism is not None and found:
        own = step_scatters(made.mechanism, found, drawn.marks, by, limits)
    return Yardstick(by, limits, scatter(made, drawn, by, wanted, limits), own)
