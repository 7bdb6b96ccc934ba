"""The section of a chapter in a note: what its page tells, below its title and the author's remarks."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.note.bricks import heading, paired
from graphic_tmm.note.document import Block, paragraph
from graphic_tmm.note.page import Page, title
from graphic_tmm.note.protocol import Known
from graphic_tmm.scene.chapter import Answer, Chapter
from graphic_tmm.scene.records import Scene


@dataclass(frozen=True)
class Noted(Answer):
    """What a chapter tells in the note.

    ``page``: its section and what follows from its results; else what the log tells of it. ``places``: those
    that it shows of, whatever sheets ask for.
    """

    stands: ClassVar[str] = "note.NOTE"
    page: type[Page[Any]] = Page
    places: tuple[str, ...] = ()


def page_of(drawn: Drawn, chapter: Chapter, language: str, known: Known | None = None) -> Page[Any]:
    """Return what a chapter tells of a drawn board; ``known``: what others have told from the log."""
    kind = Noted.of(chapter).page
    own = known is None or kind.blocks is not Page.blocks
    return kind(drawn, chapter, language, set() if own or known is None else known)


def chapter_section(drawn: Drawn, chapter: Chapter, language: str, known: Known) -> Iterator[Block]:
    """Yield the section of a chapter; nothing where there is nothing to tell.

    ``known``: what chapters before it have told.
    """
    blocks = list(paired(page_of(drawn, chapter, language, known).blocks()))
    if blocks:
        yield heading(title(chapter, language), 1)
        yield from map(paragraph, drawn.scene.author.remarks.get(chapter.name, ()))
        yield from blocks


def without_result(scene: Scene, chapter: Chapter) -> Iterator[Block]:
    """Yield the section of a chapter that is left out, for it has no result: a sentence that says so."""
    yield heading(title(chapter, scene.language), 1)
    yield paragraph(f"{speaking(scene.language)(scene.left_out[chapter.name])}.")
