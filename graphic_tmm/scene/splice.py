"""A TOML text with one value changed, added or taken out: no other character of it is touched.

The text is taken to be good TOML. What is made is read once more, and has to say what was meant: a layout that
cannot be followed is refused, never damaged.
"""

from __future__ import annotations

import re
import tomllib
from itertools import islice
from typing import Any

from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import key_text, toml
from graphic_tmm.scene.lines import Layout, layout
from graphic_tmm.scene.sections import LENGTHS, declared
from graphic_tmm.scene.vary import put

_REST = re.compile(r"[^\n]*\n?")
_ROW = re.compile(r"([ \t]*)([^=\s]+)([ \t]*)=([ \t]*)")
_COMMENTS_ABOVE = re.compile(r"(?:^[ \t]*#[^\n]*\n)*\Z", re.MULTILINE)
_COMMENTS_BELOW = re.compile(r"(?:[ \t]*#[^\n]*(?:\n|\Z))+(?=[ \t]*\r?\n|\Z)")
_EMPTY = re.compile(r"(?:[ \t]*\r?\n)+")
_ENDS_EMPTY = re.compile(r"\n[ \t]*\r?\n\Z")
_ALIGNED = re.compile(r"^\w+ {2,}=", re.MULTILINE)
_PART = re.compile(r"""[\w-]+|"(?:\\.|[^"\\\n])*"|'[^'\n]*'""", re.ASCII)
_NUMBER = re.compile(r"[+-]?[0-9]+(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?")


class Unplaced(ValueError):
    """The text is laid out so that a value cannot be set in it without touching anything else."""


def literal(text: str) -> object:
    """Return the value that a text is as it stands, without quotes; None if it is none, or more than one."""
    try:
        doc = tomllib.loads(f"x = {text}")
    except (tomllib.TOMLDecodeError, ValueError, RecursionError):
        return None
    whole = layout(f"x = {text}").values.get(("x",)) == (4, 4 + len(text))
    value = doc["x"] if doc.keys() == {"x"} and whole else None
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return value if _NUMBER.fullmatch(text) else None
    return value if isinstance(value, (bool, list)) else None


def set_to(text: str, path: Path, value: str | None) -> str:
    """Return a text in which a path has a value, as TOML writes it; None takes it out.

    Raises
    ------
    Unplaced
        If that cannot be done without touching anything else.
    """
    doc = tomllib.loads(text)
    there = layout(text)
    wanted = _meant(doc, path, value)
    return _checked(_spliced(text, there, path, value), wanted, path)


def _checked(made: str, wanted: dict[str, Any], path: Path) -> str:
    """Return a text that says what was meant."""
    try:
        said = tomllib.loads(made)
    except (tomllib.TOMLDecodeError, ValueError, RecursionError):
        raise Unplaced(path) from None
    if repr(said) != repr(wanted) and said != wanted:
        raise Unplaced(path)
    return made


def _meant(doc: dict[str, Any], path: Path, value: str | None) -> dict[str, Any]:
    """Return the document as it shall be."""
    try:
        return put(doc, path, None if value is None else tomllib.loads(f"x = {value}")["x"])
    except LookupError:
        raise Unplaced(path) from None


def _spliced(text: str, there: Layout, path: Path, value: str | None) -> str:
    if value is None:
        return _without(text, there, path)
    if path in there.values:
        begin, end = there.values[path]
        return text[:begin] + value + text[end:]
    return _with(text, there, path, value)


def _without(text: str, there: Layout, path: Path) -> str:
    """Return a text without a key and its value; a comment beside it stays on the line."""
    if path not in there.keys or path not in there.values:
        raise Unplaced(path)
    begin, end = there.keys[path], there.values[path][1]
    if any(path[:k] in there.inline for k in range(1, len(path))):
        return _without_pair(text, begin, end)
    line = text.rfind("\n", 0, begin) + 1
    match = _REST.match(text, end)
    assert match is not None
    rest = match.group()
    if rest.strip():
        return text[:begin] + rest.lstrip(" \t") + text[match.end() :]
    return text[:line] + text[match.end() :]


def _without_pair(text: str, begin: int, end: int) -> str:
    """Return a text without a pair of an inline table, and without the comma on one side of it."""
    behind = re.compile(r"\s*,\s*").match(text, end)
    if behind is not None:
        return text[:begin] + text[behind.end() :]
    before = re.search(r"\s*,\s*$", text[:begin])
    return text[: before.start() if before else begin] + text[end:]


