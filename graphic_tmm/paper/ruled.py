"""Text in ruled boxes, and ruled tables: what stands between lines never touches them."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Sequence
from itertools import accumulate
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import TABLE, Drawing, Label, Stand, Stroke, line
from graphic_tmm.paper.lettering import letters

PITCH = 1.7
"""Distance of base lines in sizes of type B (ГОСТ 2.304)."""

CLEAR, ROOMY = 0.5, 0.015
"""Least way from the ink in a box to the axis of a line above and below: in a row of 5 mm, in mm,
and what it grows by for each further mm of the box's height."""

LONGEST = 1000
"""No box of a sheet holds more characters; a longer text is cut before it is measured."""

PADDING = 1.5
"""Kept free on both sides of the widest text of a table's column, mm; at least half the size."""

TITLE_GAP = 3.0
"""From the upper line of a table to the base line of its title, mm."""

ROW_CLEAR = 0.5
"""Least way from the ink in a table to the axis of a ruling, mm."""

ELLIPSIS = "…"
BLANK = ("", "-", "–", "—", "−")

NUMERAL = re.compile(r"[+\-−–]?(\d+)([.,]\d+)?")


class Box(NamedTuple):
    """A rectangle: left, bottom, right, top in mm."""

    left: float
    bottom: float
    right: float
    top: float

    def moved(self, by: complex) -> Box:
        """Return the box translated by ``by`` (complex, mm)."""
        dx, dy = by.real, by.imag
        return Box(self.left + dx, self.bottom + dy, self.right + dx, self.top + dy)


class Slot(NamedTuple):
    """A place for text: the text or the name of a field, its box, the sizes to try, the lines.

    ``sizes`` fall; ``anchor`` is "start" or "middle"; ``turn`` is 0, 90, 180 or −90 degrees; ``pad`` is
    kept free at both ends of a line, mm.
    """

    text: str
    box: Box
    sizes: tuple[float, ...] = (3.5, 2.5, 1.8)
    lines: int = 1
    anchor: str = "middle"
    turn: float = 0.0
    pad: float = 0.6


class Fit(NamedTuple):
    """How a text goes into a box: its size and its lines, plain text."""

    size: float
    lines: tuple[str, ...]


def fit(text: str, slot: Slot) -> Fit:
    """Return the largest size of the slot in which plain text goes into its box, broken at spaces.

    What does not go in at the smallest size is cut and ends with an ellipsis.
    """
    words = text[:LONGEST].split()
    width, height = _room(slot)
    for size in slot.sizes:
        lines = _wrapped(words, width, size)
        if lines is not None and len(lines) <= slot.lines and _spare(lines, size, height) >= 0:
            return Fit(size, lines)
    size = slot.sizes[-1]
    count = slot.lines
    while count > 1 and 2 * _clear(height) + size * (PITCH * (count - 1) + 1.5) > height:
        count -= 1
    return Fit(size, _cut(" ".join(words), width, size, count))


def _room(slot: Slot) -> tuple[float, float]:
    """Return the length of a line and the height that a slot's box offers, seen along the text."""
    box = slot.box
    width, height = box.right - box.left, box.top - box.bottom
    if abs(slot.turn) == 90:
        width, height = height, width
    return width - 2 * slot.pad, height


def _clear(height: float) -> float:
    """Return the least way from the ink to a line above and below in a box of a height, mm."""
    return CLEAR + ROOMY * max(height - 5, 0.0)


def _lettered(text: str, size: float) -> letters.Lettering:
    """Return plain text as lettering."""
    return letters.letter(letters.escape(text), size=size)


def _width(text: str, size: float) -> float:
    """Return the width of plain text in mm: of its ink, leaning tops and tails included."""
    ink = _lettered(text, size)
    return max(ink.right, ink.width) - min(ink.left, 0.0)


def _reach(text: str, size: float) -> tuple[float, float]:
    """Return the width of mark-up along its base line, and how far it leans over that, mm."""
    ink = letters.letter(text, size=size)
    return ink.width, max(ink.right - ink.width, 0.0)


def _wrapped(words: Sequence[str], width: float, size: float) -> tuple[str, ...] | None:
    """Return the words in lines no wider than ``width``; None where a word is wider by itself."""
    lines: list[str] = []
    for word in words:
        joined = f"{lines[-1]} {word}" if lines else word
        if lines and _width(joined, size) <= width:
            lines[-1] = joined
        elif _width(word, size) <= width:
            lines.append(word)
        else:
            return None
    return tuple(lines)


