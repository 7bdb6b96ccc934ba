"""Sentences of the protocol as the page shows them: runs of text and letters, each letter with its mark."""

from __future__ import annotations

import re
from collections.abc import Iterator
from string import Formatter
from typing import Any

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.language.names import spoken
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.lettering.indices import markup
from graphic_tmm.readers.equations import Equation, Term
from graphic_tmm.readers.narration import Line
from graphic_tmm.readers.sentences import Phrase, grounds, phrase

Run = str | list[Any]
"""Text, or the mark-up of a letter with the slot of its mark."""
_INDEX = re.compile(r"_((?:(?!\w′*_)[^\W_]|[′*–-])+)")
_SINGLE = re.compile(r"([_^])([^{])")


def line_of(line: Line, reading: Reading, language: str) -> dict[str, Any]:
    """Return a line of the protocol as data; what it has nothing to say to is left out."""
    step = line.step
    if step is None:
        told: dict[str, Any] = {"text": [indexed(line.text)]}
        if line.equation is not None:
            told |= {"equation": equation_of(line.equation)}
        return told
    told = {
        "n": line.label,
        "text": runs(phrase(step, language, reading, line.place), step, language),
        "it": step.it.slot,
        "uses": [mark.slot for mark in step.uses],
        "op": step.op.name,
    }
    why = grounds(step, language, reading, line.place)
    if why is not None:
        told["why"] = runs(why, step, language)
    if line.calculation:
        told["calc"] = indexed(line.calculation)
    return told


def indexed(text: str) -> str:
    """Return plain text whose indices are marked up: v_BA -> v_{BA}.

    >>> indexed("v_A = ω_1·l_OA"), indexed("(O_1B_1)")
    ('v_{A} = ω_{1}·l_{OA}', '(O_{1}B_{1})')
    """
    return _INDEX.sub(r"_{\1}", text)


def runs(said: Phrase, step: Step, language: str) -> list[Run]:
    """Return a sentence with what stands for the names of its template, letters with their marks."""
    return list(_runs(said, step, language))


def _runs(said: Phrase, step: Step, language: str) -> Iterator[Run]:
    template, words = said
    marks = dict(zip(step.op.arguments, step.uses, strict=True)) | {"it": step.it}
    for text, name, _, _ in Formatter().parse(template):
        if text:
            yield text
        if name is None:
            continue
        mark, word = marks.get(name), words[name]
        called = spoken(mark, language) if mark is not None else ""
        if mark is None or not called or not word.startswith(called):
            yield word
            continue
        yield [marked_up(mark, language), mark.slot]
        if rest := word.removeprefix(called):
            yield rest


def marked_up(mark: Mark, language: str) -> str:
    """Return the letter of a mark as on the sheet, each of its indices in braces."""
    return _SINGLE.sub(r"\1{\2}", markup(symbol(mark.name, language)))


def equation_of(equation: Equation) -> dict[str, Any]:
    """Return a vector equation as data: its sides, each a row of vectors."""
    sought = equation.sought
    return {
        "sought": term_of(sought) if isinstance(sought, Term) else {"symbol": sought},
        "marks": [mark.slot for mark in equation.marks],
        "sides": [[term_of(term) for term in side] for side in equation.sides],
    }


def term_of(term: Term) -> dict[str, Any]:
    """Return a vector of an equation as data: its letter, what is known of it, the marks that draw it."""
    return {
        "symbol": term.symbol,
        "known": term.known,
        "way": term.direction,
        "marks": [mark.slot for mark in term.marks],
        "line": term.line.slot if term.line is not None else -1,
    }
