"""A table of variants as people and spreadsheets keep it: a row a variant, a column a key; read and written."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from pathlib import Path as File
from typing import NamedTuple, NoReturn

from graphic_tmm.checking.readings.csv_cells import CellRow
from graphic_tmm.checking.readings.grid import Grid, grid, too_many, torn
from graphic_tmm.checking.readings.writing import csv_text, is_workbook, workbook_of
from graphic_tmm.classroom.variants.variant import LONGEST_NAME, Value, Variant, is_name
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import Kind, read
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.scene.quantities import NUMBER
from graphic_tmm.scene.units import UNITS, plain_unit

VARIANTS = Kind(said("a table of variants"), said("name a CSV or xlsx file of variants"), 8_000_000)
MOST, COLUMNS = 100_000, 256
"""A table has no more variants, and no more columns."""
TOLD = 20
"""So many faults of a table are told; how many more there are is counted."""
_BRACED = re.compile(r"(?P<key>.+?)\s*\((?P<unit>.+)\)|(?P<named>.+?)\s+\[(?P<of>[^\[\]]+)\]")
_NUMBER = re.compile(rf"[+-]?{NUMBER}")


class _Column(NamedTuple):
    """A column: its place, the key that its title names, the unit if it names one."""

    place: int
    key: str
    unit: str


def read_variants(file: File) -> tuple[Variant, ...]:
    """Read the variants of a CSV file or a workbook (xlsx), in the order of its rows.

    The first row holds titles: the first column names the variants, whatever its title; every other title is
    a key of the scene, with the unit of bare numbers below it or without: ``OA``, ``OA, mm``, ``OA (мм)``,
    ``drive.speed [rpm]``. An empty cell leaves what the scene has. Blank rows and comments (#) are left out.

    Parameters
    ----------
    file : Path
        In UTF-8, UTF-16 or Windows-1251, cells separated by commas, semicolons or tabs; or xlsx, of which
        the first sheet counts that holds anything.

    Returns
    -------
    tuple of Variant
        Values as typed; where semicolons or tabs separate the cells, a bare number with a decimal point.

    Raises
    ------
    SceneError
        With the faults of the table, the first 20 of them, each with its column and line.
    """
    found = grid(file, read(file, VARIANTS), COLUMNS + 2)
    if found is None:
        says = said(
            "the table is empty; its first row holds titles: variant, and keys of the scene"
        )
        _refuse(file, [Fault("", 0, says)])
    faults = list[Fault]()
    columns = _columns(found, faults)
    if faults:
        _refuse(file, faults)
    rows = list(_filled(found))
    if not rows or len(rows) > MOST:
        says = said("there is no variant below the titles; a row is a variant")
        if rows:
            says = said(
                "{count} rows; a table has at most {most} variants", count=len(rows), most=MOST
            )
        _refuse(file, [Fault("", found.first.line, says)])
    variants = [_variant(row, found, columns, faults) for row in rows]
    faults += _alike(variants)
    if faults:
        _refuse(file, sorted(faults, key=lambda fault: fault.line))
    return tuple(variants)


def _columns(found: Grid, faults: list[Fault]) -> list[_Column]:
    """Return the columns of values; what is wrong with the titles is added to ``faults``."""
    first, columns = found.first, list[_Column]()
    if first.wrong:
        faults.append(Fault("", first.line, torn(first.wrong)))
        return []
    titles = [" ".join(cell.split()) for cell in first.cells]
    while titles and not titles[-1]:
        titles.pop()
    if not 2 <= len(titles) <= COLUMNS:
        says = said(
            "the first row has {count} titles; the first column names the variants, each of the others (at "
            "most {most}) is a key of the scene",
            count=len(titles),
            most=COLUMNS - 1,
        )
        faults.append(Fault("", first.line, says))
    for place, title in enumerate(titles[:COLUMNS]):
        wrong = _bad(title)
        if place and not wrong:
            key, unit, wrong = parted(title)
            wrong = wrong or _doubtful(found, place, title, [one.key for one in columns], key)
            columns.append(_Column(place, key, unit))
        if wrong:
            faults.append(Fault(title, first.line, wrong))
    return columns


def _doubtful(found: Grid, place: int, title: str, before: Sequence[str], key: str) -> str:
    """Return what is wrong with a title among others, or ""."""
    if (
        found.separator == ","
        and found.first.cells[place][:1] == " "
        and plain_unit(title) in UNITS
    ):
        return said(
            '"{unit}" is a unit; quote a title that holds a comma, "OA, mm", or write OA [mm]',
            unit=title,
        )
    says = said("this column stands twice; take one out, or rename it")
    return says if key in before else ""


def parted(title: str) -> tuple[str, str, str]:
    """Return the key of a title and its unit, "" if it has none; and what is wrong with it, or ""."""
    key, comma, unit = title.rpartition(", ")
    if comma and plain_unit(unit) in UNITS:
        return key.strip(), unit.strip(), ""
    match = _BRACED.fullmatch(title)
    if match is not None:
        unit = (match["unit"] or match["of"]).strip()
        known = plain_unit(unit) in UNITS
        says = said('the unit "{unit}" is not known; write OA (mm)', unit=unit)
        return match["key"] or match["named"], unit, "" if known else says
    says = said("a column without a title; it is a key of the scene, with a unit: OA, mm")
    return title, "", "" if title else says


def _filled(found: Grid) -> Iterator[CellRow]:
    """Yield the rows in which anything stands."""
    for row in found.rows:
        if row.wrong or any(cell.strip() for cell in row.cells):
            yield row


def _variant(row: CellRow, of: Grid, columns: Sequence[_Column], faults: list[Fault]) -> Variant:
    """Return the variant of a row; what is wrong with it is added to ``faults``."""
    width = len(columns) + 1
    cells = [" ".join(cell.split()) for cell in row.cells] + [""] * width
    name, says = cells[0], ""
    if row.wrong:
        says = torn(row.wrong)
    elif any(cells[width:]):
        says = too_many(len(row.cells), width, of.separator)
    elif not name:
        says = said("the variant has no name; the first column names it: 7, Ivanov_A")
    elif not is_name(name):
        says = said(
            '"{name}" is no name of a variant; files are called by it: letters, digits, _ . - and no spaces, '
            "{most} at most",
            name=name,
            most=LONGEST_NAME,
        )
    if says:
        faults.append(Fault("", row.line, says))
    values = list[Value]()
    for one in columns:
        typed = cells[one.place]
        if bad := _bad(typed):
            faults.append(Fault(one.key, row.line, bad))
        if of.separator in (";", "\t") and _NUMBER.fullmatch(typed):
            typed = typed.replace(",", ".")
        if typed:
            values.append(Value(one.key, typed, one.unit))
    return Variant(name, tuple(values), row.line)


def _bad(text: str) -> str:
    """Return what is wrong with the characters of a cell, or ""."""
    bad = next((sign for sign in text if not sign.isprintable()), "")
    code = f"U+{ord(bad):04X}" if bad else ""
    says = said("a character that nobody sees ({code}) stands in the cell; type it anew", code=code)
    return says if bad else ""


def _alike(variants: Sequence[Variant]) -> Iterator[Fault]:
    """Yield a fault for every name that stands twice, or differs by small and capital letters only."""
    seen = dict[str, Variant]()
    for one in variants:
        first = seen.setdefault(folded(one.name), one)
        if first is not one and one.name:
            says = said(
                '"{name}" is called as the variant of line {line}; files are called by names, small and '
                "capital letters are the same in them",
                name=one.name,
                line=first.line,
            )
            yield Fault("", one.line, says)


def folded(name: str) -> str:
    """Return a name as systems of files compare it."""
    return unicodedata.normalize("NFKC", name).casefold()


def _refuse(file: File, faults: Sequence[Fault]) -> NoReturn:
    raise SceneError(str(file), first_of(faults, TOLD)) from None


_CELL_NUMBER = re.compile(r"-?(?:0|[1-9]\d{0,11})(?:\.\d{0,9}[1-9])?")
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
    return float(cell) if _CELL_NUMBER.fullmatch(cell) else cell


def _pointed(cell: str, point: str) -> str:
    return cell.replace(".", point) if _CELL_NUMBER.fullmatch(cell) else cell
