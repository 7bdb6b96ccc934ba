"""How marks are called in each language: what stands in an index is a word, and words have a language.

A mark's name is mark-up (P_{i3}, y_{Pi3}); what is made of another's name holds it, in braces or without. So
names reach sheets, tables and protocols by this one way.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache

_BOTH: Sequence[tuple[str, str]] = (
    # the log tells the sizes of the rim and reduced quantities by one letter
    (r"\bm_r\b", "m_F"),
    (r"\bD_m\b", "D_{mean}"),
    (r"\bM_r\b", "M_{red}"),
    (r"\bJ_(r|\{red\})(?![a-z])", "J_{red}"),
    (r"\bc_F\b", "c"),
    (r"\bd_F\b", "d"),
    (r"\by_F\b", "y_{TF}"),
)
_ENGLISH: Sequence[tuple[str, str]] = (
    *_BOTH,
    (r"([PM])_\{bl\}", r"\1_{b}^{Zh}"),
    (r"\bm_F\b", "m_{F}"),
    (r"(?<=[pPFDdnfhc]_)k(?=0?$)|(?<=[ph]_\{)k(?=m\})", "c"),
    (r"(?<=[pPFDdnfhc]_)v(?=0?$)|(?<=[ph]_\{)v(?=m\})", "s"),
    (r"(?<=[ph]_\{[cs])m(?=\})", ",mean"),
)
_RUSSIAN: Sequence[tuple[str, str]] = (
    *_BOTH,
    (r"([PM])_\{bl\}", r"\1_{ур}^{Ж}"),
    (r"([PM])_\{?b\}?(?![a-z])", r"\1_{ур}"),
    (r"(?<=[yh]_\{[PM])b(?=[}^])", "ур"),
    (r"([PM]_\{|[yh]_\{(?:−?F)?[PM]|F_\{M|h_\{)i(?=\d)", r"\1и"),
    (r"(P_\{?|[yh]_\{P)in", r"\1и"),
    (r",ser\}", ",ряд}"),
    (r"M_\{f", "M_{т"),
    (r"\bT_\{(\d+)t\}", r"T_{\1пост}"),
    (r"\bT_\{(\d+)r\}", r"T_{\1вр}"),
    (r"\bT_\{?L\}?", "T_{зв}"),
    (r"\bT_\{?F\}?", "T_{м}"),
    (r"\by_\{TF\}", "y_{Tм}"),
    (r"\bJ_F\b", "J_{м}"),
    (r"\bm_F\b", "m_{м}"),
    (r"\{mean\}", "{ср}"),
    (r"\{red\}", "{пр}"),
    (r"_\{dr\}", "_{чер}"),
    (r"(?<=[φΦNnuαβO]_)r(?=[\])]?$)", "п"),
    (r"(?<=[φΦNnuαβO]_)f(?=[\])]?$)", "о"),
    (r"(?<=[pPFDdnfhc]_)k(?=0?$)|(?<=[ph]_\{)k(?=m\})", "к"),
    (r"(?<=[pPFDdnfhc]_)v(?=0?$)|(?<=[ph]_\{)v(?=m\})", "в"),
    (r"(?<=[ph]_\{[кв])m(?=\})", ",ср"),
)
_RULES = {
    language: tuple((re.compile(pattern), put) for pattern, put in rules)
    for language, rules in (("en", _ENGLISH), ("ru", _RUSSIAN))
}


@cache
def symbol(name: str, language: str) -> str:
    """Return the name of a mark as mark-up in a language.

    >>> symbol("P_b", "ru"), symbol("y_{Pi3}", "ru"), symbol("P_{bl}", "en"), symbol("v_A", "ru")
    ('P_{ур}', 'y_{Pи3}', 'P_{b}^{Zh}', 'v_A')
    """
    for pattern, put in _RULES[language]:
        name = pattern.sub(put, name)
    return name


RESULTS = {
    "alpha_w": "α_{w}",
    "delta_y": "Δy",
    "contact_ratio": "ε_{α}",
    "contact_ratio_drawn": "ε_{dr}",
    "contact_ratio_difference": "Δε",
    "arc_of_engagement1": "c_{1}d_{1}",
    "arc_of_engagement2": "c_{2}d_{2}",
    "overall_ratio": "U_{0}",
    "rim_width": "b",
}
"""Results whose machine name is no letter of theirs."""
_INDEXED = re.compile(r"(?:planetary_)?([A-Za-z])_?(\w*)")


def result_symbol(name: str, language: str) -> str:
    """Return the letter of a result by its machine name, as mark-up.

    >>> result_symbol("r_b1", "en"), result_symbol("planetary_z3", "ru"), result_symbol("a", "en")
    ('r_{b1}', 'z_{3}', 'a')
    """
    known = RESULTS.get(name)
    found = _INDEXED.fullmatch(name)
    if known is None and found is not None:
        known = f"{found[1]}_{{{found[2]}}}" if found[2] else found[1]
    return symbol(known or name, language)
