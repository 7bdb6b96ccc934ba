"""Variants written down as CSV or as a workbook, which are read back as they are."""

from __future__ import annotations

import re
from collections.abc import Sequence

from graphic_tmm.checking.readings.writing import csv_text, is_workbook, workbook_of
from graphic_tmm.classroom.variants.variant import Value, Variant
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said

_NUMBER = re.compile(r"-?(?:0|[1-9]\d{0,11})(?:\.\d{0,9}[1-9])?")
"""A number that a spreadsheet keeps as it is typed."""
_WIDTH = 14.0


def write_variants(variants: Sequence[Variant], name: str, *, language: str = "en") -> str | bytes:
    """Return variants as the file that its name asks for: a workbook for ``.xlsx``, else CSV.

    Parameters
    ----------
    variants : sequence of Variant
        Their lines are not written: a row's line is its own.
    name : str
        The name of the file.
    language : str
        "en": separated by commas, decimal points; "ru": Russian titles, semicolons, decimal commas, and a
        byte order mark, as spreadsheets set to Russian want them.

    Raises
    ------
    SheetError
        If a workbook is asked for and openpyxl is missing.
    """
    speech = speaking(language)
    units = _units(variants)
    titles = [f"{key}, {unit}" if unit else key for key, unit in units.items()]
    heads = [speech(said("variant", context="column")), *titles]
    rows = [[one.name, *_cells(one, units)] for one in variants]
    if is_workbook(name):
        numbered = [[row[0], *map(_number, row[1:])] for row in rows]
        sheet = speech(said("variants", context="sheet"))
        widths = [max(_WIDTH, len(head) + 2.0) for head in heads]
        return workbook_of(sheet, [heads, *numbered], widths, language=language, frozen="B2")
    if (point := decimal_sign(language)) != ".":
        rows = [[row[0], *(_pointed(cell, point) for cell in row[1:])] for row in rows]
    return csv_text([heads, *rows], language)


def _units(variants: Sequence[Variant]) -> dict[str, str]:
    """Return the keys in the order in which they come, each with its unit; "" where variants differ in it."""
    found = dict[str, str]()
    for value in (value for one in variants for value in one.values):
        if found.setdefault(value.key, value.unit) != value.unit:
            found[value.key] = ""
    return found


def _cells(variant: Variant, units: dict[str, str]) -> list[str]:
    values = {value.key: _typed(value, units[value.key]) for value in variant.values}
    return [values.get(key, "") for key in units]


def _typed(value: Value, unit: str) -> str:
    return value.typed if value.unit == unit else f"{value.typed} {value.unit}"


def _number(cell: str) -> str | float:
    return float(cell) if _NUMBER.fullmatch(cell) else cell


def _pointed(cell: str, point: str) -> str:
    return cell.replace(".", point) if _NUMBER.fullmatch(cell) else cell
