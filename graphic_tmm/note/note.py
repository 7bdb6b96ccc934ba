"""A note of a scene, section by section, and its files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain

from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.note.document import Block, Document, once
from graphic_tmm.note.formats import files
from graphic_tmm.note.protocol import Known
from graphic_tmm.note.section_chapter import Noted, chapter_section, without_result
from graphic_tmm.note.section_conclusions import conclusions, literature, symbol_list
from graphic_tmm.note.section_opening import frame_fields, introduction, title_page
from graphic_tmm.note.section_scales import scales
from graphic_tmm.note.section_task import synthesis, task
from graphic_tmm.scene.chapter import Chapter, chapters
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.tasks import calls_for


def wanted(scene: Scene) -> set[str]:
    """Return what is drawn for a note: what the scene calls for, and what chapters show besides."""
    noted = (Noted.of(one).places for one in chapters() if calls_for(scene, one))
    return {*scene.called, *chain.from_iterable(noted)}


def note(made: DrawnScene, further: Iterable[Block] = ()) -> Document:
    """Return the note of a scene in its language; ``further``: sections before the conclusions."""
    language = made.scene.language
    blocks: list[Block] = [*title_page(made, language), *introduction(made, language)]
    blocks += task(made, language)
    blocks += synthesis(made, language)
    told: list[tuple[Chapter, Drawn | None]] = [
        (chapter, board) for board in made.boards for chapter in board.project.chapters
    ]
    told += [(chapter, None) for chapter in chapters() if chapter.name in made.scene.left_out]
    told.sort(key=lambda one: one[0].number)
    known: Known = set()
    early = [one for one in told if one[0].number < FIRST]
    late = told[len(early) :]
    blocks += _sections(made, early, known)
    blocks += scales(made, language)
    blocks += _sections(made, late, known)
    blocks += further
    blocks += conclusions(made, language)
    blocks += symbol_list(made, blocks, language)
    blocks += literature(made, language)
    return Document(made.scene.title, language, once(blocks), frame_fields(made, language))


def _sections(
    made: DrawnScene, told: Sequence[tuple[Chapter, Drawn | None]], known: Known
) -> Iterator[Block]:
    """Yield the sections of chapters in their order; of one without a result (no board) why there is none."""
    for chapter, board in told:
        if board is None:
            yield from without_result(made.scene, chapter)
        else:
            yield from chapter_section(board, chapter, made.scene.language, known)


FIRST = 2
"""Chapters before this one need no scale factor: these are told behind them."""


def note_files(
    made: DrawnScene, stem: str, formats: Sequence[str], further: Iterable[Block] = ()
) -> dict[str, str | bytes]:
    """Return the files of the note of a scene by name; ``further``: sections before the conclusions.

    Raises
    ------
    SheetError
        If what writes a format is not installed.
    """
    return files(note(made, further), stem, formats)
