"""The page's program with short names: what a module calls its own is one letter or two in the page.

A name is shortened wherever it stands for a binding, and alike in the whole program, so that no scope has to be
known: what is declared nowhere, and what a program has of the browser, keeps its name, as members and keys do.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import count
from string import ascii_letters, digits
from typing import NamedTuple

_TOKEN = re.compile(
    r"""(?P<skip>/\*.*?\*/|//[^\n]*)|(?P<space>\s+)|(?P<quoted>"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')"""
    r"""|(?P<number>(?:0x[\da-fA-F]+|(?:\d[\d_]*\.?\d*|\.\d+)(?:e[-+]?\d+)?))"""
    r"""|(?P<name>[A-Za-z_$][\w$]*)|(?P<sign>=>|\?\.(?!\d)|\.\.\.|&&|\|\||\?\?|[^\s\w])""",
    re.S,
)
_PATTERN = re.compile(r"/(?:[^/\\\[\n]|\\.|\[(?:[^\]\\\n]|\\.)*\])+/[a-z]*")
_BEFORE_PATTERN = frozenset([*"(,=:[!&|?{};+-*", "&&", "||", "??", "=>", "return"])
_WORDS_OF_SCRIPT = """
async await break case catch class const constructor continue default delete do else export extends false
finally for from function get if import in instanceof let new null of return set static super switch this throw
true try typeof undefined var void while yield arguments eval as
"""
_KEYWORDS = frozenset(_WORDS_OF_SCRIPT.split())
BROWSERS = frozenset({"window"})
"""What modules take from the browser although something of theirs is called so (`tests/page`)."""
_OBJECT = frozenset([*"=(,[:?", "return", "...", "const", "let", "&&", "||", "??", "yield"])
_MEMBER = frozenset([*"{;},", "get", "set", "static", "async"])
_HEADS = frozenset({"if", "for", "while", "switch", "return"})
_TEMPLATE_BEGINS, _TEMPLATE_ENDS = ("begin", "middle"), ("middle", "end of template")
_WORDS, _DOUBLED = {"name", "number"}, {"+", "-", "/"}
_FIRST = ascii_letters
_FURTHER = ascii_letters + digits


class Token(NamedTuple):
    """A part of a program: its kind; ``text`` as it stands; ``role`` of a name.

    Roles: "used" stands for a binding, "short" is the key of an object, too; "own" is a member.
    """

    kind: str
    text: str
    role: str = ""
    declared: bool = False


def shortened(parts: Iterable[str]) -> str:
    """Return the parts of a program with short names, without remarks and blanks."""
    tokens = [one for part in parts for one in _read(part)]
    declared = {one.text for one in tokens if one.declared} - BROWSERS
    uses = Counter(one.text for one in tokens if one.role not in ("", "own"))
    kept = _KEYWORDS | (uses.keys() - declared)
    free = (name for name in _names() if name not in kept)
    most = sorted(declared, key=lambda name: (-uses[name], name))
    short = dict(zip(most, free, strict=False))
    return "".join(_written(one, short) for one in tokens)


def _written(one: Token, short: dict[str, str]) -> str:
    if one.role in ("", "own"):
        return one.text
    name = short.get(one.text, one.text)
    return f"{one.text}:{name}" if one.role == "short" and name != one.text else name


def _names() -> Iterator[str]:
    """Yield names, the shortest first."""
    yield from _FIRST
    for behind in count(1):
        for first in _FIRST:
            for n in range(len(_FURTHER) ** behind):
                rest = ""
                for _ in range(behind):
                    n, k = divmod(n, len(_FURTHER))
                    rest += _FURTHER[k]
                yield first + rest


@cache
def _read(code: str) -> tuple[Token, ...]:
    """Return the tokens of a part of a program, names with their roles, without blanks that say nothing."""
    return tuple(_closed_up([*_roles(_tokens(code))]))


