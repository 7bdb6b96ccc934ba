"""What the lengths of a view stand for: the rows of its small table, figure by figure as tables tell them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Mark, Step, segment_name
from graphic_tmm.board.values import Length, Number, Reals
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.page.sentences import braced, marked_up
from graphic_tmm.readers.columns import Column, row_of
from graphic_tmm.readers.rounding import Figures, rounded_figures
from graphic_tmm.readers.table import columns_of

OFF = 0.02
"""By so much of itself the quantity of a column may differ from its length times its μ: by rounding."""


class Entry(NamedTuple):
    """A column of a table and its figures as told there; ``mark``: the length or number that it tells."""

    mark: Mark
    column: Column
    figures: Figures


class Values:
    """The figures of the tables of a board, by the marks of its log."""

    def __init__(self, drawn: Drawn, language: str) -> None:
        self.drawn, self.language = drawn, language

    @cached_property
    def entries(self) -> Mapping[int, Entry]:
        """What tables tell of marks, by their slots; lengths that no table tells as one of them would."""
        found = {one.mark.slot: one for one in self.plan_entries(columns_of(self.drawn))}
        others = (self.column(m, mm) for m, mm in self.lengths.items() if m.slot not in found)
        found |= {
            e.mark.slot: e for e in self.plan_entries([one for one in others if one is not None])
        }
        return found

    def plan_entries(self, columns: Sequence[Column]) -> Iterator[Entry]:
        """Yield what some columns tell of marks, plan by plan as their tables do."""
        for _, same in groupby(sorted(columns, key=_plan), key=_plan):
            some = list(same)
            for column, figures in zip(some, rounded_figures(some), strict=True):
                yield from (Entry(mark, column, figures) for mark in self.marks(column))

    def column(self, mark: Mark, mm: Reals) -> Column | None:
        """Return a length that was read as a column of its own; None where it stands for no quantity."""
        scale = self.drawn.scales.get(mark.view)
        if scale is None:
            return None
        of = "" if scale.unit == "1/mm" else scale.unit.removesuffix("/mm").strip("()")
        name = segment_name(mark.letter)
        mu = np.array([scale.at(k).value for k in range(mm.shape[-1])])
        return Column(mark.view, name, mark.name, of, mm, mm * mu)

    @cached_property
    def steps(self) -> Sequence[Step]:
        """The steps that leave lengths or numbers: what tables tell."""
        return [s for s in self.drawn.construction.steps if s.it.kind in (Length, Number)]

    @cached_property
    def laid(self) -> Mapping[Mark, Mark]:
        """Lengths that are laid off, and the points that mark them."""
        steps = self.drawn.construction.steps
        return {s.uses[1]: s.it for s in steps if s.op.name == "lay_off"}

    @cached_property
    def arms(self) -> frozenset[Mark]:
        """Arms of forces: they stand for no quantity until a force is at them."""
        return frozenset(s.it for s in self.steps if s.op is arm)

    @cached_property
    def lengths(self) -> Mapping[Mark, Reals]:
        """The lengths that are read off the drawing, in mm along the positions of the board, by their marks."""
        found = {}
        for step in self.steps:
            reading = self.drawn.of(step.it.view)
            if step.it.kind is Length and step.op.reads and reading is not None:
                rows, places = np.abs(reading.figure(step.it)), self.drawn.row(step.it.view)
                if rows.shape[1] in (1, len(places)):
                    found[step.it] = row_of(rows, places, len(self.drawn.names))
        return found

    def marks(self, column: Column) -> list[Mark]:
        """Return the marks that a column tells: the one of its name in its plan, else what was read for it."""
        named = [
            s.it
            for s in self.steps
            if s.it.view == column.plan
            and (s.it.name == column.letter or segment_name(s.it.letter) == column.segment)
            and (s.it.kind is Length) == column.drawn
        ]
        if named or not column.drawn:
            return named
        mm = np.abs(column.mm)
        there = np.isfinite(mm)
        alike = [
            mark
            for mark, row in self.lengths.items()
            if row.shape == mm.shape and np.array_equal(row[there], mm[there])
        ]
        return [m for m in alike if segment_name(m.letter).endswith(column.segment)] or alike[:1]

    def row(self, mark: Mark, at: int) -> list[Any] | None:
        """Return the row of a mark in a position of the board: slots, segment, mm, μ, value, quantity.

        None where it has none there, and of what stands for no quantity.
        """
        entry = self.entries.get(mark.slot)
        if entry is None or at >= len(entry.figures.value):
            return None
        column, figures, language = entry.column, entry.figures, self.language
        value = figures.value[at]
        if value is None or not math.isfinite(value):
            return None
        worth = f"{fixed(value, figures.places, language)} {unit(column.unit, language)}".rstrip()
        if not column.drawn:
            return [[mark.slot], marked_up(mark, language), "", "", worth, ""]
        mm, scale = figures.mm[at], self.drawn.scales.get(mark.view)
        if mm is None or scale is None:
            return None
        scale = scale.at(at)
        if abs(abs(mm) * scale.value - abs(value)) > OFF * abs(value) + scale.value:
            return None
        length = f"{fixed(mm, figures.mm_places, language)} {unit('mm', language)}"
        slots = [mark.slot, *([self.laid[mark].slot] if mark in self.laid else [])]
        if mark in self.arms:
            return [slots, marked_up(mark, language), length, "", "", ""]
        by = f"{number(scale.value, language)} {unit(scale.unit, language)}"
        return [slots, marked_up(mark, language), length, by, worth, self.quantity(entry)]

    def quantity(self, entry: Entry) -> str:
        """Return the letter of what a length stands for, as mark-up; "" if it has none of its own."""
        column = entry.column
        if column.quantity:
            return braced(symbol(column.quantity, self.language))
        own = column.letter != entry.mark.name and " " not in column.letter
        return braced(symbol(column.letter, self.language)) if own else ""

    def rows(self, views: Sequence[str], at: int) -> Iterator[list[Any]]:
        """Yield the rows of some views of the log in a position of the board, in the order of the log."""
        for step in self.drawn.construction.steps:
            if step.it.view in views and step.it.slot in self.entries:
                found = self.row(step.it, at)
                if found is not None:
                    yield found


def _plan(column: Column) -> str:
    return column.plan
