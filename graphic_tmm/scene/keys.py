"""The reference of keys: every section of a scene, told from its declaration in a language.

``keys.md`` is this in English, ``keys.ru.md`` in Russian, as ``graphic-tmm keys`` prints them.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Iterator
from dataclasses import MISSING
from typing import Any

from graphic_tmm.language.catalogue import SOURCE, Speech, speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities, tables
from graphic_tmm.scene.declare import Key, Kind, Section, Sort, keys_of
from graphic_tmm.scene.document import default_text, toml
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.new import about, in_words
from graphic_tmm.scene.sections import LENGTHS, declared
from graphic_tmm.scene.units import UNITS

HEAD = said(
    "# The keys of a scene\n\n"
    "Printed by `graphic-tmm keys` from the declarations of the sections; do not edit it.\n"
    "A number without a unit is in SI (an angle in degrees), a text carries its unit: "
    '`"95 mm"`. A length may be\nnamed in `[{lengths}]` (`r = "0.3 m"`) and then stand in sums, '
    '`"-OB - 1.25 BC"`.\n',
    lengths=LENGTHS,
)
COLUMNS = (said("key"), said("says"), said("value"), said("default"), said("example"))
SHAPES = {
    "boolean": said("true or false"),
    "array": said("a list"),
    "string": said("a text"),
}
FIRST = said("Before the first section")
AS_SHOWN = said("as in the example")
NONE = "-"
BEHIND = said("`[[{name}]]`: those behind the first")


def reference(language: str = SOURCE, only: Collection[str] = ()) -> str:
    """Return the page in a language; ``only``: of these sections, all if there are none."""
    speech, made = speaking(language), list[str]()
    if not only:
        made += [speech(HEAD), *_page(speech(FIRST), "", Head, speech)]
    for name, section in declared().items():
        if name in only or not only:
            made += _page(_headed(section), about(section.record), section.record, speech)
            if section.further is not None:
                behind = speech(BEHIND, name=section.name)
                made += _page(behind, about(section.further), section.further, speech)
    if not only:
        made += _unit_table(speech)
    return "\n".join(made)


def is_written(text: str, latin: bool) -> bool:
    """Whether a text has no letter of the other script."""
    other = "CYRILLIC" if latin else "LATIN"
    return not any(unicodedata.name(sign, "").startswith(other) for sign in text)


def _unit_table(speech: Speech) -> Iterator[str]:
    """Yield the units of every quantity, in each spelling that the language has letters for."""
    yield f"## {speech(said('Units'))}\n"
    yield speech(
        said(
            "A weight may stand for a mass: a kgf is a kg, a lbf a lb, newtons are divided by g. Each unit is "
            "read as other languages write it, too."
        )
    )
    yield f"\n| {speech(said('of'))} | {speech(said('units'))} |\n|---|---|"
    for dimension in dict.fromkeys(unit.dimension for unit in UNITS.values()):
        names = [name for name, unit in UNITS.items() if unit.dimension == dimension]
        known = [one for one in names if is_written(one, speech.language == SOURCE)]
        yield f"| {speech(quantities.article(dimension))} | {', '.join(known)} |"
    yield ""


def _headed(section: Section) -> str:
    single, several = f"`[{section.name}]`", f"`[[{section.name}]]`"
    if section.together is not None:
        return f"{single}, {several}"
    return several if section.several else single


def _page(heading: str, says: str, record: type, speech: Speech) -> Iterator[str]:
    """Yield the lines of a section, then those of the tables that stand in it."""
    yield f"## {heading}\n"
    if says:
        yield f"{speech(says)}\n"
    yield f"| {' | '.join(map(speech, COLUMNS))} |"
    yield "|---|---|---|---|---|"
    inner: dict[str, type] = {}
    for name, one in keys_of(record).items():
        value, example = _value(one.kind, speech), _written(one.example, speech)
        cells = (f"`{name}`", speech(one.says), value, _default(one, speech), example)
        yield "| " + " | ".join(cell.replace("|", "\\|") or NONE for cell in cells) + " |"
        inner.update((table.__name__, table) for table in inner_tables(one.kind))
    yield ""
    for table in inner.values():
        yield from _page(f"{heading}: {speech(called(table))}", about(table), table, speech)


def called(table: type) -> str:
    """Return what a table that stands for a key is, in English: a guide."""
    return quantities.article(table.__name__.lower())


def inner_tables(sort: Sort) -> Iterator[type]:
    """Yield the records of the tables that may stand for a key."""
    if isinstance(sort, tables.DeclaredTable):
        yield sort.record
    elif isinstance(sort, (tables.Named, tables.Several)):
        yield from inner_tables(sort.each)
    elif isinstance(sort, tables.ByShape):
        yield from (*inner_tables(sort.other), *inner_tables(sort.such))


def _value(sort: Sort, speech: Speech) -> str:
    """Return what may stand for a key, in a few words."""
    if isinstance(sort, Kind):
        return _of_kind(sort, speech)
    if isinstance(sort, tables.DeclaredTable):
        return speech(said("a table: {what}"), what=speech(called(sort.record)))
    if isinstance(sort, tables.Named):
        return speech(said("a table by name: {what}"), what=_value(sort.each, speech))
    if isinstance(sort, tables.Several):
        return speech(said("a list: {what}"), what=_value(sort.each, speech))
    assert isinstance(sort, tables.ByShape)
    return speech(
        said("{one}; or {other}"), one=_value(sort.other, speech), other=_value(sort.such, speech)
    )


def _of_kind(kind: Kind, speech: Speech) -> str:
    told = kind.schema({})
    items = told.get("items", {})
    if words := told.get("enum", items.get("enum") if isinstance(items, dict) else None):
        return ", ".join(
            f"`{word}`" for word in words if speech.language != SOURCE or word.isascii()
        )
    shape = SHAPES.get(told.get("type", ""), "") if isinstance(told.get("type"), str) else ""
    bound = (
        kind.bound.wanted if kind.bound is not None and not kind.unit.startswith("scale") else ""
    )
    unit = quantities.article(kind.unit) if kind.unit else ""
    if not (unit or bound) and told.get("type") != "string":
        unit = told.get("description", AS_SHOWN)
    return ": ".join(speech(part) for part in (shape, unit, bound) if part)


def _default(declared: Key, speech: Speech) -> str:
    if declared.default is MISSING:
        return speech(said("**to be written**"))
    text = default_text(declared)
    return NONE if text is None else f"`{text}`"


def _written(value: Any, speech: Speech) -> str:
    """Return a value as a scene file writes it."""
    return NONE if value is None else f"`{toml(in_words(value, speech))}`"


def sentences() -> Iterator[str]:
    """Yield what sections say of themselves, of their keys and of what may stand for these, in English."""
    for record in (Head, *(section.record for section in declared().values())):
        yield from _of_record(record)


def _of_record(record: type) -> Iterator[str]:
    yield about(record)
    for one in keys_of(record).values():
        yield one.says
        yield from _units(one.kind)
        for inner in inner_tables(one.kind):
            yield called(inner)
            yield from _of_record(inner)


def _units(sort: Sort) -> Iterator[str]:
    if isinstance(sort, Kind):
        yield quantities.article(sort.unit) if sort.unit else ""
    elif isinstance(sort, (tables.Named, tables.Several)):
        yield from _units(sort.each)
    elif isinstance(sort, tables.ByShape):
        yield from (*_units(sort.other), *_units(sort.such))
