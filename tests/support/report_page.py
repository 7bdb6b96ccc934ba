"""A finished report as it is read: headings, sentences, tables, printed numbers and sums of them."""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Mapping
from html.parser import HTMLParser
from typing import Any, NamedTuple

NUMBER = re.compile(r"−?\d+(?:[.,]\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


class Table(NamedTuple):
    heading: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


class Page(HTMLParser):
    """Headings and paragraphs in their order, tables; no pictures, no style."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.sentences: list[tuple[str, str]] = []
        self.tables: list[Table] = []
        self._heading, self._inside, self._text = "", "", ""
        self._hidden = 0
        self._head: list[str] = []
        self._rows: list[list[str]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self._hidden += tag in ("svg", "style", "title")
        if tag in ("h1", "h2", "h3", "p", "li", "summary", "th", "td"):
            self._inside, self._text = tag, ""
        if tag == "table":
            self._head, self._rows = [], []
        if tag == "tr":
            self._rows.append([])

    def handle_data(self, data: str) -> None:
        self._text += "" if self._hidden else data

    def handle_endtag(self, tag: str) -> None:
        self._hidden -= tag in ("svg", "style", "title")
        if tag == "table":
            rows = tuple(tuple(row) for row in self._rows if row)
            self.tables.append(Table(self._heading, tuple(self._head), rows))
        if tag != self._inside:
            return
        text, self._inside = " ".join(self._text.split()), ""
        folded = tag == "summary" and re.fullmatch(
            r"\w+: \d+", text
        )  # a table of the heading above
        if tag in ("h1", "h2", "h3", "summary") and not folded:
            self._heading = text
        if tag == "th":
            self._head.append(text)
        elif tag == "td":
            self._rows[-1].append(text)
        elif text:
            self.sentences.append((self._heading, text))


def worth(text: str) -> float:
    """Return what a printed number is worth."""
    mantissa, _, power = text.replace("−", "-").replace(",", ".").partition("·10")
    return float(mantissa) * 10.0 ** int(power.translate(RAISED) or "0")


_OPERATIONS: Mapping[type, Any] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.Pow: operator.pow, ast.USub: operator.neg, ast.UAdd: operator.pos,
}  # fmt: skip


def reckoned(text: str) -> float | None:
    """Return what a printed sum of numbers comes to; None where it is more than sums, products and powers."""
    text = text.replace(",", ".").replace("−", "-").replace("²", "**2").replace("³", "**3")
    text = re.sub(r"·10([⁻⁰¹⁴-⁹]+)", lambda f: f"*1e{f[1].translate(RAISED)}", text).replace(
        "·", "*"
    )
    if not re.fullmatch(r"[-\d.()*/+ e]+", text):
        return None

    def of(node: ast.AST) -> float:
        if isinstance(node, ast.Constant):
            return float(node.value)  # type: ignore[arg-type]
        if isinstance(node, ast.UnaryOp):
            return float(_OPERATIONS[type(node.op)](of(node.operand)))
        assert isinstance(node, ast.BinOp)
        return float(_OPERATIONS[type(node.op)](of(node.left), of(node.right)))

    return of(ast.parse(text, mode="eval").body)
