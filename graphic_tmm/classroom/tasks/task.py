"""A task: the scheme, what is given, what is drawn, what is handed in; its sentences as blocks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.classroom.tasks import sentences
from graphic_tmm.classroom.tasks.given import GivenViews, arranged, drawer, rowed, told_rows
from graphic_tmm.classroom.tasks.sheet import (
    BESIDE,
    FILLING,
    NARROWER,
    SETTINGS,
    Band,
    Block,
    Setting,
    band,
    columned,
    even,
    laid,
    rag,
    sheets,
    width_of,
)
from graphic_tmm.handout.sheets import advance, set_rows
from graphic_tmm.handout.words import LetteringRow, broken
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.section_opening import DISCIPLINE, THEME, TO, VARIANT
from graphic_tmm.paper.drawing import Drawing, Label, Sheet
from graphic_tmm.paper.lettering.letters import escape, letter, plain
from graphic_tmm.project import own_boards
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.records import Scene

DRAWN, HELD = said("To be drawn"), said("To be taken into account")
FACTORS, HAND_IN = said("Scale factors", context="task"), said("To be handed in")
INDENT = 4.0
"""Sentences stand so far in from their heading, mm."""
BEHIND = 1.2
"""Between a heading and the sentence that begins on its line, of the heading's height."""


class Paragraph(NamedTuple):
    """A sentence (mark-up, "" for none) under headings that it begins: of a part of the task, of a sheet."""

    name: str
    part: str
    sheet: str
    told: str


def boards(scene: Scene) -> tuple[str, ...]:
    """Return the boards on which a scene calls for something to be drawn."""
    own = (MECHANISM,) if scene.mechanism is not None else ()
    return (*own, *own_boards(scene))


def paragraphs(scene: Scene, doc: Document, *, readings: bool) -> list[Paragraph]:
    """Return the sentences of a task; ``readings``: a table of these is handed in, too."""
    _, drawn = speaking(scene.language), bool(boards(scene))
    parts = (
        (HELD, [sentences.Paragraphs("", tuple(sentences.conditions(scene)))]),
        (DRAWN, [*sentences.numbered([*sentences.synthesis(scene), *sentences.orders(scene)])]),
        (FACTORS, [sentences.Paragraphs("", tuple(sentences.scales(scene, doc)))] if drawn else []),
        (
            HAND_IN,
            [
                sentences.Paragraphs(
                    "", tuple(sentences.handed(scene, readings=readings, drawn=drawn))
                )
            ],
        ),
    )
    found = list[Paragraph]()
    for k, (part, some) in enumerate(parts):
        heading = _(part)
        for one in some:
            sheet = one.heading
            for sentence in one.sentences:
                found.append(Paragraph(f"task {k} {len(found)}", heading, sheet, sentence))
                heading = sheet = ""
    return found


def blocks(some: Sequence[Paragraph], wide: float, setting: Setting) -> Iterator[Block]:
    """Yield sentences as blocks so wide, mm; a heading stands with the first of them."""
    for one in some:
        yield _run_in(one, wide, setting) if setting.run_in else _below(one, wide, setting)


def _above(one: Paragraph, setting: Setting) -> float:
    if one.part:
        return setting.between
    return (2.0 if one.sheet else 1.0) * setting.least


def _below(one: Paragraph, wide: float, setting: Setting) -> Block:
    """Return a sentence below its headings."""
    labels, down = list[Label](), 0.0
    lines = (
        (one.part, setting.heading, 0.0),
        (one.sheet, setting.text, 0.0),
        (one.told, setting.text, INDENT),
    )
    for text, size, indent in lines:
        if not text:
            continue
        down += setting.least if labels else 0.0
        rows = even(text, size, wide - indent)
        labels += set_rows(rows, complex(indent, -down))
        down += sum(map(advance, rows))
    return _block(one, labels, down, setting)


def _run_in(one: Paragraph, wide: float, setting: Setting) -> Block:
    """Return a sentence that begins on the line of its heading."""
    if not one.part:
        return _below(one, wide, setting)
    first, rest = (one.sheet, one.told) if one.sheet else (one.told, "")
    head = LetteringRow(one.part, setting.heading)
    begin = letter(head.text, size=head.size).right + BEHIND * head.size
    line, again = _begun(first, setting.text, wide - begin, wide - INDENT)
    if letter(line, size=setting.text).right > wide - begin:
        return _below(one, wide, setting)
    labels = [*set_rows([head], 0j)]
    labels.append(Label(line, complex(begin, labels[0].at.imag), setting.text))
    down = advance(head)
    for n, more in enumerate((again, even(rest, setting.text, wide - INDENT))):
        down += setting.least if n and more else 0.0
        labels += set_rows(more, complex(INDENT, -down))
        down += sum(map(advance, more))
    return _block(one, labels, down, setting)