def _with(text: str, there: Layout, path: Path, value: str) -> str:
    """Return a text with a key that was not there."""
    *above, last = path
    table = tuple(above)
    if not isinstance(last, str):
        raise Unplaced(path)
    if table in there.inline:
        return _in_braces(text, there, table, f"{key_text(last)} = {value}")
    if table in there.rows and (table in there.headers or not table):
        return _below(text, there, table, table, [last], value)
    for k in range(len(table) - 1, -1, -1):  # slides.on = 3 below [[link]]
        rows = [row for row in there.rows.get(table[:k], ()) if row[: len(table)] == table]
        if rows:
            return _below(text, there, table[:k], table, list(path[k:]), value)
    if len(path) == 2 and isinstance(path[0], str) and (path[0],) not in there.values:
        return _at_the_end(text, path[0], f"{key_text(last)} = {value}")
    raise Unplaced(path)


def _in_braces(text: str, there: Layout, table: Path, pair: str) -> str:
    begin, end = there.values[table]
    inner = text[begin + 1 : end - 1]
    kept = inner.rstrip(" \t")
    if not kept.strip():
        return f"{text[:begin]}{{ {pair} }}{text[end:]}"
    return f"{text[: begin + 1]}{kept}, {pair}{inner[len(kept) :]}{text[end - 1 :]}"


def _below(
    text: str, there: Layout, header: Path, like: Path, names: list[str | int], value: str
) -> str:
    """Return a text with a line behind the last key of a header's table that begins as ``like``."""
    key = ".".join(key_text(str(name)) for name in names)
    rows = [row for row in there.rows[header] if row[: len(like)] == like and row in there.values]
    line = f"{key} = {value}"
    if rows:
        at = max(there.values[row][1] for row in rows)
        last = max(rows, key=lambda row: there.keys[row])
        begin = text.rfind("\n", 0, there.keys[last]) + 1
        match = _ROW.match(text, begin)
        if match is not None:
            indent, name, before, after = match.groups()
            width = len(name) + len(before)
            line = f"{indent}{key:<{width}}" if before else f"{indent}{key}"
            line += " " if before and not line.endswith(" ") else ""
            line += f"={after}{value}"
        return _line_behind(text, at, line)
    if not header:
        return f"{line}{_newline(text)}{text}"
    return _line_behind(text, there.headers[header], line)


def _line_behind(text: str, at: int, line: str) -> str:
    """Return a text with one more line behind that of a place."""
    end = _end_of_line(text, at)
    newline = _newline(text)
    before = "" if text[:end].endswith("\n") else newline
    behind = newline if text[:end].endswith("\n") else ""
    return f"{text[:end]}{before}{line}{behind}{text[end:]}"


def with_key(text: str, path: Path, key: str) -> str:
    """Return a text in which what stands at a path has another key, wherever that is written.

    Raises
    ------
    Unplaced
        If that cannot be followed.
    """
    there = layout(text)
    wanted = tomllib.loads(text)
    try:
        *above, last = path
        at: Any = wanted
        for part in above:
            at = at[part]
        at[key] = at.pop(last)
    except (KeyError, IndexError, TypeError, AttributeError):
        raise Unplaced(path) from None
    depth = sum(isinstance(part, str) for part in path)
    spots = [
        _key_part(text, text.rfind("\n", 0, end) + 1, depth)
        for header, end in there.headers.items()
        if header[: len(path)] == path
    ]
    for row, begin in there.keys.items():
        table = _table_of(row, there)
        if row[: len(path)] == path and len(table) < len(path):
            spots.append(_key_part(text, begin, len(path) - len(table)))
    for begin, end in sorted(spots, reverse=True):
        text = text[:begin] + key_text(key) + text[end:]
    return _checked(text, wanted, path)


def _table_of(row: Path, there: Layout) -> Path:
    """Return the table, in braces or with a header, in which a key stands."""
    braces = [row[:k] for k in range(len(row)) if row[:k] in there.inline]
    return braces[-1] if braces else next(k for k, rows in there.rows.items() if row in rows)


def _key_part(text: str, begin: int, number: int) -> tuple[int, int]:
    """Return where a part of a key stands, counted from 1, that begins there, in brackets or not."""
    parts = _PART.finditer(text, begin)
    return next(islice(parts, number - 1, None)).span()


