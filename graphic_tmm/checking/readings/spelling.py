"""Ways of spelling a name: by Unicode, by the sound of a Greek letter, by Cyrillic letters that look Latin.

A name that somebody typed and a name of a scene are brought to the same keys, level by level: the later one,
the more ways of typing it forgives. Of letters that may be meant in several ways a name has several keys.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping
from functools import lru_cache
from itertools import product

Keys = frozenset[str]

LEVELS = ("sign", "sound", "shape", "case", "voice")
"""What is forgiven: another sign for the same letter; a Greek letter by its name; a Cyrillic letter of the same
shape; small for capital; a Cyrillic letter of the same sound."""
_LONGEST, _MOST = 24, 256
"""A longer name has no keys but itself; of many ways to mean a name no more than so many are tried."""
_LEFT_OUT = re.compile(r"[\s_{}^\\$()\u200b-\u200f\u2060\ufeff]+")
_SIGNS = str.maketrans(
    dict.fromkeys("'’‘`´ʹʼ", "′")
    | {"∆": "Δ", "∑": "Σ", "ϵ": "ε", "ɛ": "ε", "ϖ": "π", "ϕ": "φ", "ϑ": "θ", "∗": "*", "⁎": "*"}
    | {"∏": "Π", "ѡ": "ω", "ɷ": "ω", "−": "-", "–": "-", "є": "ε"}
)
_GREEK = {
    **{"α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "ε": "epsilon", "ζ": "zeta"},
    **{"η": "eta", "θ": "theta", "ι": "iota", "κ": "kappa", "λ": "lambda", "μ": "mu"},
    **{"ν": "nu", "ξ": "xi", "π": "pi", "ρ": "rho", "σ": "sigma", "ς": "sigma", "τ": "tau"},
    **{"υ": "upsilon", "φ": "phi", "χ": "chi", "ψ": "psi", "ω": "omega"},
}
_SPOKEN = {
    **{"омега": "omega", "эпсилон": "epsilon", "дельта": "delta", "альфа": "alpha"},
    **{"бета": "beta", "тета": "theta", "лямбда": "lambda", "фи": "phi", "пи": "pi"},
}
"""Names of Greek letters as Russian writes them."""
_SPOKEN_NAME = re.compile("|".join(_SPOKEN), re.IGNORECASE)
_SHORT = (
    (re.compile(r"(?:w|om|ш)(?=\d+$)", re.IGNORECASE), "omega"),
    (re.compile(r"(?:e|eps|э|эпс)(?=\d+$)", re.IGNORECASE), "epsilon"),
    (re.compile(r"(?:d|д)(?=[^\W\d_]$)"), "delta"),
)
"""What a hand writes for a Greek letter before a number, or before a single letter."""
_SHAPES = {
    **{"А": "A", "В": "B", "Е": "E", "К": "K", "М": "M", "Н": "H", "О": "O", "Р": "P", "С": "C"},
    **{"Т": "T", "У": "Y", "Х": "X", "І": "I", "Ѕ": "S", "Ј": "J", "З": "3", "а": "a", "в": "b"},
    **{"е": "e", "к": "k", "м": "m", "о": "o", "р": "p", "с": "c", "т": "t", "у": "y", "х": "x"},
    **{"і": "i", "ѕ": "s", "ј": "j", "ԛ": "q", "ԝ": "w", "ь": "b"},
}
"""Cyrillic letters that look like Latin ones."""
_BACK = str.maketrans({latin: sign for sign, latin in _SHAPES.items() if sign not in "в"})
_SOUNDS = {
    **{"б": ("b",), "в": ("b", "v"), "г": ("g",), "д": ("d",), "ж": ("g",), "з": ("z",)},
    **{"и": ("i", "n"), "к": ("k",), "л": ("l",), "м": ("m",), "н": ("n",), "п": ("p", "pi", "n")},
    **{"р": ("r",), "с": ("s",), "т": ("t",), "у": ("u",), "ф": ("f", "phi"), "х": ("h",)},
    **{"ц": ("c",), "ш": ("w",), "э": ("e",), "я": ("a",)},
}
"""Cyrillic letters by what they sound like, and small ones by what else they look like in writing."""


def signs(name: str) -> str:
    """Return a name with one sign for each letter, without spaces, braces and what sets an index.

    >>> signs("ω₃"), signs("P_{i3}"), signs("π a"), signs("O'2")
    ('ω3', 'Pi3', 'πa', 'O′2')
    """
    same = unicodedata.normalize("NFC", unicodedata.normalize("NFKC", name.translate(_SIGNS)))
    return _LEFT_OUT.sub("", same.translate(_SIGNS))


@lru_cache(maxsize=4096)
def keys(name: str, level: str) -> Keys:
    """Return what a name may mean when a level of `LEVELS`, and those before it, are forgiven.

    >>> keys("πa", "sound") & keys("pia", "sound"), keys("ω_3", "sound") & keys("w3", "sound")
    (frozenset({'pia'}), frozenset({'omega3'}))
    """
    word = signs(name)
    if not word or len(word) > _LONGEST:
        return frozenset((word,))
    rank = LEVELS.index(level)
    words = {word}
    if rank >= LEVELS.index("sound"):
        words = {_spelt(_sounded(one)) for one in (word, *_long(word))}
    if rank >= LEVELS.index("shape"):
        ways = _SOUNDS if level == "voice" else {}
        words |= {_spelt(other) for one in words for other in _meant(one, ways)}
        words |= {_spelt(long) for one in tuple(words) for long in _long(one)}
    if rank >= LEVELS.index("case"):
        words = {one.casefold() for one in words}
    return frozenset(words)


def cyrillic(name: str) -> bool:
    """Whether a name has a Cyrillic letter."""
    return any("CYRILLIC" in unicodedata.name(sign, "") for sign in name)


def in_cyrillic(name: str) -> str:
    """Return a Cyrillic name in which Latin letters stand for others of the same shape, all Cyrillic.

    >>> in_cyrillic("cилы") == "cилы", in_cyrillic("cилы") == "силы", in_cyrillic("sad")
    (False, True, 'sad')
    """
    return name.translate(_BACK) if cyrillic(name) else name


def lost(name: str, whole: str) -> bool:
    """Whether a name is one that was saved in Windows-1251, which has a "?" for what it has no sign for.

    >>> lost("?a", "πa"), lost("?3", "ω3"), lost("?a", "pa")
    (True, True, False)
    """
    short, due = _LEFT_OUT.sub("", name), _LEFT_OUT.sub("", whole)
    return (
        "?" in short
        and len(short) == len(due)
        and all(_lost(one, sign) for one, sign in zip(short, due, strict=True))
    )


def _lost(typed: str, sign: str) -> bool:
    kept = bool(sign.encode("cp1251", "ignore"))
    return typed == sign if kept else typed in ("?", sign)


def restored(name: str) -> str:
    """Return a name that was saved in UTF-8 and opened in Windows-1251 as it was, "" if it was not so.

    >>> restored("ПЂa"), restored("pa")
    ('πa', '')
    """
    try:
        back = name.encode("cp1251").decode("utf-8")
    except UnicodeError:
        return ""
    return back if back != name else ""


def _sounded(word: str) -> str:
    return _SPOKEN_NAME.sub(lambda found: _SPOKEN[found[0].lower()], word)


def _spelt(word: str) -> str:
    """Return a word with its Greek letters written out, capitals as small ones."""
    return "".join(_GREEK.get(sign.lower(), sign) for sign in word)


def _long(word: str) -> Iterable[str]:
    """Yield a word with what was written short for a Greek letter at its beginning written out."""
    for short, letter in _SHORT:
        found = short.match(word)
        if found:
            yield letter + word[found.end() :]


def _meant(word: str, ways: Mapping[str, tuple[str, ...]]) -> Iterable[str]:
    """Yield a word with its Cyrillic letters replaced: by shape, and by those ``ways``; few at the most."""
    choices = [_replaced(sign, ways) for sign in word]
    count = 1
    for choice in choices:
        count *= len(choice)
    if count <= _MOST:
        yield from map("".join, product(*choices))


def _replaced(sign: str, ways: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    shape = _SHAPES.get(sign)
    sounds = ways.get(sign.lower(), ())
    if sign != sign.lower():
        sounds = tuple(one.upper() for one in sounds)
    found = (*((shape,) if shape else ()), *sounds)
    return tuple(dict.fromkeys(found)) or (sign,)
