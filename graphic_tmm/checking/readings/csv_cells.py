"""A table of cells in a text: its encoding, its separator, its columns by name, its rows with lines."""

from __future__ import annotations

import codecs
import csv
import io
import re
import unicodedata
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import chain
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple, NoReturn

from graphic_tmm.checking.readings.figures import SHEET
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.files import Kind
from graphic_tmm.language.catalogue import languages, speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.scene.misfits import near
from graphic_tmm.scene.units import UNITS, plain_unit

READINGS = Kind(said("a file of readings"), said("name a CSV or xlsx file of readings"), 8_000_000)
_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),  # before UTF-16, whose mark is its beginning
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_CONTROL = re.compile("[\x00-\x08\x0e-\x1f\x7f]")
NO_BOOK = said("this is no xlsx workbook, or a damaged one; save the sheet as CSV or xlsx")
_NO_TEXT = said("this is not a text; save the table as CSV with the encoding UTF-8")


def decoded(file: Path, data: bytes) -> str:
    """Return the text of the bytes of a file, their encoding found out; raises SceneError if they are none."""
    for encoding in _encodings(data):
        try:
            text = codecs.decode(data, encoding).lstrip("\ufeff").rstrip("\x1a")
        except UnicodeDecodeError:
            continue
        found = _CONTROL.search(text)
        if found is None:
            return text
        _refuse(file, _none(file), text.count("\n", 0, found.start()) + 1)
    _refuse(file, _none(file))


def _encodings(data: bytes) -> tuple[str, ...]:
    """Return the encodings that the bytes may be in, the likeliest first."""
    for mark, encoding in _BOMS:
        if data.startswith(mark):
            return (encoding,)
    if b"\0" in data:  # every Latin letter of UTF-16 has one, at the odd or at the even places
        little = data[1::2].count(0) > data[::2].count(0)
        return ("utf-16-le" if little else "utf-16-be",)
    return "utf-8", "cp1251"


def _none(file: Path) -> str:
    """Return what is told of a file that is neither a text nor a workbook."""
    return NO_BOOK if file.suffix.lower() == ".xlsx" else _NO_TEXT


def _refuse(file: Path, message: str, line: int = 0) -> NoReturn:
    raise SceneError(str(file), (Fault("", line, message),)) from None


HEADS = (
    said("plan", context="column"),
    said("position", context="column"),
    said("segment", context="column"),
    said("mm", context="column"),
    said("value", context="column"),
    said("unit", context="column"),
    said("x", context="column"),
    said("y", context="column"),
)
"""The columns that mean something; a file may name them in any language."""
SEPARATORS = {",": said("comma"), ";": said("semicolon"), "\t": said("tab")}
_LOOKED, _LONGEST = 50, 30
"""So many titles are looked through for one misspelt, if they have no more than so many letters."""
_LOOK_ALIKE = {"х": "x", "у": "y"}
"""Cyrillic letters that look like the names of columns."""
_CALLED = {
    "plan": ("diagram", "чертёж", "чертеж", "название плана"),
    "position": (
        "pos",
        "no",
        "#",
        "пол",
        "no положения",
        "no пол",
        "номер положения",
        "position no",
    ),
    "segment": ("vector", "symbol", "вектор", "обозначение", "отр", "название отрезка"),
    "value": ("quantity", "значение", "числовое значение", "значение величины", "знач"),
    "unit": (
        "units",
        "ед",
        "ед. изм",
        "единицы",
        "единица измерения",
        "ед. измерения",
        "размерность",
    ),
}
"""Other titles of columns; NFKC makes "no" of №."""
_MEASURED = re.compile(
    r"(?:([xyху]|mm|length|значение|длина(?: отрезка| вектора)?)[\s,:(\[]+)?([^\W\d_]+)\.?[)\]]?"
)
"""A title of lengths, with the unit of the paper in which they are."""
_OF_QUANTITY = re.compile(r"(.+?)\s*[,:(\[]\s*([^\s,()\[\]]+)\s*[)\]]?")
_QUANTITIES = frozenset(
    ("скорость", "ускорение", "сила", "velocity", "speed", "acceleration", "force")
)
"""Titles of quantities, with the unit in which they are: "value [m/s]", "скорость, м/с"."""
_SEPARATOR_LINE = re.compile(r'"?sep=.?"?', re.IGNORECASE)


def heads(language: str) -> tuple[str, ...]:
    """Return the titles of the columns in a language."""
    return tuple(map(speaking(language), HEADS))


@cache
def _names() -> Mapping[str, str]:
    """Return the columns by their titles in all languages, English last."""
    titles = {
        title: str(name)
        for language in reversed(languages())
        for name, title in zip(HEADS, heads(language), strict=True)
    }
    called = {title: name for name, titles_ in _CALLED.items() for title in titles_}
    return called | titles | _LOOK_ALIKE


@cache
def _with_comma() -> frozenset[str]:
    """Return the titles of languages that write a decimal comma."""
    found = [heads(language) for language in languages() if decimal_sign(language) == ","]
    return frozenset(title for titles in found for title in titles) - frozenset(HEADS)


class CellRow(NamedTuple):
    """The cells of one row and the line where it begins; ``wrong``: why it cannot be split, or ""."""

    line: int
    cells: list[str]
    wrong: str = ""


