"""The reference of keys: every section of a scene, told from its declaration. ``keys.md`` is this, printed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import MISSING

from graphic_tmm.scene import quantities, tables
from graphic_tmm.scene.declare import Key, Kind, Section, Sort, keys_of
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.sections import LENGTHS, declared
from graphic_tmm.scene.units import UNITS
from graphic_tmm.scene.written import default_text, toml

HEAD = f"""# The keys of a scene

Printed by `python -m graphic_tmm.scene.keys` from the declarations of the sections; do not edit it.
A number without a unit is in SI (an angle in degrees), a text carries its unit: `"95 mm"`. A length may be
named in `[{LENGTHS}]` (`r = "0.3 m"`) and then stand in sums, `"-OB - 1.25 BC"`.
"""
NONE = "-"


def reference() -> str:
    """Return the page."""
    made = [HEAD, *_page("Before the first section", "", Head)]
    for section in declared().values():
        first = (section.record.__doc__ or "").partition("\n")[0]
        made += _page(_headed(section), first, section.record)
    return "\n".join((*made, *_units()))


def _units() -> Iterator[str]:
    """Yield the units of every quantity, in each spelling that is read."""
    yield "## Units\n"
    yield "A weight may stand for a mass: a kgf is a kg, a lbf a lb, newtons are divided by g.\n"
    yield "| of | units |"
    yield "|---|---|"
    for dimension in dict.fromkeys(unit.dimension for unit in UNITS.values()):
        known = (name for name, unit in UNITS.items() if unit.dimension == dimension)
        yield f"| {quantities.article(dimension)} | {', '.join(known)} |"
    yield ""


def _headed(section: Section) -> str:
    return f"`[[{section.name}]]`" if section.several else f"`[{section.name}]`"


def _page(heading: str, says: str, record: type) -> Iterator[str]:
    """Yield the lines of a section, then those of the tables that stand in it."""
    yield f"## {heading}\n"
    if says:
        yield f"{says}\n"
    yield "| key | says | value | default | example |"
    yield "|---|---|---|---|---|"
    inner: dict[str, type] = {}
    for name, one in keys_of(record).items():
        cells = (f"`{name}`", one.says, _value(one.kind), _default(one), _example(one))
        yield "| " + " | ".join(cell.replace("|", "\\|") or NONE for cell in cells) + " |"
        inner.update((table.__name__, table) for table in inner_tables(one.kind))
    yield ""
    for name, table in inner.items():
        yield from _page(
            f"{heading}: {quantities.article(name.lower())}",
            (table.__doc__ or "").partition("\n")[0],
            table,
        )


def inner_tables(sort: Sort) -> Iterator[type]:
    """Yield the records of the tables that may stand for a key."""
    if isinstance(sort, tables.Table):
        yield sort.record
    elif isinstance(sort, (tables.Named, tables.Several)):
        yield from inner_tables(sort.each)
    elif isinstance(sort, tables.ByShape):
        yield from (*inner_tables(sort.other), *inner_tables(sort.such))


def _value(sort: Sort) -> str:
    """Return what may stand for a key, in a few words."""
    if isinstance(sort, Kind):
        return _of_kind(sort)
    if isinstance(sort, tables.Table):
        return f"a table: {quantities.article(sort.record.__name__.lower())}"
    if isinstance(sort, tables.Named):
        return f"a table by name: {_value(sort.each)}"
    if isinstance(sort, tables.Several):
        return f"a list: {_value(sort.each)}"
    assert isinstance(sort, tables.ByShape)
    return f"{_value(sort.other)}; or {_value(sort.such)}"


def _of_kind(kind: Kind) -> str:
    told = kind.schema({})
    items = told.get("items", {})
    if words := told.get("enum", items.get("enum") if isinstance(items, dict) else None):
        return ", ".join(f"`{word}`" for word in words)
    shapes = {"boolean": "true or false", "array": "a list", "string": "a text"}
    shape = shapes.get(told.get("type", ""), "") if isinstance(told.get("type"), str) else ""
    bound = (
        kind.bound.wanted if kind.bound is not None and not kind.unit.startswith("scale") else ""
    )
    unit = quantities.article(kind.unit) if kind.unit else ""
    if not (unit or bound) and told.get("type") != "string":
        unit = told.get("description", "as in the example")
    return ": ".join(part for part in (shape, unit, bound) if part)


def _example(declared: Key) -> str:
    return NONE if declared.example is None else f"`{toml(declared.example)}`"


def _default(declared: Key) -> str:
    if declared.default is MISSING:
        return "**to be written**"
    text = default_text(declared)
    return NONE if text is None else f"`{text}`"


if __name__ == "__main__":
    print(reference(), end="")
