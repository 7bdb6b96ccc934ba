"""The conclusions: what follows from the results, chapter by chapter, and what could not be drawn."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Heading, Item, Listed, Paragraph, Runs, text
from graphic_tmm.readers.warnings import warnings

CONCLUSIONS = said("Conclusions")


def conclusions(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield what follows from the results; nothing where nothing does."""
    found: list[Runs] = []
    for drawn in made.boards:
        for chapter in drawn.project.chapters:
            found += chapter.concludes(drawn, language)
    for drawn in made.boards:
        found += [text(_sentence(told)) for told in warnings(drawn, language)]
    if found:
        yield Heading(1, text(speaking(language)(CONCLUSIONS)), numbered=False)
        yield Listed(tuple(Item("", (Paragraph(one),)) for one in found))


def _sentence(told: str) -> str:
    return f"{told[:1].upper()}{told[1:].rstrip('.')}."
