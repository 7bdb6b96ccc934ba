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
NOISE = 1e-12
"""A figure below this share of the largest of its plan is the rounding of the machine."""
RATES = {"ω": "omega", "ε": "epsilon"}


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
    mm: tuple[float | None, ...]
    value: tuple[float | None, ...]
    at: Positions = ()

    def without(self, places: Sequence[int]) -> Column:
        """Return the column with nothing at the places (indices) of positions that cannot be drawn."""

        def blank(row: tuple[float | None, ...]) -> tuple[float | None, ...]:
            return tuple(None if k in places else x for k, x in enumerate(row))

        return self._replace(mm=blank(self.mm), value=blank(self.value)) if places else self


def segment_name(letter: str) -> str:
    """Return a letter of the log as machines read it: n_{ab} -> nab, ω_2 -> omega2."""
    if letter[0] in RATES:
        return RATES[letter[0]] + letter[1:].strip("_{}")
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
    mu = reading[view.scale]
    steps = [step for step in construction.steps if step.it.view == plan and _is_segment(step)]
    rates = dict(sorted((shared or {}).items()))
    lengths = quiet([np.abs(reading[step.it]) for step in steps])
    turning = quiet([reading[mark] for mark in rates.values()])
    made = []
    for step, mm in zip(steps, lengths, strict=True):
        rows = row_of(mm, places, count), row_of(mm * mu, places, count)
        segment = segment_name(step.it.letter)
        made.append(Column(plan, segment, step.it.name, UNITS[plan], *rows))
    empty = (None,) * count
    for (link, mark), value in zip(rates.items(), turning, strict=True):
        letter = f"{'ω' if plan == 'velocities' else 'ε'}_{link}"
        row = row_of(value, places, count)
        made.append(Column(plan, segment_name(letter), letter, mark.unit, empty, row))
    return tuple(made)


def quiet(rows: list[Reals]) -> list[Reals]:
    """Return figures with those that are nothing but rounding beside the largest of them set to zero."""
    finite = [np.abs(row[np.isfinite(row)]) for row in rows]
    largest = max((float(row.max()) for row in finite if row.size), default=0.0)
    return [np.where(np.abs(row) < NOISE * largest, 0.0, row) for row in rows]


def _is_segment(step: Step) -> bool:
    if step.it.kind is not Length:
        return False
    return step.op.reads or step.it.view != "positions"


def row_of(values: Reals, places: Sequence[int], count: int) -> tuple[float | None, ...]:
    """Return the values at ``places`` out of ``count`` positions; None elsewhere, and where there is none."""
    row: list[float | None] = [None] * count
    spread = np.broadcast_to(values[0], (len(places),))
    for place, value in zip(places, spread, strict=True):
        row[place] = float(value) if np.isfinite(value) else None
    return tuple(row)