def _cut(text: str, width: float, size: float, count: int) -> tuple[str, ...]:
    """Return ``count`` lines filled with text, broken anywhere if need be, the last one cut."""
    lines: list[str] = []
    for left in range(count - 1, -1, -1):
        if _width(text, size) <= width:
            return (*lines, text)
        tail = "" if left else ELLIPSIS
        low, high = 0, len(text)
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (
                (middle, high) if _width(text[:middle] + tail, size) <= width else (low, middle)
            )
        space = text.rfind(" ", 0, low + 1)
        end = space if left and space > 0 else low
        lines.append(text[:end].rstrip() + tail)
        text = text[end:].lstrip()
    return tuple(lines)


def _spare(lines: Sequence[str], size: float, height: float) -> float:
    """Return what is left of ``height`` over plain lines; negative where they do not go in."""
    if not lines:
        return height
    down, up = _lettered(lines[-1], size).descent, _lettered(lines[0], size).ascent
    return height - 2 * _clear(height) - down - up - PITCH * size * (len(lines) - 1)


def set_text(text: str, slot: Slot) -> tuple[Label, ...]:
    """Return the labels of plain text set into a slot's box, centred by its capitals."""
    size, lines = fit(text, slot)
    if not lines:
        return ()
    width, height = _room(slot)
    written = [_lettered(text, size) for text in lines]
    rise = PITCH * size * (len(lines) - 1)
    low = max((height - rise - size) / 2, _clear(height) + written[-1].descent)
    low = min(low, height - _clear(height) - written[0].ascent - rise)
    box, turn = slot.box, cmath.rect(1, math.radians(slot.turn))
    corner = complex(
        box.left if slot.turn in (0, -90) else box.right,
        box.top if slot.turn in (180, -90) else box.bottom,
    )
    labels = []
    for k, (text, ink) in enumerate(zip(lines, written, strict=True)):
        foot = low + rise - PITCH * size * k
        along = slot.pad - min(ink.left, 0.0)
        if slot.anchor == "middle":
            along = slot.pad + (width + ink.width - ink.left - ink.right) / 2
        at = corner + complex(along, foot) * turn
        labels.append(Label(letters.escape(text), at, size, slot.anchor, slot.turn))
    return tuple(labels)


class Grid(NamedTuple):
    """A table measured: its heads and cells by columns, how they are aligned, and what room they take.

    ``places``: of each column the width of its text, the anchor and place of each cell; ``widths`` those of the
    columns; ``row``: the heights of a row and of its base line; ``head``: the height of the head, and of its
    last line below and above the base line, mm.
    """

    heads: list[list[str]]
    body: list[list[str]]
    ways: Sequence[str]
    places: list[tuple[float, tuple[tuple[str, float], ...]]]
    widths: list[float]
    row: tuple[float, float]
    head: tuple[float, float, float]


def measured(
    name: str,
    columns: Sequence[str],
    rows: Sequence[Sequence[str]],
    *,
    size: float,
    head_size: float,
    align: Sequence[str] | None,
) -> Grid:
    """Return what a table takes; see `table`.

    Raises
    ------
    SheetError
        Where a row has not one cell for each column.
    """
    if not columns or any(len(row) != len(columns) for row in rows):
        raise SheetError(
            f"table {name}: each row needs one cell for each of {len(columns)} columns"
        )
    body = [[row[k] for row in rows] for k in range(len(columns))]
    ways = align or ["number" if _numerals(cells) else "centre" for cells in body]
    heads = [column.split("\n") for column in columns]
    places = [_places(cells, way, size) for cells, way in zip(body, ways, strict=True)]
    pad = _pad(size, head_size)
    widths = [
        2 * pad + max(width, *(sum(_reach(text, head_size)) for text in lines))
        for (width, _), lines in zip(places, heads, strict=True)
    ]
    last, rise = _row([text for lines in heads for text in lines], head_size)
    crown = last + PITCH * head_size * (max(map(len, heads)) - 1)
    row = _row([cell for row in rows for cell in row], size)
    return Grid(heads, body, ways, places, widths, row, (crown, last, rise))


def _pad(size: float, head_size: float) -> float:
    """Return what is kept free on both sides of a column's text, mm."""
    return max(PADDING, size / 2, head_size / 2)


