"""The sections that a task may give besides the mechanism, as the form beside its scheme asks for them."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path as File
from typing import Any

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import places
from graphic_tmm.scene.declare import Kind, Section, keys_of
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.scene.new import about, example_of
from graphic_tmm.scene.registry import called
from graphic_tmm.scene.sections import declared
from graphic_tmm.scene.splice import Unplaced, with_table
from graphic_tmm.scene.tables import ByShape
from graphic_tmm.serve.form import blank, choices_in
from graphic_tmm.serve.plainly import clause, entry_text
from graphic_tmm.serve.scheme.entries import ROW, TICKED, FormKey, entered, form_key
from graphic_tmm.serve.scheme.units import unit_shown

GEOMETRY = ("task", "frame", "joints", "link", "drive")
"""What the scheme itself gives."""


def offered(doc: Document, speech: Speech) -> list[dict[str, Any]]:
    """Return the sections that a scene of a mechanism may have besides, with their keys, as JSON takes them."""
    return [
        {
            "name": section.name,
            "says": speech(section.says or about(section.record)),
            "keys": [_key(asked, doc, speech) for asked in _fields(section, speech)],
            "there": _there(section, doc, speech),
        }
        for section in declared().values()
        if _may_be_added(section, doc)
    ]


def _there(section: Section, doc: Document, speech: Speech) -> list[str]:
    """Return what a scene has of a section that may stand several times, a line each."""
    tables, keys = doc.get(section.name), keys_of(section.record)
    return [
        "; ".join(
            f"{clause(speech(keys[k].says)) if k in keys else k}: {entry_text(v)}"
            for k, v in as_table(one).items()
        )
        for one in (tables if isinstance(tables, list) else ())
    ]


def _may_be_added(section: Section, doc: Document) -> bool:
    if section.name in GEOMETRY or (section.alone and not section.gives):
        return False
    return section.several or section.name not in doc


@cache
def _fields(section: Section, speech: Speech) -> tuple[FormKey, ...]:
    """Return the keys of a section that take one value or a list, what has to be written first."""
    found = []
    for name, key in keys_of(section.record).items():
        sort = key.kind.other if isinstance(key.kind, ByShape) else key.kind
        if isinstance(sort, Kind):
            found.append(form_key(name, blank(sort, key), sort, example_of(key, speech) or ""))
    return tuple(sorted(found, key=lambda one: not one.field.wanted))


def _key(asked: FormKey, doc: Document, speech: Speech) -> dict[str, Any]:
    field = asked.field
    choices = {one: one for one in choices_in(field, speech.language)}
    if field.kind == "switch":
        choices = dict(zip(choices, (speech(said("yes")), speech(said("no"))), strict=True))
    elif asked.form == TICKED:
        choices = _shown_on_sheets(doc, speech.language)
    measured = field.kind == "quantity" or asked.form == ROW
    return {
        "name": asked.name,
        "says": speech(field.says),
        "form": asked.form,
        "choices": list(map(list, choices.items())),
        "example": asked.example,
        "unit": unit_shown(field, doc, speech.language) if measured else "",
        "wanted": field.wanted,
    }


def _shown_on_sheets(doc: Document, language: str) -> dict[str, str]:
    """Return what sheets can show of a scene, by name, as people call it, if they have a word for it."""
    words = captions(language)
    return {
        name: words[name]
        for name, (chapter, _) in places().items()
        if name in words and called(chapter, doc.keys(), mechanism=True)
    }


def with_section(text: str, name: str, typed: Mapping[str, str], file: File, speech: Speech) -> str:
    """Return a scene's text with one more section, its values as they were typed; empty ones are left out.

    Raises
    ------
    SceneError
        If there is no such section, or the text cannot take it.
    """
    section, doc = declared().get(name), tomllib.loads(text)
    if section is None or not _may_be_added(section, doc):
        raise SceneError(str(file), (Fault(name[:40], 0, said("there is no such section to add")),))
    fields = {one.name: one for one in _fields(section, speech)}
    table = {
        key: entered(value, fields[key], doc, text)
        for key, value in typed.items()
        if key in fields and value.strip()
    }
    try:
        return with_table(text, name, table, several=section.several)
    except Unplaced:
        says = said("this cannot be set here; change it in the file itself")
        raise SceneError(str(file), (Fault(name, 0, says),)) from None
