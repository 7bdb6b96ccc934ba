"""Columns of figures read off the log: segments in mm, times μ, in SI; the links' rates.

Segments are magnitudes; the sense of a link's ω and ε is the sign of its value.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isnan

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import TALLY, Construction, Mark, Step
from graphic_tmm.board.values import Length, Reals

UNITS = {"positions": "m", "velocities": "m/s", "accelerations": "m/s²"}
RATES = {"ω": "omega", "ε": "epsilon"}


Row = list[float | None]
"""The figures of one drawing along the positions; None where there is none."""
Positions = tuple[tuple[str, float | None], ...]
"""Positions by their numbers and the angles of what turns, degrees."""


@dataclass(frozen=True, eq=False)
class Column:
    """Figures along the positions, drawing by drawing: mm on the sheet, and SI.

    ``mm``, ``value``: (trial, position), NaN where nothing is measured; one trial where all drawings are alike.
    ``at``: the numbers of its positions and their angles (degrees, None where there is none), if they are not
    those of the mechanism.
    """

    plan: str
    segment: str
    letter: str
    unit: str
    mm: Reals
    value: Reals
    at: Positions = ()

    def without(self, places: Sequence[int]) -> Column:
        """Return the column with nothing at the places (indices) of positions that cannot be drawn."""
        return self.blank(np.isin(range(self.value.shape[1]), places)[None]) if places else self

    def blank(self, gone: NDArray[np.bool_]) -> Column:
        """Return the column with nothing where ``gone``, (trial, position)."""
        mm, value = (np.where(gone, np.nan, rows) for rows in (self.mm, self.value))
        return replace(self, mm=mm, value=value)

    @property
    def drawn(self) -> bool:
        """Whether anything of it is measured in mm."""
        return bool(np.isfinite(self.mm).any())

    @property
    def told(self) -> tuple[Row, Row]:
        """The figures of the first drawing, mm and value."""
        mm, value = (
            [None if isnan(x) else x for x in row[0].tolist()] for row in (self.mm, self.value)
        )
        return mm, value


def known_at(columns: Sequence[Column]) -> list[int]:
    """Return the positions (indices) at which any of some columns, all as long, has a value."""
    known = [np.isfinite(one.value).any(axis=0) for one in columns]
    return [int(k) for k in np.flatnonzero(np.any(known, axis=0))]


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
    for link, mark in rates.items():
        letter = f"{'ω' if plan == 'velocities' else 'ε'}_{link}"
        row = row_of(reading.figure(mark), places, count)
        made.append(Column(plan, segment_name(letter), letter, mark.unit, empty(count), row))
    return tuple(made)


def _is_segment(step: Step) -> bool:
    if step.it.kind is not Length:
        return False
    return step.op.reads or step.it.view != "positions"


def row_of(values: Reals, places: Sequence[int], count: int) -> Reals:
    """Return values (trial, position) at ``places`` out of ``count`` positions; NaN elsewhere, and of ±∞."""
    row = np.full((len(values), count), np.nan)
    row[:, list(places)] = np.where(np.isfinite(values), values, np.nan)
    return row


def empty(count: int) -> Reals:
    """Return the figures of what is not drawn, or not known, at any of ``count`` positions; (1, position)."""
    return np.full((1, count), np.nan)


def ordinates(reading: Reading, mark: Mark, mu: Mark, count: int) -> tuple[Reals, Reals]:
    """Return an ordinate along the positions: mm, and what it stands for."""
    mm, value = (row_of(reading.figure(mark, by), range(count), count) for by in (None, mu))
    return mm, value