def ruled_table(
    name: str,
    title: str,
    columns: Sequence[str],
    rows: Sequence[Sequence[str]],
    *,
    size: float = 3.5,
    head_size: float | None = None,
    title_size: float = 5.0,
    align: Sequence[str] | None = None,
) -> Drawing:
    r"""Return a ruled table, its lower left corner at 0, its title above it.

    ``columns`` and ``title`` (with "\n" for several lines) and the cells of ``rows`` are mark-up.
    ``align`` gives each column "left", "centre" or "number" (a common decimal place); left out, a
    column of numerals is "number" and any other "centre". Lettering is ``size`` mm high, the head
    ``head_size``, the title ``title_size`` or as high as the cells. Raises SheetError where a row
    has not one cell for each column.
    """
    head = size if head_size is None else head_size
    grid = measured(name, columns, rows, size=size, head_size=head, align=align)
    heads, body, ways, places, widths, (step, foot), (crown, last, rise) = grid
    edges, pitch, top = [0.0, *accumulate(widths)], PITCH * head, step * len(rows)
    pad = _pad(size, head)
    labels: list[Label] = []
    for k, lines in enumerate(heads):
        low = top + rise + (crown - last - pitch * (len(lines) - 1)) / 2
        middle = edges[k] + (widths[k] - max(_reach(text, head)[1] for text in lines)) / 2
        for i, text in enumerate(reversed(lines)):
            labels.append(Label(text, complex(middle, low + pitch * i), head, "middle"))
    for k, (width, spots) in enumerate(places):
        left = edges[k] + (pad if ways[k] == "left" else (widths[k] - width) / 2)
        for i, (cell, (anchor, x)) in enumerate(zip(body[k], spots, strict=True)):
            labels.append(Label(cell, complex(left + x, top - step * (i + 1) + foot), size, anchor))
    large = max(size, title_size)
    for i, text in enumerate(reversed(title.split("\n"))):
        labels.append(Label(text, complex(0, top + crown + TITLE_GAP + PITCH * large * i), large))
    labels = [label for label in labels if label.text]
    ruling = _ruling(edges, step, top, crown)
    told = title.replace("\n", " ")
    return Drawing(name, told, ruling, tuple(labels), stand=Stand(kind="table"), role=TABLE)


def _row(cells: Sequence[str], size: float) -> tuple[float, float]:
    """Return the heights of a row and of its base line: two sizes, more for towering mark-up."""
    inks = [letters.letter(cell, size=size) for cell in cells]
    down, up = max((i.descent for i in inks), default=0), max((i.ascent for i in inks), default=0)
    foot = max(size / 2, down + ROW_CLEAR)
    return foot + max(1.5 * size, up + ROW_CLEAR), foot


def _numerals(cells: Sequence[str]) -> bool:
    """Tell whether a column holds numerals, perhaps with empty cells and dashes between."""
    found = [cell for cell in cells if cell not in BLANK]
    return bool(found) and all(NUMERAL.fullmatch(cell) for cell in found)


def _places(
    cells: Sequence[str], way: str, size: float
) -> tuple[float, tuple[tuple[str, float], ...]]:
    """Return the width of a column's text, and each cell's anchor and place from its left edge."""
    if way not in ("left", "centre", "number"):
        raise SheetError(f"align {way!r}: choose left, centre or number")
    reach = [_reach(cell, size) for cell in cells]
    matches = [NUMERAL.fullmatch(cell) if way == "number" else None for cell in cells]
    before = [
        letters.width(cell[: match.end(1)], size=size) if match else 0.0
        for cell, match in zip(cells, matches, strict=True)
    ]
    point = max(before, default=0.0)
    after = [sum(r) - b for r, b, match in zip(reach, before, matches, strict=True) if match]
    block = point + max(after, default=0.0)
    total = max([block, *map(sum, reach)])
    start = (total - block) / 2 + point
    spots: list[tuple[str, float]] = []
    lean = max((over for _, over in reach), default=0.0)
    for match, left in zip(matches, before, strict=True):
        if match:
            spots.append(("start", start - left))
        else:
            spots.append(("start", 0.0) if way == "left" else ("middle", (total - lean) / 2))
    return total, tuple(spots)


def _ruling(edges: Sequence[float], step: float, top: float, crown: float) -> tuple[Stroke, ...]:
    """Return the lines of a table: thin inside, the heavy frame, the heavy line under the head."""
    right, high = edges[-1], top + crown
    rows = round(top / step)
    thin = [line("thin", complex(x, 0), complex(x, high)) for x in edges[1:-1]]
    thin += [line("thin", complex(0, step * k), complex(right, step * k)) for k in range(1, rows)]
    frame = line("main", 0j, complex(right, 0), complex(right, high), complex(0, high), closed=True)
    head = (line("main", complex(0, top), complex(right, top)),) if rows else ()
    return (*thin, frame, *head)
