"""The sections that a task may give besides the mechanism, as the form beside its scheme asks for them."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path as File
from typing import Any

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import Kind, Section, keys_of
from graphic_tmm.scene.document import Document, as_table, toml
from graphic_tmm.scene.new import about, example_of
from graphic_tmm.scene.sections import declared
from graphic_tmm.scene.splice import Unplaced, with_table
from graphic_tmm.scene.tables import ByShape
from graphic_tmm.serve.edit import source_of
from graphic_tmm.serve.form import Field, blank, choices_in

GEOMETRY = ("task", "frame", "joints", "link", "drive")
"""What the scheme itself gives."""


def offered(doc: Document, speech: Speech) -> list[dict[str, Any]]:
    """Return the sections that a scene of a mechanism may have besides, with their keys, as JSON takes them."""
    return [
        {
            "name": section.name,
            "says": speech(section.says or about(section.record)),
            "keys": [
                _key(name, field, example, speech)
                for name, field, example in _fields(section, speech)
            ],
            "there": _there(section.name, doc),
        }
        for section in declared().values()
        if _may_be_added(section, doc)
    ]


def _there(name: str, doc: Document) -> list[str]:
    """Return what a scene has of a section that may stand several times, a line each."""
    tables = doc.get(name)
    return [
        ", ".join(f"{k} = {v if isinstance(v, str) else toml(v)}" for k, v in as_table(one).items())
        for one in (tables if isinstance(tables, list) else ())
    ]


def _may_be_added(section: Section, doc: Document) -> bool:
    if section.name in GEOMETRY or (section.alone and not section.gives):
        return False
    return section.several or section.name not in doc


def _fields(section: Section, speech: Speech) -> Iterator[tuple[str, Field, str]]:
    """Yield the keys of a section that take one value, what has to be written first."""
    found = []
    for name, key in keys_of(section.record).items():
        sort = key.kind.other if isinstance(key.kind, ByShape) else key.kind
        if isinstance(sort, Kind):
            found.append((name, blank(sort, key), example_of(key, speech) or ""))
    yield from sorted(found, key=lambda one: not one[1].wanted)


def _key(name: str, field: Field, example: str, speech: Speech) -> dict[str, Any]:
    return {
        "name": name,
        "says": speech(field.says),
        "choices": choices_in(field, speech.language),
        "example": example.strip('"'),
        "wanted": field.wanted,
    }


def with_section(text: str, name: str, typed: Mapping[str, str], file: File, speech: Speech) -> str:
    """Return a scene's text with one more section, its values as they were typed; empty ones are left out.

    Raises
    ------
    SceneError
        If there is no such section, or the text cannot take it.
    """
    section = declared().get(name)
    if section is None or not _may_be_added(section, tomllib.loads(text)):
        raise SceneError(str(file), (Fault(name[:40], 0, said("there is no such section to add")),))
    fields = {key: field for key, field, _ in _fields(section, speech)}
    table = {
        key: tomllib.loads(f"x = {source_of(value, fields[key], text)}")["x"]
        for key, value in typed.items()
        if key in fields and value.strip()
    }
    try:
        return with_table(text, name, table, several=section.several)
    except Unplaced:
        says = said("this cannot be set here; change it in the file itself")
        raise SceneError(str(file), (Fault(name, 0, says),)) from None
