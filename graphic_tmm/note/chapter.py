"""What a chapter tells in the explanatory note."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.note.document import Block, Runs
from graphic_tmm.scene.chapter import Answer


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
