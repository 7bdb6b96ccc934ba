"""The JSON Schema of scene files, which editors read, from the declarations of the sections."""

from __future__ import annotations

from dataclasses import MISSING
from typing import Any

from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import Said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Schema, Section, keys_of
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.sections import LENGTHS, declared
from graphic_tmm.scene.tables import Named, key_schema, table_schema


def schema() -> Schema:
    """Return the JSON Schema of a scene file, as shipped in ``scene.schema.json``."""
    tables: dict[str, Schema] = {}
    head = keys_of(Head)
    properties: dict[str, Any] = {name: key_schema(name, one, tables) for name, one in head.items()}
    lengths = Named(v.PLAIN_LENGTH).schema(tables)
    properties[LENGTHS] = {**lengths, "description": "named lengths", "title": "Lengths"}
    for name, section in declared().items():
        properties[name] = _section(section, tables)
    return {
        "$defs": dict(sorted(tables.items())),
        "additionalProperties": False,
        "description": "A scene of graphic_tmm: a mechanism, its drive, and what is drawn of it.",
        "properties": properties,
        "required": [name for name, one in head.items() if one.default is MISSING],
        "title": "SceneFile",
        "type": "object",
    }


def in_language(part: Any, speech: Speech) -> Any:
    """Return a schema, or a part of one, with what it says to people in a language."""
    if isinstance(part, dict):
        return {
            name: speech(one) if name == "description" else in_language(one, speech)
            for name, one in part.items()
        }
    if isinstance(part, list):
        return [in_language(one, speech) for one in part]
    return speech(part) if isinstance(part, Said) else part


def _section(section: Section, tables: dict[str, Schema]) -> Schema:
    words = section.name.title()
    name = f"{words.replace('_', '')}Table"
    tables[name] = table_schema(section.record, name, tables)
    made: Schema = {"$ref": f"#/$defs/{name}"}
    if section.several:
        made = {"type": "array", "items": made, "title": words.replace("_", " ")}
    return {**made, "description": section.says} if section.says else made