def _closed_up(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yield tokens without blanks about signs; a line ends where a bracket does."""
    for k, one in enumerate(tokens):
        if one.kind != "space":
            yield one
            continue
        before, after = tokens[k - 1] if k else one, tokens[k + 1] if k + 1 < len(tokens) else one
        if before.text == "}":
            yield Token("space", "\n" if "\n" in one.text else "")
        elif {before.kind, after.kind} <= _WORDS or {before.text, after.text} <= _DOUBLED:
            yield Token("space", " ")


def _tokens(code: str) -> list[Token]:
    """Return the tokens of a program, without remarks; what a template quotes is its own token."""
    found: list[Token] = []
    deep: list[int] = []
    at, last, level = 0, "", 0
    while at < len(code):
        sign = code[at]
        if sign == "`" or (sign == "}" and deep and deep[-1] == level):
            at, ends = _template(code, at + 1, found, sign)
            if sign == "}":
                deep.pop()
            if not ends:
                deep.append(level)
            last = "`" if ends else "("
            continue
        match = (_PATTERN if sign == "/" and last in _BEFORE_PATTERN else _TOKEN).match(code, at)
        if sign == "/" and code[at + 1] in "*/":
            match = _TOKEN.match(code, at)
        assert match is not None, code[at : at + 40]
        at, kind = match.end(), match.lastgroup or "quoted"
        if kind == "skip":
            continue
        level += (match[0] == "{") - (match[0] == "}")
        found.append(Token(kind, match[0]))
        if kind != "space":
            last = match[0] if kind in ("sign", "name") else kind
    return found


def _template(code: str, at: int, found: list[Token], begun: str) -> tuple[int, bool]:
    """Enter what a template quotes up to its end, or to what is put in; return where, and whether it ends."""
    begin = at - 1
    while True:
        if code[at] == "\\":
            at += 2
        elif code[at] == "`":
            found.append(
                Token("end of template" if begun == "}" else "quoted", code[begin : at + 1])
            )
            return at + 1, True
        elif code.startswith("${", at):
            kind = "middle" if begun == "}" else "begin"
            found.append(Token(kind, code[begin : at + 2]))
            return at + 2, False
        else:
            at += 1


def _roles(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yield tokens, each name with its role."""
    ends = [Token("end", "")]
    code = [*ends, *(one for one in tokens if one.kind != "space"), *ends, *ends]
    closes, inside = _brackets(code)
    declared = _declared(code, closes)
    k = 0
    for one in tokens:
        if one.kind == "space":
            yield one
            continue
        k += 1
        if one.kind == "name" and one.text not in _KEYWORDS:
            before = code[k - 2 if code[k - 1].text == "*" else k - 1].text
            role = _role(before, code[k + 1].text, inside[k])
            yield one._replace(role=role, declared=k in declared)
        else:
            yield one


def _brackets(code: Sequence[Token]) -> tuple[dict[int, int], list[str]]:
    """Return where each bracket is closed, and in what each token stands: "class", "object", another."""
    closes: dict[int, int] = {}
    inside: list[str] = []
    open_: list[tuple[int, str]] = [(0, "")]
    for k, one in enumerate(code):
        if one.kind in _TEMPLATE_ENDS or one.text in (")", "]", "}"):
            closes[open_.pop()[0]] = k
        inside.append(open_[-1][1])
        if one.kind == "sign" and one.text in "([{":
            open_.append((k, _bracket(code, k)))
        elif one.kind in _TEMPLATE_BEGINS:
            open_.append((k, "`"))
    return closes, inside


def _bracket(code: Sequence[Token], k: int) -> str:
    """Return what a bracket begins."""
    if code[k].text != "{":
        return code[k].text
    for behind in reversed(code[max(k - 5, 0) : k]):
        if behind.text == "class":
            return "class"
        if behind.kind == "sign":
            break
    return "object" if code[k - 1].text in _OBJECT else "{"


def _declared(code: Sequence[Token], closes: Mapping[int, int]) -> set[int]:
    """Return which tokens declare a name: behind a word for it, in a pattern, as what a function takes."""
    found = set[int]()
    for k, one in enumerate(code):
        if one.kind == "name" and code[k + 1].text == "=>":
            found.add(k)
        elif one.text in ("function", "class"):
            found.add(k + 1 + (code[k + 1].text == "*"))
        elif one.text in ("const", "let"):
            if code[k + 1].text in ("[", "{"):
                found |= _taken(code, k + 1, closes[k + 1])
            else:
                found |= {k + 1 + n for n in range(0, _listed(code, k + 1), 2)}
        elif one.text == "(" and k in closes:
            behind = code[closes[k] + 1].text
            heads = code[k - 1].kind == "name" and code[k - 1].text not in _HEADS
            if behind == "=>" or (behind == "{" and heads):
                found |= _taken(code, k, closes[k])
    return {k for k in found if code[k].kind == "name" and code[k].text not in _KEYWORDS}


def _listed(code: Sequence[Token], begin: int) -> int:
    """Return how many tokens names with nothing but commas between them are."""
    end = begin + 1
    while code[end].text == "," and code[end + 1].kind == "name":
        end += 2
    return end - begin


def _taken(code: Sequence[Token], begin: int, end: int) -> set[int]:
    """Return the names of a pattern."""
    return {
        k
        for k in range(begin + 1, end)
        if code[k].kind == "name"
        and code[k - 1].text in ("(", ",", "{", "[", "...", ":")
        and code[k + 1].text in (",", ")", "}", "]", "=")
    }


def _role(before: str, after: str, inside: str) -> str:
    """Return what a name is by what stands beside it and in what it stands."""
    if before in (".", "?."):
        return "own"
    if inside not in ("class", "object") or before not in _MEMBER:
        return "used"
    if inside == "class" or after in (":", "(") or before not in ("{", ","):
        return "own"
    return "short"
