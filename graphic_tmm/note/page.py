"""What a chapter tells of its board in one position that is worked: its words, the formulas of its steps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.note.bricks import filled
from graphic_tmm.note.document import Block, Display, Formula, Paragraph, Run
from graphic_tmm.note.plans import at_position
from graphic_tmm.note.steps import Told, calculated

NONE: Mapping[str, Run] = {}


class Page:
    """A drawn board, told in one position (index).

    ``lettered``: letters of the drawing that sentences name, besides what each is given.
    """

    lettered: Mapping[str, Run] = NONE

    def __init__(self, drawn: Drawn, language: str, at: int) -> None:
        self.drawn, self.language, self.at = drawn, language, at
        self.speech = speaking(language)

    def says(self, told: str, put: Mapping[str, Run] = NONE, /, **named: Run) -> Paragraph:
        """Return a sentence with runs in the places of its names."""
        return Paragraph(filled(self.speech(told), {**self.lettered, **put, **named}))

    def of(self, view: str, at: int | None = None) -> Told | None:
        """Return where the numbers of a view are read in a position: in that which is worked."""
        return at_position(self.drawn, view, self.at if at is None else at, self.language)

    def worked_out(self, told: Told, *marks: Mark) -> Iterator[Block]:
        """Yield the calculations of marks as formulas on lines of their own, each once."""
        found: dict[object, Formula] = {}
        for step in map(told.log.step, marks):
            formula = calculated(told, step) if step is not None else None
            if step is not None and formula is not None:
                found.setdefault((step.op, step.uses), formula)
        if found:
            yield Display(tuple(found.values()))
