"""A scene to begin with: the copy of another one, or a mechanism with all that may be added as comments."""

from __future__ import annotations

import json
import re
from collections.abc import Container, Iterator, Mapping

from graphic_tmm.paper.formats import AUTO
from graphic_tmm.scene.declare import Key, Section, keys_of
from graphic_tmm.scene.letters import POLES
from graphic_tmm.scene.read import FILE
from graphic_tmm.scene.schema import schema
from graphic_tmm.scene.sections import declared
from graphic_tmm.scene.written import default_text, toml

SCHEMA = "scene.schema.json"
KEPT = f"# The letters {', '.join(POLES)} are kept for the poles of plans: call a point K, or P1.\n"
MANNER = ("scales", "hand", "sheet", "title_block", "note")
"""The sections that say how a mechanism is drawn and noted, not what it is."""
WIDTH = 36
"""Where what a key says stands behind it, characters."""
_HEAD = re.compile(rf"^#:schema .*\n(?:{re.escape(KEPT)})?", re.MULTILINE)
_SECTION = re.compile(r"^\[+(\w+)", re.MULTILINE)


def begun(text: str) -> dict[str, str]:
    """Return the files of a new scene by name.

    ``text``: of the scene that is copied; the line that leads editors to the schema leads to the folder's own.
    """
    return {FILE: f"#:schema {SCHEMA}\n{KEPT}{_HEAD.sub('', text)}", SCHEMA: schema_text()}


def begun_with(text: str, title: str, language: str, remark: str) -> dict[str, str]:
    """Return the files of a new scene by name: what a scene is of, under a title and in a language of its own.

    ``text``: of the scene that it is taken from. How that is drawn is left out; each section that it does not
    have stands behind it as a comment, with defaults and examples, under ``remark``.
    """
    parts = dict(_parts(text))
    kept = "".join(part for name, part in parts.items() if name and name not in MANNER)
    head = f"title    = {toml(title)}\nlanguage = {toml(language)}\n\n"
    others = "\n".join(_examples(parts.keys() - set(MANNER)))
    sheet = f"[[sheet]]\nformat = {toml(AUTO)}"
    return begun(f"{head}{kept.strip()}\n\n{sheet}\n\n# {remark}\n\n{others}")


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


def _examples(there: Container[str]) -> Iterator[str]:
    """Yield the lines of the sections that are not there, as comments."""
    for section in declared().values():
        if section.name in there:
            continue
        keys = {
            name: one for name, one in keys_of(section.record).items() if shown(one) is not None
        }
        if keys:
            yield from (f"# {line}".rstrip() for line in _example(section, keys))
            yield ""


def _example(section: Section, keys: Mapping[str, Key]) -> Iterator[str]:
    head = f"[[{section.name}]]" if section.several else f"[{section.name}]"
    says = (section.record.__doc__ or "").partition("\n")[0]
    yield f"{head:<{WIDTH}} # {says}"
    for name, one in keys.items():
        yield f"{f'{name} = {shown(one)}':<{WIDTH}} # {one.says}"


def shown(one: Key) -> str | None:
    """Return a key's default as a scene writes it, or its example if it has none; None if there is neither."""
    default = default_text(one)
    return toml(one.example) if default is None and one.example is not None else default


def schema_text() -> str:
    """Return the JSON Schema of scenes as it is printed and shipped."""
    return json.dumps(schema(), ensure_ascii=False, indent=2) + "\n"
