"""Numbers with their units; a plan's table as arrays: mm on the sheet and quantity, drawing by drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.errors import needed
from graphic_tmm.face.html import grid
from graphic_tmm.face.refusals import absent
from graphic_tmm.mechanism.records import TURN, Sweep
from graphic_tmm.readers.columns import renamed
from graphic_tmm.readers.writing import ANGLE, LENGTH


class Quantity(float):
    """A figure of a drawing: a float like any other, that knows its unit.

    Parameters
    ----------
    value : float
        The figure, of several drawings that of the first; NaN where it could not be drawn.
    unit : str
        Its unit, in English: ``"kg·m²"``; ``""`` of a bare number.
    trials : array, optional
        What it came to in each drawing, (trial,); left out, the one figure.

    Examples
    --------
    >>> from graphic_tmm import Quantity
    >>> inertia = Quantity(1.5, "kg·m²")
    >>> inertia, 2 * inertia, inertia.unit
    (1.5 kg·m², 3.0, 'kg·m²')
    """

    unit: str
    trials: Reals

    def __new__(cls, value: float, unit: str = "", trials: Reals | None = None) -> Quantity:
        """Return the figure with its unit."""
        made = super().__new__(cls, value)
        made.unit = unit
        made.trials = np.array([float(value)]) if trials is None else trials
        return made

    @property
    def value(self) -> float:
        """The bare figure."""
        return float(self)

    def __repr__(self) -> str:
        return f"{float(self):.6g} {self.unit}".rstrip()

    __str__ = __repr__

    def __format__(self, spec: str) -> str:
        return f"{float(self):{spec}} {self.unit}".rstrip() if spec else repr(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (float(self), self.unit, self.trials)


@dataclass(frozen=True, eq=False)
class Column:
    """A segment of a plan, or a rate, along the positions.

    ``mm`` on the sheet and ``value`` in its ``unit`` (SI), both (trial, position): NaN where nothing is
    measured or nothing could be drawn. ``positions``: their numbers, as on the sheet; ``coordinates``: of
    the drive, (position,), NaN where there are none: angles, degrees, of the crank, or of what else turns;
    lengths, m, of what slides, and ``sweep`` tells which. ``name``: what people call it; ``quantity``: the
    letter of what the segment stands for, "" if it has none of its own.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> pa = tmm.draw("crank-rocker").table("velocities")["pa"]
    >>> pa.value.shape, pa.unit, pa.at(1)
    ((1, 9), 'm/s', 2.51327 m/s)
    """

    segment: str
    name: str
    unit: str
    mm: Reals
    value: Reals
    positions: tuple[str, ...]
    coordinates: Reals
    quantity: str = ""
    sweep: Sweep = TURN

    @property
    def angles(self) -> Reals:
        """The angles of the drive, degrees, (position,); NaN where it slides."""
        return self.coordinates if self.sweep.turns else np.full(len(self), np.nan)

    @property
    def lengths(self) -> Reals:
        """The coordinates of a drive that slides, m, (position,); NaN where it turns."""
        return np.full(len(self), np.nan) if self.sweep.turns else self.coordinates

    def at(self, position: str | int) -> Quantity:
        """Return the quantity in one position.

        Parameters
        ----------
        position : str or int
            Its number, as on the sheet: ``3``, ``"6*"``.

        Raises
        ------
        AbsentError
            If there is no such position.
        """
        if str(position) not in self.positions:
            raise absent(position, self.positions)
        row = self.value[:, self.positions.index(str(position))]
        return Quantity(float(row[0]), self.unit, row)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return np.array(self.value, dtype=dtype)

    def __len__(self) -> int:
        return len(self.positions)

    def __repr__(self) -> str:
        trials, count = self.value.shape
        return f"<Column {self.segment}, {self.unit or '1'}: {trials} × {count}>"


@dataclass(frozen=True, eq=False)
class Table(Mapping[str, Column]):
    """The table of a plan: a mapping of segments to their columns, as ``graphic-tmm table`` prints it.

    ``plan``: its name, as the commands have it; ``title``: as people have it.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> table = tmm.draw("crank-rocker").table("velocities")
    >>> table.columns[:2], table.trials, table.positions[:3]
    (('pa', 'ab'), 1, ('0', '1', '2'))
    >>> table.to_records()[0]["value"]
    2.513...
    """

    plan: str
    title: str
    _columns: tuple[Column, ...]
    _rows: tuple[tuple[tuple[str, ...], ...], ...]

    @property
    def columns(self) -> tuple[str, ...]:
        """The segments, in the order of the plan."""
        return tuple(one.segment for one in self._columns)

    @property
    def positions(self) -> tuple[str, ...]:
        """The numbers of the positions, as on the sheet: those of the longest column."""
        return max((one.positions for one in self._columns), key=len)

    @property
    def angles(self) -> Reals:
        """The angles of the crank at the positions, degrees, (position,); NaN where there are none."""
        return max(self._columns, key=len).angles

    @property
    def lengths(self) -> Reals:
        """How far what drives has slid at the positions, m, (position,); NaN where the drive turns."""
        return max(self._columns, key=len).lengths

    @property
    def trials(self) -> int:
        """The number of drawings in it."""
        return len(self._columns[0].value)

    def __getitem__(self, segment: str) -> Column:
        """Return the column of a segment.

        Parameters
        ----------
        segment : str
            Its letters, as on the plan: ``"pb"``, ``"n3a3"``; ``"omega2"``, ``"R12"``. A name of an earlier
            version is understood, too.

        Raises
        ------
        AbsentError
            If the plan has none: a KeyError that lists those that there are.
        """
        known = {one.segment: one for one in self._columns}
        found = known.get(segment) or known.get(
            renamed(self.plan, segment, {k: (one.quantity,) for k, one in known.items()})
        )
        if found is None:
            raise absent(segment, self.columns)
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self._columns)

    def to_records(self) -> list[dict[str, Any]]:
        """Return a dictionary for each segment and position, with the names of the columns of the CSV.

        Returns
        -------
        list of dict
            plan, position, angle_deg (length_m where the drive slides), segment, mm, value, unit; of several
            drawings also trial, from 0. What is not there is None; where neither mm nor value is there is no
            record.
        """
        long = self._long()
        names, rows = list(long), zip(*(_listed(one) for one in long.values()), strict=True)
        return [dict(zip(names, row, strict=True)) for row in rows]

    def to_pandas(self) -> Any:
        """Return a data frame of the same columns and rows; what is not there is NaN.

        Returns
        -------
        pandas.DataFrame
            A row for each segment and position (and trial), with the names of the columns of the CSV.

        Raises
        ------
        MissingError
            If pandas is not installed.
        """
        return needed("pandas", "pandas").DataFrame(self._long())

    def _long(self) -> dict[str, Any]:
        """Return the columns of a long table, each (row,)."""
        parts = [_stacked(one) for one in self._columns]
        trial, position, at, mm, value = (np.concatenate(part) for part in zip(*parts, strict=True))
        counts = [len(part[0]) for part in parts]
        segments = np.repeat([one.segment for one in self._columns], counts)
        units = np.repeat([one.unit for one in self._columns], counts)
        plan = np.full(len(trial), self.plan)
        turns = max(self._columns, key=len).sweep.turns
        told = {"plan": plan, "trial": trial, "position": position}
        told |= {str(ANGLE if turns else LENGTH): at}
        told |= {"segment": segments, "mm": mm, "value": value, "unit": units}
        return {name: one for name, one in told.items() if name != "trial" or self.trials > 1}

    def __repr__(self) -> str:
        return "\n".join([self._headed(), *(_printed(rows) for rows in self._rows)])

    def _repr_html_(self) -> str:
        """Return the table for a notebook."""
        return "\n".join(grid(self._headed(), rows) for rows in self._rows)

    def _headed(self) -> str:
        return self.title if self.trials == 1 else f"{self.title} (1/{self.trials})"


def _stacked(column: Column) -> tuple[Any, ...]:
    """Return trials, positions, coordinates, mm and values of a column, (row,), where any figure is there."""
    trial, place = np.nonzero(np.isfinite(column.mm) | np.isfinite(column.value))
    names = np.array(column.positions, dtype=object)
    mm, value = column.mm[trial, place], column.value[trial, place]
    return trial, names[place], column.coordinates[place], mm, value


def _listed(rows: Any) -> list[Any]:
    """Return an array as a list; None for NaN."""
    return [None if one != one else one for one in rows.tolist()]


def _printed(rows: tuple[tuple[str, ...], ...]) -> str:
    """Return rows of cells as lines of text, columns one below the other; the first two to the left."""
    wide = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join(
        "  ".join(
            cell.ljust(width) if k < 2 else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, wide, strict=True))
        ).rstrip()
        for row in rows
    )
