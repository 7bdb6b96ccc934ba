"""Readings in the unit of the figure that they are compared with."""

from __future__ import annotations

from graphic_tmm.checking.cells import Cell
from graphic_tmm.checking.records import Taken
from graphic_tmm.language.said import said
from graphic_tmm.scene.units import UNITS, plain


def taken_figure(taken: Taken, cell: Cell) -> float:
    """Return a reading in mm, or as a quantity in the unit of its figure.

    Raises
    ------
    ValueError
        If its unit is not known or measures something else.
    """
    if taken.mm is not None:
        return taken.mm
    assert taken.value is not None
    return taken.value * _factor(taken, cell)


def due_figure(cell: Cell, taken: Taken) -> float:
    """Return the figure that a reading is compared with: mm where it is given in mm."""
    due = cell.mm if taken.mm is not None else cell.value
    assert due is not None
    return due


def half_of(taken: Taken, cell: Cell) -> float:
    """Return half a unit of the last digit that was written of a reading, in the unit of its figure."""
    return taken.last.mm if taken.mm is not None else taken.last.value * _factor(taken, cell)


def _factor(taken: Taken, cell: Cell) -> float:
    if taken.unit in ("", "1", cell.unit):
        return 1.0
    own, other = UNITS.get(plain(taken.unit)), UNITS.get(plain(cell.unit))
    if own is None or (other is not None and own.dimension != other.dimension):
        raise ValueError(
            said(
                'the unit "{unit}" does not fit; write it in {due}',
                unit=taken.unit[:20],
                due=cell.unit or said("plain numbers"),
            )
        )
    return float(own.factor) / (float(other.factor) if other is not None else 1.0)
