"""What notes are built of besides bricks: single steps told as formulas with their reasons, words, columns.

Engine and flywheel tell the gas and what follows from it in the order of their book, not in that of the log.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.indicator.task import CALCULATED as STROKE
from graphic_tmm.chapters.indicator.task import VIEW
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import heading, worked
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Number,
    Paragraph,
    Picture,
    Runs,
    Source,
    Symbol,
    Table,
    Text,
    text,
)
from graphic_tmm.note.figures import in_hand, picture
from graphic_tmm.note.plans import Page, at_position, section, shown_and_listed
from graphic_tmm.note.protocol import Known, Manner, protocol_blocks
from graphic_tmm.note.steps import calculated, reason_runs
from graphic_tmm.note.widths import broken
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.rounding import decimals
from graphic_tmm.readers.text import column_name
from graphic_tmm.scene.captions import captions


class Worked(Page):
    """The position that is worked in full; ``known``: what was told already, formulas and reasons among it."""

    def __init__(self, drawn: Drawn, language: str) -> None:
        super().__init__(drawn, language, worked(drawn))
        self.known: Known = set()

    def view(
        self, view: str, shown: tuple[Picture, ...] = (), *, bare: bool = False
    ) -> Iterator[Block]:
        """Yield what the log tells of a view as a table, with its heading and its figures."""
        found = section(self.drawn, view, self.at, self.language, self.known, bare=bare)
        if found is not None:
            yield heading(found.title)
            yield from shown_and_listed((found,), view, found.title, self.language, shown)

    def alone(self, view: str, *, bare: bool = False) -> Iterator[Block]:
        """Yield what the log tells of a view, without a heading."""
        told = at_position(self.drawn, view, self.at, self.language)
        if told is not None:
            manner = Manner(self.drawn.scene.turned, known=self.known, bare=bare)
            yield from protocol_blocks(told, manner)

    def calculation(self, *marks: Mark | None) -> Iterator[Block]:
        """Yield the formulas of steps with their numbers, each behind its reason; what is known is left out."""
        for reason, formula in self._steps(marks):
            if reason:
                yield Paragraph(reason)
            yield Display(broken(formula))

    def sentences(self, *marks: Mark | None) -> Iterator[Block]:
        """Yield the same among words, each formula at the end of what tells its reason."""
        for reason, formula in self._steps(marks):
            yield Paragraph((*reason, Text(" "), formula._replace(flat=True), Text(".")))

    def _steps(self, marks: Iterable[Mark | None]) -> Iterator[tuple[Runs, Formula]]:
        """Yield the reason and the formula of each step, as far as they are not known."""
        for mark in marks:
            told = at_position(self.drawn, mark.view, self.at, self.language) if mark else None
            step = told.log.step(mark) if told is not None and mark is not None else None
            if told is None or step is None or not math.isfinite(told.value(step.it)):
                continue
            formula = calculated(told, step)
            if formula is None or repr(formula) in self.known:
                continue
            self.known.add(repr(formula))
            new = bool(step.reason) and step.reason not in self.known
            self.known |= {step.reason} if new else set()
            yield reason_runs(told, step) if new else (), formula

    def hide(self, *marks: Mark | None) -> None:
        """Note formulas as known: they are told elsewhere."""
        for _ in self._steps(marks):
            pass

    def again(self, mark: Mark) -> Iterator[Block]:
        """Yield the formula of a step that was hidden, among words."""
        known, self.known = self.known, set()
        yield from self.sentences(mark)
        self.known |= known

    def number(self, mark: Mark, *, size: bool = False) -> Number:
        """Return the value of a mark in the worked position, with its unit; its ``size`` only."""
        told = at_position(self.drawn, mark.view, self.at, self.language)
        assert told is not None
        found = told.number(mark, unit=True)
        if not size or found.value >= 0.0:
            return found
        source = found.source._replace(kind="size")
        return found._replace(text=found.text.removeprefix("−"), source=source, value=-found.value)

    def cell(
        self, column: Column, place: int, *, mm: bool = False, places: int | None = None
    ) -> Runs:
        """Return the figure of a column in a position, as a table tells it."""
        row = column.first_figures[0 if mm else 1]
        value = row[place]
        if value is None:
            return text("—")
        digits = (1 if mm else decimals(row)) if places is None else places
        name = f"{column.plan}/{column.segment}"
        source = Source("column", self.drawn.board, name, place, "", 0 if mm else 1)
        return (Number(fixed(value, digits, self.language), "", source, value),)

    def upright(
        self, id: str, title: str, some: Sequence[tuple[Column, bool]], places: Sequence[int]
    ) -> Table:
        """Return a table with a row for each position; ``some``: columns, whether in mm."""
        words = captions(self.language)
        heads = [text(words["position"])]
        for column, mm in some:
            name = markup(column_name(column, self.language))
            of = unit("mm" if mm else column.unit, self.language)
            heads.append((Symbol(name), Text(f", {of}")))
        body = tuple(
            (text(self.drawn.names[k]), *(self.cell(one, k, mm=mm) for one, mm in some))
            for k in places
        )
        return Table(id, text(self.speech(title)), tuple(heads), body, "c" * len(heads))

    def letters(self, *lines: str) -> Display:
        """Return lines of letters alone."""
        return Display(tuple(Formula((Symbol(symbol(line, self.language)),)) for line in lines))


def gas(page: Worked, by: str) -> Iterator[Block]:
    """Yield the indicator diagram: its division, pressures, areas, the force; the scale of the stroke."""
    views = indicator_views(in_hand(page.drawn), True, by)
    shown = tuple(picture(view, page.language) for view in views)
    yield from page.view(VIEW, shown)
    log = page.drawn.construction
    marks = [step.it for step in log.steps if step.it.view == STROKE]
    yield from page.calculation(*marks)
