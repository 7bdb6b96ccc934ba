"""The introduction: what the author says that the machine is for, and what is done with it."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Heading, paragraph, text

INTRODUCTION = said("Introduction")


def introduction(made: DrawnScene, language: str) -> Iterator[Block]:
    """Yield the introduction, in the author's words; nothing without any."""
    told = (*made.scene.author.machine, *made.scene.author.introduction)
    if told:
        yield Heading(1, text(speaking(language)(INTRODUCTION)), numbered=False)
        yield from map(paragraph, told)
