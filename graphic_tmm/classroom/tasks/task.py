"""A task: the scheme, what is given, what is drawn, with which scales, what is handed in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.classroom.tasks.breaks import Band
from graphic_tmm.classroom.tasks.paragraphs import Paragraph, blocks, boards, paragraphs
from graphic_tmm.classroom.tasks.setting import FILLING, SETTINGS, Setting
from graphic_tmm.classroom.tasks.sheet import (
    BESIDE,
    Block,
    band,
    columned,
    laid,
    sheets,
    width_of,
)
from graphic_tmm.classroom.tasks.shown import Shown, arranged, drawer, rowed
from graphic_tmm.classroom.tasks.sought import told_rows
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.section_opening import DISCIPLINE, THEME, TO, VARIANT
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.records import Scene

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


def _bands(shown: Shown, told: Sequence[Paragraph], wide: float, setting: Setting) -> list[Band]:
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
