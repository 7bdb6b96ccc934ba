"""Any table that people and spreadsheets save, a text or a workbook (extra ``xlsx``), as rows of cells."""

from __future__ import annotations

import io
import re
import warnings
import zipfile
from collections.abc import Iterator, Sequence
from datetime import date, datetime, time, timedelta
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from graphic_tmm.checking.readings.csv_cells import (
    NO_BOOK,
    CellRow,
    Head,
    decoded,
    first_row,
    head_of,
    rows,
)
from graphic_tmm.errors import Fault, SceneError, installing, printable
from graphic_tmm.language.said import said

START = b"PK\x03\x04"
"""With what a workbook begins, as every ZIP."""
OLD = b"\xd0\xcf\x11\xe0"
"""With what a workbook of before 2007, or one with a password, begins."""
LARGEST = 10_000_000
"""So many bytes a workbook may have unpacked: some 25,000 rows, which take some seconds."""
ROWS, COLUMNS = 1_048_576, 64
"""A sheet has so many rows; columns further right mean nothing here."""
_ABOVE = 60
"""The row of titles is one of so many first ones that hold something."""
_WANTED = ("plan", "position", "segment")
_FIGURES = ("mm", "value", "x", "y")
_DECIMALS = re.compile(r"0\.(0+)(?![#0])")


class Sheet(NamedTuple):
    """A sheet: its name, its rows that hold something."""

    name: str
    rows: list[CellRow]


def sheet_table(file: Path, sheets: Sequence[Sheet]) -> tuple[Head, Iterator[CellRow]] | None:
    """Return the row of titles of a workbook and its other rows as text; None if no sheet holds anything.

    Of several sheets that is taken which has the titles of readings; what stands above them means nothing.

    Raises
    ------
    SceneError
        If two sheets hold readings.
    """
    found = [(one.name, *_below(one.rows)) for one in sheets]
    titled = [one for one in found if one[1] is not None]
    filled = [
        one for one in titled if one[1] is not None and any(_filled(one[1], r) for r in one[2])
    ]
    if len(filled) > 1:
        names = ", ".join(printable(name)[:30] for name, _, _ in filled[:5])
        says = said(
            "several sheets hold readings ({names}); keep them in one, or call each by its plan",
            names=names,
        )
        _refuse(file, says)
    for _, head, below in (*filled, *titled):
        if head is not None:
            return head, iter(below)
    if not sheets:
        return None
    first, *below = sheets[0].rows
    return head_of(first, ";"), iter(below)


def _below(rows: Sequence[CellRow]) -> tuple[Head | None, list[CellRow]]:
    """Return the titles of a sheet that holds readings, if it does, and the rows below them."""
    for k, row in enumerate(rows[:_ABOVE]):
        head = head_of(row, ";")
        if sum(name in head.places for name in _WANTED) >= 2:
            return head, [_wide(one, len(head.titles)) for one in rows[k + 1 :]]
    return None, []


def _wide(row: CellRow, width: int) -> CellRow:
    return row._replace(cells=row.cells[:width] + [""] * (width - len(row.cells)))


def _filled(head: Head, row: CellRow) -> bool:
    return any(row.cells[head.places[name]] for name in _FIGURES if name in head.places)


def sheets_of(file: Path, data: bytes, columns: int = COLUMNS) -> list[Sheet]:
    """Return the sheets of a workbook; a formula has the result that the spreadsheet has saved.

    Raises
    ------
    SceneError
        If openpyxl is missing, the file is no workbook, damaged, or too large.
    """
    _measure(file, data)
    try:
        from openpyxl import load_workbook
    except ImportError:
        says = said(
            "an xlsx file needs the package openpyxl: {remedy}", remedy=installing("[xlsx]")
        )
        _refuse(file, says)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            typed = _read(load_workbook, data, columns, results=False)
            if any(cell.startswith("=") for one in typed for row in one.rows for cell in row.cells):
                typed = _with_results(typed, _read(load_workbook, data, columns, results=True))
        except SceneError:
            raise
        except Exception:  # whatever openpyxl, a parser of XML or zlib makes of a damaged file
            _refuse(file, NO_BOOK)
    return typed


