"""The frame of a sheet: margins, title block, columns in the binding margin and the 100 mm check line.

ГОСТ 2.301 and 2.104 for Russian sheets, ISO 5457 and 7200 for others, as the catalogue of the language says
(see `title_block` for the forms). Sheet coordinates: mm from the lower left corner of the paper, y upward.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import Speech, code_of, languages, speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Label, Stroke, line
from graphic_tmm.paper.formats import FORMATS, size_of
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.ruled import Box, Slot, set_text
from graphic_tmm.paper.title_block import (
    COLUMN_26,
    COLUMN_26_UPRIGHT,
    FORM_1,
    FORM_2,
    FORM_2A,
    ISO_FIRST,
    ISO_NEXT,
    MARGIN_19_23,
    MARGIN_24_25,
    Block,
    lettered,
    ruled,
)

MARGINS: Mapping[str, tuple[float, float]] = MappingProxyType(
    {"GOST": (20.0, 5.0), "ISO": (20.0, 10.0)}
)
"""By the standard: the binding margin on the left and the other three in mm (ГОСТ 2.301; ISO 5457)."""

FIELDS: tuple[str, ...] = tuple(
    dict.fromkeys(
        slot.text
        for block in (FORM_1, ISO_FIRST)
        for slot in block.entries
        if slot.text not in ("sheet", "sheets", "language")
    )
)
"""The fields of a title block that a scene may fill; the numbers of the sheets are filled here."""

NAME = "frame"
"""The name of its drawing, by which it is distinguished from views."""
CHECK_LENGTH = 100.0
"""The check line, mm: a ruler laid against it shows whether a print is true to size."""
CHECK_DOWN, CHECK_END, CHECK_TICK, CHECK_SIZE = 2.2, 20.0, 1.0, 2.5
"""The check line: how far below the upper edge, from the right of the frame; half a tick, its lettering, mm."""


def standard(language: str) -> str:
    """Return by which standards the sheets of a language are framed: ISO's, or what its catalogue says."""
    _ = speaking(language)
    return _("ISO", context="standard of the title block")


class Area(NamedTuple):
    """Where views may stand: the rectangle inside the frame less what is taken of it, mm."""

    inner: Box
    occupied: tuple[Box, ...]


def drawing_area(format: str, language: str, first: bool, *, text: bool = False) -> Area:
    """Return the rectangle inside the frame and what title block and column 26 take of it.

    ``text``: whether the sheet is one of a text, whose first has a form of its own.
    """
    inner = _inner(format, language)
    blocks = _blocks(format, language, first, text)
    taken = (
        Box(at.real, at.imag, at.real + block.width, at.imag + block.height)
        for block, at in blocks
        if at.real >= inner.left
    )
    return Area(inner, tuple(taken))


def frame(
    format: str,
    *,
    language: str,
    first: bool,
    number: int,
    count: int,
    fields: Mapping[str, str],
    check: bool = True,
    text: bool = False,
    again: bool = True,
) -> Drawing:
    """Return the frame of sheet ``number`` of ``count``, its title block filled from plain text.

    ``fields`` holds any of `FIELDS`; what a form has no place for is left out. A single sheet bears
    no number (ГОСТ 2.104). ``check``: the check line stands above it. ``text``: it is one of a text; ``again``:
    its designation stands upside down, too. What is not told of the letter is that of documents made for study.
    Raises SheetError for an unknown format, language or field.
    """
    unknown = sorted(set(fields) - set(FIELDS))
    if unknown:
        known = ", ".join(FIELDS)
        raise SheetError(
            said(
                "title block: no field {listed}; the fields are {known}",
                listed=", ".join(unknown),
                known=known,
            )
        )
    inner = _inner(format, language)
    gost, _ = standard(language) == "GOST", speaking(language)
    letter = {"letter": _("S", context="letter of a document made for study")}
    entries = {**letter, **fields, **_numbers(language, number, count)}
    if gost and "date" in fields:
        entries["date"] = _short(fields["date"])
    strokes, labels = _edges(format, inner), list[Label]()
    blocks = _blocks(format, language, first, text)
    for block, at in blocks if again else (one for one in blocks if one[0] is not COLUMN_26):
        strokes += ruled(block, at)
        labels += lettered(block, at, entries, _)
    if gost:
        labels += _foot(format, inner, _)
    if check:
        more, words = check_line(format, language)
        strokes, labels = strokes + more, [*labels, *words]
    return Drawing(NAME, _("Frame and title block"), strokes, tuple(labels))


