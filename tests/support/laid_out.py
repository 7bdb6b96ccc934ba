"""The lines on the pages of a note from top to bottom, as another's reader finds them in the PDF."""

from __future__ import annotations

import io
import math
import re
from collections import Counter
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pdfplumber

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.note.document import Document
from graphic_tmm.note.formats import files
from graphic_tmm.note.note import note, wanted
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

NOTES = Path(__file__).parents[1] / "cases" / "notes"
POINT = 72 / 25.4
"""Points a millimetre has."""
FOOT = 280.0
"""Below this, mm from the top, stands the number of the page."""


class PageLine(NamedTuple):
    """A line of a page: its words, its place (mm from the top), the size of most of its letters (pt)."""

    words: str
    top: float
    size: float


@cache
def drawn_case(name: str) -> DrawnScene:
    """A case, drawn for its note in its usual size."""
    task = read(NOTES / f"{name}.toml")
    return make(task, wanted=wanted(task), given=Composition(usual(formatted(task)), ()))


@cache
def note_of_case(name: str) -> Document:
    """The note of a case."""
    return note(drawn_case(name))


@cache
def case_file(name: str, form: str) -> bytes:
    """A file of the note of a case."""
    return bytes_of(note_of_case(name), form)


def bytes_of(document: Document, form: str) -> bytes:
    """A file of a note."""
    found = files(document, "note", (form,))[f"note.{form}"]
    return found.encode("utf-8") if isinstance(found, str) else found


@cache
def pages_of(name: str) -> tuple[tuple[PageLine, ...], ...]:
    """The lines of each page of the PDF of a case, without the number below."""
    with pdfplumber.open(io.BytesIO(case_file(name, "pdf"))) as pdf:
        return tuple(_lines(page) for page in pdf.pages)


def _lines(page: pdfplumber.page.Page) -> tuple[PageLine, ...]:
    found = []
    for line in page.extract_text_lines(return_chars=True):
        if line["top"] / POINT < FOOT:
            sizes = Counter(round(c["size"], 1) for c in line["chars"] if _is_word(c))
            size = max(sizes, key=lambda one: sizes[one], default=math.inf)
            found.append(PageLine(_plain(line["text"]), line["top"] / POINT, size))
    return tuple(found)


def _is_word(char: dict[str, str]) -> bool:
    """Whether a letter is one of words, not of a formula: those are set in a font of their own."""
    return "Math" not in char["fontname"] and char["text"].isalpha()


def _plain(words: str) -> str:
    return re.sub(r"\s+", " ", words).strip()
