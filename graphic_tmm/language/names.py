"""What marks are called, as plain text."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol

if TYPE_CHECKING:
    from graphic_tmm.board.record import Mark


def plain(letter: str) -> str:
    """Return a letter of the log as plain text: l_{OA} -> l_OA."""
    return letter.replace("{", "").replace("}", "")


def spoken(mark: Mark, language: str) -> str:
    """Return what a mark is called in a language, as plain text."""
    return plain(symbol(mark.name, language))


ORDINALS = (
    said("the second", context="mark"),
    said("the third", context="mark"),
    said("the fourth", context="mark"),
    said("the fifth", context="mark"),
    said("the sixth", context="mark"),
    said("the seventh", context="mark"),
    said("the eighth", context="mark"),
    said("the ninth", context="mark"),
    said("the tenth", context="mark"),
)
"""Which of the marks of one name in a view: how many came before it."""
PRIMES = (
    said("prime", context="mark"),
    said("double prime", context="mark"),
    said("triple prime", context="mark"),
)
_PRIMED = re.compile("[′″‴]+")
_WEIGHT = {"′": 1, "″": 2, "‴": 3}


def aloud(mark: Mark, language: str) -> str:
    """Return what a mark is called where it is spoken: A prime; l OA; O, the fifth of its name in its view."""
    speech = speaking(language)

    def primes(found: re.Match[str]) -> str:
        count = sum(_WEIGHT[sign] for sign in found[0])
        told = PRIMES[count - 1] if count <= len(PRIMES) else said("with {n} primes", n=count)
        return f" {speech(told)} "

    name = plain(symbol(mark.name, language)).replace("_", " ").replace("^", " ")
    name = " ".join(_PRIMED.sub(primes, name).split())
    before = mark.tally
    if not before:
        return name
    which = ORDINALS[before - 1] if before <= len(ORDINALS) else said("number {n}", n=before + 1)
    return f"{name}, {speech(which)}"
