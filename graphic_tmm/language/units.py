"""Units of quantities: every one is made of a few base units, each with its name in a language."""

from __future__ import annotations

import re

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said

BASE: dict[str, str] = {
    word: word
    for word in (
        said("mm", context="unit"),
        said("m", context="unit"),
        said("s", context="unit"),
        said("rad", context="unit"),
        said("kg", context="unit"),
        said("N", context="unit"),
        said("kgf", context="unit"),
        said("Pa", context="unit"),
        said("J", context="unit"),
        said("W", context="unit"),
        said("rpm", context="unit"),
    )
}
"""The units of which the others are made."""
_SIGNS = frozenset("1·/()²³°%")
"""What stands between them, or for a unit that every language writes alike."""
_WORD = re.compile(r"[A-Za-z]+")
_RATES: dict[str, str] = {
    one: one for one in (said("1/s", context="unit"), said("1/s²", context="unit"))
}
"""Rates of turning, which a language writes as a fraction or by a power."""
_RATE = re.compile(r"1/s²?(?![A-Za-z])")
_NEEDLESS = re.compile(r"\(([^()/]*⁻[^()/]*)\)")
"""Parentheses about what is written by a power."""


def unit(name: str, language: str) -> str:
    """Return a unit in a language; what is none of the package stays as it is.

    >>> unit("(m/s²)/mm", "ru"), unit("kg·m²", "ru"), unit("(1/s)/mm", "ru")
    ('(м/с²)/мм', 'кг·м²', 'с⁻¹/мм')
    """
    speech = speaking(language)
    told = _RATE.sub(lambda found: speech(_RATES[found[0]]), name)
    told = _WORD.sub(lambda found: speech(BASE.get(found[0], found[0])), told)
    return _NEEDLESS.sub(r"\1", told)


def known(name: str) -> bool:
    """Whether a unit is made of units of the package only."""
    words, signs = _WORD.findall(name), _WORD.sub("", name)
    return set(words) <= BASE.keys() and set(signs) <= _SIGNS
