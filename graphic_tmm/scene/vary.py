"""A scene with other values at some of its keys (``link 3, slides.on``), and scenes that no file holds."""

from __future__ import annotations

import re
from collections.abc import Mapping
from copy import deepcopy
from pathlib import PurePath
from typing import Any

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import DEEPEST, Document
from graphic_tmm.scene.lines import key_of
from graphic_tmm.scene.sections import LENGTHS

LONGEST = 200
"""A longer key is no key of a scene."""
_ITEM = re.compile(r"(\w+) (?:\d{1,9}|\(the \d+[a-z]{2} in the file\))")
_PART = re.compile(r"([^.\[\]]+)((?:\[\d{1,6}\])*)")


def path_of(doc: Document, key: str) -> Path:
    """Return the path of a key; of a text that cannot be one, itself as a key before the first section."""
    found = _path_of(doc, key) if len(key) <= LONGEST else None
    return found or (key[:LONGEST],)


def _path_of(doc: Document, key: str) -> Path | None:
    item, comma, rest = key.partition(", ")
    match = _ITEM.fullmatch(item)
    if match is None:
        return _dotted(key)
    items = doc.get(match[1])
    if not isinstance(items, list):
        return None
    at = next((k for k in range(len(items)) if key_of(doc, (match[1], k)) == item), None)
    inner = _dotted(rest)
    return None if at is None or inner is None or not comma else (match[1], at, *inner)


def _dotted(text: str) -> Path | None:
    path: list[str | int] = []
    for part in text.split("."):
        match = _PART.fullmatch(part)
        if match is None:
            return None
        path.append(match[1])
        path += [int(number) - 1 for number in re.findall(r"\d+", match[2])]
    return tuple(path)


_NUMBERED = re.compile(r"links?\.(\d{1,9})\.(.+)")


def place_of(doc: Document, key: str) -> Path:
    """Return where a key that a person writes stands in a scene.

    ``drive.speed``, ``link 3, mass`` or ``links.3.mass``; the name of a length alone, ``OA`` or ``links.1.OA``.
    """
    lengths = doc.get(LENGTHS)
    named = lengths if isinstance(lengths, dict) else {}
    key = " ".join(key.split())
    if match := _NUMBERED.fullmatch(key):
        rest = match[2]
        return (LENGTHS, rest) if rest in named else path_of(doc, f"link {match[1]}, {rest}")
    return (LENGTHS, key) if key in named else path_of(doc, key)


def put(doc: Document, path: Path, value: object) -> Document:
    """Return a copy of a document that has a value at a path; None takes out what stands there.

    Raises
    ------
    LookupError
        If there is no such place: an item of a list that has fewer, a key of what is no table, nothing to be
        taken out.
    """
    made = deepcopy(doc)
    at: Any = made
    last: Any = path[-1]
    if any(isinstance(part, int) and part < 0 for part in path):
        raise LookupError(path)
    try:
        for part in path[:-1]:
            known = isinstance(part, str) and isinstance(at, dict)
            at = at.setdefault(part, {}) if known and value is not None else at[part]
        if value is None:
            del at[last]
        elif isinstance(at, dict) == isinstance(last, str):
            at[last] = value
        else:
            raise KeyError(last)
    except (KeyError, IndexError, TypeError, AttributeError):
        raise LookupError(path) from None
    return made


def changed(doc: Document, values: Mapping[str, object], source: str) -> Document:
    """Return a document with other values, by their keys as people write them; None takes one out.

    Raises
    ------
    SceneError
        With a fault for every key that the scene cannot have, and for every value that no scene can hold.
    """
    faults, made = list[Fault](), doc
    taken = dict[Path, str]()
    for key, value in values.items():
        path = place_of(doc, str(key))
        if path in taken:
            says = said("this is the same key as {key}; keep one of them", key=taken[path])
            faults.append(Fault(str(key), 0, says))
            continue
        taken[path] = str(key)
        try:
            put_in = None if value is None else toml_value(value, str(key))
            made = put(made, path, put_in)
        except SceneError as error:
            faults += error.faults
        except LookupError:
            says = said("the scene has no such key; write it as the scene does: OA, drive.speed")
            faults.append(Fault(str(key), 0, says))
    if faults:
        raise SceneError(source, tuple(faults))
    return made


def document_of(tables: Mapping[Any, Any], source: str) -> Document:
    """Return tables that somebody put together as TOML would give them: no tuples, no numbers of numpy.

    Raises
    ------
    SceneError
        With a fault for every value that no scene can hold, at its key.
    """
    faults, made = list[Fault](), Document()
    for key, value in tables.items():
        try:
            made[_key(key, "")] = toml_value(value, str(key))
        except SceneError as error:
            faults += error.faults
    if faults:
        raise SceneError(source, tuple(faults))
    return made


def toml_value(value: Any, key: str, deep: int = 1) -> Any:
    """Return a value as TOML would give it.

    Raises
    ------
    SceneError
        If no scene can hold it: the key, what it is.
    """
    if hasattr(value, "tolist"):  # of numpy, whichever it is
        value = value.tolist()
    if isinstance(value, PurePath):
        value = str(value)
    if isinstance(value, (bool, int, float)):
        return value
    if isinstance(value, str) and _written(value):
        return str(value)
    if deep < DEEPEST and isinstance(value, Mapping):
        return {_key(k, key): toml_value(one, f"{key}.{k}", deep + 1) for k, one in value.items()}
    if deep < DEEPEST and isinstance(value, (list, tuple)):
        return [toml_value(one, f"{key}[{k + 1}]", deep + 1) for k, one in enumerate(value)]
    says = said(
        'a scene cannot hold this ({kind}); give a number, a text such as "95 mm", true or false, a list or '
        "a table",
        kind=type(value).__name__,
    )
    raise SceneError("", (Fault(key, 0, says),))


def _key(key: Any, above: str) -> str:
    if isinstance(key, str) and _written(key):
        return str(key)
    says = said("the keys of a table are texts, not {kind}", kind=type(key).__name__)
    raise SceneError("", (Fault(above, 0, says),))


def _written(text: str) -> bool:
    """Whether a text can stand in a file."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def paths(doc: Document) -> list[Path]:
    """Return the paths of a document's sections and of their keys."""
    found = list[Path]()

    def walk(at: object, path: Path) -> None:
        found.append(path)
        items: Any = at.items() if isinstance(at, dict) else ()
        items = enumerate(at) if isinstance(at, list) else items
        if len(path) < 3:
            for key, one in items:
                walk(one, (*path, key))

    for key, one in doc.items():
        walk(one, (key,))
    return found


def lines_by_key(doc: Document, lines: Mapping[Path, int] | None) -> dict[str, int]:
    """Return the sections and keys as people write them, each with its line; 0 where no file holds them."""
    there = dict.fromkeys(paths(doc), 0) if lines is None else lines
    return {key_of(doc, path): line for path, line in there.items() if len(path) < 4}
