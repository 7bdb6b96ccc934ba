"""The section of a chapter in a note: what the chapter tells itself, or what every one gets from the log."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.symbols import plain
from graphic_tmm.note.bricks import columns, figures_of, heading, paired, results, worked
from graphic_tmm.note.document import Block, Runs, paragraph
from graphic_tmm.note.plans import section, shown_and_listed
from graphic_tmm.note.protocol import Known
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import Named, captions
from graphic_tmm.scene.chapter import Answer, Chapter, chapters
from graphic_tmm.scene.records import Scene


@dataclass(frozen=True)
class Noted(Answer):
    """What a chapter tells in the note.

    ``section``: a drawn board, a language -> its section; None: what the log tells of it; ``places``: those
    that it shows of, whatever sheets ask for. ``concludes``: what follows from its results, a sentence each.
    """

    stands: ClassVar[str] = "note.NOTE"
    section: Callable[[Drawn, str], Iterable[Block] | None] = lambda drawn, language: None
    places: tuple[str, ...] = ()
    concludes: Callable[[Drawn, str], Iterable[Runs]] = lambda drawn, language: ()


def chapter_section(drawn: Drawn, chapter: Chapter, language: str, known: Known) -> Iterator[Block]:
    """Yield the section of a chapter; nothing where there is nothing to tell.

    ``known``: what chapters before it have told.
    """
    own = Noted.of(chapter).section(drawn, language)
    told = own if own is not None else from_log(drawn, chapter, language, known=known)
    blocks = list(paired(told))
    if blocks:
        yield heading(title(chapter, language), 1)
        yield from map(paragraph, drawn.scene.author.remarks.get(chapter.name, ()))
        yield from blocks


def without_result(scene: Scene, language: str) -> Iterator[Block]:
    """Yield the sections of chapters that are left out, for they have no result: a sentence that says so."""
    for chapter in chapters():
        if chapter.name in scene.left_out:
            yield heading(title(chapter, language), 1)
            yield paragraph(f"{speaking(language)(scene.left_out[chapter.name])}.")


def title(chapter: Chapter, language: str) -> str:
    """Return what the section of a chapter is called."""
    words = captions(language)
    return plain(words.get(f"chapter {chapter.name}", words.get(chapter.name, chapter.name)))


def from_log(
    drawn: Drawn,
    chapter: Chapter,
    language: str,
    calculated: Container[str] = (),
    *,
    known: Known | None = None,
    tables: bool = True,
) -> Iterator[Block]:
    """Yield what the log tells of a chapter: its figures, its plans as a table, its columns, its results.

    ``calculated``: the views of which only is told what is calculated or read; of others drawing is told where
    it has a reason that is new. ``known``: what was told before. ``tables``: of its columns and results, too.
    """
    at = worked(drawn)
    shown = [
        one
        for place in chapter.places
        if place.name in drawn.scene.called and not place.together
        for one in figures_of(drawn, place, at, language)
    ]
    known = set() if known is None else known
    found = [
        section(drawn, view, at, language, known, bare=view in calculated, brief=True)
        for view in _views(drawn, chapter)
    ]
    sections = [one for one in found if one is not None]
    name = f"{drawn.board}-{chapter.name}"
    yield from shown_and_listed(sections, name, title(chapter, language), language, shown)
    if tables:
        yield from columns(drawn, Tabled.of(chapter).columns(drawn), language)
        yield from results(drawn, chapter, language)


def _views(drawn: Drawn, chapter: Chapter) -> list[str]:
    """Return the views of the log that are a chapter's, plan by plan; those of a part in the log's order."""
    there = dict.fromkeys(step.it.view for step in drawn.construction.steps)
    told = Protocols.of(chapter).views(drawn.project)
    own = [view for plan in Named.of(chapter).plans for view in told.get(plan, ())]
    if not own and len(drawn.project.chapters) == 1:
        own = list(there)
    return [view for view in dict.fromkeys(own) if view in there]