def check_line(format: str, language: str) -> tuple[tuple[Stroke, ...], tuple[Label, ...]]:
    """Return the line of exactly 100 mm in the margin above the frame, and its words."""
    _, (width, height) = speaking(language), size_of(format)
    end = complex(width - MARGINS[standard(language)][1] - CHECK_END, height - CHECK_DOWN)
    start = end - CHECK_LENGTH
    told = f"{CHECK_LENGTH:g} {unit('mm', language)}"
    data = (("check-line", f"{CHECK_LENGTH:g}"),)
    body = line("thin", start, end)._replace(title=told, data=data)
    ticks = tuple(line("thin", z - 1j * CHECK_TICK, z + 1j * CHECK_TICK) for z in (start, end))
    texts = (
        (_("Print check"), start - 6, "end"),
        ("0", start - 1.5, "end"),
        (told, end + 1.5, "start"),
    )
    foot = -0.5j * CHECK_SIZE
    labels = tuple(Label(text, at + foot, CHECK_SIZE, side) for text, at, side in texts)
    return (body, *ticks), labels


def _inner(format: str, language: str) -> Box:
    """Return the rectangle of the frame."""
    if format not in FORMATS:
        raise SheetError(
            said(
                "no frame for the format {format!r}: choose one of {listed}",
                format=format,
                listed=", ".join(FORMATS),
            )
        )
    if code_of(language) not in languages():
        raise SheetError(
            said(
                "no frame in {language!r}: choose one of {listed}",
                language=language,
                listed=", ".join(languages()),
            )
        )
    width, height, (binding, other) = *size_of(format), MARGINS[standard(language)]
    return Box(binding, other, width - other, height - other)


def _blocks(
    format: str, language: str, first: bool, text: bool
) -> tuple[tuple[Block, complex], ...]:
    """Return the blocks of a sheet, each with the place of its lower left corner."""
    inner = _inner(format, language)
    corner = complex(inner.right, inner.bottom)
    if standard(language) == "ISO":
        block = ISO_FIRST if first else ISO_NEXT
        return ((block, corner - block.width),)
    block = FORM_2A if not first else FORM_2 if text else FORM_1
    margin = complex(inner.left - MARGIN_19_23.width, inner.bottom)
    again = (COLUMN_26, complex(inner.left, inner.top - COLUMN_26.height))
    if format.endswith("portrait"):
        upright = COLUMN_26_UPRIGHT
        again = (upright, complex(inner.right - upright.width, inner.top - upright.height))
    columns = (MARGIN_19_23, MARGIN_24_25) if first else (MARGIN_19_23,)
    return (
        (block, corner - block.width),
        again,
        # a lying A4 is not high enough for columns 24 and 25, which stand above the others
        *((one, margin) for one in columns if inner.bottom + one.height <= inner.top),
    )


def _edges(format: str, inner: Box) -> tuple[Stroke, ...]:
    """Return the edge of the paper, a thin line whose ink stays on it, and the heavy frame."""
    half = pens(format)["thin"].width / 2
    width, height = size_of(format)
    paper = Box(half, half, width - half, height - half)
    return tuple(
        line(
            pen,
            complex(box.left, box.bottom),
            complex(box.right, box.bottom),
            complex(box.right, box.top),
            complex(box.left, box.top),
            closed=True,
        )
        for pen, box in (("thin", paper), ("main", inner))
    )


def _numbers(language: str, number: int, count: int) -> dict[str, str]:
    """Return the number of the sheet and how many there are, as the forms write them."""
    if not 1 <= number <= count:
        raise SheetError(
            said("sheet {number} of {count}: number the sheets from 1", number=number, count=count)
        )
    if standard(language) == "ISO":
        return {"sheet": f"{number}/{count}", "language": code_of(language)}
    return {"sheet": str(number) if count > 1 else "", "sheets": str(count)}


def _short(date: str) -> str:
    """Return a day as the 10 mm of its column take it, 12.03.26; another text is left as it is."""
    words = re.sub(r"(\d{4})-(\d\d)-(\d\d)", r"\3.\2.\1", date.strip())
    return re.sub(r"(\d\d?\.\d\d\.)\d\d(\d\d)", r"\1\2", words)


def _foot(format: str, inner: Box, speech: Speech) -> tuple[Label, ...]:
    """Return the captions under the frame: who copied, and the format."""
    strip = Box(inner.right - 120, 0.4, inner.right - 50, inner.bottom - 0.3)
    end = strip._replace(left=inner.right - 50, right=inner.right)
    form = speech(said("Format {format}"), format=format.split()[0])
    captions = ((speech(said("Copied by")), strip), (form, end))
    return tuple(
        label
        for text, box in captions
        for label in set_text(text, Slot("", box, (2.5,), anchor="start"))
    )
