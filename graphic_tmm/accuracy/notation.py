"""Symbols of geometrography, read and written: ``2R1 + R2``, and ``n`` for each knot of a row."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from functools import cache

from graphic_tmm.accuracy.geometrography import DEFAULT, ELEMENTARY, FORMULA, READING, SYMBOLS
from graphic_tmm.board.grammar import Operation

_TERM = re.compile(r"(\d*)(n?)([A-Z]\d)")


def symbol(op: Operation) -> str:
    """Return the symbol of an operation of the board; one that is not listed has that of its sort."""
    if op.name in SYMBOLS:
        return SYMBOLS[op.name]
    return FORMULA if op.formula else READING if op.reads else DEFAULT


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
