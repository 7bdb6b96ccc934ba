"""Columns of figures read off the log: mm on the sheet, times μ, in SI; drawing by drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isnan

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals

Row = list[float | None]
"""The figures of one drawing along the positions; None where there is none."""
Positions = tuple[tuple[str, float | None], ...]
"""Positions by their numbers and the angles of what turns, degrees."""


@dataclass(frozen=True, eq=False)
class Column:
    """Figures along the positions, drawing by drawing: mm on the sheet, and SI.

    ``mm``, ``value``: (trial, position), NaN where nothing is measured; one trial where all drawings are alike.
    ``quantity``: the letter of what it stands for, if that is not the one of the segment.
    ``ends``: the letters on the plan between which the segment lies, if it is not called by them.
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
    quantity: str = ""
    ends: str = ""

    def without(self, places: Sequence[int]) -> Column:
        """Return the column with nothing at the places (indices) of positions that cannot be drawn."""
        return self.blank(np.isin(range(self.value.shape[1]), places)[None]) if places else self

    def blank(self, gone: NDArray[np.bool_]) -> Column:
        """Return the column with nothing where ``gone``, (trial, position)."""
        mm, value = (np.where(gone, np.nan, rows) for rows in (self.mm, self.value))
        return replace(self, mm=mm, value=value)

    def placed_as(self, other: Column) -> Column:
        """Return the column with its positions in the order of those of another.

        A list stands in the order of its first drawing: the lists of two blocks of drawings may differ in it.
        """
        if self.at == other.at:
            return self
        names = [name for name, _ in self.at]
        order = [names.index(name) for name, _ in other.at]
        return replace(self, mm=self.mm[:, order], value=self.value[:, order], at=other.at)

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


def row_of(values: Reals, places: Sequence[int], count: int) -> Reals:
    """Return values (trial, position) at ``places`` out of ``count`` positions; NaN elsewhere, and of ±∞."""
    row = np.full((len(values), count), np.nan)
    row[:, list(places)] = np.where(np.isfinite(values), values, np.nan)
    return row


def listed(
    plan: str,
    segment: str,
    letter: str,
    unit: str,
    figures: Sequence[Reals],
    heads: Sequence[str],
    mm: Sequence[Reals] = (),
) -> Column:
    """Return figures, (trial,), that stand under heads of their own: wheels, points of a line, rows of a list.

    ``mm``: what was measured for each of them; nothing if it is left out. Without heads it is one figure.
    """
    names = tuple((head, None) for head in heads or ("",))
    value = np.stack(np.broadcast_arrays(*figures), axis=1).astype(float)
    value[~np.isfinite(value)] = np.nan
    lengths = np.stack(np.broadcast_arrays(*mm), axis=1) if mm else empty(len(names))
    return Column(plan, segment, letter, unit, lengths, value, names)


def empty(count: int) -> Reals:
    """Return the figures of what is not drawn, or not known, at any of ``count`` positions; (1, position)."""
    return np.full((1, count), np.nan)


def ordinates(reading: Reading, mark: Mark, mu: Mark, count: int) -> tuple[Reals, Reals]:
    """Return an ordinate along the positions: mm, and what it stands for."""
    mm, value = (row_of(reading.figure(mark, by), range(count), count) for by in (None, mu))
    return mm, value