class Head(NamedTuple):
    """The first row: the separator, the titles as typed, and the place of each column by its name.

    ``twice``: titles of columns named once more; ``wrong``: why the row cannot be split, or "". ``units``: of
    columns of lengths, the mm of their unit; ``unit``: that of the quantities, where their title has it.
    """

    line: int
    separator: str
    titles: tuple[str, ...]
    places: Mapping[str, int]
    twice: tuple[str, ...] = ()
    wrong: str = ""
    units: Mapping[str, float] = MappingProxyType({})
    unit: str = ""

    @property
    def ignored(self) -> Mapping[int, str]:
        """The titles that mean nothing, by their places."""
        used = set(self.places.values())
        return {k: title for k, title in enumerate(self.titles) if title and k not in used}

    @property
    def columns(self) -> tuple[int, ...]:
        """The place of every column of ``HEADS``; the first place past the titles for one missing."""
        return tuple(self.places.get(name, len(self.titles)) for name in HEADS)

    @property
    def with_comma(self) -> bool:
        """Whether a column is named in a language that writes a decimal comma."""
        return any(_folded(title) in _with_comma() for title in self.titles)

    @property
    def spoken(self) -> str:
        """The titles as a message quotes them."""
        shown = ", ".join(title[:_LONGEST] for title in self.titles[:10] if title)
        return f"{shown}, ..." if len(self.titles) > 10 else shown

    def title(self, name: str) -> str:
        """Return the title of a column as it stands in the file, its name if it does not."""
        return self.titles[self.places[name]] if name in self.places else name

    def like(self, name: str) -> str:
        """Return the title that was probably meant for a column that is missing; "" if none."""
        looked = [title for title in self.titles[:_LOOKED] if len(title) <= _LONGEST]
        known = [title for title, meant in _names().items() if meant == name]
        unknown = [title for title in looked if not _column(title)[0]]
        return next(filter(None, (near(one, unknown, 0.8) for one in known)), "")


def header_and_rows(text: str) -> tuple[Head, Iterator[CellRow]] | None:
    """Return the first row of a text and an iterator over the others; None if the text is empty.

    Of the separators that one is taken which makes most of the first row columns that are known.
    """
    found = [
        (head_of(first, separator), following)
        for separator in SEPARATORS
        for following in (rows(text, separator),)
        for first in (first_row(following),)
        if first is not None
    ]
    return max(found, key=lambda one: (len(one[0].places), len(one[0].titles)), default=None)


def rows(text: str, separator: str) -> Iterator[CellRow]:
    """Yield the rows of a text; blank lines and comments (#) between rows are left out."""
    numbered = enumerate(io.StringIO(text, newline=None), 1)
    for line, first in numbered:
        if not first.strip() or first.lstrip(" ").startswith("#"):
            continue
        if '"' not in first:
            yield CellRow(line, first.rstrip("\n").split(separator))
            continue
        lines = chain((first,), (more for _, more in numbered))
        reader = csv.reader(lines, delimiter=separator, skipinitialspace=True, strict=True)
        try:
            yield CellRow(line, next(reader))
        except csv.Error as error:
            yield CellRow(line, [], str(error))


def first_row(following: Iterator[CellRow]) -> CellRow | None:
    """Return the row of titles: not a comment that a spreadsheet has quoted, nor its line ``sep=;``."""
    for row in following:
        start = "".join(row.cells[:2])
        if not start.startswith("#") and not _SEPARATOR_LINE.fullmatch(start.strip()):
            return row
    return None


def head_of(row: CellRow, separator: str) -> Head:
    """Return the first row of a table."""
    titles = [" ".join(cell.split()) for cell in row.cells]
    while titles and not titles[-1]:
        titles.pop()
    places: dict[str, int] = {}
    twice, units, of_values = [], {}, ""
    for place, title in enumerate(titles):
        name, unit = _column(title)
        if name in places:
            twice.append(title)
        elif name:
            places[name], units[name] = place, unit
            of_values = of_values or (_quantity_unit(title) if name == "value" else "")
    return Head(
        row.line, separator, tuple(titles), places, tuple(twice), row.wrong, units, of_values
    )


def column_of(title: str) -> str:
    """Return the column that a title names; "" for none."""
    return _column(title)[0]


def _quantity_unit(title: str) -> str:
    """Return the unit in a title of quantities; "" for none."""
    found = _OF_QUANTITY.fullmatch(unicodedata.normalize("NFKC", title).strip())
    unit = found[2] if found else ""
    if not unit or plain_unit(unit) not in UNITS or unit.casefold() in SHEET:
        return ""
    word = _folded(found[1]) if found else ""
    return unit if word in _QUANTITIES or _names().get(word) == "value" else ""


def _column(title: str) -> tuple[str, float]:
    """Return the column that a title names, and the mm of its unit; "" if none: "x (cm)", "длина, мм"."""
    folded = _folded(title)
    name = _names().get(folded, "")
    found = _MEASURED.fullmatch(folded)
    if not name and _quantity_unit(title):
        return "value", 1.0
    if name or found is None or found[2] not in SHEET:
        return name, 1.0
    named = _names().get(found[1] or "", "mm")
    return named if named in ("x", "y") else "mm", SHEET[found[2]]


def _folded(title: str) -> str:
    """Return a title in the form of `HEADS`."""
    return unicodedata.normalize("NFKC", title).casefold().strip().rstrip(":.").strip()
