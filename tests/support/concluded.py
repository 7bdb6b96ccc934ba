"""What a note concludes of a part that is drawn, as plain text."""

from __future__ import annotations

from graphic_tmm.drawn import Drawn
from graphic_tmm.note.document import Number, Text
from graphic_tmm.note.section_chapter import page_of


def concluded(drawn: Drawn, language: str = "en") -> list[str]:
    """Return the conclusions of the only chapter of a board, a sentence each; letters are left out."""
    (chapter,) = drawn.project.chapters
    return [
        "".join(one.text for one in told if isinstance(one, (Text, Number)))
        for told in page_of(drawn, chapter, language).concludes()
    ]
