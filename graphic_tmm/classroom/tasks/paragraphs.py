"""The sentences of a task as blocks of lettering: below their headings, or beginning on their lines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.classroom.tasks import told
from graphic_tmm.classroom.tasks.setting import Setting
from graphic_tmm.classroom.tasks.sheet import NARROWER, Block, even, rag
from graphic_tmm.handout.sheets import advance, set_rows
from graphic_tmm.handout.words import Row, broken
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Label
from graphic_tmm.paper.lettering.letters import letter, plain
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
        (HELD, [told.Told("", tuple(told.conditions(scene)))]),
        (DRAWN, [*told.numbered([*told.synthesis(scene), *told.orders(scene)])]),
        (FACTORS, [told.Told("", tuple(told.scales(scene, doc)))] if drawn else []),
        (HAND_IN, [told.Told("", tuple(told.handed(scene, readings=readings, drawn=drawn)))]),
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
    head = Row(one.part, setting.heading)
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


def _begun(text: str, size: float, wide: float, whole: float) -> tuple[str, list[Row]]:
    """Return the line that begins a sentence, ``wide`` mm, and the lines below it; the last is no rag."""
    found = list[tuple[str, list[Row]]]()
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
