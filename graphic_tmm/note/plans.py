"""The views of a log in a note: each in one position, in running text or as a table, with its figures."""

from __future__ import annotations

import math
import re
from collections.abc import Container, Iterable, Iterator, Sequence
from functools import cached_property

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import by_ruler, heading, referred, worked
from graphic_tmm.note.calculations import Section, as_table
from graphic_tmm.note.document import (
    Block,
    Display,
    Figure,
    Formula,
    Once,
    Paragraph,
    Runs,
    Table,
    Text,
    text,
)
from graphic_tmm.note.protocol import Known, Manner, protocol_blocks, protocol_parts
from graphic_tmm.note.steps import NumberSource, calculated, reason_runs
from graphic_tmm.note.widths import broken
from graphic_tmm.readers.protocol import covering, title_of
from graphic_tmm.scene.chapter import MECHANISM

ALIKE = said("Axes, divisions and ordinates are drawn as on the diagrams before.")


def at_position(drawn: Drawn, view: str, place: int, language: str) -> NumberSource | None:
    """Return where the numbers of a view are read in a position; None where it is not drawn there."""
    reading, row = drawn.of(view), drawn.row(view)
    if reading is None or not row:
        return None
    if view in drawn.project.rows:
        if place not in row:
            place = row[0]
        place = row.index(place)
    return NumberSource(
        drawn.board, drawn.construction, reading, view, place, language, by_ruler(drawn)
    )


def shown_and_listed(
    sections: Sequence[Section],
    name: str,
    title: str,
    language: str,
    shown: Sequence[Figure] = (),
) -> Iterator[Block]:
    """Yield what leads to figures and to the table of some views, the figures, the table."""
    told = list(as_table(sections, f"table-protocol-{name}", title, language))
    tables = [one for one in told if isinstance(one, Table)]
    if shown or tables:
        yield referred(shown, language, tables=tables)
    yield from shown
    yield from told


def section(
    drawn: Drawn,
    view: str,
    place: int,
    language: str,
    known: Known | None = None,
    *,
    bare: bool = False,
    brief: bool = False,
) -> Section | None:
    """Return what a view tells as sentences; None where it is not drawn.

    ``bare``: only what is calculated or read; ``brief``: drawing only where it has a reason that is new.
    """
    told = at_position(drawn, view, place, language)
    if told is None or not _there(drawn, view):
        return None
    usual = _usual(drawn, view, known)
    manner = Manner(drawn.scene.turned, _elsewhere(drawn, told), known, bare, usual, brief)
    equations, parts = protocol_parts(told, manner)
    if usual and not bare and _drawn(drawn, view, usual):
        alike = Once(ALIKE, text(speaking(language)(ALIKE)))
        parts = ((alike, Text(" "), *parts[0]), *parts[1:]) if parts else ()
    return Section(title_of(drawn.project, view, language), parts, equations)


def _there(drawn: Drawn, view: str) -> bool:
    return any(step.it.view == view for step in drawn.construction.steps)


def _drawn(drawn: Drawn, view: str, usual: Container[str]) -> bool:
    """Whether a view has steps that go without saying."""
    steps = drawn.construction.steps
    return any(step.it.view == view and step.op.name in usual for step in steps)


OPERATION = "operation "
"""Among what is known: an operation of a graph that was told, by its name."""


def _usual(drawn: Drawn, view: str, known: Known | None) -> frozenset[str]:
    """Return the operations that graphs before this one were drawn by; enter its own.

    Graphs are drawn alike: their axes, their divisions, their ordinates are told of the first of them.
    """
    log = drawn.construction
    if known is None or not any(f.kind == AXES and f.view == view for f in log.figures):
        return frozenset()
    told = frozenset(
        one.removeprefix(OPERATION)
        for one in known
        if isinstance(one, str) and one.startswith(OPERATION)
    )
    known |= {OPERATION + step.op.name for step in log.steps if step.it.view == view}
    return told


AXES = "axes"
"""The kind of figure that a graph has and no other view."""


def _elsewhere(drawn: Drawn, told: NumberSource) -> list[tuple[int, str]]:
    """Return other positions of a part, so that what is not there in one is told in another."""
    if drawn.board == MECHANISM:
        return []
    steps = [step.it for step in drawn.construction.steps if step.it.view == told.view]
    return [(k, drawn.names[k]) for k in covering(told.reading, steps, [told.place])]


_READ = re.compile(r"Source\([^)]*\)|value=[^),]*")
"""Where a number was read: calculations that are the same in two places are told once."""


