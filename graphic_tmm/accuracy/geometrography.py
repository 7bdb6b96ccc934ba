"""Lemoine's geometrography: the elementary operations of each step, their symbols, their minutes."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.board.grammar import FREE, JOIN, READ, Operation
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import Kind
from graphic_tmm.language.said import said
from graphic_tmm.scene.document import document


class Elementary(NamedTuple):
    """An elementary operation: what is done, whether it prepares, minutes of a practised draughtsman."""

    en: str
    prepares: bool
    minutes: float


ELEMENTARY: dict[str, Elementary] = {
    "R1": Elementary("place the ruler's edge on a point", True, 0.10),
    "R2": Elementary("draw a line along an edge", False, 0.10),
    "C1": Elementary("put a point of the compass on a given point or division", True, 0.10),
    "C2": Elementary("put a point of the compass on an arbitrary point of a line", True, 0.05),
    "C3": Elementary("draw a circle or an arc", False, 0.10),
    "E1": Elementary("place an edge of the square along a line, the ruler against it", True, 0.15),
    "E2": Elementary("slide the square until an edge goes through a point", True, 0.10),
    "M1": Elementary("place the ruler's zero on a point", True, 0.05),
    "M2": Elementary("prick off a division of the ruler", False, 0.10),
    "M3": Elementary("read a division of the ruler and write it down", False, 0.15),
    "P1": Elementary("place the protractor on a vertex and along a line", True, 0.15),
    "P2": Elementary("prick off an angle", False, 0.10),
    "P3": Elementary("read an angle and write it down", False, 0.15),
    "K1": Elementary("fit the French curve to a knot", True, 0.15),
    "K2": Elementary("draw along the French curve up to a knot", False, 0.10),
    "H1": Elementary("draw an arc between two knots by hand", False, 0.10),
    "A1": Elementary("set the planimeter on its beginning", True, 0.50),
    "A2": Elementary("go round once with the planimeter and read it", False, 1.50),
    "N1": Elementary(
        "evaluate a formula with slide rule or calculator, write it down", False, 0.50
    ),
}
"""Every elementary operation; the minutes are estimates, not measurements: give your own to `cost.count`."""

_TERM = re.compile(r"(\d*)(n?)([A-Z]\d)")


def symbol(op: Operation) -> str:
    """Return the symbol of an operation of the board; one that says none has that of its sort."""
    if op.symbol is not None or op.kept:
        return op.symbol or FREE
    if op.formula or op.looked_up:
        return "N1"
    return READ if op.reads else JOIN


def elements(text: str, n: int = 1) -> Counter[str]:
    """Return how often a symbol has each elementary operation; ``n`` is the length of the row.

    Raises
    ------
    ValueError
        If the text is no symbol.
    """
    once, each = _read(text)
    found = Counter(dict(once))
    for name, times in each:
        found[name] += n * times
    return +found


def written(found: Mapping[str, int]) -> str:
    """Return elementary operations as a symbol, in the order of the table."""
    terms = ((found.get(name, 0), name) for name in ELEMENTARY)
    return " + ".join(name if times == 1 else f"{times}{name}" for times, name in terms if times)


def simplicity(found: Mapping[str, int]) -> int:
    """Return the number of all elementary operations."""
    return sum(found.values())


def exactitude(found: Mapping[str, int]) -> int:
    """Return the number of the elementary operations that prepare a stroke."""
    return sum(times for name, times in found.items() if ELEMENTARY[name].prepares)


Terms = tuple[tuple[str, int], ...]


@cache
def _read(text: str) -> tuple[Terms, Terms]:
    """Return what a symbol has once, and what it has for each knot of the row."""
    once: Counter[str] = Counter()
    each: Counter[str] = Counter()
    for term in text.split(" + ") if text else ():
        match = _TERM.fullmatch(term)
        if match is None or match[3] not in ELEMENTARY:
            raise ValueError(f"'{term}' of '{text}' is no elementary operation")
        (each if match[2] else once)[match[3]] += int(match[1] or 1)
    return tuple(once.items()), tuple(each.items())


MINUTES = Kind(
    said("a table of minutes"), said("name a TOML file with a line such as R1 = 0.1"), 100_000
)
LONGEST = 1e6
"""Minutes of one operation: two years."""
TOLD = 20
"""Greatest number of faults reported for a file."""


def read_minutes(file: str) -> dict[str, float]:
    """Return minutes by elementary operation; those that are left out keep their own.

    Raises
    ------
    SceneError
        If the file cannot be read (as `document`), names what is no elementary operation, or gives what is
        no number of minutes.
    """
    table = document(Path(file), MINUTES)[1]
    faults = []
    for name, value in table.items():
        if name not in ELEMENTARY:
            told = ", ".join(ELEMENTARY)
            faults.append(
                Fault(
                    name,
                    0,
                    said("there is no such elementary operation; there are {told}", told=told),
                )
            )
        elif isinstance(value, bool) or not isinstance(value, (int, float)) or not _able(value):
            faults.append(
                Fault(
                    name,
                    0,
                    said(
                        "write minutes as a number 0 to {longest:.0f}, such as 0.1", longest=LONGEST
                    ),
                )
            )
    if faults:
        raise SceneError(file, first_of(faults, TOLD))
    return {name: float(value) for name, value in table.items()}


def _able(value: float) -> bool:
    return 0 <= value <= LONGEST
