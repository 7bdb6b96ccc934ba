"""The section of a chapter: what it tells itself, or what every chapter gets from the log."""

from __future__ import annotations

from collections.abc import Container, Iterator

from graphic_tmm.captions import captions
from graphic_tmm.chapter import Chapter
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.names import plain
from graphic_tmm.note.bricks import (
    ALSO,
    columns,
    figures_of,
    heading,
    plan,
    referred,
    results,
    worked,
)
from graphic_tmm.note.document import Block, paragraph
from graphic_tmm.note.protocol import Known


def chapter_section(drawn: Drawn, chapter: Chapter, language: str) -> Iterator[Block]:
    """Yield the section of a chapter; nothing where there is nothing to tell."""
    own = chapter.note(drawn, language)
    blocks = list(own if own is not None else from_log(drawn, chapter, language))
    if blocks:
        yield heading(title(chapter, language), 1)
        yield from map(paragraph, drawn.scene.author.remarks.get(chapter.name, ()))
        yield from blocks


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
    tables: bool = True,
) -> Iterator[Block]:
    """Yield what the log tells of a chapter: its plans with figures, its columns, its results.

    ``calculated``: the views of which only is told what is calculated or read; ``tables``: of its columns, too.
    """
    at = worked(drawn)
    shown = [
        one
        for place in chapter.places
        if place.name in drawn.scene.called and not place.together
        for one in figures_of(drawn, place, at, language)
    ]
    views = _views(drawn, chapter)
    taken: set[str] = set()
    known: Known = set()
    for view in views:
        own = [one for one in shown if view in one.drawing.shows and one.id not in taken]
        taken |= {one.id for one in own}
        bare = view in calculated
        yield from plan(drawn, view, at, language, own, known=known, bare=bare)
    left = [one for one in shown if one.id not in taken]
    if left:
        yield referred(left, language, ALSO)
        yield from left
    if tables:
        yield from columns(drawn, chapter.columns(drawn), language)
    yield from results(drawn, chapter, language)


def _views(drawn: Drawn, chapter: Chapter) -> list[str]:
    """Return the views of the log that are a chapter's, plan by plan; those of a part in the log's order."""
    there = dict.fromkeys(step.it.view for step in drawn.construction.steps)
    told = chapter.views(drawn.project)
    own = [view for plan in chapter.plans for view in told.get(plan, ())]
    if not own and len(drawn.project.chapters) == 1:
        own = list(there)
    return [view for view in dict.fromkeys(own) if view in there]
