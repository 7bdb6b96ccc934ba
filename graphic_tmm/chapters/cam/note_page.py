"""What the section of a cam in a note is built of: sentences, lists, formulas and figures of one position."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.table import cam_columns
from graphic_tmm.chapters.cam.views import cam_views, scheme_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.note.bricks import referred
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Item,
    Listed,
    Number,
    Picture,
    Run,
    Source,
    Symbol,
)
from graphic_tmm.note.figures import is_figure, picture, readable
from graphic_tmm.note.page import Page
from graphic_tmm.note.plans import listed
from graphic_tmm.note.protocol import Known
from graphic_tmm.note.steps import Told, calculated
from graphic_tmm.readers.told import told as as_told

_PLACE = re.compile(r"Source\([^)]*\)|value=[^),]*")
"""Where a number was read: calculations that are the same in two places are told once."""


LETTERS: dict[str, Run] = {
    "B0": Symbol("B_{0}"),
    "O1": Symbol("O_{1}"),
    "O2": Symbol("O_{2}"),
}
"""Letters of the drawing that sentences name."""


class CamPage(Page):
    """A cam, and the position that is worked: a quarter of the rise, where all of its motion is there."""

    lettered = LETTERS

    def __init__(self, drawn: Drawn, made: Cam, language: str) -> None:
        rise = made.diagrams.turn.rise
        super().__init__(drawn, language, rise.first + max(1, round(rise.parts / 4)))
        self.made = made
        self.known: Known = set()
        self.position = drawn.names[self.at]
        found = cam_columns(drawn)
        written = zip(found, as_told(found), strict=True)
        self.columns = {one.segment: (one, figures) for one, figures in written}
        drawings = [*readable(drawn, scheme_views), *readable(drawn, cam_views)]
        shown = [one for one in drawings if is_figure(one)]
        self.figures = {one.name: picture(one, language) for one in shown}

    def steps(self, told: Sequence[str]) -> Listed:
        """Return what is done, step by step."""
        return Listed(tuple(Item("", (self.says(one),)) for one in told))

    def formulas(self, view: str, *ops: Operation, first: bool = False) -> Iterator[Block]:
        """Yield the calculations of a view by some operations, each once; ``first``: only that of the first.

        One that is not there in the position that is worked (the return's) is told where it first is.
        """
        there: dict[str, Formula] = {}
        for told, step in self._steps_of(view, ops):
            formula = calculated(told, step)
            if formula is not None:
                there.setdefault(_PLACE.sub("", repr(formula)), formula)
        found = tuple(there.values())[: 1 if first else None]
        if found:
            yield Display(found)

    def _steps_of(self, view: str, ops: Sequence[Operation]) -> Iterator[tuple[Told, Step]]:
        for step in self.drawn.construction.steps:
            if step.it.view != view or step.op not in ops:
                continue
            for at in (self.at, *range(len(self.drawn.names))):
                told = self.of(view, at)
                if told is not None and math.isfinite(told.value(step.it)):
                    yield told, step
                    break

    def drawn_as(self, name: str) -> Iterator[Block]:
        """Yield a figure, and the sentence that leads to it."""
        shown = self.taken(name)
        if shown:
            yield referred(shown, self.language)
        yield from shown

    def taken(self, name: str) -> tuple[Picture, ...]:
        """Return a figure by the name of its view, which is not told again."""
        found = self.figures.pop(name, None)
        return () if found is None else (found,)

    def from_log(self, view: str, at: int, shown: Sequence[Picture] = ()) -> Iterator[Block]:
        """Yield a view as the log tells it, step by step."""
        yield from listed(self.drawn, view, at, self.language, shown, known=self.known)

    def cell(self, segment: str, factor: int) -> Number:
        """Return what a column holds in the position that is worked: in mm (0), or the quantity (1)."""
        column, figures = self.columns[segment]
        value = column.told[factor][self.at]
        assert value is not None
        row, places = (figures.value, figures.places) if factor else (figures.mm, figures.mm_places)
        source = Source("column", self.drawn.board, f"{column.plan}/{segment}", self.at, "", factor)
        written = fixed(row[self.at], places, self.language)
        return Number(written, column.unit if factor else "mm", source, value)

    def angle(self) -> Number:
        """Return the angle of the cam in the position that is worked."""
        mark = self.made.diagrams.angle
        told = self.of(mark.view)
        assert told is not None
        found = told.number(mark)
        return found._replace(text=number(found.value, self.language))
