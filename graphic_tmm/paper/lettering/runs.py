"""A line of lettering as runs of text: for a program that letters by itself, to set it as ours stands."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from itertools import groupby
from typing import NamedTuple

from graphic_tmm.paper.lettering.letters import GAP, Form, Setter, escape, width
from graphic_tmm.paper.lettering.markup import parse_markup


class Run(NamedTuple):
    """Letters of one size on one base line, mm from the start of the whole line, x right, y up.

    ``x``: where its first letter begins on its base line; ``width``: from there to where its last letter ends.
    Each letter has half of the gap to the next one on either side, as the letters of a font have.
    """

    text: str
    x: float
    y: float
    width: float
    size: float


class Runs(NamedTuple):
    """A line of lettering: the runs that can be written as text, and the letters and lines that are drawn."""

    runs: tuple[Run, ...]
    drawn: tuple[tuple[float, float, Form], ...]
    width: float


@lru_cache(maxsize=4096)
def set_in_runs(text: str, *, size: float, inclined: bool, writable: Callable[[str], bool]) -> Runs:
    """Return a marked-up line as `letters.letter` sets it, in runs of the letters that are ``writable``.

    Raises SheetError as `letters.letter` does.
    """
    setter = _RunSetter(inclined, writable)
    end = setter.put(parse_markup(text), 0.0, 0.0, 0.0, float(size))
    return Runs(tuple(setter.runs), tuple(setter.drawn), end)


class _RunSetter(Setter):
    """Sets letters as every setter does, and notes what belongs together."""

    def __init__(self, inclined: bool, writable: Callable[[str], bool]) -> None:
        super().__init__(inclined)
        self.writable = writable
        self.runs: list[Run] = []
        self.drawn: list[tuple[float, float, Form]] = []

    def _text(self, text: str, x: float, y: float, size: float) -> float:
        gap = GAP * size / 10.0
        end = x - gap
        for writable, letters in groupby(text, self.writable):
            piece, first = "".join(letters), len(self.parts)
            x = end + gap
            end = super()._text(piece, x, y, size)
            if writable:
                self._run(piece, x, y, size)
            else:
                self.drawn += self.parts[first:]
        return end

    def _run(self, piece: str, x: float, y: float, size: float) -> None:
        """Note a run without the spaces about it."""
        text = piece.strip()
        if not text:
            return
        gap = GAP * size / 10.0
        if ahead := len(piece) - len(piece.lstrip()):
            x += width(" " * ahead, size=size) + gap
        begin = x - gap / 2 + self.slant * y
        self.runs.append(Run(text, begin, y, width(escape(text), size=size) + gap, size))

    def _line(self, x: float, end: float, y: float, pen: float) -> None:
        first = len(self.parts)
        super()._line(x, end, y, pen)
        self.drawn += self.parts[first:]
