"""The protocol as the page shows it: plans and their steps, sentences as runs of text and letters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from string import Formatter
from typing import Any, NamedTuple

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.symbols import plain, spoken, symbol
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.equations import Equation, Term
from graphic_tmm.readers.narration import ProtocolLine
from graphic_tmm.readers.protocol import plan_protocols, plans
from graphic_tmm.readers.sentences import Phrase, grounds, phrase

Run = str | list[Any]
"""Text, or the mark-up of a letter with the slot of its mark."""
_INDEX = re.compile(r"_((?:(?!\w′*_)[^\W_²³]|[′*–-])+)")
_RAISED = re.compile(r"\^([^\W_]+)(?![\w{])")
_FIGURE = re.compile(r"[_^]?\{[^{}]*\}|([^\W\d_])(\d+)")
_SINGLE = re.compile(r"([_^])([^{])")


def line_of(line: ProtocolLine, reading: Reading, language: str) -> dict[str, Any]:
    """Return a line of the protocol that tells a step as data; what it has nothing to say to is left out."""
    step = line.step
    assert step is not None
    told: dict[str, Any] = {
        "text": [*runs(phrase(step, language, reading, line.place), step, language)],
        "it": step.it.slot,
        "uses": [mark.slot for mark in step.uses],
        "op": step.op.name,
    }
    why = grounds(step, language, reading, line.place)
    if why is not None:
        told["why"] = [*runs(why, step, language)]
    if line.calculation:
        told["calc"] = indexed(line.calculation)
    return told


def head_of(line: ProtocolLine, stops: Mapping[int, int], language: str) -> dict[str, Any]:
    """Return a remark that stands before a step as data; ``stops``: in which a mark is made, by its slot."""
    text = line.text if "=" in line.text else f"{line.text[:1].upper()}{line.text[1:]}"
    told: dict[str, Any] = {"head": True, "text": [indexed(text)]}
    if line.equation is not None:
        one = _spoken(line.equation, language)
        sought = one.sought
        left = sought if isinstance(sought, Term) else Term(sought, False, marks=one.marks)
        under = 1 if isinstance(sought, Term) else 0
        sides = [_sides([left], stops, under), *(_sides(side, stops) for side in one.sides)]
        told["equation"] = {"sides": sides, "ways": braced(one.directions)}
    return told


def sum_of(terms: Sequence[Term], stops: Mapping[int, int], language: str) -> dict[str, Any]:
    """Return the equation of a closed polygon as data: its vectors make nothing."""
    named = [_named(one, language) for one in terms]
    text = " + ".join(plain(one.symbol) for one in named) + " = 0"
    sides = [_sides(named, stops), [{"s": "0", "u": 0, "of": [], "from": 0, "to": 0}]]
    return {"head": True, "text": [indexed(text)], "equation": {"sides": sides, "ways": ""}}


def _spoken(equation: Equation, language: str) -> Equation:
    """Return an equation with its letters as a language has them."""
    sought = equation.sought
    left = symbol(sought, language) if isinstance(sought, str) else _named(sought, language)
    sides = tuple(tuple(_named(term, language) for term in side) for side in equation.sides)
    return equation._replace(sought=left, sides=sides)


def _named(term: Term, language: str) -> Term:
    return term._replace(symbol=symbol(term.symbol, language))


def _sides(
    terms: Sequence[Term], stops: Mapping[int, int], under: int | None = None
) -> list[dict[str, Any]]:
    return [term_of(term, stops, under) for term in terms]


def term_of(term: Term, stops: Mapping[int, int], under: int | None = None) -> dict[str, Any]:
    """Return a vector of an equation as data.

    ``s``: its letter; ``u``: the lines under it, two where it is known wholly, one where its direction is;
    ``of``: the marks that draw it; ``from``, ``to``: the stops in which its line is drawn and it is whole.
    """
    marks = [*term.marks, *([term.line] if term.line is not None else [])]
    whole = max((stops.get(mark.slot, 0) for mark in marks), default=0)
    begun = stops.get(term.line.slot, 0) if term.line is not None else whole
    lines = under if under is not None else (2 if term.known else 1 if term.line else 0)
    of = [mark.slot for mark in marks]
    return {"s": braced(term.symbol), "u": lines, "of": of, "from": begun, "to": whole}


def indexed(text: str) -> str:
    """Return plain text whose indices are marked up: v_BA -> v_{BA}.

    >>> indexed("v_A = ω_1·l_OA"), indexed("(O_1B_1)")
    ('v_{A} = ω_{1}·l_{OA}', '(O_{1}B_{1})')
    >>> indexed("a_A = ω_1²·l_OA")
    'a_{A} = ω_{1}²·l_{OA}'
    >>> indexed("R_63^τ = 9192 N")
    'R_{63}^{τ} = 9192 N'
    >>> indexed("ps1/pa3 = OS1/OA = 27,17 mm")
    'ps_{1}/pa_{3} = OS_{1}/OA = 27,17 mm'
    """
    told = _RAISED.sub(r"^{\1}", _INDEX.sub(r"_{\1}", text))
    return _FIGURE.sub(lambda found: f"{found[1]}_{{{found[2]}}}" if found[1] else found[0], told)


def runs(said: Phrase, step: Step, language: str) -> Iterator[Run]:
    """Yield a sentence with what stands for the names of its template, letters with their marks."""
    template, words = said
    marks = dict(zip(step.op.arguments, step.uses, strict=True)) | {"it": step.it}
    for text, name, _, _ in Formatter().parse(template):
        if text:
            yield indexed(text)
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
    return braced(symbol(mark.name, language))


def braced(letter: str) -> str:
    """Return a letter with each of its indices in braces.

    >>> braced("a_{BA}^n"), braced("v_A")
    ('a_{BA}^{n}', 'v_{A}')
    """
    return _SINGLE.sub(r"\1{\2}", markup(letter))


class Lines(NamedTuple):
    """Lines that follow one another, all of them steps (``numbered``) or all remarks."""

    numbered: bool
    lines: tuple[ProtocolLine, ...]


class Plan(NamedTuple):
    """A plan: what it is headed by, its lines in runs."""

    title: str
    runs: tuple[Lines, ...]


def protocol_of(made: DrawnScene, language: str) -> list[Plan]:
    """Return the protocols of all plans of a scene, a reason only where it is another than before."""
    return [
        Plan(one.title, tuple(_in_lists(_reasoned(one.lines))))
        for one in plan_protocols(made, plans(), None, language)
    ]


def _in_lists(lines: Iterator[ProtocolLine]) -> Iterator[Lines]:
    for numbered, some in groupby(lines, lambda line: line.number > 0):
        yield Lines(numbered, tuple(some))


def _reasoned(lines: tuple[ProtocolLine, ...]) -> Iterator[ProtocolLine]:
    before = ""
    for line in lines:
        yield line._replace(why="" if line.why == before else line.why)
        before = line.why or before
