"""A scene to begin with, with what may be added as comments; the JSON Schema of scenes, for editors."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import MISSING
from typing import Any

from graphic_tmm.language.catalogue import SOURCE, Speech, languages, speaking
from graphic_tmm.language.said import Said, said
from graphic_tmm.paper.formats import AUTO
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Key, Schema, Section, keys_of
from graphic_tmm.scene.document import default_text, toml
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.letters import POLES
from graphic_tmm.scene.packaged import FILE
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
    if section.further is not None:
        behind = f"{section.further.__name__}Table"
        tables[behind] = table_schema(section.further, behind, tables)
        either = {"anyOf": [made, {"$ref": f"#/$defs/{behind}"}]}
        made = {"anyOf": [made, {"type": "array", "items": either}]}
    if section.together is not None:
        made = {"oneOf": [made, {"type": "array", "items": made, "minItems": 1}]}
    if section.several:
        made = {"type": "array", "items": made, "title": words.replace("_", " ")}
    return {**made, "description": section.says} if section.says else made


SCHEMA = "scene.schema.json"
KEPT = said(
    "The letters {letters} are kept for the poles of plans: call a point K, or P1.",
    letters=", ".join(POLES),
)
OTHERS = said("What may be added; take the # away from the lines that you want.")
MANNER = ("scales", "hand", "sheet", "title_block", "note")
"""The sections that say how a mechanism is drawn and noted, not what it is."""
WIDTH = 36
"""Where what a key says stands behind it, characters."""
REMARK = re.compile(r"(?<=# ).+")
"""What stands behind a sign of comments."""
_NAME = re.compile(r'(?<=^name)( *= *")([^"]+)', re.MULTILINE)
_SECTION = re.compile(r"^\[+(\w+)", re.MULTILINE)


def begun(text: str, speech: Speech) -> dict[str, str]:
    """Return the files of a new scene by name, with what leads editors and authors in a language.

    ``text``: of the scene that is copied; the line that leads editors to the schema leads to the folder's own.
    """
    kept = "|".join(re.escape(f"# {speaking(one)(KEPT)}\n") for one in languages())
    told = re.sub(rf"^#:schema .*\n(?:{kept})?", "", text, flags=re.MULTILINE)
    head = f"#:schema {SCHEMA}\n# {speech(KEPT)}\n"
    return {FILE: f"{head}{told}", SCHEMA: schema_text(speech.language)}


def begun_with(
    text: str, title: str, speech: Speech, link_name: Callable[[str, Speech], str]
) -> dict[str, str]:
    """Return the files of a new scene by name: what a scene is of, under a title, all in a language.

    ``text``: of the scene that it is taken from. How that is drawn is left out; each section that it does not
    have stands behind it as a comment, with defaults and examples. ``link_name``: of a link, in a language.
    """
    kept = REMARK.sub(lambda found: speech(found[0]), mechanism_of(text))
    kept = _NAME.sub(lambda found: f"{found[1]}{link_name(found[2], speech)}", kept)
    head = f"title    = {toml(speech(title))}\nlanguage = {toml(speech.language)}\n\n"
    others = "\n".join(_examples(dict(_parts(kept)), speech))
    sheet = f"[[sheet]]\nformat = {toml(AUTO)}"
    return begun(f"{head}{kept.strip()}\n\n{sheet}\n\n# {speech(OTHERS)}\n\n{others}", speech)


def mechanism_of(text: str) -> str:
    """Return the sections of a scene that say what it is, not how it is drawn."""
    return "".join(part for name, part in _parts(text) if name and name not in MANNER)


def _parts(text: str) -> Iterator[tuple[str, str]]:
    """Yield the sections of a scene by name, "" before the first; a list of tables is one."""
    found: dict[str, str] = {}
    name, lines = "", list[str]()
    for line in text.splitlines(keepends=True):
        if head := _SECTION.match(line):
            before = len(lines)
            while before and lines[before - 1].startswith("#"):
                before -= 1
            found[name] = found.get(name, "") + "".join(lines[:before])
            name, lines = head[1], lines[before:]
        lines.append(line)
    found[name] = found.get(name, "") + "".join(lines)
    yield from found.items()


def _examples(there: Container[str], speech: Speech) -> Iterator[str]:
    """Yield the lines of the sections that are not there, as comments."""
    for section in declared().values():
        if section.name in there:
            continue
        keys = {
            name: value
            for name, one in keys_of(section.record).items()
            if (value := example_of(one, speech)) is not None
        }
        if keys:
            yield from (f"# {line}".rstrip() for line in _example(section, keys, speech))
            yield ""


def _example(section: Section, keys: Mapping[str, str], speech: Speech) -> Iterator[str]:
    head = f"[[{section.name}]]" if section.several else f"[{section.name}]"
    yield f"{head:<{WIDTH}} # {speech(about(section.record))}"
    known = keys_of(section.record)
    for name, value in keys.items():
        yield f"{f'{name} = {value}':<{WIDTH}} # {speech(known[name].says)}"


def about(record: type) -> str:
    """Return the sentence that says what a record is, in English."""
    return (record.__doc__ or "").partition("\n")[0]


def example_of(one: Key, speech: Speech) -> str | None:
    """Return a key's default as a scene writes it, or its example if it has none; None if there is neither."""
    default = default_text(one)
    return default or (None if one.example is None else toml(in_words(one.example, speech)))


def in_words(value: Any, speech: Speech) -> Any:
    """Return an example in a language: what was said is told in it, all else is written alike everywhere."""
    if isinstance(value, list):
        return [in_words(one, speech) for one in value]
    return speech(value) if isinstance(value, Said) else value


def schema_text(language: str = SOURCE) -> str:
    """Return the JSON Schema of scenes as it is printed in a language, and shipped in English."""
    return (
        json.dumps(in_language(schema(), speaking(language)), ensure_ascii=False, indent=2) + "\n"
    )