def _begun(text: str, size: float, wide: float, whole: float) -> tuple[str, list[LetteringRow]]:
    """Return the line that begins a sentence, ``wide`` mm, and the lines below it; the last is no rag."""
    found = list[tuple[str, list[LetteringRow]]]()
    for share in (1.0, *NARROWER):
        first, *others = broken(text, size, share * wide)
        rest = even(" ".join(row.text for row in others), size, whole)
        found.append((first.text, rest))
        if not rest or not rag(rest[-1]):
            return found[-1]
    return found[0]


def _block(one: Paragraph, labels: Sequence[Label], high: float, setting: Setting) -> Block:
    drawing = Drawing(one.name, plain(one.told), (), tuple(labels))
    return Block(drawing, 0.0, high, _above(one, setting), heads=bool(one.part or one.sheet))


TASK = said("Task", context="sheet")
COLUMN = 58.0
"""Sentences stand below the scheme, or below the table beside it, in a column no narrower than this, mm."""


def task_sheets(scene: Scene, text_of: str, doc: Document, *, readings: bool) -> list[Sheet]:
    """Return the sheets of a task, A4: one of them, if what there is can be set so close that it holds it.

    ``text_of``, ``doc``: the scene's text and what it says; ``readings``: a table of these is handed in, too.

    Raises
    ------
    StructureError
        If its mechanism cannot be drawn.
    """
    called, head = speaking(scene.language)(TASK), list(_head(scene))
    told = paragraphs(scene, doc, readings=readings)
    rows = {board: told_rows(scene, text_of, board) for board in boards(scene)}
    draw, least = drawer(scene, text_of), list[Sheet]()

    def ways(setting: Setting) -> list[list[Band]]:
        """Return how all of it may stand, as bands."""
        wide = width_of(scene.language)
        return [_bands(one, told, wide, setting) for one in arranged(scene, rows, draw, setting)]

    for setting in SETTINGS:
        bands = min(ways(setting), key=lambda some: sum(one.height + one.above for one in some))
        made = sheets(called, head, bands, scene, "task", setting)
        if not least or len(made) < len(least):
            least = made
        if len(least) == 1:
            return least
    tried = ((bands, setting) for setting in FILLING for bands in ways(setting))
    found = [
        (laid(head, bands, scene, setting.between), bands, setting) for bands, setting in tried
    ]
    good = [one for one in found if len(one[0].sheets) == len(least)]
    if not good:
        return least
    _, bands, setting = min(good, key=lambda one: one[0].bad)
    return sheets(called, head, bands, scene, "task", setting)


def _bands(
    shown: GivenViews, told: Sequence[Paragraph], wide: float, setting: Setting
) -> list[Band]:
    """Return what a task shows and tells, in bands one below the other."""
    found, tables, rest = list[Band](), list(shown.below), list(told)
    if len(shown.beside) > 1 and setting.under:
        found.append(_filled(shown.beside, tables, rest, wide, setting))
    elif shown.beside:
        found.append(band(*shown.beside, wide=wide))
    found += [band(*row, wide=wide) for row in rowed(tables, wide)]
    return [*found, *(band(one, wide=wide) for one in blocks(rest, wide, setting))]


def _filled(
    beside: Sequence[Block],
    tables: list[Block],
    told: list[Paragraph],
    wide: float,
    setting: Setting,
) -> Band:
    """Return two blocks, below the lower one further tables and sentences, as many as there is room for.

    These are taken from ``tables`` and ``told``; of the sentences only if no table is left.
    """
    low = min((0, 1), key=lambda k: beside[k].height)
    other = beside[1 - low]
    room = wide - BESIDE - other.width
    down, under = beside[low].height, [beside[low]]

    def put(one: Block) -> bool:
        nonlocal down
        fits = one.width <= room and down + one.above + one.height <= other.height
        if fits:
            down += one.above + one.height
            under.append(one)
        return fits

    while tables and put(tables[0]):
        del tables[0]
    if not tables and room >= COLUMN:
        held = 0
        for one in blocks(told, room, setting):
            if not put(one):
                break
            held += 1
        del told[:held]
    if len(under) == 1:
        return band(*beside, wide=wide)
    columns = [(under, room), ((other,), other.width)]
    return columned(columns if low == 0 else columns[::-1])


def _head(scene: Scene) -> Iterator[str]:
    """Yield the lines at the head: what it is, of what discipline, on what theme, the title."""
    _, author = speaking(scene.language), scene.author
    what = _(TASK)
    if author.kind_of_work:
        what = f"{what} {_(TO[author.kind_of_work])}"
    yield escape(what)
    if author.discipline:
        yield escape(_(DISCIPLINE, discipline=author.discipline))
    if author.theme:
        yield escape(f"{_(THEME)}: {author.theme}")
    if author.variant and (variant := _(VARIANT, variant=author.variant)) not in scene.title:
        yield escape(variant)
    yield escape(scene.title)
