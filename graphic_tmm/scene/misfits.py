"""What stands in a file where something else is wanted, and what was probably meant: parts of messages."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from graphic_tmm.language.said import Said, joined, said

LONGEST_MEANT, MOST_MEANT = 60, 1000
"""A word of more letters is nothing misspelt; so many known words are looked through for what it may mean: all
names of operations, in 0.04 s."""

_TRUTH = {
    **dict.fromkeys(("true", "yes", "on", "да", "истина", "вкл"), "true"),
    **dict.fromkeys(("false", "no", "off", "нет", "ложь", "выкл"), "false"),
}
"""What people write for the two words that a switch knows."""


def truth(word: str) -> str:
    """Return the word of TOML for what people write for yes or no; "" of any other."""
    return _TRUTH.get(word.strip().casefold(), "")


def truth_wanted(value: object) -> Said:
    """Return what to write in the place of a value that is neither true nor false."""
    word = truth(value) if isinstance(value, str) else ""
    return said("write {word}, without quotes", word=word) if word else said("write true or false")


def kind_of(value: object) -> Said:
    """Return what kind of value stands in the file, in words."""
    if isinstance(value, bool):
        return said("{value} (yes or no)", value=str(value).lower())
    if isinstance(value, (int, float)):
        return said("the number {digits}", digits=digits_of(value))
    if isinstance(value, str):
        return said('the text "{text}"', text=short(value))
    if isinstance(value, list):
        return said("a list [ ]")
    return said("a table { }") if isinstance(value, dict) else said("a date or time")


def stands(value: object, *remedies: str) -> Said:
    """Return ``the number 5 stands here; a text in quotes is wanted``; empty remedies are left out."""
    here = said("{kind} stands here", kind=kind_of(value))
    return joined("; ", (here, *filter(None, remedies)))


def fault_in_list(item: object, remedy: str) -> Said:
    """Return ``the number 5 in the list; a point is a list of two``."""
    return joined("; ", (said("{kind} in the list", kind=kind_of(item)), remedy))


def meant(word: str, known: Iterable[str], cutoff: float = 0.5) -> str:
    """Return ``did you mean "number"?``; empty if no known word is like it."""
    found = near(word, known, cutoff)
    return said('did you mean "{meant}"?', meant=found) if found else ""


def near(word: str, known: Iterable[str], cutoff: float = 0.5) -> str:
    """Return the known word that was probably meant; empty if none is like it."""

    def same_length(other: str) -> float:
        return 0.4 / max(len(word), 1) if len(word) == len(other) else 0.0

    def likeness(other: str) -> float:
        ratio = difflib.SequenceMatcher(None, word.casefold(), other.casefold()).ratio()
        begins = other[:1].casefold() == word[:1].casefold()
        return ratio + (0.1 if begins else 0.0) + same_length(other)

    if len(word) > LONGEST_MEANT:
        return ""
    best = max(sorted(known)[:MOST_MEANT], key=likeness, default="")
    return best if best and likeness(best) >= cutoff else ""


def digits_of(value: float) -> str:
    """Return a number as text; what is beyond all measure (TOML has no limit) in powers of two."""
    huge = isinstance(value, int) and value.bit_length() > 64
    return f"2^{int(value).bit_length()}" if huge else str(value)


def short(text: str) -> str:
    """Return a text as a message quotes it: not more than 60 characters."""
    return text if len(text) <= 60 else text[:57] + "..."
