"""Keys as people write them, ``link 3, slides.on``, back to paths of the parsed document."""

from __future__ import annotations

import re

from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.faults import key_of

LONGEST = 200
"""A longer key is no key of a scene."""
_ITEM = re.compile(r"(\w+) (?:\d{1,9}|\(the \d+[a-z]{2} in the file\))")
_PART = re.compile(r"([^.\[\]]+)((?:\[\d{1,6}\])*)")


def path_of(doc: Document, key: str) -> Path:
    """Return the path of a key; of a text that cannot be one, itself as a key before the first section."""
    found = _found(doc, key) if len(key) <= LONGEST else None
    return found or (key[:LONGEST],)


def _found(doc: Document, key: str) -> Path | None:
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
