"""Lettering as TEXT of a CAD program: a style by ГОСТ 2.304, each run as long as our own letters are.

A run of letters is one TEXT, fitted between the two points between which it stands here (alignment FIT), so
that it keeps its place and its length in whatever font a program has; a single letter is not stretched, it
stands in the middle of its place. An index is a TEXT of its own size. What belongs to one label is a group.
What such fonts do not hold for certain, and bars, are drawn.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable
from functools import lru_cache
from itertools import groupby
from typing import Any, NamedTuple

from graphic_tmm.paper.drawing import Label
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.lettering.letters import GAP, Form, Setter, escape, width
from graphic_tmm.paper.lettering.markup import parse_markup
from graphic_tmm.paper.write.dxf_ink import spot, vertices, weight
from graphic_tmm.paper.write.svg import shift


class TextRun(NamedTuple):
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

    runs: tuple[TextRun, ...]
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
        self.runs: list[TextRun] = []
        self.drawn: list[tuple[float, float, Form]] = []

    def _text(self, text: str, x: float, y: float, size: float) -> float:
        gap = GAP * size / 10.0
        end = x - gap
        for writable, some in groupby(text, self.writable):
            piece, first = "".join(some), len(self.parts)
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
        self.runs.append(TextRun(text, begin, y, width(escape(text), size=size) + gap, size))

    def _line(self, x: float, end: float, y: float, pen: float) -> None:
        first = len(self.parts)
        super()._line(x, end, y, pen)
        self.drawn += self.parts[first:]


FONT = "isocpeur.ttf"
"""Drawn after ISO 3098, nearest to ГОСТ 2.304 among the fonts that come with the CAD programs themselves."""
FAMILY = "ISOCPEUR"
"""What the font calls itself, by which Windows finds it."""
OBLIQUE = 15.0
"""Lean of the letters, degrees from upright (ГОСТ 2.304: about 75° to the base line)."""
STYLES = {True: "GOST_2.304_INCLINED", False: "GOST_2.304_UPRIGHT"}
"""Names of the text styles: inclined or not."""
SIGNS = "−∂∆∑√∞∫≈≠≡≤≥←↑→↓′″"
"""Signs other than letters in Windows fonts for Europe (list WGL4)."""
CODES = ("cp1251", "cp1252", "cp1253")
"""Cyrillic, Latin and Greek code pages of Windows, whose characters such fonts hold too."""
MARKS = "^\\"
"""Characters that a TEXT takes for marks of its own: they are drawn."""


def add_styles(document: Any) -> None:
    """Define the two text styles, the inclined one current; their height is free: each TEXT has its own."""
    for inclined, name in STYLES.items():
        style = document.styles.add(name, font=FONT)
        style.dxf.oblique = OBLIQUE if inclined else 0.0
        style.set_extended_font_data(FAMILY)
    document.header["$TEXTSTYLE"] = STYLES[True]


def writable(character: str) -> bool:
    """Tell whether a CAD program's font holds a character for certain."""
    if character in MARKS:
        return False
    return character in SIGNS or any(_held(character, code) for code in CODES)


class Letterer:
    """Writes labels into one space of a document; ``stroked``: their letters as strokes."""

    def __init__(self, document: Any, space: Any, *, stroked: bool = False) -> None:
        self.document, self.space, self.stroked = document, space, stroked

    def label(self, label: Label, layer: str) -> None:
        """Write a label on a layer."""
        turn = cmath.rect(1.0, math.radians(label.turn))
        if self.stroked:
            whole = letters.letter(label.text, size=label.size, inclined=label.inclined)
            start = label.at - shift(label, whole.width)
            list(self.drawn(whole.parts, start, turn, layer))
            return
        found = set_in_runs(label.text, size=label.size, inclined=label.inclined, writable=writable)
        start = label.at - shift(label, found.width)
        made = [self.run(run, label, start, turn, layer) for run in found.runs]
        made += self.drawn(found.drawn, start, turn, layer)
        if len(made) > 1:
            group = self.document.groups.new(description=letters.plain(label.text)[:255])
            group.extend(made)

    def run(self, run: TextRun, label: Label, start: complex, turn: complex, layer: str) -> Any:
        """Write a run of letters; return its TEXT."""
        from ezdxf.enums import TextEntityAlignment

        begin = start + complex(run.x, run.y) * turn
        text = self.space.add_text(
            run.text.replace("%%", "%%%%%%"),  # "%%" begins a mark, "%%%" is the sign
            height=run.size,
            rotation=label.turn,
            dxfattribs={
                "layer": layer,
                "style": STYLES[label.inclined],
                "oblique": OBLIQUE if label.inclined else 0.0,
            },
        )
        if len(run.text) == 1:
            middle = spot(begin + run.width / 2 * turn)
            text.set_placement(middle, align=TextEntityAlignment.CENTER)
            text.dxf.insert = spot(begin)
            return text
        ends = (spot(begin), spot(begin + run.width * turn))
        return text.set_placement(*ends, align=TextEntityAlignment.FIT)

    def drawn(
        self,
        parts: Iterable[tuple[float, float, Form]],
        start: complex,
        turn: complex,
        layer: str,
    ) -> Iterable[Any]:
        """Write letters and bars as strokes; yield the polylines."""
        for x, y, form in parts:
            style = {"layer": layer, "lineweight": weight(form.pen)}
            for stroke in form.strokes:
                places = [(start + complex(x + dx, y + dy) * turn, b) for dx, dy, b in stroke]
                path = tuple((z.real, z.imag, bulge) for z, bulge in places)
                yield self.space.add_lwpolyline(vertices(path), format="xyb", dxfattribs=style)


def _held(character: str, code: str) -> bool:
    try:
        character.encode(code)
    except UnicodeEncodeError:
        return False
    return True
