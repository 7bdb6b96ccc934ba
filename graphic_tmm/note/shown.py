"""The figures of a note ready to be shown: each on a paper of its size, with the letter of a part."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.note.document import Beside, Document, Picture
from graphic_tmm.note.figures import scales_of, sheet_of
from graphic_tmm.note.numbering import letter_of
from graphic_tmm.paper.drawing import Sheet


class Drawn(NamedTuple):
    """A figure ready to be shown: its file's name, its paper, how wide it stands on the page, mm."""

    name: str
    sheet: Sheet
    width: float
    alt: str

    @property
    def height(self) -> float:
        """How high it stands on the page, mm."""
        return self.width * self.sheet.height / self.sheet.width


def drawn_figures(document: Document) -> dict[str, Drawn]:
    """Return the figures of a note by id, each on a paper of its size."""
    found: dict[str, Drawn] = {}
    for block in document.blocks:
        if isinstance(block, Picture | Beside):
            _draw(block, document.language, found)
    return found


def _draw(block: Picture | Beside, language: str, found: dict[str, Drawn]) -> None:
    """Enter a figure, or the parts of one, each with its letter."""
    parts = (block,) if isinstance(block, Picture) else block.parts
    times = scales_of(parts)
    for k, (one, larger) in enumerate(zip(parts, times, strict=True)):
        letter = f"{letter_of(k, language)})" if len(parts) > 1 else ""
        sheet = sheet_of(one.drawing, language, f"figure-{len(found) + 1}", letter, larger)
        found[one.id] = Drawn(sheet.name, sheet, round(sheet.width * larger, 1), one.alt)
