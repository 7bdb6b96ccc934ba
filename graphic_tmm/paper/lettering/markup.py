r"""The mark-up of lettering, read into a tree; letters of the log in it: figures as indices.

=================== ============================================================================
``v_A  v_{BA}``     subscript: one character or a group; ``ω₁`` is the same as ``ω_1``
``a^n  n_{BA}^{t}`` superscript; both at once stand one above the other; ``мм²`` = ``мм^2``
``\bar{v}``         a line over the group: a vector
``\u{..} \uu{..}``  one line, or two, under the group: a vector known in direction, or wholly
``\_ \^ \{ \} \\``  the character itself
=================== ============================================================================
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

from graphic_tmm.errors import SheetError

_SIGNS = "0123456789+−"
_LOW = dict(zip(_SIGNS, "₀₁₂₃₄₅₆₇₈₉₊₋", strict=True))
_HIGH = dict(zip(_SIGNS, "⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", strict=True))
_LOWERED = {index: sign for sign, index in _LOW.items()}
_RAISED = {index: sign for sign, index in _HIGH.items()}
INDICES = frozenset(_LOWERED) | frozenset(_RAISED)
"""Characters of Unicode that stand for a raised or lowered one."""

_SPECIAL = frozenset("_^{}\\")
_TOLD = _SPECIAL | INDICES
_COMMANDS = ("bar", "uu", "u")
_DEEPEST = 8
"""Greatest depth of nested groups: chosen by eye, far more than can be read."""


class Text(NamedTuple):
    """Letters in a row."""

    text: str


class Lined(NamedTuple):
    """A group with a line over it ("bar"), or with one ("u") or two ("uu") lines under it."""

    kind: str
    inside: tuple[Node, ...]


class Scripts(NamedTuple):
    """The indices of what stands before them: the lower one, the upper one, or both."""

    lower: tuple[Node, ...] | None
    upper: tuple[Node, ...] | None


Node = Text | Lined | Scripts


def escape(text: str) -> str:
    """Return the mark-up that draws a plain text as it is."""
    return "".join("\\" + c if c in _SPECIAL else c for c in text)


@lru_cache(maxsize=4096)
def plain(markup: str) -> str:
    r"""Return readable plain text, for titles and search: v_BA for \bar{v}_{BA}; ω₁, мм².

    An index of digits becomes that of Unicode; another stays behind ``_`` or ``^``.
    """
    return _plain(parse_markup(markup))


def parse_markup(markup: str) -> tuple[Node, ...]:
    """Read a mark-up; SheetError names the character at which it is faulty."""
    if _TOLD.isdisjoint(markup):
        return (Text(markup),) if markup else ()
    nodes, end = _sequence(markup, 0, 0)
    if end < len(markup):
        raise _faulty(markup, end, r"a closing brace without its opening one (\} for the sign)")
    return nodes


def _plain(nodes: Iterable[Node]) -> str:
    words = []
    for node in nodes:
        if isinstance(node, Text):
            words.append(node.text)
        elif isinstance(node, Lined):
            words.append(_plain(node.inside))
        else:
            words.append(_plain_index(node.lower, "_", _LOW))
            words.append(_plain_index(node.upper, "^", _HIGH))
    return "".join(words)


def _plain_index(nodes: tuple[Node, ...] | None, sign: str, digits: dict[str, str]) -> str:
    text = _plain(nodes or ())
    signs = text.replace("-", "−")
    if all(c in digits for c in signs):
        return "".join(digits[c] for c in signs)
    return f"{sign}{text}" if text.isalnum() else f"{sign}({text})"


def _sequence(markup: str, at: int, depth: int) -> tuple[tuple[Node, ...], int]:
    """Nodes up to the end of the mark-up or the closing brace of a group, and where that stands."""
    nodes: list[Node] = []
    while at < len(markup) and markup[at] != "}":
        if markup[at] in "_^":
            at = _script(markup, at, depth, nodes)
        elif markup[at] in INDICES:
            _join_index(nodes, markup[at])
            at += 1
        else:
            inside, at = _atom(markup, at, depth)
            _join(nodes, inside)
    return tuple(nodes), at


def _join(nodes: list[Node], more: Iterable[Node]) -> None:
    """Append nodes; letters join the letters before them."""
    for node in more:
        last = nodes[-1] if nodes else None
        if isinstance(node, Text) and isinstance(last, Text):
            nodes[-1] = Text(last.text + node.text)
        else:
            nodes.append(node)


def _join_index(nodes: list[Node], index: str) -> None:
    """Append a raised or lowered character; one index may follow another, the upper the lower."""
    raised = index in _RAISED
    last = nodes[-1] if nodes else None
    if not isinstance(last, Scripts) or (last.upper is not None and not raised):
        last = Scripts(None, None)
        nodes.append(last)
    row = list((last.upper if raised else last.lower) or ())
    _join(row, (Text((_RAISED if raised else _LOWERED)[index]),))
    done = tuple(row)
    nodes[-1] = last._replace(upper=done) if raised else last._replace(lower=done)


def _script(markup: str, at: int, depth: int, nodes: list[Node]) -> int:
    """Read ``_..`` or ``^..`` and join it to the other one if that stands just before it."""
    sign = markup[at]
    if at + 1 >= len(markup) or markup[at + 1] in "}_^":
        raise _faulty(markup, at, f"nothing behind {sign!r} (write \\{sign} for the sign itself)")
    inside, end = _atom(markup, at + 1, depth)
    last = nodes[-1] if nodes else None
    if not isinstance(last, Scripts):
        last = Scripts(None, None)
        nodes.append(last)
    if (last.lower if sign == "_" else last.upper) is not None:
        raise _faulty(markup, at, f"a second {sign!r} at the same letter")
    nodes[-1] = last._replace(lower=inside) if sign == "_" else last._replace(upper=inside)
    return end


def _atom(markup: str, at: int, depth: int) -> tuple[tuple[Node, ...], int]:
    """Read a character, an escaped one, a group or a lined group; its nodes and where it ends."""
    character = markup[at]
    if character == "{":
        return _group(markup, at, depth)
    if character in INDICES:
        nodes: list[Node] = []
        _join_index(nodes, character)
        return tuple(nodes), at + 1
    if character != "\\":
        return (Text(character),), at + 1
    if at + 1 < len(markup) and markup[at + 1] in _SPECIAL:
        return (Text(markup[at + 1]),), at + 2
    for command in _COMMANDS:
        if markup.startswith(command + "{", at + 1):
            inside, end = _group(markup, at + 1 + len(command), depth)
            return (Lined(command, inside),), end
    raise _faulty(
        markup, at, r"unknown command (\bar{..}, \u{..}, \uu{..}; \\ for the sign itself)"
    )


def _group(markup: str, at: int, depth: int) -> tuple[tuple[Node, ...], int]:
    if depth >= _DEEPEST:
        raise _faulty(markup, at, f"groups nested more than {_DEEPEST} deep")
    inside, end = _sequence(markup, at + 1, depth + 1)
    if end >= len(markup):
        raise _faulty(markup, at, r"an opening brace without its closing one (\{ for the sign)")
    return inside, end + 1


def _faulty(markup: str, at: int, what: str) -> SheetError:
    return SheetError(f"lettering {markup!r}, character {at + 1}: {what}")


def markup(letter: str, number: str = "") -> str:
    """Return a letter of the log as lettered on the sheet: figures become indices, d3d -> d_{3}d.

    The number of a position follows in the last index: a_{3,5}.
    """
    if "_" in letter:
        return letter
    text = re.sub(r"([^\W\d])(\d+)", r"\1_{\2}", letter)
    if not number:
        return text
    return f"{text[:-1]},{number}}}" if text.endswith("}") else f"{text}_{{{number}}}"
