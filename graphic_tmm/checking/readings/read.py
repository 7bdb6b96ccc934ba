"""Readings of a hand-made drawing: a file as people and spreadsheets write it, and back."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple, NoReturn

from graphic_tmm.checking.readings.csv_cells import (
    HEADS,
    READINGS,
    SEPARATORS,
    CellRow,
    Head,
    decoded,
    header_and_rows,
    rows,
)
from graphic_tmm.checking.readings.figures import (
    SHEET,
    decimal_comma,
    half_unit,
    meant,
    millimetres,
    plainly,
    unit_behind,
    value_of,
)
from graphic_tmm.checking.readings.filling import filled
from graphic_tmm.checking.readings.grid import is_book, sheet_table, sheets_of, too_many, torn
from graphic_tmm.checking.readings.layouts import Layout, labelled, laid_out, named_plan
from graphic_tmm.checking.readings.letters import (
    Letters,
    is_letters,
    letters_of,
    without_letters,
)
from graphic_tmm.checking.readings.mending import twice
from graphic_tmm.checking.records import Last, Taken
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import read
from graphic_tmm.language.said import Said, joined, said

TOLD = 20
"""So many faults of a file are told; how many more there are is counted."""
_WANTED = ("plan", "position", "segment")
_FIGURES = ("mm", "value", "x", "y")
_FOR = {
    "plan": said('add it; its cells name the plan, such as velocities, or "results"'),
    "position": said("add it; its cells name the position, and are empty for results"),
    "segment": said("add it; its cells name what was measured, such as pb, or a point"),
}


class FileReadings(tuple[Taken, ...]):
    """The readings of a file, with what it says beside them.

    ``notes``: on columns left out and cells filled; ``letters``: the scene's by the student's own.
    """

    notes: tuple[Said, ...] = ()
    letters: Letters = MappingProxyType({})

    @classmethod
    def of(cls, readings: Iterable[Taken], notes: Iterable[Said], letters: Letters) -> FileReadings:
        """Return readings with notes and letters."""
        found = cls(readings)
        found.notes, found.letters = tuple(notes), letters
        return found


def with_words_of(readings: Sequence[Taken], some: Iterable[Taken]) -> FileReadings:
    """Return some of readings with the notes and letters of their file, if they are of one."""
    if isinstance(readings, FileReadings):
        return FileReadings.of(some, readings.notes, readings.letters)
    return FileReadings(some)


class _Table(NamedTuple):
    """The rows of a file under its titles, its letters; what is wrong with figures, by line."""

    head: Head
    rows: Iterable[CellRow]
    letters: Letters = MappingProxyType({})
    faults: Sequence[Fault] = ()


class _Cells(NamedTuple):
    """The cells of a row in the columns that mean something, "" where there is none; its line."""

    line: int
    plan: str
    position: str
    segment: str
    mm: str
    value: str
    unit: str
    x: str
    y: str

    @property
    def measured(self) -> bool:
        return bool(self.mm or self.value or self.x or self.y)


def read_readings(path: Path | str) -> FileReadings:
    """Read the readings of a CSV file or a workbook (xlsx), in the order of its rows.

    Its first row names the columns, in any order, in English or Russian: plan, position, segment, and mm,
    or value and unit, or x and y (mm); lengths may be in cm or inches, where a title or a cell says so.
    Further columns are left out, with a note. A crosstab of segments and positions, a block or a sheet a
    plan, is read, too (`layouts`), cells left empty below a plan or a position (`filling`), and a row of the
    student's own letters (`letters`). Cells are separated by commas, semicolons or tabs; the decimal sign is
    a point or a comma; rows without a figure, blank lines and comments (#) are left out. A unit "1" or a dash
    makes a bare number; its unit is "" in ``Taken``.

    Parameters
    ----------
    path : Path or str
        The file, in UTF-8, UTF-16 or Windows-1251, or xlsx.

    Returns
    -------
    FileReadings
        Names as typed but for spaces at their ends and repeated ones; values in their own units.

    Raises
    ------
    SceneError
        With the file's faults, the first 20 of them, each with its column and line, and how many more.
    """
    file = Path(path)
    return readings_of(file, read(file, READINGS))


def readings_of(file: Path, data: bytes) -> FileReadings:
    """Return the readings of a file of which the bytes are known; as `read_readings`."""
    table = _book(file, data) if is_book(file, data) else _text(decoded(file, data))
    if table is None:
        _refuse(
            file,
            [
                Fault(
                    "",
                    0,
                    said(
                        "the file is empty; its first row names {listed}",
                        listed=joined(", ", HEADS),
                    ),
                )
            ],
        )
    if faults := [*_faults_of(table.head), *table.faults]:
        _refuse(file, faults)
    return _taken(file, table)


def _text(text: str) -> _Table | None:
    """Return the table of a text; None if it is empty."""
    letters: dict[str, str] = {}
    faults: list[Fault] = []
    lines = text.splitlines()
    for k, line in enumerate(lines):
        row = CellRow(k + 1, re.split(r"[;,\t:]", line.replace('"', ""), maxsplit=1))
        if is_letters(row):
            more, wrong = letters_of(re.split(r"[;,\t]", "".join(row.cells[1:])), k + 1)
            letters |= more
            faults += wrong
            lines[k] = ""
    if letters or faults:
        text = "\n".join(lines)
    found = header_and_rows(text)
    if found is None:
        return None
    head, following = found
    if _faults_of(head) and not (head.wrong or head.twice):
        separator = next((sign for sign in "\t;" if sign in text), ",")
        if (laid := laid_out([("", list(rows(text, separator)))], separator)) is not None:
            return _laid(laid, letters, faults)
    return _Table(head, following, letters, faults)


def _book(file: Path, data: bytes) -> _Table | None:
    """Return the table of a workbook; None if no sheet holds anything."""
    letters: dict[str, str] = {}
    faults: list[Fault] = []
    sheets = []
    for sheet in sheets_of(file, data):
        kept, more, wrong = without_letters(sheet.rows)
        letters |= more
        faults += wrong
        sheets += [sheet._replace(rows=kept)] if kept else []
    plans = [sheet for sheet in sheets if named_plan(sheet.name)]
    several = len({sheet.name.casefold() for sheet in plans}) > 1
    found = None if several else sheet_table(file, sheets)
    if several or (found is not None and _faults_of(found[0]) and not found[0].twice):
        some = plans if several else sheets
        laid = laid_out([(sheet.name, sheet.rows) for sheet in some], ";")
        if laid is not None:
            return _laid(laid, letters, faults)
        found = sheet_table(file, sheets)
    return None if found is None else _Table(*found, letters, faults)


def _laid(laid: Layout, letters: Letters, faults: Sequence[Fault]) -> _Table:
    more = [Fault("", line, says) for line, says in laid.faults]
    return _Table(laid.head, laid.rows, letters, [*faults, *more])


def _taken(file: Path, table: _Table) -> FileReadings:
    faults: list[Fault] = []
    head = table.head
    columns, left_out = head.columns, dict[str, None]()
    found = []
    for row in table.rows:
        there = row.cells  # before it is made as wide as the titles
        if tuple(map(str.strip, there)) == head.titles:  # they stand once more
            continue
        left_out |= {
            t: None for k, t in head.ignored.items() if k < len(there) and there[k].strip()
        }
        found.append(_cells(row, head, columns, faults))
    cells, filling = filled([one for one in found if one is not None and one.measured])
    commas = head.separator == ";" or head.with_comma or _comma_seen(cells)
    taken = [_reading(one, head, commas, faults) for one in cells]
    numbered = {one.plan for one in taken if one.position}
    faults += twice([t for t in taken if t.position or t.plan not in numbered], head.title)
    if faults:
        _refuse(file, sorted(faults, key=lambda fault: fault.line))
    notes = [_left_out(title) for title in left_out]
    return FileReadings.of(meant(taken), (*notes, *filling), table.letters)


def _left_out(title: str) -> Said:
    return said('the column "{title}" means nothing here; it was left out', title=title[:40])


def _faults_of(head: Head) -> list[Fault]:
    """Return what is wrong with the row of titles."""
    if head.wrong:
        return [Fault("", head.line, torn(head.wrong))]
    faults = [
        Fault(title, head.line, said("this column stands twice; take one out, or rename it"))
        for title in head.twice
    ]
    missing = [name for name in _WANTED if name not in head.places]
    faults += [_missing(head, name, _FOR[name]) for name in missing]
    if ("x" in head.places) != ("y" in head.places):
        name = "y" if "x" in head.places else "x"
        faults.append(_missing(head, name, said("a point needs both x and y, in mm")))
    if not any(name in head.places for name in _FIGURES):
        faults.append(_missing(head, "mm", said("add it, or value and unit, or x and y")))
    return faults


def _missing(head: Head, name: str, remedy: str) -> Fault:
    column = next(one for one in HEADS if one == name)
    like = head.like(name)
    asks = said('; did you mean it by "{title}"?', title=like) if like else ""
    says = said(
        "the column {column} is missing; {remedy}{asks} (the first row names: {titles})",
        column=column,
        remedy=remedy,
        asks=asks,
        titles=head.spoken,
    )
    return Fault(name, head.line, says)


def _cells(
    row: CellRow, head: Head, columns: tuple[int, ...], faults: list[Fault]
) -> _Cells | None:
    """Return the cells of a row by columns; None, and a fault, if it does not fit under the titles."""
    cells, width = row.cells, len(head.titles)
    if row.wrong:
        faults.append(Fault("", row.line, torn(row.wrong)))
        return None
    if len(cells) > width and any(cell.strip() for cell in cells[width:]):
        faults.append(Fault("", row.line, too_many(len(cells), len(head.titles), head.separator)))
        return None
    if len(cells) == 1 < width and not cells[0].lstrip().startswith("#"):
        says = said(
            "the row is a single cell; separate its cells by a {separator}, as in the first row",
            separator=SEPARATORS[head.separator],
        )
        faults.append(Fault("", row.line, says))
        return None
    cells += [""] * (width + 1 - len(cells))
    cells[width] = ""
    chosen = [cells[place] and " ".join(cells[place].split()) for place in columns]
    plan, position, segment, mm, value, unit, x, y = chosen
    bare, of = labelled(segment)
    mm, value, x, y = (plainly(cell, bare) if cell else "" for cell in (mm, value, x, y))
    if of.casefold().rstrip(".") in SHEET and mm and not value:
        segment, mm = bare, mm if unit_behind(mm) else f"{mm} {of}"
    elif of and value and not mm:
        segment, unit = bare, unit or of
    unit = unit or (head.unit if value and not unit_behind(value) else "")
    return _Cells(row.line, plan, position, segment, mm, value, unit, x, y)


def _comma_seen(cells: Sequence[_Cells]) -> bool:
    """Return whether any figure shows that a comma is the decimal sign of the file."""
    return any(
        decimal_comma(cell)
        for one in cells
        for cell in (one.mm, one.value, one.x, one.y)
        if "," in cell
    )


def _reading(one: _Cells, head: Head, commas: bool, faults: list[Fault]) -> Taken:
    """Return a row as a reading; what cannot be read is None in it, and a fault."""
    line = one.line
    for name, cell in (("plan", one.plan), ("segment", one.segment)):
        if not cell:
            faults.append(
                Fault(head.title(name), line, said("the cell is empty, and the row has a figure"))
            )
    lengths = {"mm": one.mm, "x": one.x, "y": one.y}
    numbers: dict[str, float] = {}
    halves = {"value": half_unit(one.value)}
    for name, cell in lengths.items():
        try:
            if cell:
                usual = head.units.get(name, 1.0)
                numbers[name], unit_mm = millimetres(cell, commas=commas, usual=usual)
                halves[name] = unit_mm * half_unit(cell)
        except ValueError as error:
            faults.append(Fault(head.title(name), line, error.args[0]))
    try:
        value, unit = value_of(one.value, one.unit, commas=commas)
    except ValueError as error:
        faults.append(Fault(head.title("value"), line, error.args[0]))
        value, unit = None, ""
    if bool(one.x) != bool(one.y):
        empty = "y" if one.x else "x"
        faults.append(
            Fault(head.title(empty), line, said("a point needs both x and y; this is empty"))
        )
    mm, x, y = map(numbers.get, lengths)
    last = Last(**halves)
    return Taken(one.plan, one.position, one.segment, mm, value, unit, x, y, line, last)


def _refuse(file: Path, faults: Sequence[Fault]) -> NoReturn:
    raise SceneError(str(file), first_of(faults, TOLD)) from None
