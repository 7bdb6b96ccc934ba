"""The views of a log in a note: each in one position, in running text or as a table, with its figures."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping, Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import Figure, filled, heading, referred
from graphic_tmm.note.calculations import Section, as_table
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Once,
    Paragraph,
    Run,
    Table,
    Text,
    text,
)
from graphic_tmm.note.protocol import Known, Manner, protocol_blocks, protocol_parts
from graphic_tmm.note.steps import NumberSource, calculated
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
    return NumberSource(drawn.board, drawn.construction, reading, view, place, language)


def plan(
    drawn: Drawn,
    view: str,
    place: int,
    language: str,
    shown: Sequence[Figure] = (),
    known: Known | None = None,
) -> Iterator[Block]:
    """Yield the section of a view: heading, protocol in a position, the figures that show it.

    ``known``: what was told already and is not told again.
    """
    told = at_position(drawn, view, place, language)
    if told is None or not _there(drawn, view):
        return
    yield heading(title_of(drawn.project, view, language))
    if shown:
        yield referred(shown, language)
    yield from protocol_blocks(told, Manner(drawn.scene.turned, _elsewhere(drawn, told), known))
    yield from shown


def section_table(
    drawn: Drawn,
    view: str,
    place: int,
    language: str,
    shown: Sequence[Figure] = (),
    known: Known | None = None,
) -> Iterator[Block]:
    """Yield the section of a view, its protocol as a table; see `plan`."""
    found = section(drawn, view, place, language, known)
    if found is None:
        return
    yield heading(found.title)
    blocks = list(shown_and_listed((found,), view, found.title, language, shown))
    yield from blocks[:1]
    yield from found.equations
    yield from blocks[1:]


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


NONE: Mapping[str, Run] = {}


class Page:
    """A drawn board, told in one position (index).

    ``lettered``: letters of the drawing that sentences name, besides what each is given.
    """

    lettered: Mapping[str, Run] = NONE

    def __init__(self, drawn: Drawn, language: str, at: int) -> None:
        self.drawn, self.language, self.at = drawn, language, at
        self.speech = speaking(language)

    def says(self, told: str, put: Mapping[str, Run] = NONE, /, **named: Run) -> Paragraph:
        """Return a sentence with runs in the places of its names."""
        return Paragraph(filled(self.speech(told), {**self.lettered, **put, **named}))

    def of(self, view: str, at: int | None = None) -> NumberSource | None:
        """Return where the numbers of a view are read in a position: in that which is worked."""
        return at_position(self.drawn, view, self.at if at is None else at, self.language)

    def worked_out(self, told: NumberSource, *marks: Mark) -> Iterator[Block]:
        """Yield the calculations of marks as formulas on lines of their own, each once."""
        found: dict[object, Formula] = {}
        for step in map(told.log.step, marks):
            formula = calculated(told, step) if step is not None else None
            if step is not None and formula is not None:
                found.setdefault((step.op, step.uses), formula)
        if found:
            yield Display(tuple(found.values()))