def without_table(text: str, path: Path) -> str:
    """Return a text without a table that has a header or dotted keys, and without what comments belong to it.

    Of a header these are the lines above it, and below its last key, that no empty line parts from it.

    Raises
    ------
    Unplaced
        If the table is written otherwise.
    """
    try:
        wanted = put(tomllib.loads(text), path, None)
    except LookupError:
        raise Unplaced(path) from None
    if wanted.get(str(path[0])) == []:
        del wanted[str(path[0])]
    there = layout(text)
    own = [one for one in there.headers if one[: len(path)] == path]
    dotted = [
        row
        for header, rows in there.rows.items()
        for row in rows
        if len(header) < len(path) < len(row) and row[: len(path)] == path
    ]
    for row in sorted(dotted, key=lambda one: there.keys[one], reverse=True):
        text = _without(text, there, row)
    for one in sorted(own, key=lambda one: there.headers[one], reverse=True):
        begin, end = _block(text, there, one)
        behind = _EMPTY.match(text, end)
        if behind is not None and (not text[:begin].strip() or _ENDS_EMPTY.search(text[:begin])):
            end = behind.end()
        text = text[:begin] + text[end:]
    return _checked(text, wanted, path)


def as_list(text: str, section: str) -> str:
    """Return a text whose table of a section is the first of a list of tables: its header has two brackets.

    Raises
    ------
    Unplaced
        If the table has no header of its own.
    """
    doc, end = tomllib.loads(text), layout(text).headers.get((section,))
    if end is None:
        raise Unplaced((section,))
    begin = text.rfind("\n", 0, end) + 1
    header = text[begin : _end_of_line(text, end)]
    name, bracket, behind = header.partition("]")
    made = f"{name.replace('[', '[[', 1)}{2 * bracket}{behind}"
    made = text[:begin] + made + text[begin + len(header) :]
    return _checked(made, {**doc, section: [doc[section]]}, (section,))


def with_table(text: str, section: str, table: dict[str, Any], *, several: bool) -> str:
    """Return a text with one more table of a section: behind the last of it, or the last of those before it.

    ``several``: the section is a list of tables.

    Raises
    ------
    Unplaced
        If its place cannot be followed.
    """
    there, doc = layout(text), tomllib.loads(text)
    wanted = {**doc, section: [*doc.get(section, ()), table] if several else table}
    newline = _newline(text)
    order = [LENGTHS, *declared()]
    before = order[: order.index(section) + 1]
    blocks = {one: _block(text, there, one) for one in there.headers}
    ends = [end for one, (_, end) in blocks.items() if one[0] in before]
    begin = min((begin for begin, _ in blocks.values()), default=len(text))
    at = max(ends, default=begin)
    name = key_text(section)
    wide = (
        max(map(len, table), default=0) if _has_columns(section) and _in_columns(text, there) else 0
    )
    lines = [f"[[{name}]]" if several else f"[{name}]"]
    lines += [f"{key_text(key):<{wide}} = {toml(value)}" for key, value in table.items()]
    block = "".join(line + newline for line in lines)
    if blocks and not ends:
        made = f"{text[:at]}{block}{newline}{text[at:]}"
    else:
        gap = "" if not at else newline if text[:at].endswith("\n") else 2 * newline
        made = f"{text[:at]}{gap}{block}{text[at:]}"
    return _checked(made, wanted, (section,))


def _has_columns(section: str) -> bool:
    """Whether the keys of a section are declared; one whose keys are names has no columns."""
    known = declared().get(section)
    return known is not None and getattr(known.record, "OTHERS", None) is None


def _in_columns(text: str, there: Layout) -> bool:
    """Whether values stand below each other in a text, or nowhere beside shorter and longer keys."""
    rows = [rows for header, rows in there.rows.items() if header and _has_columns(str(header[0]))]
    columns = [
        {text.index("=", there.keys[one]) - there.keys[one] for one in some} for some in rows
    ]
    return bool(_ALIGNED.search(text)) or all(len(some) < 2 for some in columns)


def _block(text: str, there: Layout, header: Path) -> tuple[int, int]:
    """Return where a header begins and its keys end, with the comments that no empty line parts from them."""
    begin = text.rfind("\n", 0, there.headers[header]) + 1
    ends = [there.values[row][1] for row in there.rows[header] if row in there.values]
    end = _end_of_line(text, max(ends, default=there.headers[header]))
    above = _COMMENTS_ABOVE.search(text[:begin])
    assert above is not None
    below = _COMMENTS_BELOW.match(text, end)
    return above.start(), below.end() if below is not None else end


def _end_of_line(text: str, at: int) -> int:
    match = _REST.match(text, at)
    return match.end() if match is not None else at


def _at_the_end(text: str, section: str, line: str) -> str:
    newline = _newline(text)
    gap = newline if text and not text.endswith("\n") else ""
    return f"{text}{gap}{newline}[{key_text(section)}]{newline}{line}{newline}"


def _newline(text: str) -> str:
    return "\r\n" if "\r\n" in text else "\n"
