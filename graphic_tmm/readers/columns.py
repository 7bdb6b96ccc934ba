"""Columns of figures read off the log: segments in mm, times μ, in SI; the links' rates.

Segments are magnitudes; the sense of a link's ω and ε is the sign of its value.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import TALLY, Construction, Mark, Step
from graphic_tmm.board.values import Length, Reals

UNITS = {"positions": "m", "velocities": "m/s", "accelerations": "m/s²"}
RATES = {"ω": "omega", "ε": "epsilon"}


Row = tuple[float | None, ...]
Positions = tuple[tuple[str, float | None], ...]
"""Positions by their numbers and the angles of what turns, degrees."""


class Column(NamedTuple):
    """One row of figures along the positions: mm on the sheet (None where nothing is measured) and SI.

    ``at``: the numbers of its positions and their angles (degrees, None where there is none), if they are not
    those of the mechanism.
    """

    plan: str
    segment: str
    letter: str
    unit: str
    mm: Row
    value: Row
    at: Positions = ()

    def without(self, places: Sequence[int]) -> Column:
        """Return the column with nothing at the places (indices) of positions that cannot be drawn."""

        def blank(row: Row) -> Row:
            return tuple(None if k in places else x for k, x in enumerate(row))

        return self._replace(mm=blank(self.mm), value=blank(self.value)) if places else self


def segment_name(letter: str) -> str:
    """Return a letter of the log as machines read it: n_{ab} -> nab, ω_2 -> omega2."""
    stem, _, rest = letter.partition("_")
    if rest and stem in RATES:
        return RATES[stem] + rest.strip("{}")
    return letter.replace(TALLY, "′").translate({ord(sign): None for sign in "_{}"})


def columns(
    construction: Construction,
    reading: Reading,
    plan: str,
    places: Sequence[int],
    count: int,
    shared: dict[int, Mark] | None = None,
) -> tuple[Column, ...]:
    """Return the columns of one plan.

    Parameters
    ----------
    reading
        The numbers, at the positions ``places`` (indices) out of ``count``.
    shared
        The rate mark of every turning link of this plan; links that turn alike share a mark.
    """
    view = construction.view(plan)
    if view is None or view.scale is None:
        return ()
    steps = [step for step in construction.steps if step.it.view == plan and _is_segment(step)]
    rates = dict(sorted((shared or {}).items()))
    made = []
    for step in steps:
        mm, value = (np.abs(reading.figure(step.it, by)) for by in (None, view.scale))
        segment = segment_name(step.it.letter)
        rows = row_of(mm, places, count), row_of(value, places, count)
        made.append(Column(plan, segment, step.it.name, UNITS[plan], *rows))
    empty = (None,) * count
    for link, mark in rates.items():
        letter = f"{'ω' if plan == 'velocities' else 'ε'}_{link}"
        row = row_of(reading.figure(mark), places, count)
        made.append(Column(plan, segment_name(letter), letter, mark.unit, empty, row))
    return tuple(made)


def _is_segment(step: Step) -> bool:
    if step.it.kind is not Length:
        return False
    return step.op.reads or step.it.view != "positions"


def row_of(values: Reals, places: Sequence[int], count: int) -> Row:
    """Return the values at ``places`` out of ``count`` positions; None elsewhere, and where there is none."""
    row: list[float | None] = [None] * count
    spread = np.broadcast_to(values[0], (len(places),))
    for place, value in zip(places, spread, strict=True):
        row[place] = float(value) if np.isfinite(value) else None
    return tuple(row)


def ordinates(reading: Reading, mark: Mark, mu: Mark, count: int) -> tuple[Row, Row]:
    """Return an ordinate along the positions: mm, and what it stands for."""
    mm, value = (row_of(reading.figure(mark, by), range(count), count) for by in (None, mu))
    return mm, value
