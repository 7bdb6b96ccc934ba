"""Any table that people and spreadsheets save, as rows of cells: whatever its columns are called."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.checking.readings.csv_cells import Row, first_row, rows
from graphic_tmm.checking.readings.decoding import decoded
from graphic_tmm.checking.readings.workbook import OLD, START, sheets_of
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said

_ORDER = ("\t", ";", ",")
"""Separators: a title may hold a comma ("OA, mm"), hardly a semicolon, and no tab."""


class Grid(NamedTuple):
    """The first row that holds something, and an iterator over the others; ``separator``: "" of a workbook."""

    separator: str
    first: Row
    rows: Iterator[Row]


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
