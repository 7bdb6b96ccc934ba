"""Which plan, position, segment or point a name means that somebody typed, in whatever spelling.

Both names are brought to the same keys, level by level: Unicode, the sound of Greek, Cyrillic that looks Latin.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import product
from typing import NamedTuple

from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.checking.readings.quantity_names import is_coriolis, respelt, turned_round
from graphic_tmm.language.catalogue import languages
from graphic_tmm.language.symbols import plain
from graphic_tmm.readers.columns import Column, renamed
from graphic_tmm.readers.text import column_name, result_name
from graphic_tmm.scene.captions import captions

Keys = frozenset[str]

LEVELS = ("sign", "sound", "shape", "case", "voice")
"""What is forgiven: another sign for the same letter; a Greek letter by its name; a Cyrillic letter of the same
shape; small for capital; a Cyrillic letter of the same sound."""
_LONGEST, _MOST = 24, 256
"""A longer name has no keys but itself; of many ways to mean a name no more than so many are tried."""
_LEFT_OUT = re.compile(r"[\s_{}^\\$()\[\]→\u0304\u0305\u20d6\u20d7\u200b-\u200f\u2060\ufeff]+")
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
    bare = _LEFT_OUT.sub("", name.translate(_SIGNS))  # a bar over a letter before it is one with it
    same = unicodedata.normalize("NFC", unicodedata.normalize("NFKC", bare))
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


Aliases = Mapping[str, frozenset[str]]
"""What things are called besides, by the names that code has for them."""
SILENT = ("sign", "sound", "former")
"""How names are found that need no word: nobody can mean anything else."""
_STOP = frozenset(("план", "плана", "plan", "of", "the", "and"))
_ENDINGS = re.compile(r"(?:ies|es|ий|ия|ие|ей|[аеёиоуыэюяйьsy])+$")
_STEM = 3
"""A stem has so many letters at least: fewer begin too many words."""
_POINT = re.compile(r"[^\W\d_]\d*′*")
"""The letter of a point."""
DASHES = ("-", "–", "—", "−")


class Meant(NamedTuple):
    """What a name means: one thing, or several of which nobody knows which, or nothing; how it was found."""

    names: tuple[str, ...]
    how: str = ""

    @property
    def only(self) -> str:
        """The only one, or ""."""
        return self.names[0] if len(self.names) == 1 else ""


NOTHING = Meant(())


def segments_of(columns: Iterable[Column]) -> Mapping[str, Aliases]:
    """Return by plan what its segments are called: on sheets and in tables of all languages, by their ends."""
    found: dict[str, dict[str, frozenset[str]]] = {}
    for column in columns:
        if column.plan == RESULTS:
            names = {result_name(column.segment, language) for language in languages()}
        else:
            names = {plain(column_name(column, language)) for language in languages()}
        names |= {column.segment, plain(column.letter), plain(column.quantity)}
        found.setdefault(column.plan, {})[column.segment] = frozenset(names - {""})
    return found


def segment_meant(typed: str, plan: str, known: Aliases) -> Meant:
    """Return which segment of a plan is meant, by any name that it has or had in an earlier version."""
    now = "" if typed in known else renamed(plan, signs(typed), known)
    found = Meant((now,), "former") if now else meant(typed, known)
    for level in () if found.names else LEVELS:
        names = {renamed(plan, word, known) for word in keys(typed, level)} - {""}
        if names:
            return Meant(tuple(sorted(names)), _how(typed, level))
    return found if found.names else _otherwise(typed, known)


def _otherwise(typed: str, known: Aliases) -> Meant:
    """Return what is meant by a quantity whose name is written otherwise, or told from the other end."""
    word = signs(typed)
    if is_coriolis(word):
        of = _having(known, lambda alias: alias.startswith("a_") and alias.endswith("^k"))
        return Meant(of, "case")
    for how, spellings in (("case", respelt(word)), ("turned", turned_round(word))):
        for one in spellings:
            found = next((f for level in LEVELS if (f := _alike(one, known, level))), ())
            if found:
                return Meant(found, how)
    return NOTHING


def meant(typed: str, known: Aliases) -> Meant:
    """Return which of the known names somebody means by the name that was typed.

    The way of spelling that forgives least and finds something decides; where it finds several things nobody
    knows which is meant.
    """
    if typed in known:
        return Meant((typed,))
    for level in LEVELS:
        found = _alike(typed, known, level)
        if found:
            return Meant(found, _how(typed, level))
    if "?" in typed:
        return Meant(_having(known, lambda alias: lost(typed, signs(alias))), "lost")
    back = restored(typed)
    if back:
        return meant(back, known)._replace(how="lost")
    pole = _poles(typed, known)
    return pole if pole.names else _turned(typed, known)


def _how(typed: str, level: str) -> str:
    return level if level in SILENT else "look-alikes" if cyrillic(typed) else "case"


def _alike(typed: str, known: Aliases, level: str) -> tuple[str, ...]:
    """Return what is spelt alike: by its own name, or else by what it is called besides."""
    wanted = keys(typed, level)
    own = tuple(name for name in known if not wanted.isdisjoint(keys(name, level)))
    return own or _having(known, lambda alias: not wanted.isdisjoint(keys(alias, level)))


def _having(known: Aliases, fits: Callable[[str], bool]) -> tuple[str, ...]:
    return tuple(name for name, aliases in known.items() if any(map(fits, (name, *aliases))))


def _poles(typed: str, known: Aliases) -> Meant:
    """Return what is meant where p was written for π, as the pole of an acceleration plan is called, too."""
    word = signs(typed)
    if not word.casefold().startswith("p"):
        return NOTHING
    other = "π" + word[1:].lstrip("′")
    found = _having(known, lambda alias: signs(alias).casefold() == other.casefold())
    return Meant(found, "pole") if found else NOTHING


def _turned(typed: str, known: Aliases) -> Meant:
    """Return the segment between two points that were named the other way round: a length is the same."""
    points = _POINT.findall(signs(typed))
    if len(points) != 2 or "".join(points) != signs(typed):
        return NOTHING
    other = "".join(reversed(points))
    found = _having(known, lambda alias: signs(alias) == other)
    return Meant(found, "turned") if found else NOTHING


def plan_meant(typed: str, plans: Sequence[str]) -> Meant:
    """Return which plan is meant, by its name for machines or its captions, in any language and case."""
    if typed in plans:
        return Meant((typed,))
    folded = typed.casefold()
    named = {plan: _called(plan) for plan in plans}
    found = tuple(p for p, called in named.items() if folded in map(str.casefold, called))
    if found:
        return Meant(found, "sign")
    stems = _stems(typed)
    if not stems:
        return NOTHING
    whole = tuple(p for p, called in named.items() if any(_stems(one) == stems for one in called))
    if whole:
        return Meant(whole, "sign")
    part = tuple(p for p, called in named.items() if any(_begin(stems, _stems(c)) for c in called))
    return Meant(part, "sign") if part else _misspelt(typed, named)


def _misspelt(typed: str, named: Mapping[str, Sequence[str]]) -> Meant:
    """Return the plan that is meant by look-alikes, or by letters that another encoding has lost."""
    back, plans = restored(typed), tuple(named)
    if back:
        return plan_meant(back, plans)._replace(how="lost")
    turned = in_cyrillic(typed)
    found = plan_meant(turned, plans) if turned != typed else NOTHING
    if found.names:
        return found._replace(how="look-alikes")
    return Meant(_alike(typed, {p: frozenset(c) for p, c in named.items()}, "case"), "look-alikes")


def _called(plan: str) -> tuple[str, ...]:
    return (plan, plan.replace("-", " "), *(captions(one).get(plan, plan) for one in languages()))


def _stems(name: str) -> frozenset[str]:
    words = re.findall(r"[^\W\d_]+", name.casefold().replace("ё", "е"))
    return frozenset(_ENDINGS.sub("", word) or word for word in words if word not in _STOP)


def _begin(some: Iterable[str], words: Iterable[str]) -> bool:
    """Whether each of some stems is the beginning of a word, or the other way round."""
    known = list(words)
    return all(
        any(min(len(one), len(two)) >= _STEM and _either(one, two) for two in known) for one in some
    )


def _either(one: str, two: str) -> bool:
    return one.startswith(two) or two.startswith(one)
