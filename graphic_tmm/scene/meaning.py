"""What values of a document mean, by the declarations of sections: whether two say the same."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import MISSING, fields, is_dataclass
from typing import Any

from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import FAULTY, Flaw, Kind, Names, Path, Section, Sort, keys_of
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.sections import LENGTHS, declared
from graphic_tmm.scene.tables import ByShape, DeclaredTable, Named, Several

NEAR = 1e-12
"""Lengths (m), angles (degrees) and all other numbers that differ by less, or by this share, are the same:
rounding of places turned to and fro leaves 1e-14 m at the most in the packaged scenes."""


def sort_of(section: str) -> Sort | None:
    """Return what may stand for a section, or for a key before the first; None of one that there is not."""
    if section == LENGTHS:
        return Named(v.PLAIN_LENGTH)
    if section in keys_of(Head):
        return keys_of(Head)[section].kind
    known = declared().get(section)
    return None if known is None else _of_section(known)


def _of_section(section: Section) -> Sort:
    one = DeclaredTable(section.record)
    if section.several:
        return Several(one)
    further = section.further and DeclaredTable(section.further)
    return ByShape(list, Several(further or one), one)


def inner(sort: Sort | None, value: object, key: str | int) -> Sort | None:
    """Return what may stand for a key of a value of some sort, or for an item of it; None if nobody says."""
    sort = shaped(sort, value)
    if isinstance(sort, DeclaredTable):
        known = keys_of(sort.record).get(str(key))
        others: Sort | None = getattr(sort.record, "OTHERS", None)
        return others if known is None else known.kind
    if isinstance(sort, (Named, Several)):
        return sort.each
    return v.LENGTH if is_point(sort, value) else None


def shaped(sort: Sort | None, value: object) -> Sort | None:
    """Return what stands there if such a value does: one of the sorts between which its shape tells."""
    if isinstance(sort, ByShape):
        return shaped(sort.such if isinstance(value, sort.shape) else sort.other, value)
    return sort


def is_point(sort: Sort | None, value: object) -> bool:
    """Whether a value is a list of two coordinates, each of which says something by itself."""
    sort = shaped(sort, value)
    point = sort is v.POINT or not isinstance(
        sort, (Kind, DeclaredTable, Named, Several, type(None))
    )
    return point and isinstance(value, list) and len(value) == 2


def left_out(sort: Sort | None, table: object, key: str | int) -> Any:
    """Return what a table means that does not say a key; MISSING if it has to."""
    sort = shaped(sort, table)
    known = keys_of(sort.record).get(str(key)) if isinstance(sort, DeclaredTable) else None
    return MISSING if known is None else known.left_out()


def meant(sort: Sort | None, value: object, names: Names) -> Any:
    """Return what a value means; FAULTY if nothing."""
    if sort is None:
        return value
    found: list[Flaw] = []
    return sort.understood(value, (), names, found)


def same(sort: Sort | None, one: object, other: object, names: Names) -> bool:
    """Whether two values of a sort say the same."""
    if one == other and type(one) is type(other):
        return True
    first, second = meant(sort, one, names), meant(sort, other, names)
    if first is FAULTY or second is FAULTY:
        return False
    return alike(first, second, sort is v.ANGLE)


def alike(one: Any, other: Any, angle: bool = False) -> bool:
    """Whether two values that sections mean are the same but for rounding; ``angle``: and for whole turns."""
    if isinstance(one, (float, int, complex)) and isinstance(other, (float, int, complex)):
        if isinstance(one, bool) or isinstance(other, bool):
            return one is other
        apart = abs(one - other)
        apart = min(apart, abs(360.0 - apart)) if angle else apart
        return apart <= NEAR * max(1.0, abs(one)) or (one != one and other != other)
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(alike(one[k], other[k]) for k in one)
    if isinstance(one, (tuple, list)) and isinstance(other, (tuple, list)):
        return len(one) == len(other) and all(map(alike, one, other))
    if is_dataclass(one) and type(one) is type(other):
        pairs = ((getattr(one, f.name), getattr(other, f.name)) for f in fields(one))
        return all(alike(*pair) for pair in pairs)
    return bool(one == other)


def value_at(doc: Document, path: Path) -> Any:
    """Return the value at a path; None if there is none."""
    at: Any = doc
    for part in path:
        try:
            at = at[part]
        except (KeyError, IndexError, TypeError):
            return None
    return at


def sort_at(doc: Document, path: Path) -> Sort | None:
    """Return what may stand at a path of a document; None if nobody says."""
    sort, at = sort_of(str(path[0])), value_at(doc, path[:1])
    for part in path[1:]:
        sort, at = inner(sort, at, part), value_at(at, (part,))
    return sort


def leaves(doc: Document) -> Iterator[tuple[Path, Sort | None, Any]]:
    """Yield every value of a document that is no table and no list of them: its path, its sort, itself."""
    for section, value in doc.items():
        yield from _leaves(sort_of(section), value, (section,))


def _leaves(sort: Sort | None, value: Any, path: Path) -> Iterator[tuple[Path, Sort | None, Any]]:
    items: list[tuple[str | int, Any]] = []
    if isinstance(value, dict):
        items = list(value.items())
    elif isinstance(value, list) and (
        is_point(sort, value) or any(isinstance(one, (dict, list)) for one in value)
    ):
        items = list(enumerate(value))
    if not items:
        yield path, sort, value
    for key, one in items:
        yield from _leaves(inner(sort, value, key), one, (*path, key))
