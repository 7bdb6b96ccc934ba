r"""Lettering of a sheet: a line of text with indices, bars and underlines, as strokes of a pen.

The letters and their spacing are those of ГОСТ 2.304 type B: height h of a capital, pen h/10, gap
of 2/10 h between letters and 6/10 h between words, upright or leaning by 15°. An index is one step
down the row of sizes, with the pen of that size. The mark-up of a text, in short (markup.py
has all of it): ``v_A  v_{BA}  n_{BA}^{t}  \bar{v}  \u{..}  \uu{..}`` and ``\_ \^ \{ \} \\``.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cache, lru_cache
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.lettering.glyphs import SLANT, Stroke, characters, extremes, glyph, lean
from graphic_tmm.paper.lettering.markup import (
    INDICES,
    Node,
    Scripts,
    Text,
    escape,
    parse_markup,
    plain,
)

__all__ = [
    "SIZES",
    "Form",
    "Lettering",
    "compose",
    "escape",
    "letter",
    "missing",
    "plain",
    "svg_path",
    "width",
]

SIZES = (2.5, 3.5, 5, 7, 10, 14)
"""Heights of a capital in mm that the sheets use (ГОСТ 2.304 goes on to 20, 28, 40)."""

_STEPS = (1.8, 2.5, 3.5, 5.0, 7.0, 10.0, 14.0, 20.0, 28.0, 40.0)
"""All sizes of ГОСТ 2.304, mm."""
_INDEX = 0.7
"""Size of an index, of the letter before it: about one step of ГОСТ 2.304 down."""
# In tenths of the height of a capital: gaps before a letter and an index, base lines of indices,
# clear way to a line over or under a group, pitch of two lines under it, ends kept off by a bar.
GAP, _INDEX_GAP = 2.0, 1.5
_RAISED, _LOWERED = 6.0, -3.0
_LINE_GAP, _LINE_PITCH, _BAR_INSET = 1.2, 2.0, 0.4


class Form(NamedTuple):
    """A glyph at a size, or a drawn line: mm from the middle of the pen at its left edge, y up.

    ``span`` is the width of its path without the pen; ``box`` the least x and y, the largest x and
    y of its ink; ``path`` its first point and what follows it as the data of an SVG path.
    """

    strokes: tuple[Stroke, ...]
    pen: float
    span: float
    box: tuple[float, float, float, float]
    path: tuple[float, float, str]


class Lettering(NamedTuple):
    """A line of text as strokes of the middle of a round pen, mm.

    Attributes
    ----------
    parts : tuple of (x, y, Form)
        The letters with their places, from the start of the base line, x right, y up.
    width : float
        Advance, without a gap behind; measured along the base line (leaning letters reach further
        right at their tops, see `right`).
    pen, size : float
        Width of the pen (size/10) and height of a capital.
    ink : tuple of float
        Left, lower, right and upper edge of the ink, pen included; zeros where there is none.
    """

    parts: tuple[tuple[float, float, Form], ...]
    width: float
    pen: float
    size: float
    ink: tuple[float, float, float, float]

    @property
    def strokes(self) -> tuple[Stroke, ...]:
        """Polylines of (x, y, bulge), from the start of the base line, x right, y up.

        The bulge of a vertex is that of the way to the next one as in DXF: tan of a quarter of the
        turn, counter-clockwise positive, 0 = straight; that of a last vertex is 0.
        """
        return tuple(
            [
                tuple([(x + dx, y + dy, bulge) for dx, dy, bulge in stroke])
                for x, y, form in self.parts
                for stroke in form.strokes
            ]
        )

    @property
    def pens(self) -> tuple[float, ...]:
        """Widths of all pens used, the widest first: an index has the pen of its own size."""
        return tuple(sorted({form.pen for _, _, form in self.parts}, reverse=True))

    @property
    def ascent(self) -> float:
        """Reach of the ink above the base line, pen included."""
        return self.ink[3]

    @property
    def descent(self) -> float:
        """Reach of the ink below the base line, pen included; negative for ink wholly above it."""
        return 0.0 - self.ink[1]

    @property
    def left(self) -> float:
        """Least x of the ink, pen included."""
        return self.ink[0]

    @property
    def right(self) -> float:
        """Largest x of the ink, pen included."""
        return self.ink[2]


def missing(text: str) -> str:
    """Return the characters of a text that have no glyph, in the order of their code points."""
    return "".join(sorted(set(text) - characters() - INDICES))


@lru_cache(maxsize=4096)
def letter(text: str, *, size: float = 5.0, inclined: bool = True) -> Lettering:
    """Letter a line of text.

    Parameters
    ----------
    text : str
        Mark-up as at the head of this file; see `escape` for a literal text.
    size : float
        Height of a capital, mm.
    inclined : bool
        Leaning by 15° (75° to the base line), else upright.

    Raises
    ------
    SheetError
        A character has no glyph, the mark-up is faulty, or the size is not a positive number.
    """
    return compose(text, size=size, inclined=inclined)


def compose(text: str, *, size: float = 5.0, inclined: bool = True) -> Lettering:
    """Do what `letter` does, remembering single letters only, not the whole line."""
    if not (size > 0.0 and math.isfinite(size)):
        raise SheetError(f"the size of letters must be a positive number of mm, not {size!r}")
    size = float(size)
    setter = Setter(inclined)
    width = setter.put(parse_markup(text), 0.0, 0.0, 0.0, size)
    parts = tuple(setter.parts)
    return Lettering(parts, width, size / 10.0, size, _ink(parts))


def width(text: str, *, size: float = 5.0) -> float:
    """Return the advance of a lettered text in mm, without a gap behind it."""
    return letter(text, size=size).width


def svg_path(
    lettering: Lettering, x: float, y: float, *, angle: float = 0.0, pen: float | None = None
) -> str:
    """Return the strokes as the data of an SVG path in sheet millimetres, "" for no strokes.

    Parameters
    ----------
    lettering : Lettering
        From `letter`.
    x, y : float
        Start of the base line on the sheet, mm, y down.
    angle : float
        Direction of the base line in degrees, counter-clockwise as seen on the sheet.
    pen : float, optional
        Only the strokes of this one of the lettering's ``pens``.
    """
    if not (math.isfinite(x) and math.isfinite(y) and math.isfinite(angle)):
        raise SheetError(f"lettering cannot stand at ({x}, {y}) turned by {angle}°")
    parts = lettering.parts
    if pen is not None:
        parts = tuple(part for part in parts if part[2].pen == pen)
    words = []
    if not angle:
        for px, py, form in parts:
            dx, dy, path = form.path
            words.append(f"M{x + px + dx:.3f} {y - py - dy:.3f}{path}")
    else:
        turn = complex(math.cos(math.radians(angle)), math.sin(math.radians(angle)))
        for px, py, form in parts:
            start = complex(x, -y) + complex(px, py) * turn
            dx, dy, path = _path(tuple(_turned(stroke, turn, start) for stroke in form.strokes))
            words.append(f"M{dx:.3f} {-dy:.3f}{path}")
    return "".join(words).replace("-0.000", "0")


class Setter:
    """Sets parsed text letter by letter; knows the places of the letters put so far."""

    def __init__(self, inclined: bool) -> None:
        self.inclined = inclined
        self.slant = SLANT if inclined else 0.0
        self.parts: list[tuple[float, float, Form]] = []

    def put(self, nodes: Iterable[Node], x: float, lead: float, y: float, size: float) -> float:
        """Put nodes on the base line y, after a gap behind the ink edge x; return the new edge."""
        unit = size / 10.0
        for node in nodes:
            if isinstance(node, Text):
                x = self._text(node.text, x + lead, y, size)
            elif isinstance(node, Scripts):
                x = self._scripts(node, x, min(lead, _INDEX_GAP * unit), y, size)
            else:
                x = self._lined(node.kind, node.inside, x + lead, y, size)
            lead = GAP * unit
        return x

    def _text(self, text: str, x: float, y: float, size: float) -> float:
        forms, parts = _forms(size, self.inclined), self.parts
        pen, gap = size / 10.0, GAP * size / 10.0
        start = pen / 2.0 + self.slant * y
        for character in text:
            form = forms[character]
            if form.strokes:
                parts.append((x + start, y, form))
            x += form.span + pen + gap
        return x - gap

    def _scripts(self, node: Scripts, x: float, lead: float, y: float, size: float) -> float:
        unit, small, ends = size / 10.0, _index_size(size), [x]
        if node.lower:
            ends.append(self.put(node.lower, x, lead, y + _LOWERED * unit, small))
        if node.upper:
            ends.append(self.put(node.upper, x, lead, y + _RAISED * unit, small))
        return max(ends)

    def _lined(self, kind: str, inside: tuple[Node, ...], x: float, y: float, size: float) -> float:
        unit, first = size / 10.0, len(self.parts)
        end = self.put(inside, x, 0.0, y, size)
        _, low, _, high = _ink(self.parts[first:]) if first < len(self.parts) else (0, y, 0, y)
        if kind == "bar":
            inset = _BAR_INSET * unit
            self._line(x + inset, end - inset, high + (_LINE_GAP + 0.5) * unit, unit)
        for row in range(kind.count("u")):
            self._line(x, end, low - (_LINE_GAP + 0.5 + _LINE_PITCH * row) * unit, unit)
        return end

    def _line(self, x: float, end: float, y: float, pen: float) -> None:
        length = end - x - pen
        if length > 0.0:
            strokes: tuple[Stroke, ...] = (((0.0, 0.0, 0.0), (length, 0.0, 0.0)),)
            self.parts.append((x + pen / 2.0 + self.slant * y, y, _form(strokes, pen, length)))


class _Forms(dict[str, Form]):
    """The glyphs used so far at one size."""

    def __init__(self, size: float, inclined: bool) -> None:
        super().__init__()
        self.pen = size / 10.0
        self.inclined = inclined

    def __missing__(self, character: str) -> Form:
        """Draw a glyph at its first use."""
        try:
            clear, strokes = glyph(character)
        except KeyError:
            name = f"{character!r} (U+{ord(character):04X})"
            raise SheetError(f"the lettering has no glyph for the character {name}") from None
        if self.inclined:
            strokes = lean(strokes)
        unit = self.pen
        scaled = tuple(
            tuple((unit * (x - 0.5), unit * y, bulge) for x, y, bulge in stroke)
            for stroke in strokes
        )
        self[character] = _form(scaled, unit, unit * (clear - 1.0))
        return self[character]


@lru_cache(maxsize=64)
def _forms(size: float, inclined: bool) -> _Forms:
    return _Forms(size, inclined)


def _form(strokes: tuple[Stroke, ...], pen: float, span: float) -> Form:
    x0, y0, x1, y1 = extremes(strokes)
    half = pen / 2.0
    box = (x0 - half, y0 - half, x1 + half, y1 + half)
    path = _path(strokes) if strokes else (0.0, 0.0, "")
    return Form(strokes, pen, span, box, path)


@cache
def _index_size(size: float) -> float:
    """One step down the row of sizes, 1.8 at the least; 0.7 of a size that is not of the row."""
    if size in _STEPS:
        return _STEPS[max(_STEPS.index(size) - 1, 0)]
    return _INDEX * size


def _ink(parts: Iterable[tuple[float, float, Form]]) -> tuple[float, float, float, float]:
    """Left, lower, right and upper edge of the ink; zeros where there is none."""
    boxes = [(x, y, form.box) for x, y, form in parts]
    if not boxes:
        return (0.0, 0.0, 0.0, 0.0)
    return (
        min([x + box[0] for x, _, box in boxes]),
        min([y + box[1] for _, y, box in boxes]),
        max([x + box[2] for x, _, box in boxes]),
        max([y + box[3] for _, y, box in boxes]),
    )


def _turned(stroke: Stroke, turn: complex, start: complex) -> Stroke:
    points = [(complex(x, y) * turn + start, bulge) for x, y, bulge in stroke]
    return tuple((point.real, point.imag, bulge) for point, bulge in points)


def _number(value: float) -> str:
    """Write a number with at most three decimals and no -0."""
    text = repr(round(value, 3) + 0.0)
    return text[:-2] if text.endswith(".0") else text


def _pair(letter: str, dx: float, dy: float) -> str:
    """Write a relative step as short as SVG allows: l.5-.25 for (0.5, -0.25)."""
    x, y = (
        _number(value).replace("0.", ".", 1) if abs(value) < 1.0 else _number(value)
        for value in (dx, dy)
    )
    return f"{letter}{x}{y}" if y.startswith("-") else f"{letter}{x} {y}"


def _path(strokes: tuple[Stroke, ...]) -> tuple[float, float, str]:
    """First point (y up), then relative steps between points rounded to 0.01 mm (y down)."""
    x0, y0, _ = strokes[0][0]
    words: list[str] = []
    at = (0.0, 0.0)
    for stroke in strokes:
        places = [(round(x - x0, 2), round(y0 - y, 2)) for x, y, _ in stroke]
        if words:
            words.append(_pair("m", places[0][0] - at[0], places[0][1] - at[1]))
        for i in range(1, len(places)):
            (x, y), (nx, ny) = places[i - 1], places[i]
            words.append(_step(nx - x, ny - y, stroke[i - 1][2]))
        at = places[-1]
    return x0, y0, "".join(words)


def _step(dx: float, dy: float, bulge: float) -> str:
    if bulge:
        radius = round(math.hypot(dx, dy) * (1.0 + bulge * bulge) / abs(4.0 * bulge), 2)
        if abs(bulge) > 0.99:
            # A half circle: SVG widens a radius that is too small to just half the chord.
            radius = max(math.floor(50.0 * math.hypot(dx, dy)) / 100.0, 0.01)
        flags = f" 0 {int(abs(bulge) > 1.0)} {int(bulge < 0.0)}"
        return _pair("a", radius, radius) + _pair(flags + " ", dx, dy)
    if abs(dy) < 5e-3:
        return f"h{_number(dx)}"
    if abs(dx) < 5e-3:
        return f"v{_number(dy)}"
    return _pair("l", dx, dy)
