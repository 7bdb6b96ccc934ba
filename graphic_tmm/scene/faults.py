"""What was found wrong, at its place: paths of the document turned into keys and lines."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from graphic_tmm.errors import Fault
from graphic_tmm.scene.declare import Found, Path
from graphic_tmm.scene.lines import line_of


def fault(doc: Mapping[str, Any], lines: Mapping[Path, int], found: Found) -> Fault:
    """Return a finding as the fault that a person reads."""
    return Fault(key_of(doc, found.path), line_of(lines, found.path), found.message)


def key_of(doc: Mapping[str, Any], path: Path) -> str:
    """Return the path as people write it: ``link 3, slides.on``, ``drive.speed``.

    Links go by their own numbers, items of lists are counted from 1.
    """
    if len(path) < 2 or not isinstance(path[1], int):
        return _dotted(path)
    section, _, *rest = path
    item = f"{section} {_called(doc, str(section), path[1])}"
    return f"{item}, {_dotted(rest)}" if rest else item


def _called(doc: Mapping[str, Any], section: str, index: int) -> str:
    if section != "link":
        return str(index + 1)
    numbers = [entry.get("number") if isinstance(entry, dict) else None for entry in doc["link"]]
    number = numbers[index]
    whole = isinstance(number, int) and not isinstance(number, bool) and abs(number) < 10**9
    if whole and numbers.count(number) == 1:
        return str(number)
    return f"(the {_ordinal(index + 1)} in the file)"


def _ordinal(number: int) -> str:
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10 if number % 100 not in (11, 12, 13) else 0)
    return f"{number}{ending or 'th'}"


def _dotted(path: Sequence[str | int]) -> str:
    text = ""
    for part in path:
        text += f"[{part + 1}]" if isinstance(part, int) else f".{part}" if text else part
    return text
