"""Ranges from which variants are drawn: a file ``ranges.toml`` beside the scene, understood as a whole or not.

::

    [ranges]                                     # keys as in a table of variants
    OA    = { from = "90 mm", to = "130 mm", step = "5 mm" }
    drive.speed = ["50 rpm", "60 rpm", "75 rpm"]

    [good]                                       # what a good variant is
    transmission = "30 deg"                      # the least transmission angle over the turn
    vector       = "3 mm"                        # the shortest vector that is measured on a plan
    short        = ["ps3"]                       # segments that may be shorter
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from decimal import Decimal
from pathlib import Path as File
from typing import Any, NamedTuple

from graphic_tmm.classroom.variants.table import parted
from graphic_tmm.classroom.variants.variant import Base, Value, Variant, place_of, scene_of, text_of
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import Kind
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.document import Document, document
from graphic_tmm.scene.lines import key_of, line_of, locate
from graphic_tmm.scene.misfits import meant, short
from graphic_tmm.scene.quantities import NUMBER, parse
from graphic_tmm.scene.units import UNITS, Dimension, plain_unit

FILE = "ranges.toml"
RANGES = Kind(said("a file of ranges"), said("name a file of ranges (TOML)"), 256_000)
MOST_KEYS, MOST_VALUES = 64, 10_000
"""So many keys vary at most, and each of them has no more values."""
Place = tuple[str, ...]
"""Where a key stands in the file."""
TOLD = 20
"""So many faults of a file are told; how many more there are is counted."""
TRANSMISSION, VECTOR = 30.0, 3.0
"""The least transmission angle, degrees, and the shortest vector, mm, where a file does not say."""
_STEPS = "from", "to", "step"
_GOOD = "transmission", "vector", "short"
_QUANTITY = re.compile(rf"\s*([+-]?{NUMBER})\s*(\D.*?)?\s*", re.DOTALL)
_EXAMPLE = said('write from = "90 mm", to = "130 mm", step = "5 mm" in braces, or a list of values')


class Range(NamedTuple):
    """What may stand at a key: the key, its values in order, the unit of bare numbers if they have one."""

    key: str
    values: tuple[str, ...]
    unit: str = ""

    def at(self, k: int) -> Value:
        """Return the value of a number, from 0."""
        return Value(self.key, self.values[k], self.unit)


class Good(NamedTuple):
    """What a good variant is.

    ``transmission``: its least transmission angle, degrees; ``vector``: how short a vector may be that is
    measured, mm; ``short``: the segments that may be shorter, as tables call them.
    """

    transmission: float = TRANSMISSION
    vector: float = VECTOR
    short: tuple[str, ...] = ()


class Ranges(NamedTuple):
    """What varies, and what a good variant is."""

    ranges: tuple[Range, ...]
    good: Good = Good()

    @property
    def all(self) -> int:
        """How many variants they hold, good and bad."""
        found = 1
        for one in self.ranges:
            found *= len(one.values)
        return found


def read_ranges(file: File, of: Base) -> Ranges:
    """Read the ranges of a scene's variants.

    Raises
    ------
    SceneError
        With the faults of the file, the first 20 of them, each with its key and line: a key that the scene
        does not have, or that it refuses the values of, is one.
    """
    text, doc = document(file, RANGES)
    lines, faults = locate(text), list[Fault]()

    def fault(path: Place, says: str) -> None:
        faults.append(Fault(key_of(doc, path), line_of(lines, path), says))

    for name in doc.keys() - {"ranges", "good"}:
        fault((name,), joined("; ", _unknown(name, ("ranges", "good"))))
    found = dict[Place, Range]()
    for path, value in _entries(_table(doc, "ranges", fault)):
        try:
            found[path] = _range(".".join(path[1:]), value)
        except ValueError as error:
            fault(path, error.args[0])
    if not found and not faults:
        fault(("ranges",), joined("; ", (said("no key has a range"), _EXAMPLE)))
    if len(found) > MOST_KEYS:
        fault(
            ("ranges",), said("{count} keys vary, at most {most}", count=len(found), most=MOST_KEYS)
        )
        found = {}
    good = _good(_table(doc, "good", fault), fault)
    faults += _misplaced(of, file, {line_of(lines, path): one for path, one in found.items()})
    places = dict[object, Place]()
    for path, one in found.items():
        first = places.setdefault(place_of(of, one.key), path)
        if first is not path:
            fault(
                path, said("this is the key of line {line} once more", line=line_of(lines, first))
            )
    if faults:
        faults.sort(key=lambda one: (one.line, one.key))
        raise SceneError(str(file), first_of(faults, TOLD))
    return Ranges(tuple(found.values()), good)


def _unknown(name: str, known: Sequence[str]) -> Iterator[str]:
    yield said("there is no such key; there are {known}", known=", ".join(known))
    if likely := meant(name, known):
        yield likely


def _table(doc: Document, name: str, fault: Any) -> Document:
    found = doc.get(name, {})
    if isinstance(found, dict):
        return found
    fault((name,), said("a section [{name}] is wanted here", name=name))
    return {}


def _entries(table: Document) -> Iterator[tuple[Place, object]]:
    """Yield the keys that have a range; what is no range itself is a part of keys: drive.speed, unquoted."""
    level: list[tuple[tuple[str, ...], object]] = [
        (("ranges", name), value) for name, value in table.items()
    ]
    while level:
        path, value = level.pop(0)
        inner = value if isinstance(value, dict) and not value.keys() & set(_STEPS) else {}
        if inner:
            level[:0] = [((*path, name), one) for name, one in inner.items()]
        else:
            yield path, value


def _range(title: str, value: object) -> Range:
    """Return the range of a key; ValueError tells why it is none."""
    key, unit, wrong = parted(" ".join(title.split()))
    if wrong or not key:
        raise ValueError(wrong or said("this is no key of a scene"))
    values, own = _stepped(value) if isinstance(value, dict) else _listed(value)
    if unit and own:
        raise ValueError(said("the key and its values both have a unit; leave one of them out"))
    if len(set(values)) < len(values):
        raise ValueError(said("a value stands twice in the list"))
    return Range(key, values, unit or own)


def _listed(value: object) -> tuple[tuple[str, ...], str]:
    """Return the values of a list, and their unit if it is one for all."""
    if not isinstance(value, list) or not value:
        raise ValueError(_EXAMPLE)
    if len(value) > MOST_VALUES:
        raise ValueError(_too_many(len(value)))
    typed = [_typed(one) for one in value]
    matches = [_QUANTITY.fullmatch(one) for one in typed]
    units = {match[2] or "" if match else "" for match in matches}
    unit = units.pop() if len(units) == 1 else ""
    if not unit or plain_unit(unit) not in UNITS:
        return tuple(typed), ""
    return tuple(match[1] for match in matches if match), unit


def _typed(value: object) -> str:
    """Return a value of a list as a person types it into a table."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int | float):
        return _digits(_decimal(value))
    if not isinstance(value, str) or not value.strip() or not value.isprintable():
        raise ValueError(said("a list of values holds numbers and texts, none of them empty"))
    return " ".join(value.split())


