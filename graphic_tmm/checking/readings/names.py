"""Which plan, position, segment or point of a scene a name means that somebody typed."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.checking.readings.spelling import (
    LEVELS,
    cyrillic,
    in_cyrillic,
    keys,
    lost,
    restored,
    signs,
)
from graphic_tmm.language.catalogue import languages
from graphic_tmm.language.symbols import plain
from graphic_tmm.readers.columns import Column, renamed
from graphic_tmm.readers.text import column_name, result_name
from graphic_tmm.scene.captions import captions

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
_DASHES = ("-", "–", "—", "−")
_POSITION = re.compile(r"(?:no|#|pos\.?|пол\.?)?\s*0*(\d+)(?:[.,]0*)?\s*([*×xх]|°|deg|град\.?)?")


class Meant(NamedTuple):
    """What a name means: one thing, or several of which nobody knows which, or nothing; how it was found."""

    names: tuple[str, ...]
    how: str = ""

    @property
    def one(self) -> str:
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
    return found


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


def position_meant(typed: str, names: Sequence[str]) -> Meant:
    """Return which position is meant: "01" and "1.0" are 1, "6 *" is 6*, a dash is none.

    >>> position_meant("01", ["0", "1"]).one, position_meant("6∗", ["6", "6*"]).one
    ('1', '6*')
    """
    if typed in names:
        return Meant((typed,))
    if typed in _DASHES and "" in names:
        return Meant(("",), "sign")
    number = _numbered(typed)
    found = tuple(name for name in names if number and _numbered(name) == number)
    if not found and number and not number[1]:
        found = tuple(name for name in names if _numbered(name) == (number[0], "°"))
    if found:
        return Meant(found, "sign")
    return meant(typed, {name: frozenset() for name in names if name})


def _numbered(name: str) -> tuple[str, str] | None:
    found = _POSITION.fullmatch(signs(name).casefold())
    if found is None:
        return None
    number, mark = found.groups()
    sign = "*" if mark in ("*", "×", "x", "х") else "°" if mark else ""
    return str(int(number)), sign
