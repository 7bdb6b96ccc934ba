"""Readings of the scenes as CSV files, and changes of such a file at random."""

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
    *((cell, 8), (number, 6), (comma, 2), (separator, 1), (surplus, 2), (drop_line, 2)),
    *((double_line, 1), (move_line, 2), (bytes_of, 2), (cut_off, 1)),
)


def changed_readings(source: random.Random, name: str) -> bytes:
    """Return the readings of a scene, changed, in some encoding."""
    text = readings(name)
    ways, weights = zip(*CHANGES, strict=True)
    for way in source.choices(ways, weights, k=source.choice((1, 1, 2, 3))):
        text = way(source, text)
    coded = source.choice(ENCODINGS) if source.random() < 0.2 else "utf-8"
    data = text.encode(coded, "surrogatepass" if coded.startswith("utf") else "replace")
    if source.random() < 0.05:
        at = source.randrange(len(data) + 1)
        data = data[:at] + source.randbytes(source.randrange(4)) + data[at + 1 :]
    return data
