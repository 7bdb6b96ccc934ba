r"""Formulas as TeX: trees of the board's formulas, letters as lettered on sheets, numbers with their units.

Only what pandoc understands in all its formats is written; a letter that TeX has no name for stands in \text.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import groupby

from graphic_tmm.board.formula_text import FUNCTIONS, Node
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.symbols import function
from graphic_tmm.language.units import unit
from graphic_tmm.note.document import Formula, Leaf, Number, Symbol, Tree
from graphic_tmm.paper.lettering import markup
from graphic_tmm.paper.lettering.markup import markup as indexed

SIGNS = {
    "·": r" \cdot ",
    "−": "-",
    "–": r"\text{–}",
    "-": r"\text{-}",
    "×": r" \times ",
    "±": r" \pm ",
    "=": " = ",
    "≠": r" \neq ",
    "≤": r" \leq ",
    "≥": r" \geq ",
    "<": " < ",
    ">": " > ",
    "∥": r" \parallel ",
    "⊥": r" \perp ",
    "→": r" \rightarrow ",
    "∞": r"\infty ",
    "′": "'",
    "″": "''",
    "*": r"\ast ",
    " ": r"\ ",
    ",": ",",
    "Δ": r"\Delta ",
    "Σ": r"\Sigma ",
    "Φ": r"\Phi ",
    "Ω": r"\Omega ",
    "Θ": r"\Theta ",
    "α": r"\alpha ",
    "β": r"\beta ",
    "γ": r"\gamma ",
    "δ": r"\delta ",
    "ε": r"\varepsilon ",
    "ζ": r"\zeta ",
    "η": r"\eta ",
    "θ": r"\theta ",
    "ϑ": r"\vartheta ",
    "κ": r"\kappa ",
    "λ": r"\lambda ",
    "μ": r"\mu ",
    "ν": r"\nu ",
    "ξ": r"\xi ",
    "π": r"\pi ",
    "ρ": r"\rho ",
    "σ": r"\sigma ",
    "τ": r"\tau ",
    "φ": r"\varphi ",
    "χ": r"\chi ",
    "ψ": r"\psi ",
    "ω": r"\omega ",
}
"""What TeX calls the signs of sheets."""
_PLAIN = frozenset("0123456789+()[]|/.:;!'")
_ESCAPED = {c: "\\" + c for c in "{}$%#&_"} | {
    "\\": r"\textbackslash ",
    "~": r"\textasciitilde ",
    "^": r"\textasciicircum ",
}
_WORDS = frozenset(
    {"in", "dr", "ser", "mean", "red", "max", "min", "lim", "Zh", "bal", "fly", "bl"}
)
"""Indices that are words: they stand upright."""
_WORD = re.compile("[–\u0400-\u04ff-]")
"""An index with one of these, a Cyrillic letter or a dash, is words, or a range: no product of letters."""
_MOST = re.compile(r"(.*?)(max|min)(\d*)")
"""An index that ends with such a word, figures behind it: 3max, min1."""
_STAR = re.compile(r"(?<=[A-Za-z\d])\*")
"""A star behind a letter is raised: between two it would be a sign of multiplication."""
_NAMED = {"arcsin", "arccos", "arctan", "sin", "cos", "tan", "max", "min"}
_RELATIONS = {"=": " = ", "≠": r" \neq ", "<": " < ", ">": " > ", "≤": r" \leq ", "≥": r" \geq "}

_LEADS = {"−": "-", "±": r"\pm"}
"""Signs with which a line goes on with a sum."""
BEGUN = {"open": ("(", ""), "close": ("", ")"), "inner": ("", "")}
"""Parts of a bracket over several lines: its first, its last (which may be divided), those between."""

Ink = markup.Text | markup.Lined | markup.Scripts
Put = Callable[[str], str]
"""How a format writes the digits of a number."""


def spelt(digits: str) -> str:
    """Return a number as TeX writes it: a decimal comma is no comma between two things."""
    if not digits[-1:].isdigit():
        return one_word(digits)
    return digits.replace(",", "{,}").replace("−", "-")


def one_word(digits: str) -> str:
    """Return a number as one word, unless it is of digits only: a sign or a comma would stand apart."""
    return digits if digits.isdigit() else rf"\text{{{escaped(digits)}}}"


def tex(one: Formula | Tree | Leaf, language: str, put: Put = one_word) -> str:
    """Return a formula as TeX; ``put``: how digits are written."""
    return _Writer(language, put).written(one)


def escaped(words: str) -> str:
    r"""Return words as they stand within \text."""
    return "".join(_ESCAPED.get(c, c) for c in words)


class _Writer:
    """Writes the formulas of one language with the digits of one format."""

    def __init__(self, language: str, put: Put) -> None:
        self.language, self.put = language, put
        self.flat = False
        """Fractions are written in a line: the formula stands among words."""
        self.signed = False
        """A sign stands before what is written now."""
        self.led = False
        """A sign stands before the line that is written now, which goes on with a sum."""

    def written(self, one: Formula | Tree | Leaf) -> str:
        if isinstance(one, Symbol):
            return self.markup(one.markup)
        if isinstance(one, Number):
            return self.number(one)
        if isinstance(one, Tree):
            return self.tree(one.node, one.put)
        sign = _RELATIONS.get(one.sign, f" {one.sign} ")
        self.flat, self.led = one.flat, bool(one.lead)
        found = sign.join(self.written(side) for side in one.sides)
        if one.follows:
            lead = _LEADS.get(one.lead, one.lead) or sign
            found = f"{lead.strip()} {found}"
        return found + "".join(rf",\quad {self.written(more)}" for more in one.behind)

    # ------------------------------------------------------------ letters

    def markup(self, told: str) -> str:
        if told.startswith("inv "):
            return rf"\mathrm{{inv}}\, {self.markup(told[4:])}"
        return self._nodes(markup.parse_markup(indexed(_STAR.sub("^{*}", told))), False).strip()

    def _nodes(self, nodes: Iterable[Ink], index: bool) -> str:
        return "".join(self._node(node, index) for node in nodes)

    def _node(self, node: Ink, index: bool) -> str:
        if isinstance(node, markup.Text):
            return self._text(node.text, index)
        if isinstance(node, markup.Lined):
            inside = self._nodes(node.inside, index).strip()
            if node.kind == "bar":
                return rf"\bar{{{inside}}}"
            lined = rf"\underline{{{inside}}}"
            return rf"\underline{{{lined}}}" if node.kind == "uu" else lined
        found = ""
        for sign, part in (("_", node.lower), ("^", node.upper)):
            if part is not None:
                found += f"{sign}{{{self._nodes(part, True).strip()}}}"
        return found

    def _text(self, words: str, index: bool) -> str:
        if index and words in _WORDS:
            return rf"\mathrm{{{words}}}"
        if index and (found := _MOST.fullmatch(words)):
            return f"{self._text(found[1], True)}\\mathrm{{{found[2]}}}{found[3]}"
        if index and _WORD.search(words):
            return _upright(words)
        told = []
        for known, some in groupby(words, key=_known):
            run = "".join(some)
            told.append("".join(SIGNS.get(c, c) for c in run) if known else _upright(run))
        return "".join(told)

    # ------------------------------------------------------------ numbers

    def number(self, one: Number) -> str:
        """Return a number with its unit; a sign of degrees or of hundredths is a part of it."""
        if one.unit in ("°", "%"):
            return self.digits(one.text, one.unit)
        found, told = self.digits(one.text), unit(one.unit, self.language)
        return rf"{found}\ \text{{{escaped(told)}}}" if told else found

    def digits(self, told: str, sign: str = "") -> str:
        """Return a number as `language.numbers` tells it; powers of ten are raised."""
        mantissa, _, power = told.partition("·10")
        if not power:
            return self.put(mantissa + sign)
        return rf"{self.put(mantissa)} \cdot 10^{{{power.translate(_LOWERED)}}}"

    # ------------------------------------------------------------ trees

    def tree(self, node: Node, put: Mapping[str, Leaf]) -> str:
        if node.head in _LEAVES:
            return self._leaf(node, put)
        if node.head in ("·", "/"):
            return self._product(node, put)
        if node.head in ("+", "−", "±"):
            left, right = node.parts
            sign = {"+": " + ", "−": " - ", "±": r" \pm "}[node.head]
            before = self.tree(left, put)
            self.signed = True
            behind = self._within(right, put, ("+", "−", "±"), first=False)
            self.signed = False
            return before + sign + behind
        if node.head == "neg":
            return f"-{self._within(node.parts[0], put, ('+', '−', '±'), first=False)}"
        if node.head == "^":
            return self._power(node, put)
        if node.head in ("radians", "degrees"):
            return self.tree(node.parts[0], put)
        if node.head in BEGUN:
            before, behind = BEGUN[node.head]
            told = f"{before}{self.tree(node.parts[0], put)}{behind}"
            return told + "".join(f"/{self._below(part, put)}" for part in node.parts[1:])
        if node.head in _RELATIONS:
            return _RELATIONS[node.head].join(self.tree(part, put) for part in node.parts)
        return self._call(node, put)

    def _leaf(self, node: Node, put: Mapping[str, Leaf]) -> str:
        if node.head == "π":
            return r"\pi "
        if node.head == "name":
            led, self.led = self.led, False
            leaf = put.get(node.word, Symbol(node.word))
            told = self.written(leaf) if node.word in put else self._text(node.word, False)
            minus = led and isinstance(leaf, Number) and leaf.text.startswith("−")
            return rf"\left({told}\right)" if minus else told
        degrees = "°" if node.head == "°" else ""
        return self.put(node.word.replace(".", decimal_sign(self.language)) + degrees)

    def _power(self, node: Node, put: Mapping[str, Leaf]) -> str:
        base, power = node.parts
        raised = self.tree(power, put).strip()
        if base.head in _NAMED and power.head == "figure":
            return rf"{self._named(base.head)}^{{{raised}}} {self._argument(base.parts[0], put)}"
        return f"{self._base(base, put)}^{{{raised}}}"

    def _named(self, name: str) -> str:
        """Return a function as its language calls it; what TeX does not know by name is an operator too."""
        called = function(name, self.language)
        return rf"\{name}" if called == name else rf"\operatorname{{{called}}}"

    def _base(self, node: Node, put: Mapping[str, Leaf]) -> str:
        told = self.tree(node, put).strip()
        if node.head == "name":
            leaf = put.get(node.word)
            bare = not isinstance(leaf, Number) or not (leaf.unit or leaf.text.startswith("−"))
            simple = bare and not _powered(node, put)
            if simple and not (isinstance(leaf, Symbol) and "^" in leaf.markup):
                return told if not isinstance(leaf, Number) else f"{{{told}}}"
            return rf"{{\left({told}\right)}}"
        return told if node.head in ("figure", "π", "abs") else rf"{{\left({told}\right)}}"

    def _product(self, node: Node, put: Mapping[str, Leaf]) -> str:
        above, below = list[Node](), list[Node]()
        for factor, over in _factors(node):
            (below if over else above).append(factor)
        if not below:
            return self._row(above, put)
        if not self.flat:
            return rf"\frac{{{self._row(above, put)}}}{{{self._row(below, put)}}}"
        upper, lower = (self._row(row, put) for row in (above, below))
        plain = len(below) == 1 and not _powered(below[0], put)
        return f"{upper}/{lower}" if plain else f"{upper}/({lower})"

    def _row(self, factors: Sequence[Node], put: Mapping[str, Leaf]) -> str:
        """Return factors of a product; one that stands alone above or below a line needs no brackets."""
        if len(factors) == 1 and not self.flat:
            return self.tree(factors[0], put)
        loose = ("+", "−", "±", "neg")
        begun, self.signed = not self.signed, False
        told = [
            self._within(one, put, loose, first=begun and not k) for k, one in enumerate(factors)
        ]
        return r" \cdot ".join(told)

    def _below(self, node: Node, put: Mapping[str, Leaf]) -> str:
        """Return what stands behind a stroke of a fraction; a power of ten there would be a factor above it."""
        told = self.tree(node, put)
        return told if node.head in _LEAVES and not _powered(node, put) else f"({told})"

    def _within(
        self, node: Node, put: Mapping[str, Leaf], loose: tuple[str, ...], *, first: bool
    ) -> str:
        """Return a part in brackets where it would else come apart, or two signs would meet."""
        told = self.tree(node, put)
        leaf = put.get(node.word) if node.head == "name" else None
        minus = isinstance(leaf, Number) and leaf.text.startswith("−") and not first
        return rf"\left({told}\right)" if node.head in loose or minus else told

    def _call(self, node: Node, put: Mapping[str, Leaf]) -> str:
        told = [self.tree(part, put) for part in node.parts]
        if node.head == "sqrt":
            return rf"\sqrt{{{told[0]}}}"
        pairs = {
            "abs": ("|", "|"),
            "ceil": (r"\lceil", r"\rceil"),
            "floor": (r"\lfloor", r"\rfloor"),
        }
        if node.head in pairs:
            left, right = pairs[node.head]
            return rf"\left{left} {told[0]} \right{right}"
        name = (
            self._named(node.head) if node.head in _NAMED else rf"\mathrm{{{escaped(node.head)}}}"
        )
        if len(told) > 1:
            return rf"{name}\left({', '.join(told)}\right)"
        apart = "" if node.head in _NAMED else r"\,"
        return f"{name}{apart} {self._argument(node.parts[0], put)}"

    def _argument(self, node: Node, put: Mapping[str, Leaf]) -> str:
        inner = node.parts[0] if node.head in ("radians", "degrees") else node
        told = self.tree(inner, put)
        if inner.head in _LEAVES or inner.head in FUNCTIONS:
            return told
        return rf"\left({told}\right)"


_LEAVES = ("name", "figure", "°", "π")
_LOWERED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


def _factors(node: Node, over: bool = False) -> Iterable[tuple[Node, bool]]:
    """Yield the factors of a product or quotient, each with whether it stands below the line."""
    if node.head == "·":
        for part in node.parts:
            yield from _factors(part, over)
    elif node.head == "/":
        yield from _factors(node.parts[0], over)
        yield from _factors(node.parts[1], not over)
    else:
        yield node, over


def _powered(node: Node, put: Mapping[str, Leaf]) -> bool:
    """Whether a part is a number with a power of ten, which is a product."""
    leaf = put.get(node.word) if node.head == "name" else None
    return isinstance(leaf, Number) and "·10" in leaf.text


def _known(c: str) -> bool:
    return c in SIGNS or c in _PLAIN or bool(re.match("[A-Za-z]", c))


def _upright(run: str) -> str:
    return rf"\text{{{escaped(run)}}}"
