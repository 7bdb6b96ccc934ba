"""A workbook (xlsx) of readings, by openpyxl (extra ``xlsx``): the same rows, the same bytes."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Sequence
from typing import Any

from graphic_tmm.checking.readings.csv_cells import HEADS, heads
from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said

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
            said('an xlsx file needs the package openpyxl: pip install "graphic-tmm[xlsx]"')
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
