"""The letters of points, and texts that are drawn: what may be written on a plan.

A letter has one to four characters: a Latin, Russian or Greek letter, then digits or primes. Plans
write the images of points with small letters and their poles as p and π, so capitals and small
letters, and letters that look alike in two alphabets, may not stand side by side in one mechanism.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping
from typing import Any

from graphic_tmm.language.said import joined, said
from graphic_tmm.scene import misfits

_LETTER = re.compile(r"[A-Za-zА-Яа-яЁёΑ-Ωα-ω][0-9′]{0,3}")
POLES = "PpΠπ"
"""Of points no one may be called so: they are the poles of the plans of velocities and of accelerations."""
_ALIKE = str.maketrans(
    "АВЕКМНОРСТУХаеорсухΑΒΕΖΗΙΚΜΝΟΡΤΥΧο",
    "ABEKMHOPCTYXaeopcyxABEZHIKMNOPTYXo",
)
_ALPHABETS = {
    "CYRILLIC": said("Russian", context="letter"),
    "LATIN": said("Latin", context="letter"),
    "GREEK": said("Greek", context="letter"),
}
LONGEST_TEXT = 200
"""Characters of a text of the scene at the most; chosen by eye."""
NAMED = 4
"""Of the characters of a text that cannot be lettered so many are named."""


def letter_fault(letter: str, *, pole: bool = True) -> str:
    """Return what is wrong with a letter; empty if nothing.

    Parameters
    ----------
    letter : str
        As written in the scene.
    pole : bool
        Whether the letters of the poles are refused (they are for points, not for guides).
    """
    if not _LETTER.fullmatch(letter):
        return said(
            '"{letter}" is not a letter for a point or guide: one to four characters, first a Latin, '
            "Russian or Greek letter, then digits or ′, such as A, S2 or C′",
            letter=letter[:20],
        )
    if pole and letter in POLES:
        return said(
            '"{letter}" is kept for the pole of the {kind} plan; choose another letter, such as K, or '
            'number it, "P1"',
            letter=letter,
            kind=said("velocity", context="plan")
            if letter in "Pp"
            else said("acceleration", context="plan"),
        )
    return ""


def folded(letter: str) -> str:
    """Return what a letter looks like on a plan: small, one for look-alikes of two alphabets."""
    return latin(letter).casefold()


def latin(letter: str) -> str:
    """Return a letter with Latin letters for those of other alphabets that look like them."""
    return letter.translate(_ALIKE)


def clash(first: str, second: str) -> str:
    """Why two different letters may not stand in one mechanism; empty if they may."""
    if first == second or folded(first) != folded(second):
        return ""
    if first.casefold() == second.casefold():
        return said(
            '"{second}" and "{first}" would both be "{small}" on a plan, which writes small letters; '
            "rename one of them",
            second=second,
            first=first,
            small=second.casefold(),
        )
    return said(
        '"{second}" ({alphabet}) looks like "{first}" ({other}) and would be taken for it on a plan; '
        "write both with one keyboard, or rename one of them",
        second=second,
        alphabet=alphabet(second),
        first=first,
        other=alphabet(first),
    )


def alphabet(letter: str) -> str:
    """Latin, Russian or Greek, by the first character."""
    name = unicodedata.name(letter[0], "").split(" ")[0]
    return _ALPHABETS.get(name, name.capitalize())


def split(pair: str) -> tuple[str, str] | None:
    """Two letters written together, ``"BC"`` or ``"S3C"``, apart; None if they are not two."""
    found = _LETTER.findall(pair)
    return (found[0], found[1]) if len(found) == 2 and "".join(found) == pair else None


def renamed(value: Any, names: Mapping[str | int, str | int]) -> Any:
    """Return a letter, two of them, a guide, the number of a link, or a list of such, by other names.

    Whatever else stands there is returned as it is.
    """
    if isinstance(value, list):
        return [renamed(one, names) for one in value]
    if isinstance(value, bool) or not isinstance(value, (int, str)):
        return value
    pair = split(value) if isinstance(value, str) and value not in names else None
    return "".join(str(names.get(one, one)) for one in pair) if pair else names.get(value, value)


def last_renamed(value: Any, names: Mapping[str | int, str | int]) -> Any:
    """Return a text of several words whose last is a letter, two of them or a guide, by other names."""
    words = re.fullmatch(r"(.*\s)(\S+)(\s*)", value) if isinstance(value, str) else None
    return value if words is None else f"{words[1]}{renamed(words[2], names)}{words[3]}"


def unknown(says: str, word: str, known: Iterable[str], what: str) -> str:
    """``"AX" is no letter; did you mean "AB"?; letters of link 3 are A, B, C``, behind ``says``."""
    names = sorted(set(known))
    alike = [name for name in names if folded(name) == folded(word)]
    meant = misfits.meant(word, alike[:1] or names, 0.0 if alike else 0.5)
    if alike and alphabet(alike[0]) != alphabet(word):
        meant = said(
            'did you mean "{meant}" ({alphabet}, not {other})?',
            meant=alike[0],
            alphabet=alphabet(alike[0]),
            other=alphabet(word),
        )
    there = said(
        "{what} is {listed}",
        "{what} are {listed}",
        n=len(names),
        what=what,
        listed=", ".join(names) or said("none", context="letters"),
    )
    return joined("; ", filter(None, (says, meant, there)))


def text_fault(text: str) -> str:
    """Return what is wrong with a text to be drawn; empty if nothing."""
    if len(text) > LONGEST_TEXT:
        return said(
            "a text of {n} characters; at most {most} can be drawn, shorten it",
            n=len(text),
            most=LONGEST_TEXT,
        )
    for character in text:
        if _is_control(character):
            return said(
                "the control character U+{code:04X} cannot be drawn; take it out",
                code=ord(character),
            )
    return ""


def _is_control(character: str) -> bool:
    return unicodedata.category(character) in ("Cc", "Cf", "Cs", "Zl", "Zp")


def undrawable(text: str, missing: str) -> list[str]:
    """Return a sentence for each of the first characters of ``text`` that are among ``missing``.

    A control character is told by `text_fault`; in a message it would do what it does.
    """
    found = [c for c in dict.fromkeys(text) if c in missing and not _is_control(c)]
    says: list[str] = [
        said(
            'the character "{character}" (U+{code:04X}) cannot be lettered; replace it',
            character=character,
            code=ord(character),
        )
        for character in found[:NAMED]
    ]
    if len(found) > NAMED:
        many = said("{n} different characters cannot be lettered; replace them all", n=len(found))
        says.append(many)
    return says
