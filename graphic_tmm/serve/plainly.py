"""Faults of a scene for who fills in forms: places and remedies by what the forms call them, and not by keys.

A key stands in a form by the first clause of what its section says of it; a section by what that says it is.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from functools import cache

from graphic_tmm.errors import Fault
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import keys_of
from graphic_tmm.scene.document import toml
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.keys import inner_tables
from graphic_tmm.scene.new import about
from graphic_tmm.scene.sections import LENGTHS, declared

_CLAUSE = re.compile(r"[;:,(]")
_WORD = re.compile(r"[^\W\d_]{4}")
_ITEM = re.compile(r"(?P<section>\w+)(?: (?P<number>[0-9]+))?(?:(?:, |\.)(?P<rest>.+))?")
_COUNTED = re.compile(r"\[[0-9]+\]")
_VALUE = r'"[^"]*"|\[(?:[^\[\]]|\[[^\[\]]*\])*\]|\{[^{}]*\}|[+-]?[0-9][0-9.]*\b|true\b|false\b'
_SET = re.compile(rf"\b([A-Za-z_]\w*) = ({_VALUE})")
_SECTION = re.compile(r"\[\[?([a-z_]+)\]\]?")
_PATH = re.compile(r"\b[a-z_]+(?:\.| [0-9]+(?:, |\.))[A-Za-z_]\w*(?:\.\w+)*")
_HEAD = re.compile(r"^[a-z_]+(?=: )")
_OF_FILES = "TOML"
"""What a message speaks of that is for who writes the file."""
_LONG = re.compile(r"\b[a-z]+(?:_[a-z]+)+\b")


def clause(says: str) -> str:
    """Return the first clause of what a key is."""
    return _CLAUSE.split(says)[0].strip()


def fault_text(fault: Fault, speech: Speech) -> str:
    """Return a fault in words, with its place."""
    place, shown = place_words(fault.key, speech), fault.for_reader(speech)
    return ": ".join(filter(None, (place, plainly(shown.message, speech, fault.key))))


def place_words(key: str, speech: Speech) -> str:
    """Return a place of a scene in words: ``link 2, points.A`` is point A of link 2.

    "" of what no section declares: of something misspelt a file is told in its own words.
    """
    item = _ITEM.fullmatch(_COUNTED.sub("", key))
    if item is None:
        return ""
    section, number, rest = item["section"], item["number"] or "", item["rest"] or ""
    path = rest.split(".")
    if section == LENGTHS and rest:
        return speech(said("length {name}", name=rest))
    if section not in declared():
        return _key_words("", key, speech)
    if section == "link" and path[0] == "points" and len(path) > 1:
        return speech(said("point {letter} of link {number}", letter=path[1], number=number))
    if section == "frame" and path[0] not in _keys(section) and len(path[0]) == 1:
        guide = len(path) > 1 and not path[1].isdigit()
        name = said("guide {name} of the frame") if guide else said("point {name} of the frame")
        return speech(name, name=path[0])
    of = _called(section, number, speech)
    what = _key_words(section, rest, speech) if rest else ""
    return of if not rest else f"{of}: {what}" if what else ""


def _called(section: str, number: str, speech: Speech) -> str:
    """Return what a section is called, or one of several."""
    if section == "link" and number:
        return speech(said("link {number}", number=number))
    one = declared()[section]
    name = clause(speech(one.says or about(one.record))).removesuffix(".")
    return f"{name}, {number}" if number else name


def _key_words(section: str, rest: str, speech: Speech) -> str:
    """Return the last key of a path in words; "" if nobody has any for it."""
    path = [one for one in rest.split(".") if not one.isdigit()]
    if path and path[0] not in _keys(section):
        return ""
    return next(filter(None, (_label(one, _keys(section), speech) for one in reversed(path))), "")


def _label(key: str, known: Mapping[str, str], speech: Speech) -> str:
    """Return what a key is called; "" of one that is not known, or has no more than a unit."""
    label = clause(speech(known.get(key, "")))
    return _sections_named(label, speech) if _WORD.search(label) else ""


def _quoted(name: str, speech: Speech) -> str:
    return speech(said("“{name}”", context="quoted", name=name))


def _sections_named(text: str, speech: Speech) -> str:
    def called(found: re.Match[str]) -> str:
        if found[1] not in declared():
            return found[0]
        return _quoted(_called(found[1], "", speech), speech)

    return _SECTION.sub(called, text)


@cache
def _keys(section: str) -> Mapping[str, str]:
    """Return what a section says of its keys, and of those of tables within it; of those before all for ""."""
    one = declared().get(section)
    records = [Head] if one is None else [one.record, *filter(None, (one.further,))]
    found: dict[str, str] = {}
    for record in records:
        for name, says in _of_record(record):
            found.setdefault(name, says)
    return found


@cache
def _everywhere() -> Mapping[str, str]:
    """Return what keys are wherever they stand, of those of one name the first."""
    found: dict[str, str] = {}
    for section in ("", *declared()):
        found = {**_keys(section), **found}
    return found


def _of_record(record: type) -> Iterator[tuple[str, str]]:
    for name, key in keys_of(record).items():
        yield name, key.says
    for key in keys_of(record).values():
        for table in inner_tables(key.kind):
            yield from _of_record(table)


def plainly(text: str, speech: Speech, key: str = "") -> str:
    """Return a message with what forms call sections and keys; ``key``: the place that it is told of."""
    section, last = re.split(r"[ .,]", key)[0], re.split(r"[ .,]", key)[-1]
    if _OF_FILES in text or (key and (not place_words(key, speech) or f"[{key}]" in text)):
        return text
    known = {**_everywhere(), **_keys(section)}

    def named(name: str) -> str:
        label = _label(name, known, speech)
        return _quoted(label, speech) if label else name

    def value(one: object) -> str:
        if isinstance(one, dict):
            return "; ".join(f"{named(k)}: {entry_text(v)}" for k, v in one.items())
        return entry_text(one)

    def assigned(found: re.Match[str]) -> str:
        try:
            told = tomllib.loads(f"x = {found[2]}")["x"]
        except tomllib.TOMLDecodeError:
            return found[0]
        return f"{named(found[1])}: {value(told)}" if found[1] in known else found[0]

    if _label(last, known, speech):
        text = text.replace(f'"{last}"', named(last))
    text = _HEAD.sub(lambda found: place_words(found[0], speech) or found[0], text)
    text = _sections_named(_SET.sub(assigned, text), speech)
    text = _PATH.sub(lambda found: place_words(found[0], speech) or found[0], text)
    return _LONG.sub(lambda found: named(found[0]), text)


def entry_text(value: object) -> str:
    """Return a value of a scene as people enter it.

    >>> entry_text("190 N"), entry_text(["A", 2]), entry_text([[0, "0 N"], [1, "5 N"]])
    ('190 N', 'A, 2', '0: 0 N; 1: 5 N')
    """
    if not isinstance(value, list):
        return value if isinstance(value, str) else toml(value)
    if any(isinstance(one, list) for one in value):
        return "; ".join(": ".join(map(entry_text, one)) for one in value)
    return ", ".join(map(entry_text, value))
