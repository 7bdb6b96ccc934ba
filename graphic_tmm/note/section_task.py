"""The task: what the mechanism is, its scheme, what is given; how its lengths follow from that."""

from __future__ import annotations

import re
from collections.abc import Iterator

from graphic_tmm.board.execute import execute
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.bricks import heading, in_columns, worked
from graphic_tmm.note.document import (
    Block,
    Item,
    Listed,
    Number,
    Paragraph,
    Picture,
    Ref,
    Runs,
    Source,
    Symbol,
    Table,
    Text,
    lettered,
    paragraph,
    text,
)
from graphic_tmm.note.figures import picture, readable
from graphic_tmm.note.protocol import Manner, protocol_blocks
from graphic_tmm.note.steps import NumberSource
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.protocol import SYNTHESIS
from graphic_tmm.readers.protocol import synthesis as found_for
from graphic_tmm.readers.task_sheet import (
    TaskSheet,
    given_figure,
    given_rows,
    given_title,
    sought,
)
from graphic_tmm.scene.captions import captions, view_name

TASK = said("Task")
SCHEME = said("Scheme of the mechanism")
OF = said("The mechanism is shown in {figure}; the given data are listed in {table}.")


def task(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the section of the task."""
    yield heading(speaking(language)(TASK), 1)
    yield Paragraph(text(f"{made.scene.title}."))
    tables = [found for one in made.boards if (found := given_table(one, language)) is not None]
    shown = scheme(made.mechanism, language) if made.mechanism is not None else None
    if shown is not None and tables:
        before, between, behind = (
            speaking(language)(OF).replace("{table}", "{figure}").split("{figure}")
        )
        yield Paragraph(
            (Text(before), Ref(shown.id), Text(between), Ref(tables[0].id), Text(behind))
        )
    if shown is not None:
        yield shown
    yield from tables
    yield from _by_points(made, language)
    yield from _conditions(made, language)


def _by_points(made: DrawnScene, language: str) -> Iterator[Table]:
    """Yield what is given point by point; what has no title goes on under the last one."""
    listed = (
        one
        for drawn in made.boards
        for chapter in drawn.project.chapters
        for one in TaskSheet.of(chapter).listed(made.scene, language)
    )
    title = ""
    for k, one in enumerate(dict.fromkeys(listed)):
        heads, *rows = (tuple(map(_cell, row)) for row in (one.heads, *one.rows))
        title = one.title or title
        yield Table(f"table-listed-{k}", lettered(title), heads, tuple(rows), "c" * len(heads))


def _cell(words: str) -> Runs:
    """Return a cell: a letter with an index or a power, and what follows it."""
    letter = re.match(r"[^ ,]*[_^](\{[^}]*\}|\w)*", words)
    return (Symbol(letter[0]), *text(words[letter.end() :])) if letter else text(words)


def _conditions(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield what the scene asks for besides, sentence by sentence, and what the author says of it."""
    told = [
        sentence
        for drawn in made.boards
        for chapter in drawn.project.chapters
        for sentence in TaskSheet.of(chapter).stated(made.scene, language)
    ]
    if told:
        yield paragraph(speaking(language)(BESIDES))
        yield Listed(tuple(Item("", (paragraph(one),)) for one in dict.fromkeys(told)))
    yield from map(paragraph, made.scene.author.task)


BESIDES = said("In addition:")


def scheme(drawn: Drawn, language: str) -> Picture | None:
    """Return the mechanism in one position, as its first plan that can be drawn alone."""
    place, title = worked(drawn), speaking(language)(SCHEME)
    plans = [
        (Readings.of(chapter).plan_at, plan)
        for chapter in drawn.project.chapters
        for plan in Readings.of(chapter).pointed
    ]
    if not plans:
        return None
    plan_at, plan = plans[0]
    shown = readable(drawn, lambda held: [plan_at(held, plan, place, "scheme", title, ())])
    return picture(shown[0], language)


def given_table(drawn: Drawn, language: str) -> Table | None:
    """Return the table of what is given for a board; lengths that the synthesis finds stand there."""
    hidden = sought(drawn.scene)
    rows = [row for row in given_rows(drawn.scene, drawn.board) if row.symbol not in hidden]
    words = captions(language)
    told: list[tuple[Runs, ...]] = []
    for row in rows:
        word = words.get(row.symbol)
        letter = word or row.symbol
        called: Runs = text(letter)
        if not word or "_" in word:
            called = (Symbol(markup(symbol(letter, language))),)
        value: Runs
        if isinstance(row.value, str):
            value = text(words.get(row.value, row.value))
        else:
            source = Source("given", drawn.board, row.symbol)
            value = (Number(given_figure(row.value, language), "", source, row.value),)
        told.append((called, value, text(unit(row.unit, language) or "—")))
    if not told:
        return None
    title = given_title(drawn.board, language)
    heads = text(words["letter"]), text(words["figure"]), text(words["unit"])
    return in_columns(
        Table(f"table-given-{drawn.board}", text(title), heads, tuple(told), "lcc"), language
    )


def synthesis(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the section of the synthesis, if the scene states a task."""
    found = found_for(made.scene)
    if found is None:
        return
    reading = execute(found.construction, found.given)
    yield heading(view_name(SYNTHESIS, language), 1)
    yield from protocol_blocks(
        NumberSource(SYNTHESIS, found.construction, reading, SYNTHESIS, 0, language), Manner()
    )
