"""Sentences of the protocol as lettering: letters with their indices, lines of a column's width."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board.record import Construction
from graphic_tmm.language.symbols import spoken, symbol
from graphic_tmm.paper.lettering.letters import escape, letter
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.narration import ProtocolLine
from graphic_tmm.scene.captions import captions

SENTENCE, REASON = 3.5, 2.5
"""Heights of letters: of sentences and calculations; of reasons, mm (ГОСТ 2.304)."""
SPACE = 0.8
"""What is between the letters of two words, of their height."""
_SIGN = r"(?:[^\W_⁰-⁹⁻¹²³])"
_INDEX = re.compile(
    rf"_(?P<low>{_SIGN}+)|\^(?P<high>[−+*]|{_SIGN}+(?:_{_SIGN}+)?)|(?<=[^\W\d_⁰-⁹¹²³⁻])(?P<figure>\d+)"
)


class LetteringRow(NamedTuple):
    """A line of lettering: mark-up and height, mm."""

    text: str
    size: float


def letters_of(log: Construction, language: str) -> Mapping[str, str]:
    """Return the letters with indices that no rule tells from their plain text, as mark-up."""
    marks = (*log.given, *(step.it for step in log.steps))
    found = {}
    for mark in dict.fromkeys(marks):
        plain = spoken(mark, language)
        if "_" in plain or "^" in plain:
            found[plain] = markup(symbol(mark.name, language))
    return {plain: told for plain, told in found.items() if indexed(plain) != told}


def indexed(text: str) -> str:
    """Return plain text as mark-up: what stands behind _ or ^ is an index, and figures behind a letter.

    >>> indexed("v_A = ω_1·l_OA, pa3")
    'v_{A} = ω_{1}·l_{OA}, pa_{3}'
    >>> indexed("(c_к + x_k0)^n_к, E_1^−")
    '(c_{к} + x_{k0})^{n_{к}}, E_{1}^{−}'
    """

    def put(found: re.Match[str]) -> str:
        if found["high"]:
            head, _, low = found["high"].partition("_")
            return f"^{{{head}_{{{low}}}}}" if low else f"^{{{head}}}"
        return f"_{{{found['low'] or found['figure']}}}"

    parts, at = [], 0
    for found in _INDEX.finditer(text):
        parts += [escape(text[at : found.start()]), put(found)]
        at = found.end()
    return "".join([*parts, escape(text[at:])])


def marked_up(text: str, letters: Mapping[str, str]) -> str:
    """Return plain text as mark-up; ``letters``: those that bear more than a rule tells."""
    if not letters:
        return indexed(text)
    names = "|".join(re.escape(name) for name in sorted(letters, key=len, reverse=True))
    parts, at = [], 0
    for found in re.finditer(rf"(?<![^\W\d_])(?:{names})(?![^\W_])", text):
        parts += [indexed(text[at : found.start()]), letters[found[0]]]
        at = found.end()
    return "".join([*parts, indexed(text[at:])])


def rows(
    lines: Iterable[ProtocolLine],
    width: float,
    letters: Mapping[str, str],
    language: str,
    known: set[str],
) -> Iterator[list[LetteringRow]]:
    """Yield what each line of the protocol tells, in lines of lettering no wider than ``width`` mm.

    ``known``: the reasons that were told; each is told once, and entered.
    """
    for line in lines:
        told = f"{line.label}. {line.text}" if line.number else line.text
        found = list(broken(marked_up(told, letters), SENTENCE, width))
        if line.calculation:
            found += broken(marked_up(line.calculation, letters), SENTENCE, width)
        if line.why and line.why not in known:
            known.add(line.why)
            why = f"{captions(language)['why']}: {line.why}"
            found += broken(marked_up(why, letters), REASON, width)
        yield found


def broken(text: str, size: float, width: float) -> Iterator[LetteringRow]:
    """Yield mark-up in lines no wider than ``width`` mm, broken at spaces, in long terms behind a sign."""
    row, taken = "", 0.0
    for word in _words(text, size, width):
        wide = letter(word, size=size).right
        more = taken + SPACE * size + wide if row else wide
        if row and more > width:
            yield LetteringRow(row, size)
            row, taken = word, wide
        else:
            row, taken = (f"{row} {word}", more) if row else (word, wide)
    if row:
        yield LetteringRow(row, size)


def _glued(words: Sequence[str]) -> list[str]:
    """Return words, those that do not stand at the end of a line with what follows them; units with numbers."""
    found: list[str] = []
    for word in words:
        if found and (found[-1] in SIGNS or _UNIT.fullmatch(found[-1] + " " + word)):
            found[-1] += f" {word}"
        else:
            found.append(word)
    return found


SIGNS = ("=", "+", "∥", "⊥")
"""Signs that stand before what they belong to."""
_UNIT = re.compile(r"(= )?[−(]*\d[\d,.]*\)?( ?[^\d\s=]+[^\s]*)")
_SPACES = re.compile(r" +(?![^{]*\})")
_TERMS = re.compile(r"(?<=[·/+=;,)])(?![^{]*\})")


def _words(text: str, size: float, width: float) -> Iterator[str]:
    for word in _glued(_SPACES.split(text)):
        if letter(word, size=size).right <= width:
            yield word
            continue
        piece = ""
        for term in _TERMS.split(word):
            if piece and letter(piece + term, size=size).right > width:
                yield piece
                piece = ""
            piece += term
        yield piece
