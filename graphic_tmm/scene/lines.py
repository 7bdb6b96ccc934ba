"""Where in a TOML text each key stands (tomllib does not tell), and what was found wrong there.

The text is taken to be good TOML (tomllib has read it before); whatever cannot be followed ends the
walk, and a key that was not reached falls back on the nearest table above it.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

from graphic_tmm.errors import Fault
from graphic_tmm.scene.declare import Flaw, Path

_SPACE = re.compile(r"[ \t]*")
_BLANK = re.compile(r"(?:[ \t\r\n]+|#[^\n]*)*")
_BARE = re.compile(r"[A-Za-z0-9_-]+")
_STRING = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}(?!")'
    r"|'''(?:.)*?'{3,5}(?!')"
    r'|"(?:\\.|[^"\\\n])*"'
    r"|'[^'\n]*'",
    re.DOTALL,
)
_SCALAR = re.compile(r"[^,\]}#\r\n]+")


Span = tuple[int, int]
"""From this character of the text to before that one."""


@dataclass
class Layout:
    """Where things stand in a TOML text.

    ``values``: of each path, its value as it is written. ``keys``: of each path that is written as key = value,
    where the key begins (in an inline table too). ``headers``: of each table with a header of its own, where
    that ends. ``inline``: the paths of tables in braces. ``rows``: of each table with a header (() before the
    first), the paths of the keys below it, in order.
    """

    values: dict[Path, Span] = field(default_factory=dict)
    keys: dict[Path, int] = field(default_factory=dict)
    headers: dict[Path, int] = field(default_factory=dict)
    inline: set[Path] = field(default_factory=set)
    rows: dict[Path, list[Path]] = field(default_factory=lambda: {(): []})


def layout(text: str) -> Layout:
    """Return where everything stands in a TOML text; what cannot be followed is left out."""
    return _walked(text).found


def locate(text: str) -> dict[Path, int]:
    """Map every key path of a TOML text to its line, counted from 1.

    Parameters
    ----------
    text : str
        A TOML document.

    Returns
    -------
    dict of tuple to int
        ``("link", 0, "points", "A") -> 7``; items are counted from 0, as in the parsed document.
    """
    return _walked(text).lines


def line_of(lines: Mapping[Path, int], path: Path) -> int:
    """Return the line of a path, or of the nearest table or key above it; 0 if there is none."""
    for length in range(len(path), 0, -1):
        if path[:length] in lines:
            return lines[path[:length]]
    return 0


class _Lost(Exception):
    """The walk does not understand the text."""


class _Walk:
    """A cursor over the text that notes where each key begins."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0
        self.lines: dict[Path, int] = {}
        self.found = Layout()
        self.items: dict[Path, int] = {}
        self._line, self._counted = 1, 0

    def document(self) -> None:
        table: Path = ()
        self.skip(_BLANK)
        while self.at < len(self.text):
            table = self.header() if self.text[self.at] == "[" else self.row(table)
            self.skip(_BLANK)

    def header(self) -> Path:
        """``[a.b]`` or ``[[a.b]]``: the path of the table that the next keys belong to."""
        line = self.line()
        several = self.text.startswith("[[", self.at)
        self.at += 2 if several else 1
        *above, last = self.key()
        self.expect("]]" if several else "]")
        end = self.at
        path: Path = ()
        for part in above:
            path = self.latest(self.note((*path, part), line))
        path = self.note((*path, last), line)
        if several:
            number = self.items.get(path, -1) + 1
            self.items[path] = number
            path = self.note((*path, number), line)
        self.found.headers[path] = end
        self.found.rows[path] = []
        return path

    def latest(self, path: Path) -> Path:
        """Return an array of tables in the way stands for its latest table."""
        return (*path, self.items[path]) if path in self.items else path

    def row(self, table: Path) -> Path:
        """``key = value`` below the header of a table, which is handed back."""
        self.found.rows[table].append(self.pair(table))
        return table

    def pair(self, table: Path) -> Path:
        """``key = value`` in a table: the path of the key."""
        line, begin = self.line(), self.at
        path = table
        for part in self.key():
            path = self.note((*path, part), line)
        self.expect("=")
        self.value(path)
        self.found.keys[path] = begin
        return path

    def key(self) -> list[str]:
        parts = [self.part()]
        while self.text.startswith(".", self.at):
            self.at += 1
            parts.append(self.part())
        return parts

    def part(self) -> str:
        self.skip(_SPACE)
        match = _BARE.match(self.text, self.at) or _STRING.match(self.text, self.at)
        if match is None:
            raise _Lost
        self.at = match.end()
        self.skip(_SPACE)
        return _spoken(match.group())

    def value(self, path: Path) -> None:
        self.skip(_SPACE)
        begin = self.at
        match = _STRING.match(self.text, self.at)
        if match is not None:
            self.at = match.end()
        elif self.text.startswith("[", self.at):
            self.array(path)
        elif self.text.startswith("{", self.at):
            self.table(path)
        else:
            self.skip(_SCALAR)
        written = self.text[begin : self.at].rstrip(" \t")
        self.found.values[path] = (begin, begin + len(written))
        self.skip(_SPACE)

    def array(self, path: Path) -> None:
        self.at += 1
        number = 0
        self.skip(_BLANK)
        while not self.text.startswith("]", self.at):
            self.note((*path, number), self.line())
            self.value((*path, number))
            self.skip(_BLANK)
            self.separator("]")
            number += 1
        self.at += 1

    def table(self, path: Path) -> None:
        self.found.inline.add(path)
        self.at += 1
        self.skip(_BLANK)
        while not self.text.startswith("}", self.at):
            self.pair(path)
            self.skip(_BLANK)
            self.separator("}")
        self.at += 1

    def separator(self, end: str) -> None:
        if not self.text.startswith(end, self.at):
            self.expect(",")
            self.skip(_BLANK)

    def expect(self, token: str) -> None:
        if not self.text.startswith(token, self.at):
            raise _Lost
        self.at += len(token)

    def skip(self, pattern: re.Pattern[str]) -> None:
        match = pattern.match(self.text, self.at)
        if match is not None:
            self.at = match.end()

    def line(self) -> int:
        self._line += self.text.count("\n", self._counted, self.at)
        self._counted = self.at
        return self._line

    def note(self, path: Path, line: int) -> Path:
        self.lines.setdefault(path, line)
        return path


def _walked(text: str) -> _Walk:
    walk = _Walk(text)
    with suppress(_Lost, RecursionError):
        walk.document()
    return walk


def _spoken(raw: str) -> str:
    """Return a key without its quotes and escapes."""
    if raw[0] not in "\"'":
        return raw
    try:
        return next(iter(tomllib.loads(f"{raw} = 0")))
    except tomllib.TOMLDecodeError as error:
        raise _Lost from error


def fault(doc: Mapping[str, Any], lines: Mapping[Path, int], found: Flaw) -> Fault:
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
