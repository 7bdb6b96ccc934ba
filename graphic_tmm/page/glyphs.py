"""The letters of a page, each kind of them once."""

from __future__ import annotations

from typing import Any

from graphic_tmm.paper.drawing import Label
from graphic_tmm.paper.lettering.letters import letter, plain, svg_path
from graphic_tmm.paper.write.svg import clean, shift


class Glyphs:
    """The letters of the page, each once: strokes from the beginning of its base line, their pens."""

    def __init__(self) -> None:
        self.made: list[list[Any]] = []
        self._known: dict[tuple[str, float, bool, float], int] = {}

    def of(self, text: str, size: float, *, inclined: bool = True, turn: float = 0.0) -> int:
        """Return the number of a letter; a new one is drawn."""
        key = (text, size, inclined, turn)
        if key not in self._known:
            self._known[key] = len(self.made)
            written = letter(text, size=size, inclined=inclined)
            strokes = [
                [pen, svg_path(written, 0.0, 0.0, angle=turn, pen=pen)] for pen in written.pens
            ]
            self.made.append([clean(plain(text)), strokes])
        return self._known[key]

    def label(self, label: Label) -> list[Any]:
        """Return a letter that stands: its number, where its base line begins, mm."""
        written = letter(label.text, size=label.size, inclined=label.inclined)
        at = label.at - shift(label, written.width)
        return [
            self.of(label.text, label.size, inclined=label.inclined, turn=label.turn),
            round(at.real, 3),
            round(at.imag, 3),
        ]
