"""What stands for a key and is a table or a list itself; how a table is understood, key by key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, dataclass
from types import SimpleNamespace
from typing import Any

from graphic_tmm.language.said import joined, said
from graphic_tmm.scene import misfits
from graphic_tmm.scene.declare import (
    FAULTY,
    Flaw,
    Key,
    Kind,
    Names,
    Path,
    Said,
    Schema,
    Sort,
    build,
    keys_of,
)
from graphic_tmm.scene.document import default_text, toml, value_of

MOST = 100
"""So many faults of one table are put into words."""
_EXAMPLES = {
    "points": "{ A = [0, 0] }",
    "slides": '{ on = 3, along = "BC" }',
    "guides": '{ q = { through = [0, 0], angle = "0 deg" } }',
}


@dataclass(frozen=True)
class DeclaredTable:
    """A table that has a declaration of its own."""

    record: type

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return the record of a table, or FAULTY."""
        told = understood(self.record, value, at, names, found)
        return FAULTY if told is None else build(self.record, told)

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return a reference to the schema of the record."""
        name = f"{self.record.__name__}Table"
        if name not in tables:
            tables[name] = table_schema(self.record, name, tables)
        return {"$ref": f"#/$defs/{name}"}


@dataclass(frozen=True)
class Named:
    """A table whose keys are names, each with one sort of value."""

    each: Sort

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return the values by name, or FAULTY."""
        if not isinstance(value, dict):
            return _no_table(value, at, found)
        read = {
            name: self.each.understood(one, (*at, name), names, found)
            for name, one in value.items()
        }
        return FAULTY if any(one is FAULTY for one in read.values()) else read

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return what an editor is told."""
        return {"type": "object", "additionalProperties": self.each.schema(tables)}


@dataclass(frozen=True)
class Several:
    """A list of one sort of value, as a tuple; ``wanted``: what is said where something else stands."""

    each: Sort
    wanted: str = said("a list of tables is wanted, [{ ... }]")

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return the values, or FAULTY."""
        if not isinstance(value, list):
            found.append(Flaw(at, misfits.stands(value, self.wanted)))
            return FAULTY
        read = tuple(
            self.each.understood(one, (*at, i), names, found) for i, one in enumerate(value)
        )
        return FAULTY if any(one is FAULTY for one in read) else read

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return what an editor is told."""
        return {"type": "array", "items": self.each.schema(tables)}


@dataclass(frozen=True)
class ByShape:
    """One sort where a value of the type ``shape`` stands, another elsewhere."""

    shape: type
    such: Sort
    other: Sort

    def understood(self, value: object, at: Path, names: Names, found: list[Flaw]) -> Any:
        """Return what a value means, or FAULTY."""
        sort = self.such if isinstance(value, self.shape) else self.other
        return sort.understood(value, at, names, found)

    def schema(self, tables: dict[str, Schema]) -> Schema:
        """Return what an editor is told."""
        return {"oneOf": [self.other.schema(tables), self.such.schema(tables)]}


def understood(record: type, raw: object, at: Path, names: Names, found: list[Flaw]) -> Said | None:
    """Return what a table says, by key; None if anything but a key that means nothing is wrong.

    What is wrong is put at the end of ``found``.
    """
    if not isinstance(raw, dict):
        _no_table(raw, at, found, record)
        return None
    known: Mapping[str, Key] = keys_of(record)
    others: Sort | None = getattr(record, "OTHERS", None)
    strange = [name for name in raw if name not in known]
    faults: list[Flaw] = []
    values, fine = _known(known, raw, at, names, (set() if others else set(strange), faults))
    if others is not None:
        rest = {name: raw[name] for name in strange}
        values["others"] = Named(others).understood(rest, at, names, faults)
        fine = fine and values["others"] is not FAULTY
    else:
        listed = list(known)
        faults += (Flaw((*at, name), unknown_key(name, listed)) for name in strange[:MOST])
    found += faults[:MOST]
    return SimpleNamespace(**values) if fine else None


def _known(
    known: Mapping[str, Key], raw: Mapping[str, Any], at: Path, names: Names,
    faults: tuple[set[str], list[Flaw]],
) -> tuple[dict[str, Any], bool]:  # fmt: skip
    """Return the values of the keys, and whether they are all there and sound."""
    strange, found = faults
    misspelt = {misfits.near(name, known, 0.6) for name in sorted(strange)[:MOST]}
    values: dict[str, Any] = {}
    fine = True
    for name, one in known.items():
        if name in raw:
            values[name] = one.kind.understood(raw[name], (*at, name), names, found)
        else:
            values[name] = one.left_out()
            if one.default is MISSING and name not in misspelt:
                found.append(Flaw((*at, name), missing_key(name, one)))
        fine = fine and values[name] is not FAULTY and values[name] is not MISSING
    return values, fine


def _no_table(value: object, at: Path, found: list[Flaw], record: type | None = None) -> Any:
    found.append(Flaw(at, misfits.stands(value, _table_wanted(at, record))))
    return FAULTY


def _table_wanted(path: Path, record: type | None) -> str:
    key = next((part for part in reversed(path) if isinstance(part, str)), "")
    example = _EXAMPLES.get(key) or (_example(record) if len(path) > 1 and record else "")
    if example:
        return said("a table is wanted, for example {key} = {example}", key=key, example=example)
    if len(path) == 1:
        return said(
            "a section is wanted: [{name}] on a line of its own, its keys below it", name=path[0]
        )
    return said("a table is wanted, { key = value }")


def _example(record: type) -> str:
    """Return a table with the keys that have to be there; "" if none has."""
    wanted = {k: one.example for k, one in keys_of(record).items() if one.default is MISSING}
    return toml(wanted) if wanted else ""


def unknown_key(name: str, known: list[str]) -> str:
    """Return a key that means nothing here, the one that was probably meant, and all there are."""
    keys = said("keys here are {listed}", listed=", ".join(known))
    meant = misfits.meant(name, known, 0.6)
    there = joined(" ", (meant, keys)) if meant else keys
    return joined("; ", (said('"{name}" means nothing here', name=name), there))


def missing_key(name: str, declared: Key) -> str:
    """Return a key that has to be there, with an example."""
    example = declared.example
    if example is None:
        return said('"{name}" is missing', name=name)
    written = f'"{example}"' if isinstance(example, str) else str(example)
    return said(
        '"{name}" is missing; write for example {name} = {written}', name=name, written=written
    )


def table_schema(record: type, name: str, tables: dict[str, Schema]) -> Schema:
    """Return what an editor is told of a table: its keys, those that have to be there, no others."""
    known = keys_of(record)
    others: Sort | None = getattr(record, "OTHERS", None)
    made: Schema = {
        "additionalProperties": others.schema(tables) if others is not None else False,
        "description": (record.__doc__ or "").partition("\n")[0],
        "properties": {key: key_schema(key, one, tables) for key, one in known.items()},
        "title": name,
        "type": "object",
    }
    if required := [key for key, one in known.items() if one.default is MISSING]:
        made["required"] = required
    return made


def key_schema(name: str, declared: Key, tables: dict[str, Schema]) -> Schema:
    """Return what an editor is told of a key."""
    made = declared.kind.schema(tables)
    if "$ref" not in made:
        made["title"] = name.title().replace("_", " ")
    if declared.says:
        made["description"] = declared.says
    if declared.example is not None:
        made["examples"] = [declared.example]
    if (text := default_text(declared)) is not None:
        made["default"] = value_of(text)
    elif declared.default in ((), "") and isinstance(declared.kind, Kind):
        made["default"] = [] if declared.default == () else ""
    return made