def _measure(file: Path, data: bytes) -> None:
    """Refuse what is no ZIP, or is too large unpacked."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            size = sum(entry.file_size for entry in archive.infolist())
    except (zipfile.BadZipFile, ValueError, OSError, NotImplementedError, EOFError):
        _refuse(file, NO_BOOK)
    if size > LARGEST:
        _refuse(file, said("the workbook is too large; delete sheets that hold no readings"))


def _read(load_workbook: Any, data: bytes, columns: int, *, results: bool) -> list[Sheet]:
    book = load_workbook(io.BytesIO(data), read_only=True, data_only=results, keep_links=False)
    try:
        return [Sheet(sheet.title, list(_rows(sheet, columns))) for sheet in book.worksheets]
    finally:
        book.close()


def _rows(sheet: Any, columns: int) -> Iterator[CellRow]:
    """Yield the rows of a sheet that hold something and are no comment; ValueError beyond all rows."""
    sheet.reset_dimensions()  # a file may tell fewer than it has
    before = None
    for line, cells in enumerate(sheet.iter_rows(max_col=columns), 1):
        if line > ROWS:
            raise ValueError(line)
        if cells is before:  # openpyxl fills up missing rows with one and the same
            continue
        before = cells
        texts = [_text(cell) if cell.value is not None else "" for cell in cells]
        while texts and not texts[-1].strip():
            texts.pop()
        if texts and not texts[0].lstrip().startswith("#"):
            yield CellRow(line, texts)


def _with_results(typed: list[Sheet], worked: list[Sheet]) -> list[Sheet]:
    """Return sheets as they were typed, results in the places of formulas; without one a formula stays."""
    found = []
    for sheet, values in zip(typed, worked, strict=True):
        by_line = {row.line: row.cells for row in values.rows}
        rows = [
            row._replace(cells=_worked(row.cells, by_line.get(row.line, []))) for row in sheet.rows
        ]
        found.append(sheet._replace(rows=rows))
    return found


def _worked(cells: Sequence[str], results: Sequence[str]) -> list[str]:
    there = [*results, *[""] * len(cells)]
    return [there[k] or cell if cell.startswith("=") else cell for k, cell in enumerate(cells)]


def _text(cell: Any) -> str:
    """Return a cell as text: a number as somebody would type it, with the noughts that are shown of it."""
    value = cell.value
    if isinstance(value, bool):
        return str(value).upper()
    if isinstance(value, int | float):
        return _number(float(value), str(cell.number_format or ""))
    if isinstance(value, datetime | date | time):
        return value.isoformat(" ")[:10] if isinstance(value, datetime) else value.isoformat()
    if isinstance(value, timedelta):
        return str(value)
    return str(getattr(value, "text", value))


def _number(value: float, shown: str) -> str:
    if shown.rstrip().endswith("%"):
        return f"{100.0 * value:.12g} %"
    text = str(int(value)) if value.is_integer() and abs(value) < 1e15 else repr(value)
    decimals = _DECIMALS.search(shown.partition(";")[0])
    if decimals is None or "e" in text:
        return text
    whole, _, digits = text.partition(".")
    return f"{whole}.{digits.ljust(len(decimals[1]), '0')}"


def _refuse(file: Path, message: str) -> NoReturn:
    raise SceneError(str(file), (Fault("", 0, message),)) from None


_ORDER = ("\t", ";", ",")
"""Separators: a title may hold a comma ("OA, mm"), hardly a semicolon, and no tab."""


class Grid(NamedTuple):
    """The first row that holds something, and an iterator over the others; ``separator``: "" of a workbook."""

    separator: str
    first: CellRow
    rows: Iterator[CellRow]


def grid(file: Path, data: bytes, columns: int) -> Grid | None:
    """Return the table of a text, or of the first sheet of a workbook that holds any; None if none does.

    ``columns``: so many are read of a workbook.

    Raises
    ------
    SceneError
        If it is neither a text nor a workbook, or openpyxl is missing for that.
    """
    if is_book(file, data):
        sheets = [one.rows for one in sheets_of(file, data, columns) if one.rows]
        return Grid("", sheets[0][0], iter(sheets[0][1:])) if sheets else None
    text = decoded(file, data)
    for separator in _ORDER:
        following = rows(text, separator)
        first = first_row(following)
        if first is None:
            return None
        if len(first.cells) > 1 or first.wrong or separator == _ORDER[-1]:
            return Grid(separator, first, following)
    return None


def is_book(file: Path, data: bytes) -> bool:
    """Whether the bytes of a file are a workbook; an old one, or one with a password, is refused."""
    if data.startswith(OLD):
        says = said("an old workbook, or one with a password; save the sheet as CSV or xlsx")
        raise SceneError(str(file), (Fault("", 0, says),))
    return data.startswith(START)


def torn(why: str) -> str:
    """Return what is wrong with a row that the csv reader cannot split."""
    return said(
        "the row cannot be split into cells ({why}); "
        'a quoted cell ends with its quote, and a quote inside it is written twice: ""',
        why=why,
    )


def too_many(count: int, titles: int, separator: str) -> str:
    """Return what is wrong with a row of more cells than there are titles."""
    remedy = said("take the surplus ones out, or give their columns titles")
    if separator == ",":
        remedy = said('quote a number with a decimal comma, "17,5", or write 17.5')
    return said(
        "the row has {count} cells, the first row {titles}; {remedy}",
        count=count,
        titles=titles,
        remedy=remedy,
    )
