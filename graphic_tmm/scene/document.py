"""A TOML file as its text and tables; what is wrong with a text that is none; values as TOML writes them."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import MISSING
from pathlib import Path
from pkgutil import resolve_name
from typing import Any, NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.files import Kind, read
from graphic_tmm.language.catalogue import languages
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.declare import Flaw, Key, Section
from graphic_tmm.scene.declare import Path as Place
from graphic_tmm.scene.letters import latin
from graphic_tmm.scene.misfits import truth

LOOKED = 256_000
"""So many characters of a scene are looked through for its language."""
_LANGUAGE = re.compile(r"""^language\s*=\s*["'](\w+)["']""", re.MULTILINE)


def spoken(text: str) -> str:
    """Return the language that a text asks for; "" if none that there is."""
    found = _LANGUAGE.search(text[:LOOKED])
    return found[1] if found is not None and found[1] in languages() else ""


_AT = re.compile(r"\s*\((?:at line ([0-9]+), column ([0-9]+)|at end of document)\)")
_TWICE = (
    "Cannot overwrite a value",
    "Duplicate inline table key",
    "Cannot declare",
    "Cannot mutate",
)

_COMMENT = re.compile(r"""^([^"#]*(?:"[^"]*"[^"#]*)*)#.*$""")
"""A line with a comment behind it, and what stands before; a # in quotes is none."""
LONGEST = 300
"""A longer line is not quoted in a remedy."""


def syntax_fault(text: str, message: str) -> Fault:
    """Return the fault that tomllib's message speaks of.

    Parameters
    ----------
    text : str
        The whole file.
    message : str
        What ``tomllib.loads`` said, in English, with "(at line 3, column 7)" at its end.
    """
    match = _AT.search(message)
    lines = text.replace("\r\n", "\n").split("\n")
    number = int(match.group(1)) if match and match.group(1) else len(lines)
    line = lines[number - 1] if number <= len(lines) else ""
    reason = _AT.sub("", message)
    if reason.startswith(_TWICE):
        return _twice(reason, number, line, match)
    says = said("this is not TOML ({reason})", reason=reason)
    return Fault(_key(line), number, joined("; ", filter(None, (says, _remedy(line)))))


def _twice(reason: str, number: int, line: str, match: re.Match[str] | None) -> Fault:
    """Return the fault of a key or a section that stands twice."""
    names = re.findall(r"'([^']*)'", reason)
    section = line.lstrip().startswith("[")
    column = int(match.group(2)) if match and match.group(2) else len(line)
    key = ".".join(names) or (line.strip(" \t[]") if section else _key(line[:column]))
    if section:
        name = key.split(".")[0]
        says = (
            said("write [[{name}]] in double brackets, each time: there can be several", name=name)
            if name in several()
            else said("put its keys into one section")
        )
        twice = said("the section [{key}] stands twice", key=key)
        return Fault(key, number, joined("; ", (twice, says)))
    says = said('"{key}" stands twice in one table; take one out, or rename it', key=key)
    return Fault(key, number, says)


def _sections() -> list[str]:
    named = _declared().items()
    return ["[lengths]", *(f"[[{k}]]" if one.several else f"[{k}]" for k, one in named)]


def several() -> frozenset[str]:
    """Return the sections that a scene may have several times."""
    found = _declared().items()
    return frozenset(
        name for name, one in found if one.several or one.together or one.further is not None
    )


def _declared() -> Mapping[str, Section]:
    """Return the sections by name: they stand above what reads TOML, and only its messages name them."""
    found: Mapping[str, Section] = resolve_name("graphic_tmm.scene.sections:declared")()
    return found


def _key(line: str) -> str:
    """Return the word before the first sign of equality, in one pass: a line may be very long."""
    name = line.partition("=")[0].rstrip() if "=" in line else ""
    start = len(name)
    while start and (name[start - 1].isalnum() or name[start - 1] in "_.′\"'-"):
        start -= 1
    return name[start:].strip("\"'")


def _remedy(line: str) -> str:
    """Return what to do about the commonest mistakes, as far as the line shows them."""
    if len(line) > LONGEST:
        return ""
    name, sign, value = _COMMENT.sub(r"\1", line).partition("=")
    value = value.strip()
    if re.search(r"[«»“”„]", line):
        return said('write straight quotes: "..."')
    if not sign and re.match(r"\s*\[", line):
        if re.search(r"[^\x00-\x7f]", name):
            return said("sections have English names: {listed}", listed=", ".join(_sections()))
        return said("a section is written [frame], or [[link]] for one of several")
    if not sign:
        return said("write key = value")
    return _key_remedy(name, value) or _value_remedy(name.strip(), value)


def _key_remedy(name: str, value: str) -> str:
    if re.search(r"[^\x00-\x7f]", name) and '"' not in name:
        return _not_latin(name.strip())
    if inner := re.search(r"[{,]\s*([^\x00-\x7f\s\"]+)\s*=", value):
        return _not_latin(inner[1])
    return ""


def _not_latin(name: str) -> str:
    """Return how a key is written that is not Latin; of one that only looks so, both ways."""
    quoted = said('a key that is not Latin stands in quotes: "{name}" = ...', name=name)
    looks = latin(name)
    if not looks.isascii():
        return quoted
    says = said('"{name}" is not Latin: write {looks} with Latin letters', name=name, looks=looks)
    return joined("; ", (says, quoted))


def _value_remedy(name: str, value: str) -> str:
    if not value:
        return said("a value is missing, {name} = ...", name=name)
    if word := truth(value):
        return said("write {name} = {word}", name=name, word=word)
    if value.count('"') % 2:
        return said("a quote is not closed: write {name} = {value}", name=name, value=f'{value}"')
    if re.match(r"[–—‒‑−]\s*[0-9.,]+$", value):
        right = f"-{value[1:].strip()}"
        return said('a minus is written "-": {name} = {right}', name=name, right=right)
    if re.match(r"[-+]?[0-9]+,[0-9]", value):
        right = value.replace(",", ".", 1)
        return said("the decimal sign of a number is a point: {right}", right=right)
    if '"' in value:
        return ""
    if re.match(r"[-+–—‒‑−]?\s*[0-9][0-9.,]*\s*[^\W\d_]", value):
        return said(
            'a value with a unit stands in quotes: {name} = "{value}"', name=name, value=value
        )
    if value.count("{") > value.count("}"):
        return said("a table in { } stands on one line")
    if re.match(r"[^\W\d_]", value):
        return said('a text stands in quotes: {name} = "{value}"', name=name, value=value)
    return ""


Document = dict[str, Any]

DEEPEST = 12
"""So many tables and lists may stand in one another; a scene needs five."""
_DEEP = said("lists or tables are nested too deep; a scene needs five levels at most")
_PART = r"""(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+"""
_LONG_KEY = re.compile(rf"""(?<![\w\-."'])(?:{_PART}\.[ \t]*+){{{DEEPEST + 8}}}""")
"""A key of so many parts is far too deep already, and tomllib's time grows with the square of them."""


def document(file: Path, kind: Kind) -> tuple[str, Document]:
    """Return the text of a file, and what it says.

    Raises
    ------
    SceneError
        If it cannot be read (as `files.read`), is not in UTF-8, is no TOML, or nested too deep.
    """
    return parsed(read(file, kind), file)


def parsed(data: bytes, file: Path) -> tuple[str, Document]:
    """Return the text of a file of which the bytes are known, and what it says; raises as `document`."""
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        _refuse(file, said("the file is not in UTF-8; save it with the encoding UTF-8"), line)
    if found := _LONG_KEY.search(text):
        _refuse(file, _DEEP, text.count("\n", 0, found.start()) + 1)
    try:
        doc = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SceneError(str(file), (syntax_fault(text, str(error)),)) from None
    except RecursionError:
        _refuse(file, _DEEP)
    except ValueError as error:
        reason = re.sub(r"[;,].*", "", str(error))
        _refuse(file, said("a value cannot be read: {reason}", reason=reason))
    if _deeper(doc):
        _refuse(file, _DEEP)
    return text, doc


def _deeper(doc: Document) -> bool:
    """Whether anything stands deeper than `DEEPEST`; level by level, so that no depth is too much for it."""
    level: list[Any] = [doc]
    for _ in range(DEEPEST):
        inner = (item.values() if isinstance(item, dict) else item for item in level)
        level = [item for items in inner for item in items if isinstance(item, (dict, list))]
        if not level:
            return False
    return True


def _refuse(file: Path, message: str, line: int = 0) -> NoReturn:
    raise SceneError(str(file), (Fault("", line, message),)) from None


def texts(doc: Document) -> list[tuple[Place, str]]:
    """Every text of a document that is drawn, with its path: titles, names, letters."""
    drawn: list[tuple[Place, str]] = [(("title",), doc.get("title", ""))]
    for key, value in as_table(doc.get("title_block")).items():
        drawn.append((("title_block", key), value))
    sheets = doc.get("sheet")
    for k, sheet in enumerate(sheets if isinstance(sheets, list) else []):
        drawn.extend(
            (("sheet", k, key), as_table(sheet).get(key, "")) for key in ("name", "designation")
        )
    drawn.extend((("frame", key), key) for key in as_table(doc.get("frame")) if key != "number")
    for path, link in raw_links(doc):
        drawn.append(((*path, "name"), link.get("name", "")))
        for part in ("points", "guides"):
            drawn.extend(((*path, part, key), key) for key in as_table(link.get(part)))
    return [(path, value) for path, value in drawn if isinstance(value, str)]


def raw_links(doc: Document) -> list[tuple[Place, Document]]:
    """Return the links as they stand in the document, understood or not."""
    links = doc.get("link")
    if not isinstance(links, list):
        return []
    return [(("link", i), link) for i, link in enumerate(links) if isinstance(link, dict)]


def as_table(value: object) -> Document:
    """Return a value of the document if it is a table, else an empty one."""
    return value if isinstance(value, dict) else {}


def number(value: object) -> float | None:
    """Return a value of the document if it is a number that arithmetic can hold; None of all else."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    try:
        found = float(value)
    except OverflowError:
        return None
    return found if math.isfinite(found) else None


_UNIT = re.compile(r"[\d.,]+( [^\d\s].*)")
_BARE = re.compile(r"[A-Za-z0-9_-]+")
_ESCAPES = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\r": "\\r", "\t": "\\t"}


def default_text(one: Key) -> str | None:
    """Return a key's default as a scene writes it; None where that is nothing."""
    if one.default is not MISSING and one.default is not None and one.default not in ((), {}, ""):
        for text in _spelled(one):
            if _read(one, text) == one.default:
                return text
    return None


def _spelled(one: Key) -> Iterator[str]:
    """Yield how a default may be written: an only item by itself, as it is, in the unit of the example."""
    with suppress(TypeError):
        if isinstance(one.default, tuple) and len(one.default) == 1:
            yield toml(one.default[0])
        yield toml(one.default)
    unit = _UNIT.fullmatch(one.example) if isinstance(one.example, str) else None
    if unit is not None and isinstance(one.default, (int, float)):
        yield toml(f"{one.default:g}{unit[1]}")


def _read(one: Key, text: str) -> object:
    """Return what a value means that is written so; None if it is none."""
    found: list[Flaw] = []
    value = one.kind.understood(value_of(text), (), {}, found)
    return None if found else value


def value_of(text: str) -> Any:
    """Return the value that TOML writes so."""
    return tomllib.loads(f"it = {text}")["it"]


def quoted(text: str) -> str:
    """Return a text as TOML writes it, on one line."""
    return '"' + "".join(map(_escaped, text)) + '"'


def _escaped(sign: str) -> str:
    if sign in _ESCAPES:
        return _ESCAPES[sign]
    return f"\\u{ord(sign):04x}" if ord(sign) < 32 or ord(sign) == 127 else sign


def key_text(name: str) -> str:
    """Return a key as TOML writes it: bare, or in quotes."""
    return name if _BARE.fullmatch(name) else quoted(name)


def toml(value: object) -> str:
    """Return a value as TOML writes it, on one line.

    >>> toml({"a": [0, 0.5], "b c": True})
    '{ a = [0, 0.5], "b c" = true }'

    Raises
    ------
    TypeError
        If TOML has no such values.
    """
    if isinstance(value, (bool, int, float)):
        return repr(value).removesuffix(".0") if isinstance(value, float) else str(value).lower()
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(toml, value))}]"
    if isinstance(value, dict):
        pairs = (f"{key_text(k)} = {toml(v)}" for k, v in value.items())
        return f"{{ {', '.join(pairs)} }}" if value else "{}"
    raise TypeError(type(value).__name__)
