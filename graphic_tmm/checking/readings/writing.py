"""Readings written down as CSV or as a workbook (extra ``xlsx``), and templates to be filled in."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Sequence
from pathlib import PurePath
from typing import Any

from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.checking.readings.csv_cells import HEADS, heads
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import Results
from graphic_tmm.errors import SheetError, installing
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.readers.columns import Column, empty, row_of

Cells = Sequence[str | float | None]
EPOCH = (1980, 1, 1, 0, 0, 0)
"""When everything in the file was made: it does not tell."""
_TOLD = re.compile(rb"(<dcterms:(?:created|modified)[^>]*>)[^<]*")
_WIDTHS = {"plan": 16.0, "position": 11.0, "segment": 16.0}
_WIDTH, _ASIDE = 10.0, 110.0
"""How wide the other columns are, and that of explanations, in letters."""
_ILLEGAL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f]")
_AS_TEXT = "@"
"""The format of a cell in which a spreadsheet leaves what is typed: 1.2 is no date there."""


def workbook(rows: Iterable[Cells], *, language: str, told: Sequence[str] = ()) -> bytes:
    """Return a workbook with rows under the titles of readings; ``told``: lines of a second sheet.

    Raises
    ------
    SheetError
        If openpyxl is missing.
    """
    name = speaking(language)(said("readings", context="sheet"))
    widths = [_WIDTHS.get(head, _WIDTH) for head in HEADS]
    table = (heads(language), *rows)
    return workbook_of(name, table, widths, language=language, frozen="D2", told=told)


def workbook_of(
    name: str,
    rows: Iterable[Cells],
    widths: Sequence[float],
    *,
    language: str,
    frozen: str,
    told: Sequence[str] = (),
) -> bytes:
    """Return a workbook of one sheet, its first row bold titles; parameters and errors as `workbook`.

    ``widths``: of the first columns, in letters; ``frozen``: the cell left of and above which all stays.
    """
    try:
        from openpyxl import Workbook
        from openpyxl.utils import get_column_letter
    except ImportError as error:
        raise SheetError(
            said("an xlsx file needs the package openpyxl: {remedy}", remedy=installing("[xlsx]"))
        ) from error
    book = Workbook()
    sheet = book.active
    sheet.title = name
    for line, row in enumerate(rows, 1):
        _put(sheet, line, row, bold=line == 1)
    sheet.freeze_panes = frozen
    for column, width in enumerate(widths, 1):
        sheet.column_dimensions[get_column_letter(column)].width = width
    if told:
        aside = book.create_sheet(speaking(language)(said("what to do", context="sheet")))
        aside.column_dimensions["A"].width = _ASIDE
        for line, text in enumerate(told, 1):
            _put(aside, line, (text,), wrapped=True)
    out = io.BytesIO()
    book.save(out)
    return _timeless(out.getvalue())


def _put(sheet: Any, line: int, cells: Cells, *, bold: bool = False, wrapped: bool = False) -> None:
    """Write cells into a row; texts as texts, whatever they begin with."""
    from openpyxl.styles import Alignment, Font

    for column, value in enumerate(cells, 1):
        cell = sheet.cell(line, column)
        if isinstance(value, str) and value:
            cell.value = _ILLEGAL.sub(" ", value)
            cell.data_type = "s"
        elif isinstance(value, float):
            cell.value = value
            continue
        cell.number_format = _AS_TEXT
        if bold:
            cell.font = Font(bold=True)
        if wrapped:
            cell.alignment = Alignment(wrap_text=True, vertical="top")


def _timeless(data: bytes) -> bytes:
    """Return a workbook that does not tell when it was made."""
    out = io.BytesIO()
    with (
        zipfile.ZipFile(io.BytesIO(data)) as made,
        zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as kept,
    ):
        for name in made.namelist():
            part = _TOLD.sub(rb"\g<1>1980-01-01T00:00:00Z", made.read(name))
            kept.writestr(zipfile.ZipInfo(name, EPOCH), part, zipfile.ZIP_DEFLATED)
    return out.getvalue()


SIGNS = {".": (",", ""), ",": (";", "\ufeff")}
"""By the decimal sign: separator and what a file begins with, so that spreadsheets take it as it is."""
_QUOTED = frozenset('"\r\n#')


def write_readings(rows: Iterable[Taken], *, language: str = "en") -> str:
    """Return readings as CSV, which ``read_readings`` reads back to the last bit.

    Parameters
    ----------
    rows : iterable of Taken
        Their lines are not written: a row's line is its own.
    language : str
        "en": separated by commas, decimal points; "ru": Russian titles, semicolons, decimal commas, and a
        byte order mark, as spreadsheets set to Russian want them.
    """
    return csv_text((heads(language), *map(_row, rows)), language)


def file_of(
    name: str, rows: Iterable[Taken], *, language: str, told: Sequence[str] = ()
) -> str | bytes:
    """Return readings as the file that its name asks for: a workbook for ``.xlsx``, else CSV.

    ``told``: lines for people, comments of a CSV file and a sheet of their own in a workbook.

    Raises
    ------
    SheetError
        If a workbook is asked for and openpyxl is missing.
    """
    cells = map(_row, rows)
    if is_workbook(name):
        return workbook(cells, language=language, told=told)
    return csv_text((heads(language), *cells), language, told)


def is_workbook(name: str) -> bool:
    """Whether a file is a workbook by its name."""
    return PurePath(name).suffix.lower() == ".xlsx"


def template(
    columns: Sequence[Column],
    names: Sequence[str],
    points: Sequence[tuple[str, str]] = (),
    *,
    language: str = "en",
) -> str:
    """Return a CSV file to be filled in; see `empty_rows`; ``language``: as in ``write_readings``."""
    return write_readings(empty_rows(columns, names, points), language=language)


def empty_rows(
    columns: Sequence[Column],
    names: Sequence[str],
    points: Sequence[tuple[str, str]] = (),
) -> list[Taken]:
    """Return a row for all that can be measured, its figures empty.

    Parameters
    ----------
    columns : sequence of Column
        With a figure for each of the positions; columns of the plan "results" have one figure and no position.
        There is no row where a column holds neither mm nor value.
    names : sequence of str
        The names of the positions.
    points : sequence of (plan, letter)
        Points of plans, with a row for each position at which a column of that plan holds a figure; for every
        position if the plan has no columns, and one without position if there are no positions.
    """
    places: dict[str, set[int]] = {}
    found: list[Taken] = []
    for column in columns:
        given = _given(column)
        places.setdefault(column.plan, set()).update(given)
        unit = column.unit or "1"
        positions = [""] if column.plan == RESULTS else [name for name, _ in column.at] or names
        found += [Taken(column.plan, positions[k], column.segment, unit=unit) for k in given]
    for plan, letter in points:
        drawn = sorted(places.get(plan, range(len(names))))
        positions = [names[k] for k in drawn] if names else [""]
        found += [Taken(plan, position, letter) for position in positions]
    return found


def result_columns(results: Results) -> tuple[Column, ...]:
    """Return results by name as columns of the plan "results" of one figure each."""
    return tuple(
        Column(RESULTS, name, name, unit, empty(1), row_of(figures[:, None], [0], 1))
        for name, (figures, unit) in results.items()
    )


def _given(column: Column) -> list[int]:
    pairs = zip(*column.first_figures, strict=True)
    return [k for k, pair in enumerate(pairs) if pair != (None, None)]


def _row(one: Taken) -> tuple[str | float | None, ...]:
    unit = one.unit if one.value is None else one.unit or "1"
    return (one.plan, one.position, one.segment, one.mm, one.value, unit, one.x, one.y)


def csv_text(
    table: Iterable[Iterable[str | float | None]], language: str, told: Iterable[str] = ()
) -> str:
    """Return rows as CSV, as ``write_readings`` writes a language; ``told``: comments above them."""
    point = decimal_sign(language)
    separator, start = SIGNS[point]
    comments = (f"# {' '.join(text.split())}" for text in told)
    lines = (separator.join(_cell(cell, separator, point) for cell in row) for row in table)
    return start + "".join(f"{line}\n" for line in (*comments, *lines))


def _cell(cell: str | float | None, separator: str, point: str) -> str:
    if isinstance(cell, str):
        return _quoted(cell, separator)
    return "" if cell is None else _quoted(repr(float(cell)).replace(".", point), separator)


def _quoted(cell: str, separator: str) -> str:
    """Return a cell in quotes if it could be taken for several, or its row for a comment."""
    if separator in cell or not _QUOTED.isdisjoint(cell):
        return '"{}"'.format(cell.replace('"', '""'))
    return cell
