"""Units of quantities: every one is made of a few base units, each with its name in a language.

Code calls units by their names in SI. A scene that keeps its quantities in feet, slugs and pounds-force has it
in its language's tag, as locales have (``en-u-ms-ussystem``), so their names follow here and nowhere else.
"""

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
        said("ft", context="unit"),
        said("in", context="unit"),
        said("lbf", context="unit"),
        said("slug", context="unit"),
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


_FEET = {
    "m": "ft",
    "kg": "slug",
    "N": "lbf",
    "Pa": "(lbf/ft²)",
    "J": "ft·lbf",
    "W": "(ft·lbf/s)",
}
"""What the units of SI are in the coherent units of foot, slug and second."""
IMPERIAL = "-u-ms-ussystem"
"""The end of the tag of a language that is printed in them (BCP 47, Unicode key ms)."""


def tagged(language: str, units: str) -> str:
    """Return the tag of a language that is printed in the units that a scene names."""
    return f"{language}{IMPERIAL}" if units == "imperial" else language


def retold(tag: str, language: str) -> str:
    """Return the tag of another language that is printed in the units of the first."""
    return f"{language.removesuffix(IMPERIAL)}{IMPERIAL * tag.endswith(IMPERIAL)}"


def unit_name(name: str, language: str) -> str:
    """Return a unit as it is called in English where quantities are kept in the units of a language's tag.

    >>> unit_name("N·m", "ru-u-ms-ussystem"), unit_name("Pa/mm", "en-u-ms-ussystem"), unit_name("Pa", "en")
    ('lbf·ft', '(lbf/ft²)/mm', 'Pa')
    """
    if not language.endswith(IMPERIAL):
        return name
    told = _WORD.sub(lambda found: _FEET.get(found[0], found[0]), name)
    return told[1:-1] if told.startswith("(") and told.find(")") == len(told) - 1 else told


def millimetres(length: float, language: str) -> float:
    """Return a length as it is kept in mm."""
    return length * (304.8 if language.endswith(IMPERIAL) else 1000.0)


def small(length: float, language: str) -> tuple[float, str]:
    """Return a length as it is kept in the unit in which lengths of links are given, mm or in.

    >>> small(0.095, "en"), small(0.5, "en-u-ms-ussystem")
    ((95.0, 'mm'), (6.0, 'in'))
    """
    return (12.0 * length, "in") if language.endswith(IMPERIAL) else (1000.0 * length, "mm")


def unit(name: str, language: str) -> str:
    """Return a unit in a language; what is none of the package stays as it is.

    >>> unit("(m/s²)/mm", "ru"), unit("kg·m²", "ru"), unit("(1/s)/mm", "ru")
    ('(м/с²)/мм', 'кг·м²', 'с⁻¹/мм')
    """
    speech, name = speaking(language), unit_name(name, language)
    told = _RATE.sub(lambda found: speech(_RATES[found[0]]), name)
    told = _WORD.sub(lambda found: speech(BASE.get(found[0], found[0])), told)
    return _NEEDLESS.sub(r"\1", told)


def known(name: str) -> bool:
    """Whether a unit is made of units of the package only."""
    words, signs = _WORD.findall(name), _WORD.sub("", name)
    return set(words) <= BASE.keys() and set(signs) <= _SIGNS