def _stepped(value: Document) -> tuple[tuple[str, ...], str]:
    """Return the values from one to another in steps, and their unit: exactly as decimals."""
    if value.keys() != set(_STEPS):
        raise ValueError(joined("; ", (said("a range has from, to and step"), _EXAMPLE)))
    numbers, units = zip(*(_number(value[name]) for name in _STEPS), strict=True)
    if len({plain_unit(unit) for unit in units}) > 1:
        raise ValueError(said("from, to and step have one unit, or none of them has one"))
    first, last, step = numbers
    if step <= 0 or last < first:
        raise ValueError(said("step is above 0, and to is not less than from"))
    count = int((last - first) / step) + 1
    if count > MOST_VALUES:
        raise ValueError(_too_many(count))
    return tuple(_digits(first + k * step) for k in range(count)), units[0]


def _too_many(count: int) -> str:
    return said("{count} values, at most {most}", count=count, most=MOST_VALUES)


def _number(value: object) -> tuple[Decimal, str]:
    """Return a number and its unit, "" if it has none."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        return _decimal(value), ""
    match = _QUANTITY.fullmatch(value) if isinstance(value, str) and len(value) < 60 else None
    if match is None:
        raise ValueError(joined("; ", (said("from, to and step are numbers"), _EXAMPLE)))
    unit = match[2] or ""
    if unit and plain_unit(unit) not in UNITS:
        raise ValueError(said('the unit "{unit}" is not known; write OA (mm)', unit=short(unit)))
    return _bounded(Decimal(match[1].replace(",", "."))), unit


def _decimal(value: float) -> Decimal:
    return _bounded(Decimal(repr(value)) if abs(value) < 1e18 else Decimal("Infinity"))


def _bounded(value: Decimal) -> Decimal:
    """Return a number that a table can hold; ValueError if it is none."""
    small = value and value.is_finite() and abs(value) < Decimal("1e-12")
    if not value.is_finite() or abs(value) > Decimal("1e12") or small:
        raise ValueError(said("the number is too large, too small, or none at all"))
    return value


def _digits(value: Decimal) -> str:
    """Return a number without powers of ten and without noughts at its end."""
    text = f"{value:f}"
    return (text.rstrip("0").rstrip(".") if "." in text else text) or "0"


def _good(table: Document, fault: Any) -> Good:
    for name in table.keys() - set(_GOOD):
        fault(("good", name), joined("; ", _unknown(name, _GOOD)))
    found = Good()
    scales: tuple[tuple[str, Dimension, float, float], ...] = (
        ("transmission", "angle", 1.0, 90.0),
        ("vector", "length", 1000.0, 100.0),
    )
    for name, dimension, factor, most in scales:
        if name not in table:
            continue
        try:
            value = round(factor * parse(table[name], dimension), 9)
        except ValueError as error:
            fault(("good", name), error.args[0])
            continue
        if 0.0 <= value <= most and name == "vector":
            found = found._replace(vector=value)
        elif 0.0 <= value <= most:
            found = found._replace(transmission=value)
        else:
            fault(("good", name), said("it lies between 0 and {most:.0f}", most=most))
    segments = table.get("short", [])
    if isinstance(segments, list) and all(isinstance(one, str) for one in segments):
        return found._replace(short=tuple(segments))
    fault(("good", "short"), said('a list of segments is wanted here: ["ps3"]'))
    return found


def _misplaced(of: Base, file: File, found: dict[int, Range]) -> Iterator[Fault]:
    """Yield what the scene says to the first and the last value of each key alone: of the key, no other."""
    for line, one in found.items():
        for k in sorted({0, len(one.values) - 1}):
            variant = Variant("0", (one.at(k),), line)
            try:
                text_of(of, variant, str(file))
                scene_of(of, variant)
            except SceneError as error:
                own = key_of(of.doc, place_of(of, one.key))
                told = [f for f in error.faults if f.key in (one.key, own)]
                yield from (Fault(f"ranges.{one.key}", line, f.message) for f in told[:1])
                if told:
                    break
