"""What was found wrong, in words: pydantic's findings rewritten, paths turned into keys."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from pydantic_core import ErrorDetails

from graphic_tmm.errors import Fault
from graphic_tmm.scene import quantities
from graphic_tmm.scene.lines import Path, line_of
from graphic_tmm.scene.models import TAGS, keys_of


class Found(NamedTuple):
    """Something wrong at a path of the parsed document."""

    path: Path
    message: str


def from_pydantic(error: ErrorDetails, root: Path) -> Found:
    """One error of pydantic, its path below ``root``, in words that name the remedy."""
    path = (*root, *(part for part in error["loc"] if part not in TAGS))
    return Found(path, _message(error, path))


def _message(error: ErrorDetails, path: Path) -> str:
    kind = error["type"]
    if path[0] == "frame" and len(path) == 2 and not isinstance(error["input"], (list, dict)):
        return _frame_key(str(path[1]), error)
    if kind == "value_error":
        return str(error["ctx"]["error"])
    if kind == "missing":
        return missing_key(path)
    if kind == "extra_forbidden":
        return unknown_key(str(path[-1]), list(keys_of(path[:-1])))
    if kind in ("model_type", "model_attributes_type", "dict_type"):
        return f"{quantities.kind_of(error['input'])} stands here; {_table_wanted(path)}"
    return f"{quantities.kind_of(error['input'])} stands here: {error['msg']}"


def _frame_key(key: str, error: ErrorDetails) -> str:
    if key == "number":
        return str(error["ctx"]["error"])
    meant = '; did you mean "number"?' if quantities.near(key, ["number"], 0.6) else ""
    return (
        f"{quantities.kind_of(error['input'])} stands here{meant}; a key of the frame is number, "
        'a point, O = [0, 0], or a guide, y = { through = [0, 0], angle = "0 deg" }'
    )


def _table_wanted(path: Path) -> str:
    example = {
        "points": "{ A = [0, 0] }",
        "slides": '{ on = 3, along = "BC" }',
        "guides": '{ q = { through = [0, 0], angle = "0 deg" } }',
    }.get(str(path[-1]))
    if example:
        return f"a table is wanted, for example {path[-1]} = {example}"
    if len(path) == 1:
        return f"a section is wanted: [{path[0]}] on a line of its own, its keys below it"
    return 'a table is wanted, for example { through = [0, 0], angle = "0 deg" }'


def unknown_key(key: str, known: Sequence[str]) -> str:
    """Return a key that means nothing here, the one that was probably meant, and all there are."""
    near = quantities.near(key, known, 0.6)
    meant = f'did you mean "{near}"? ' if near else ""
    return f'"{key}" means nothing here; {meant}keys here are {", ".join(known)}'


def missing_key(path: Path) -> str:
    """Return a key that has to be there, with an example."""
    key = str(path[-1])
    field = keys_of(path[:-1]).get(key)
    example = field.examples[0] if field is not None and field.examples else None
    if example is None:
        return f'"{key}" is missing'
    written = f'"{example}"' if isinstance(example, str) else str(example)
    return f'"{key}" is missing; write for example {key} = {written}'


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
