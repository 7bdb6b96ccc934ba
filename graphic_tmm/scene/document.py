"""A TOML file as its text and its tables: of a fit size, in UTF-8, not nested beyond any use; parts of it."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path
from typing import Any, NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.files import Kind, read
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import Path as Place
from graphic_tmm.scene.syntax import syntax_fault

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
    for key, value in table(doc.get("title_block")).items():
        drawn.append((("title_block", key), value))
    sheets = doc.get("sheet")
    for k, sheet in enumerate(sheets if isinstance(sheets, list) else []):
        drawn.extend(
            (("sheet", k, key), table(sheet).get(key, "")) for key in ("name", "designation")
        )
    drawn.extend((("frame", key), key) for key in table(doc.get("frame")) if key != "number")
    for path, link in raw_links(doc):
        drawn.append(((*path, "name"), link.get("name", "")))
        for part in ("points", "guides"):
            drawn.extend(((*path, part, key), key) for key in table(link.get(part)))
    return [(path, value) for path, value in drawn if isinstance(value, str)]


def raw_links(doc: Document) -> list[tuple[Place, Document]]:
    """Return the links as they stand in the document, understood or not."""
    links = doc.get("link")
    if not isinstance(links, list):
        return []
    return [(("link", i), link) for i, link in enumerate(links) if isinstance(link, dict)]


def table(value: object) -> Document:
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
