"""Readings of the scenes as CSV files and workbooks, and changes of such a file at random."""

from __future__ import annotations

import random
from functools import cache

from fuzz_changes import (
    NUMBER,
    SHEETS,
    STRANGE,
    UNITS,
    Change,
    at_one,
    bytes_of,
    cut_off,
    double_line,
    drop_line,
    move_line,
    number,
)
from support.misspelt import misspelt
from support.workbooks import Cell, Formula, Shown, workbook

from graphic_tmm.checking.cells import RESULTS, cells, points
from graphic_tmm.checking.readings.writing import write_readings
from graphic_tmm.checking.records import Taken
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

MOST = 60
"""So many readings a file has, taken evenly from all that can be measured."""
SIGNS = (",", ";", "\t", "|", ", ", " ", '","')
ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-32", "cp1251")
CELLS = ("", '"', '""', '"a""b"', '"17,5"', "17,5", "1 000", "1e5000", "-", "—", "#", "=1+1", "pb")


@cache
def readings(name: str) -> str:
    """Return right readings of a scene: segments, quantities and points; "" if it has none."""
    made = make(read(SHEETS / name), exact=True)
    found = [
        Taken(plan, position, segment, cell.mm, cell.value, cell.unit or "1")
        for (plan, segment, position), cell in cells(made).items()
        if plan != RESULTS or cell.value == cell.value
    ]
    found += [Taken(p, at, k, x=z.real, y=z.imag) for (p, k, at), z in points(made).items()]
    return write_readings(found[:: len(found) // MOST + 1], language=made.scene.language)


def cell(source: random.Random, text: str) -> str:
    """Put something else into one cell of one line."""
    lines = text.split("\n")
    at, sign = source.randrange(len(lines)), ";" if ";" in text else ","
    parts = lines[at].split(sign)
    other = source.choice(lines).split(sign)
    parts[source.randrange(len(parts))] = source.choice((*CELLS, *STRANGE, *UNITS, *other))
    lines[at] = sign.join(parts)
    return "\n".join(lines)


def name(source: random.Random, text: str) -> str:
    """Spell the names in a few lines otherwise, or make one the pole of its plan."""
    lines, sign = text.split("\n"), ";" if ";" in text else ","
    for at in source.sample(range(len(lines)), min(4, len(lines))):
        parts = lines[at].split(sign)
        place = source.randrange(min(3, len(parts)))
        parts[place] = misspelt(source, parts[place])[0] if source.random() < 0.8 else "p"
        lines[at] = sign.join(parts)
    return "\n".join(lines)


def as_workbook(source: random.Random, text: str) -> bytes:
    """Return the file as a workbook: some figures are numbers, some formulas, some dates."""

    def typed(cell: str) -> Cell:
        figure = cell.replace(",", ".")
        if source.random() < 0.001:
            return Formula("1+1", source.choice(("", "2")))
        if not NUMBER.fullmatch(figure) or source.random() < 0.2:
            return _printable(cell) or None
        if source.random() < 0.001:
            return Shown(abs(float(figure)) % 1e5, source.choice(("0.00", "date", "0%")))
        return float(figure) if abs(float(figure)) < 1e300 else cell

    sign = ";" if ";" in text else ","
    rows = [[typed(cell) for cell in line.split(sign)[:26]] for line in text.split("\n")]
    sheets = {"one": rows} if source.random() < 0.9 else {"one": rows, "two": rows[:3]}
    return workbook(sheets, shared=source.random() < 0.5)


def _printable(cell: str) -> str:
    return "".join(sign for sign in cell.strip('"\ufeff') if sign.isprintable())


def surplus(source: random.Random, text: str) -> str:
    """Put one cell more, or one less, into a line."""
    lines, sign = text.split("\n"), ";" if ";" in text else ","
    at = source.randrange(len(lines))
    lines[at] = lines[at] + sign + "7" if source.random() < 0.5 else lines[at].rpartition(sign)[0]
    return "\n".join(lines)


def comma(source: random.Random, text: str) -> str:
    return at_one(source, text, NUMBER, lambda old: old.replace(".", ","))


def separator(source: random.Random, text: str) -> str:
    return text.replace(";" if ";" in text else ",", source.choice(SIGNS))


CHANGES: tuple[tuple[Change, int], ...] = (
    *((cell, 8), (name, 6), (number, 6), (comma, 2), (separator, 1), (surplus, 2), (drop_line, 2)),
    *((double_line, 1), (move_line, 2), (bytes_of, 2), (cut_off, 1)),
)


def changed_readings(source: random.Random, name: str) -> bytes:
    """Return the readings of a scene, changed, in some encoding."""
    text = readings(name)
    ways, weights = zip(*CHANGES, strict=True)
    for way in source.choices(ways, weights, k=source.choice((1, 1, 2, 3))):
        text = way(source, text)
    if source.random() < 0.15:
        return _torn(source, as_workbook(source, text))
    coded = source.choice(ENCODINGS) if source.random() < 0.2 else "utf-8"
    data = text.encode(coded, "surrogatepass" if coded.startswith("utf") else "replace")
    return _torn(source, data) if source.random() < 0.2 else data


def _torn(source: random.Random, data: bytes) -> bytes:
    """Put other bytes into one place of a file, in one of four files."""
    if source.random() < 0.25:
        at = source.randrange(len(data) + 1)
        data = data[:at] + source.randbytes(source.randrange(4)) + data[at + 1 :]
    return data
