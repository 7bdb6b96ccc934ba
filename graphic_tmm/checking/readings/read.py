"""Readings of a hand-made drawing: a file as people and spreadsheets write it, and back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple, NoReturn

from graphic_tmm.checking.readings.csv_cells import (
    HEADS,
    READINGS,
    SEPARATORS,
    CellRow,
    Head,
    decoded,
    header_and_rows,
)
from graphic_tmm.checking.readings.figures import (
    decimal_comma,
    half_unit,
    meant,
    millimetres,
    value_of,
)
from graphic_tmm.checking.readings.grid import is_book, sheet_table, too_many, torn
from graphic_tmm.checking.readings.mending import twice
from graphic_tmm.checking.records import Last, Taken
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import read
from graphic_tmm.language.said import joined, said

TOLD = 20
"""So many faults of a file are told; how many more there are is counted."""
_WANTED = ("plan", "position", "segment")
_FIGURES = ("mm", "value", "x", "y")
_FOR = {
    "plan": said('add it; its cells name the plan, such as velocities, or "results"'),
    "position": said("add it; its cells name the position, and are empty for results"),
    "segment": said("add it; its cells name what was measured, such as pb, or a point"),
}


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


def read_readings(path: Path | str) -> tuple[Taken, ...]:
    """Read the readings of a CSV file or a workbook (xlsx), in the order of its rows.

    Its first row names the columns, in any order, in English or Russian: plan, position, segment, and mm,
    or value and unit, or x and y (mm); lengths may be in cm or inches, where a title or a cell says so.
    Further columns mean nothing here. Cells are separated by commas, semicolons or tabs; the decimal sign is
    a point or a comma; rows without a figure, blank lines and comments (#) are left out. A unit "1" or a dash
    makes a bare number; its unit is "" in ``Taken``.

    Parameters
    ----------
    path : Path or str
        The file, in UTF-8, UTF-16 or Windows-1251, or xlsx.

    Returns
    -------
    tuple of Taken
        Names as typed but for spaces at their ends and repeated ones; values in their own units.

    Raises
    ------
    SceneError
        With the file's faults, the first 20 of them, each with its column and line, and how many more.
    """
    file = Path(path)
    return readings_of(file, read(file, READINGS))


def readings_of(file: Path, data: bytes) -> tuple[Taken, ...]:
    """Return the readings of a file of which the bytes are known; as `read_readings`."""
    found = _table(file, data)
    if found is None:
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
    head, following = found
    faults = _faults_of(head)
    if faults:
        _refuse(file, faults)
    return _taken(file, head, following)


def _table(file: Path, data: bytes) -> tuple[Head, Iterator[CellRow]] | None:
    """Return the row of titles and the others of a text or a workbook; None if it is empty."""
    if is_book(file, data):
        return sheet_table(file, data)
    return header_and_rows(decoded(file, data))


def _taken(file: Path, head: Head, rows: Iterable[CellRow]) -> tuple[Taken, ...]:
    faults: list[Fault] = []
    columns = head.columns
    found = (_cells(row, head, columns, faults) for row in rows)
    cells = [one for one in found if one is not None and one.measured]
    commas = head.separator == ";" or head.with_comma or _comma_seen(cells)
    taken = [_reading(one, head, commas, faults) for one in cells]
    faults += twice(taken, head.title)
    if faults:
        _refuse(file, sorted(faults, key=lambda fault: fault.line))
    return meant(taken)


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
    chosen = [cells[place] for place in columns]
    return _Cells(row.line, *[cell and " ".join(cell.split()) for cell in chosen])


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
