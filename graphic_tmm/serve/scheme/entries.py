"""Values as people enter them where the file has lists: entries with commas between, tables, boxes to tick.

A table is sent row by row, ``0: 0 N; 90: 190 N``; a comma between figures is one of a number.
"""

from __future__ import annotations

import re
import tomllib
from typing import Any, NamedTuple

from graphic_tmm.scene.declare import Kind
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.splice import literal
from graphic_tmm.serve.edit import source_of
from graphic_tmm.serve.form import Field
from graphic_tmm.serve.plainly import entry_text
from graphic_tmm.serve.scheme.units import is_bare, with_unit

ROW, TABLE, TICKED = "row", "table", "ticked"
_BETWEEN = re.compile(r"[;\n]")
_COMMA = re.compile(r"(?<![0-9]),|,(?![0-9])")
_WHOLE = re.compile(r"[0-9]+(?:\s*,\s*[0-9]+)+")


class FormKey(NamedTuple):
    """A key of a section that is asked for: its name, as a field, an example of it.

    ``form``: `ROW`, `TABLE` or `TICKED` of a list, "" of one value. ``words``: what stands for a whole list.
    """

    name: str
    field: Field
    example: str
    form: str = ""
    words: tuple[str, ...] = ()


def form_key(name: str, field: Field, kind: Kind, example: str) -> FormKey:
    """Return how a key is asked for."""
    told = kind.schema({})
    several = [told, *told.get("anyOf", ())]
    lists = [one for one in several if one.get("type") == "array"]
    words = tuple(one["const"] for one in several if "const" in one)
    value = literal(example)
    shown = entry_text(value if isinstance(value, list) else example.strip('"'))
    if field.kind != "list" or not lists or len(several) - len(words) - len(lists) > 1:
        return FormKey(name, field, shown)
    items = lists[0].get("items", {})
    if "enum" in items:
        return FormKey(name, field._replace(choices=tuple(items["enum"])), "", TICKED)
    table = isinstance(value, list) and any(isinstance(one, list) for one in value)
    return FormKey(name, field, shown, TABLE if table else ROW, words)


def entered(typed: str, asked: FormKey, doc: Document, text: str) -> Any:
    """Return the value that was entered for a key; a list of TOML is one, too."""
    typed, field = typed.strip(), asked.field
    if not asked.form or typed in asked.words or isinstance(literal(typed), list):
        source = source_of(with_unit(typed, field, doc), field, text)
        return tomllib.loads(f"x = {source}")["x"]
    rows = [one.strip() for one in _BETWEEN.split(typed) if one.strip()]
    if asked.form == TABLE:
        return [[_value(cell, field, doc) for cell in row.split(":", 1)] for row in rows]
    between = "," if _WHOLE.fullmatch(typed) else _COMMA
    pieces = (one for row in rows for one in re.split(between, row))
    return [_value(one, field, doc) for one in pieces if one.strip()]


def _value(typed: str, field: Field, doc: Document) -> Any:
    typed = typed.strip()
    if not is_bare(typed):
        return typed
    told = with_unit(typed, field._replace(kind="quantity"), doc) if field.dimension else typed
    return literal(told.replace(",", ".")) if is_bare(told) else told