class LogPage:
    """What the log of a drawn board tells in one position; nothing twice."""

    def __init__(self, drawn: Drawn, language: str, known: Known) -> None:
        """``known``: what was told before: sentences, reasons, formulas; what is told here is entered."""
        self.drawn, self.language, self.known = drawn, language, known

    @cached_property
    def at(self) -> int:
        """The position (index) that is worked in full."""
        return worked(self.drawn)

    def of(self, view: str, at: int | None = None) -> NumberSource | None:
        """Return where the numbers of a view are read in a position; None where it is not drawn there."""
        return at_position(self.drawn, view, self.at if at is None else at, self.language)

    def view(
        self, view: str, shown: Sequence[Figure] = (), at: int | None = None, *, bare: bool = False
    ) -> Iterator[Block]:
        """Yield what the log tells of a view: a heading, the equations of its groups, its figures, a table.

        ``bare``: only what is calculated or read, without equations.
        """
        place = self.at if at is None else at
        found = section(self.drawn, view, place, self.language, self.known, bare=bare)
        if found is not None:
            yield heading(found.title)
            led = list(shown_and_listed((found,), view, found.title, self.language, shown))
            yield from led[:1]
            yield from () if bare else found.equations
            yield from led[1:]

    def alone(self, view: str, *, bare: bool = False) -> Iterator[Block]:
        """Yield what the log tells of a view, without a heading."""
        source = self.of(view)
        if source is not None:
            manner = Manner(self.drawn.scene.turned, known=self.known, bare=bare)
            yield from protocol_blocks(source, manner)

    def worked_out(self, *marks: Mark, at: int | None = None) -> Iterator[Block]:
        """Yield the calculations of marks as formulas on lines of their own, each once."""
        found: dict[object, Formula] = {}
        for mark in marks:
            source = self.of(mark.view, at)
            step = source.log.step(mark) if source is not None else None
            if source is None or step is None:
                continue
            formula = calculated(source, step)
            if formula is not None:
                found.setdefault((step.op, step.uses), formula)
        if found:
            yield Display(tuple(found.values()))

    def formulas(self, view: str, *ops: Operation, first: bool = False) -> Iterator[Block]:
        """Yield the calculations of a view by some operations, each once; ``first``: only that of the first.

        One that is not there in the position that is worked (a cam's return) is told where it first is.
        """
        found: dict[str, Formula] = {}
        for source, step in self._steps_by(view, ops):
            formula = calculated(source, step)
            if formula is not None:
                found.setdefault(_READ.sub("", repr(formula)), formula)
        if found:
            yield Display(tuple(found.values())[: 1 if first else None])

    def _steps_by(self, view: str, ops: Sequence[Operation]) -> Iterator[tuple[NumberSource, Step]]:
        for step in self.drawn.construction.steps:
            if step.it.view != view or step.op not in ops:
                continue
            for at in (self.at, *range(len(self.drawn.names))):
                source = self.of(view, at)
                if source is not None and math.isfinite(source.value(step.it)):
                    yield source, step
                    break

    def calculation(self, *marks: Mark | None) -> Iterator[Block]:
        """Yield the formulas of steps with their numbers, each behind its reason; what is known is left out."""
        for reason, formula in self._reasoned(marks):
            if reason:
                yield Paragraph(reason)
            yield Display(broken(formula))

    def sentences(self, *marks: Mark | None) -> Iterator[Block]:
        """Yield the same among words, each formula at the end of what tells its reason."""
        for reason, formula in self._reasoned(marks):
            yield Paragraph((*reason, Text(" "), formula._replace(flat=True), Text(".")))

    def _reasoned(self, marks: Iterable[Mark | None]) -> Iterator[tuple[Runs, Formula]]:
        """Yield the reason and the formula of each step, as far as they are not known."""
        for mark in marks:
            source = self.of(mark.view) if mark else None
            step = source.log.step(mark) if source is not None and mark is not None else None
            if source is None or step is None or not math.isfinite(source.value(step.it)):
                continue
            formula = calculated(source, step)
            if formula is None or repr(formula) in self.known:
                continue
            self.known.add(repr(formula))
            new = bool(step.reason) and step.reason not in self.known
            self.known |= {step.reason} if new else set()
            yield reason_runs(source, step) if new else (), formula

    def hide(self, *marks: Mark | None) -> None:
        """Note formulas as known: they are told elsewhere."""
        for _ in self._reasoned(marks):
            pass

    def again(self, mark: Mark) -> Iterator[Block]:
        """Yield the formula of a step that was hidden, among words."""
        known, self.known = self.known, set()
        yield from self.sentences(mark)
        self.known |= known
