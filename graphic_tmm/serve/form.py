"""The values of a scene as fields of a form: what is written in the file, and what might be, by section.

A field is a key that takes one value, or a coordinate of a point; its sentence, bounds, choices and default are
those that the section declares. What stands in it is what stands in the file: a text without its quotes, all
else as it is written there.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import MISSING, replace
from itertools import islice
from pathlib import Path as File
from typing import Any, NamedTuple

from graphic_tmm.language.catalogue import SOURCE, Speech, speaking
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Key, Kind, Path, Section, Sort, keys_of
from graphic_tmm.scene.document import Document, as_table, default_text, parsed
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.keys import is_written
from graphic_tmm.scene.lines import Layout, key_of, layout
from graphic_tmm.scene.new import about
from graphic_tmm.scene.quantities import noun_of
from graphic_tmm.scene.sections import LENGTHS, declared
from graphic_tmm.scene.tables import ByShape, DeclaredTable, Named, Several
from graphic_tmm.serve.plainly import place_words


class Field(NamedTuple):
    """A value that may be set.

    ``path``: in the parsed document; ``key``: as people write it. ``text``: what the file has, "" where it has
    nothing (``written`` is False then); ``in_quotes``: it is a text there. ``unit``: what is wanted, in words;
    ``dimension``: as units have it.
    ``kind``: "quantity", "number", "switch", "choice" (one of ``choices``), "list", "text", or "other".
    ``default``: what holds where nothing is written, "" for none. ``wanted``: it has to be written.
    """

    path: Path
    key: str
    label: str
    text: str
    written: bool
    in_quotes: bool
    kind: str
    unit: Said | str = ""
    choices: tuple[str, ...] = ()
    default: str = ""
    says: str = ""
    wanted: bool = False
    dimension: str = ""


def blank(sort: Sort | None, declared: Key | None) -> Field:
    """Return a field in which nothing is written yet."""
    kind = sort if isinstance(sort, Kind) else None
    form, choices = "list" if _is_list(sort) else "other", tuple[str, ...]()
    if kind is not None:
        form, choices = _form_of(kind)
    made = Field((), "", "", "", False, False, form, _unit(kind) if kind else "", choices)
    made = made._replace(dimension=kind.unit if kind else "")
    if declared is None:
        return made
    wanted = declared.default is MISSING
    default = "" if wanted else default_text(declared) or ""
    return made._replace(default=default.strip('"'), says=declared.says, wanted=wanted)


def _is_list(sort: object) -> bool:
    """Tell whether values of a sort are a list that is written as a whole: plain values, tables among them."""
    return isinstance(sort, Several) and isinstance(sort.each, ByShape)


def _form_of(kind: Kind) -> tuple[str, tuple[str, ...]]:
    """Return what a field of a kind is, and what can be chosen in it."""
    told = kind.schema({})
    if "enum" in told:
        return "choice", tuple(told["enum"])
    shapes = {str(one.get("type")) for one in (told, *told.get("anyOf", ()))} - {"None"}
    if "boolean" in shapes:
        return "switch", ("true", "false")
    if "array" in shapes:
        return "list", ()
    if noun_of(kind.unit):
        return "quantity", ()
    if kind.bound is not None:
        return "number", ()
    return ("text" if shapes == {"string"} else "other"), ()


def _unit(kind: Kind) -> Said | str:
    """Return what is wanted, in words: a length; a whole number 1 to 12."""
    noun = noun_of(kind.unit)
    scale = kind.unit.startswith("scale")
    bound = kind.bound.wanted if kind.bound is not None and not scale else ""
    return joined(": ", tuple(filter(None, (noun, bound))))


MOST = 3000
"""So many fields of a file are shown."""
AXES = "xy"


class Group(NamedTuple):
    """The fields of a section, or of one of a list of sections; ``there``: the file has it."""

    title: str
    says: str
    there: bool
    fields: list[Field]


def form(data: bytes, file: File) -> list[Group]:
    """Return the fields of a scene's file, by section; a scene may be as wrong as it likes, if it is TOML.

    Raises
    ------
    SceneError
        If the file is no TOML.
    """
    text, doc = parsed(data, file)
    found = _Written(doc, text, layout(text)).groups()
    return [group for group in found if group.fields]


def form_json(groups: list[Group], language: str) -> list[dict[str, Any]]:
    """Return a form as JSON takes it, in a language."""
    speech = speaking(language)
    return [
        {
            "title": speech(group.title) if isinstance(group.title, Said) else group.title,
            "says": speech(group.says),
            "there": group.there,
            "fields": [_field_json(one, speech) for one in group.fields],
        }
        for group in groups
    ]


def _field_json(one: Field, speech: Speech) -> dict[str, Any]:
    return {
        "key": one.key,
        "label": one.label,
        "place": place_words(one.key, speech),
        "text": one.text,
        "written": one.written,
        "kind": one.kind,
        "unit": speech(one.unit),
        "choices": choices_in(one, speech.language),
        "default": one.default,
        "says": speech(one.says),
        "wanted": one.wanted,
    }


def choices_in(field: Field, language: str) -> list[str]:
    """Return what can be chosen in the words of a language, if it has one for each; what is written stays."""
    latin = language == SOURCE
    own = [one for one in field.choices if one == field.text or is_written(one, latin)]
    other = [one for one in field.choices if is_written(one, not latin)]
    return own if len(own) >= len(other) else list(field.choices)


class _Written(NamedTuple):
    """A file: its tables, its text, and where they stand in it."""

    doc: Document
    text: str
    places: Layout

    def groups(self) -> list[Group]:
        made = [Group(said("The scene"), "", True, self.of(Head, self.doc, ()))]
        if LENGTHS in self.doc:
            made.append(Group(LENGTHS, said("lengths by name"), True, self.lengths()))
        for name, section in declared().items():
            raw, says = self.doc.get(name), _sentence(section)
            either = section.together is not None or section.further is not None
            if section.several or (either and isinstance(raw, list)):
                items = raw if isinstance(raw, list) else []
                for k, item in enumerate(items):
                    at = (name, k)
                    title = " ".join(filter(None, (key_of(self.doc, at), _name(item))))
                    record = section.further if k and section.further else section.record
                    made.append(Group(title, says, True, self.of(record, item, at)))
            elif section.always or name in self.doc:
                there = name in self.doc
                made.append(Group(name, says, there, self.of(section.record, raw, (name,))))
        left = MOST
        for k, group in enumerate(made):
            made[k] = group._replace(fields=group.fields[:left])
            left -= len(made[k].fields)
        return made

    def lengths(self) -> list[Field]:
        fields = self.several(Named(v.PLAIN_LENGTH), self.doc[LENGTHS], (LENGTHS,), (LENGTHS,))
        return list(islice(fields, MOST))

    def of(self, record: type, raw: object, at: Path) -> list[Field]:
        """Return the fields of a section."""
        return list(islice(self.table(record, raw, at, at), MOST))

    def table(self, record: type, raw: object, at: Path, above: Path) -> Iterator[Field]:
        """Yield the fields of a table; ``above``: the path of its section, which labels leave out."""
        there = as_table(raw)
        known = keys_of(record)
        for name, one in known.items():
            if name in there:
                yield from self.sort(one.kind, there[name], (*at, name), above, one)
                continue
            sort = one.kind.other if isinstance(one.kind, ByShape) else one.kind
            if isinstance(sort, Kind) or _is_list(sort):
                yield self.left_out(replace(one, kind=sort), (*at, name), above)
        others: Sort | None = getattr(record, "OTHERS", None)
        if others is not None:
            rest = {name: value for name, value in there.items() if name not in known}
            yield from self.several(Named(others), rest, at, above)

    def sort(
        self, sort: Sort, value: object, at: Path, above: Path, declared: Key | None = None
    ) -> Iterator[Field]:
        if isinstance(sort, ByShape):
            sort = sort.such if isinstance(value, sort.shape) else sort.other
        if isinstance(sort, DeclaredTable) and isinstance(value, dict):
            yield from self.table(sort.record, value, at, above)
        elif isinstance(sort, (Named, Several)) and not _is_list(sort):
            yield from self.several(sort, value, at, above)
        elif _is_point(sort, value):
            assert isinstance(value, list)
            for k, axis in enumerate(AXES):
                yield self.field(v.LENGTH, value[k], (*at, k), above, declared, axis)
        else:
            yield self.field(sort, value, at, above, declared)

    def several(
        self, sort: Named | Several, value: object, at: Path, above: Path
    ) -> Iterator[Field]:
        items: list[tuple[str | int, object]] = []
        if isinstance(value, dict) and isinstance(sort, Named):
            items = list(value.items())
        elif isinstance(value, list) and isinstance(sort, Several):
            items = list(enumerate(value))
        for name, item in items:
            yield from self.sort(sort.each, item, (*at, name), above)

    def field(
        self, sort: Sort, value: object, at: Path, above: Path, declared: Key | None,
        axis: str = "",
    ) -> Field:  # fmt: skip
        kind = sort if isinstance(sort, Kind) else None
        label = _label(at[:-1] if axis else at, above)
        made = blank(kind, declared)
        return made._replace(
            path=at,
            key=key_of(self.doc, at),
            label=f"{label}, {axis}" if axis else label,
            text=value if isinstance(value, str) else self.source(at, value),
            written=True,
            in_quotes=isinstance(value, str),
            kind="list" if isinstance(value, list) else made.kind,
            choices=_with(made.choices, value),
        )

    def left_out(self, declared: Key, at: Path, above: Path) -> Field:
        made = blank(declared.kind, declared)
        return made._replace(path=at, key=key_of(self.doc, at), label=_label(at, above))

    def source(self, at: Path, value: object) -> str:
        """Return a value as the file writes it."""
        begin, end = self.places.values.get(at, (0, 0))
        return self.text[begin:end].replace("\r\n", "\n") or json.dumps(value, default=str)


def _sentence(section: Section) -> str:
    """Return the sentence that says what a section is."""
    return section.says or about(section.record)


def _name(item: object) -> str:
    name = as_table(item).get("name", "")
    return name[:60] if isinstance(name, str) else ""


def _label(at: Path, above: Path) -> str:
    return key_of({}, ("", *at[len(above) :])).removeprefix(".")


def _is_point(sort: Sort, value: object) -> bool:
    """Whether a value is a list of two coordinates, each of which has a field of its own."""
    point = sort is v.POINT or not isinstance(sort, (Kind, DeclaredTable))
    return point and isinstance(value, list) and len(value) == len(AXES)


def _with(choices: tuple[str, ...], value: object) -> tuple[str, ...]:
    """Return choices with what the file has, if that is none of them."""
    odd = bool(choices) and isinstance(value, str) and value not in choices
    return (*choices, str(value)) if odd else choices
