"""How marks are called in each language: what stands in an index is a word; the same as plain text."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from typing import Protocol

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import Said, said

_SHAPES = (
    # the log tells the sizes of the rim and reduced quantities by one letter
    (r"\bm_r\b", "m_F"),
    (r"\bD_m\b", "D_{mean}"),
    (r"\bM_r\b", "M_{red}"),
    (r"\bJ_(r|\{red\})(?![a-z])", "J_{red}"),
    (r"\bc_F\b", "c"),
    (r"\bd_F\b", "d"),
    (r"\by_F\b", "y_{TF}"),
    (r"\bm_F\b", "m_{F}"),
)
"""What is written otherwise on a sheet than in the log, whatever the language."""
_B, _I, _FLYWHEEL = (
    said("b", context="index: balancing"),
    said("i", context="index: inertia"),
    said("F", context="index: flywheel"),
)
_C, _S = said("c", context="index: cover side"), said("s", context="index: shaft side")
_COUNTERWEIGHT = said("c", context="index: counterweight")
_MEAN = said("mean", context="index")
_ZH = said("Zh", context="index: Zhukovsky")
_WORDS: Sequence[tuple[str, str, tuple[Said, ...]]] = (
    (r"([PM])_\{bl(\d*)\}", r"\1_{%s\2}^{%s}", (_B, _ZH)),
    (r"μ_\{vl\}", "μ_{v}^{%s}", (_ZH,)),
    (r"([PM])_\{b(\d+)\}", r"\1_{%s\2}", (_B,)),
    (r"([PM])_(?:b|\{b\})(?![a-z\d])", r"\1_{%s}", (_B,)),
    (r"(?:(?<=[yh]_\{[PM])|(?<=[yh]_\{−[PM]))b(?=\d*[}^])", "%s", (_B,)),
    (r"([PM]_\{|[yh]_\{(?:−?F)?[PM]|F_\{M|h_\{)i(?=c?\d)", r"\1%s", (_I,)),
    (r"([PM]_\{\w|[yh]_\{P\w|h_\{\w|[mrDα]_\{)c(?=\d+\})", r"\1%s", (_COUNTERWEIGHT,)),
    (r"(P_\{?|[yh]_\{P)in", r"\1%s", (said("in", context="index: inertia"),)),
    (r",ser\}", ",%s}", (said("ser", context="index: series"),)),
    (r"A_\{ex\}", "A_{%s}", (said("ex", context="index: excess"),)),
    (r"\bM_d\b", "M_%s", (said("d", context="index: driving"),)),
    (r"M_\{f", "M_{%s", (said("f", context="index: friction"),)),
    (r"\bT_\{(\d+)t\}", r"T_{\1%s}", (said("t", context="index: translation"),)),
    (r"\bT_\{(\d+)r\}", r"T_{\1%s}", (said("r", context="index: rotation"),)),
    (r"\bT_\{?L\}?", "T_{%s}", (said("L", context="index: links"),)),
    (r"\bT_\{?F\}?", "T_{%s}", (_FLYWHEEL,)),
    (r"\by_\{TF\}", "y_{T%s}", (_FLYWHEEL,)),
    (r"\bJ_F\b", "J_{%s}", (_FLYWHEEL,)),
    (r"\bm_\{F\}", "m_{%s}", (_FLYWHEEL,)),
    (r"\{mean\}", "{%s}", (_MEAN,)),
    (r"\{red\}", "{%s}", (said("red", context="index: reduced"),)),
    (r"\^(?:\{t\}|t(?![a-z]))", "^{%s}", (said("t", context="index: tangential"),)),
    (r"_\{dr\}", "_{%s}", (said("dr", context="index: drawn"),)),
    (r"(?<=[φΦNnuαβO]_)r(?=[\])]?$)", "%s", (said("r", context="index: rise"),)),
    (r"(?<=[φΦNnuαβO]_)f(?=[\])]?$)", "%s", (said("f", context="index: return"),)),
    (r"(?<=[ph]_\{[kv])m(?=\})", ",%s", (_MEAN,)),
    (r"([ph]_\{[kv](?:[A-Z]\d*)+)m(?=\})", r"\1,%s", (_MEAN,)),
    (r"(?<=[pPFDdnfhcxyA]_\{)k(?=[A-Z])", "%s", (_C,)),
    (r"(?<=[pPFDdnfhcxyA]_\{)v(?=[A-Z])", "%s", (_S,)),
    (r"(?<=[pPFDdnfhcAσ]_)k(?=0?$)|(?<=[ph]_\{)k(?=,)", "%s", (_C,)),
    (r"(?<=[pPFDdnfhcAσ]_)v(?=0?$)|(?<=[ph]_\{)v(?=,)", "%s", (_S,)),
)
"""Where a word stands in an index. The log's own letter is left where a language has the same."""
_NOT_ITS_OWN = frozenset({_C, _S, _MEAN, _ZH})
"""Words for which the log has another letter, so that they are put in English too."""
_RULES = tuple((re.compile(pattern), put, words) for pattern, put, words in _WORDS)


@cache
def symbol(name: str, language: str) -> str:
    """Return the name of a mark as mark-up in a language.

    >>> symbol("P_b", "ru"), symbol("y_{Pi3}", "ru"), symbol("P_{bl}", "en"), symbol("h_{Pb6}", "ru")
    ('P_{ур}', 'y_{Pи3}', 'P_{b}^{Zh}', 'h_{Pур6}')
    """
    for shape, put in _SHAPES:
        name = re.sub(shape, put, name)
    speech = speaking(language)
    for pattern, put, words in _RULES:
        told = tuple(speech(word) for word in words)
        if told != words or _NOT_ITS_OWN.intersection(words):
            name = pattern.sub(put % told, name)
    return name


_FUNCTIONS = {
    "tan": said("tan", context="function"),
    "arctan": said("arctan", context="function"),
}
"""Functions that languages call by other letters."""
_CALLED = re.compile(rf"\b({'|'.join(_FUNCTIONS)})(?=[( ])")


def function(name: str, language: str) -> str:
    """Return what a function of a formula is called in a language.

    >>> function("arctan", "ru"), function("arctan", "en"), function("sin", "ru")
    ('arctg', 'arctan', 'sin')
    """
    return speaking(language)(_FUNCTIONS[name]) if name in _FUNCTIONS else name


def with_functions(formula: str, language: str) -> str:
    """Return the text of a formula with its functions as they are called in a language.

    >>> with_functions("arctan({a}/{b})", "ru")
    'arctg({a}/{b})'
    """
    return _CALLED.sub(lambda found: function(found[1], language), formula)


_INDEXED = re.compile(r"([A-Za-z])_?(\w*)")


def result_symbol(name: str, language: str) -> str:
    """Return the letter of a result by its machine name, which is that letter and its index, as mark-up.

    >>> result_symbol("r_b1", "en"), result_symbol("z3", "ru"), result_symbol("a", "en")
    ('r_{b1}', 'z_{3}', 'a')
    """
    found = _INDEXED.fullmatch(name)
    if found is not None:
        name = f"{found[1]}_{{{found[2]}}}" if found[2] else found[1]
    return symbol(name, language)


class HasName(Protocol):
    """What bears a name, as the marks of a log do."""

    @property
    def name(self) -> str:
        """The name."""


def plain(letter: str) -> str:
    """Return a letter of the log as plain text: l_{OA} -> l_OA."""
    return letter.replace("{", "").replace("}", "")


def spoken(mark: HasName, language: str) -> str:
    """Return what a mark is called in a language, as plain text."""
    return plain(symbol(mark.name, language))
