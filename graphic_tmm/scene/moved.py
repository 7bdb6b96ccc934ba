"""A scene's text with sections that say something else: what says the same stays as it was typed.

Values are compared by what they mean (`meaning`), each that differs is set by itself (`splice`); a link that is
no more goes with its block, a new one comes behind the last. Comments, order and line ends stay.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from graphic_tmm.scene.declare import Names, Path, Sort
from graphic_tmm.scene.document import Document, toml
from graphic_tmm.scene.meaning import (
    alike,
    inner,
    is_point,
    left_out,
    meant,
    same,
    sort_at,
    sort_of,
    value_at,
)
from graphic_tmm.scene.mechanism import DIGITS
from graphic_tmm.scene.named_lengths import name_at, places_of, solved
from graphic_tmm.scene.quantities import NUMBER, measuring
from graphic_tmm.scene.sections import LENGTHS, lengths_of, measures
from graphic_tmm.scene.splice import Unplaced, as_list, set_to, with_table, without_table
from graphic_tmm.scene.units import UNITS, plain_unit

MARK = "\ufeff"
"""What some editors put before the first character of a file in UTF-8."""
_WRITTEN = re.compile(rf"\s*[+-]?{NUMBER}(\s*)(.*?)\s*")
Changes = Iterator[tuple[Path, Any]]


def rewritten(text: str, tables: Mapping[str, Any], *, everywhere: bool = False) -> str:
    """Return a scene's text in which sections say what tables say; what says so already is not touched.

    Parameters
    ----------
    text : str
        The scene.
    tables : mapping of str to table or list of tables
        The sections that shall stand there, whole, as tomllib would read them; others stay. Links go by their
        numbers.
    everywhere : bool
        Whether a length that is named in several places (`uses`) changes in all of them; else here alone.

    Raises
    ------
    Unplaced
        If the text is laid out so that something cannot be set, put in or taken out, or if a length that a task
        gives shall change everywhere.
    """
    if text.startswith(MARK):
        return MARK + rewritten(text.removeprefix(MARK), tables, everywhere=everywhere)
    doc = tomllib.loads(text)
    with measuring(measures(doc)):
        changes = list(_changes(doc, tables, lengths_of({**doc, **tables})))
        text = _with_lengths(text, doc, changes, everywhere)
        text = _with_values(text, changes)
        return _with_tables(text, tables)


def uses(text: str, path: Path) -> tuple[Path, ...]:
    """Return where the named length stands by which a value is told, or that which is named at a path.

    () of a value by no name, or by several.
    """
    doc = tomllib.loads(text.removeprefix(MARK))
    with measuring(measures(doc)):
        name = path[1] if path[:1] == (LENGTHS,) else name_at(doc, path)
        return () if name is None else places_of(doc, str(name))


@dataclass(frozen=True)
class _Pairing:
    """The tables of a list, by number in it, as they shall be; ``gone``, ``fresh``: those that go and come."""

    there: tuple[tuple[int, Document], ...]
    gone: tuple[int, ...]
    fresh: tuple[Document, ...]


def _paired(section: str, old: list[Any], new: list[Any]) -> _Pairing:
    """Return which tables of two lists belong together: by number, or in their order."""

    def known(tables: list[Any]) -> dict[object, Any]:
        return {one.get("number") if section == "link" else k: one for k, one in enumerate(tables)}

    was, will = known(old), known(new)
    return _Pairing(
        tuple((k, will[key]) for k, key in enumerate(was) if key in will),
        tuple(k for k, key in enumerate(was) if key not in will),
        tuple(one for key, one in will.items() if key not in was),
    )


def _changes(doc: Document, tables: Mapping[str, Any], names: Names) -> Changes:
    """Yield the values that differ, each with its path; None of what is left out."""
    for section, new in tables.items():
        sort, old = sort_of(section), doc.get(section)
        if isinstance(old, list) and isinstance(new, list):
            for k, table in _paired(section, old, new).there:
                one = inner(sort, old, k)
                yield from _differing(one, old[k], table, (section, k), names)
        elif isinstance(old, dict) and isinstance(new, list):
            yield from _differing(sort, old, new[0], (section,), names)
        elif old is not None:
            yield from _differing(sort, old, new, (section,), names)


def _differing(sort: Sort | None, old: Any, new: Any, path: Path, names: Names) -> Changes:
    if same(sort, old, new, names):
        return
    if isinstance(old, dict) and isinstance(new, list) and len(new) == 1:
        new = new[0]
    if isinstance(old, dict) and isinstance(new, dict):
        for key in dict.fromkeys((*old, *new)):
            one, default = inner(sort, old, key), left_out(sort, old, key)
            if key in old and key in new:
                yield from _differing(one, old[key], new[key], (*path, key), names)
            elif not alike(meant(one, old.get(key, new.get(key)), names), default):
                yield (*path, key), new.get(key)
        return
    lists = isinstance(old, list) and isinstance(new, list) and len(old) == len(new)
    if lists and (is_point(sort, old) or any(isinstance(one, dict) for one in old)):
        for k, (was, will) in enumerate(zip(old, new, strict=True)):
            yield from _differing(inner(sort, old, k), was, will, (*path, k), names)
        return
    yield path, new


def _with_lengths(
    text: str, doc: Document, changes: list[tuple[Path, Any]], everywhere: bool
) -> str:
    """Return a text whose named lengths are such that values by them are what they shall be."""
    own = doc.get(LENGTHS, {})
    told = set[str]()
    for path, new in changes:
        name = None if new is None else name_at(doc, path)
        if name is None or name in told:
            continue
        several = len(places_of(doc, name)) > 1
        if several and not everywhere:
            continue
        if name not in own:
            if several:
                raise Unplaced(path)
            continue
        told.add(name)
        length = solved(doc, path, name, new)
        if length is not None:
            text = set_to(text, (LENGTHS, name), _length(length, own[name]))
    return text


def _with_values(text: str, changes: list[tuple[Path, Any]]) -> str:
    """Return a text with values that differ; those that named lengths have changed already are left.

    What goes does so last: a table of dotted keys is there as long as it has one.
    """
    doc = tomllib.loads(text)
    names = lengths_of(doc)
    for path, new in sorted(changes, key=lambda change: change[1] is None):
        old, sort = value_at(doc, path), sort_at(doc, path)
        if new is None:
            text = _without(text, path)
        elif old is None or not same(sort, old, new, names):
            text = set_to(text, path, _source(new, old))
    return text


def _without(text: str, path: Path) -> str:
    try:
        return set_to(text, path, None)
    except Unplaced:
        return without_table(text, path)


def _source(new: object, old: object) -> str:
    """Return a value as TOML writes it: a length in mm in the unit that it had."""
    millimetres = _WRITTEN.fullmatch(new) if isinstance(new, str) else None
    if millimetres is not None and millimetres[2] == "mm" and isinstance(old, (str, int, float)):
        return _length(float(str(new).split()[0]) / 1000.0, old)
    return toml(new)


def _length(metres: float, like: object) -> str:
    """Return a length as TOML writes it, in the unit of another, or as a number if that is one."""
    if isinstance(like, (int, float)) and like:
        return f"{metres:.{DIGITS}g}"
    written = _WRITTEN.fullmatch(like) if isinstance(like, str) else None
    unit = UNITS.get(plain_unit(written[2])) if written is not None else None
    if written is None or unit is None or unit.dimension != "length":
        return toml(f"{1000.0 * metres:.{DIGITS}g} mm")
    number = f"{metres / float(unit.factor):.{DIGITS}g}"
    number = number.replace(".", ",") if "," in str(like) else number
    return toml(f"{number}{written[1]}{written[2]}")


def _with_tables(text: str, tables: Mapping[str, Any]) -> str:
    """Return a text without the tables of lists that are no more, with those that are new, and new sections."""
    doc = tomllib.loads(text)
    for section, new in tables.items():
        old = doc.get(section)
        if isinstance(old, dict) and isinstance(new, list) and len(new) > 1:
            text, old = as_list(text, section), [old]
        if isinstance(old, list) and isinstance(new, list):
            pairing = _paired(section, old, new)
            for k in reversed(pairing.gone):
                text = without_table(text, (section, k))
            for table in pairing.fresh:
                text = with_table(text, section, table, several=True)
        elif old is None:
            for table in new if isinstance(new, list) else [new]:
                text = with_table(text, section, table, several=isinstance(new, list))
    return text
