"""The protocol of a view in one position as blocks: sentences with their letters, calculations as formulas."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from string import Formatter
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.formula_text import FUNCTIONS, Node, tree_of
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Angle, Length
from graphic_tmm.language.numbers import EXACTLY, fixed, number
from graphic_tmm.language.symbols import spoken, symbol
from graphic_tmm.note.document import (
    Formula,
    Leaf,
    Number,
    Run,
    Runs,
    Source,
    Symbol,
    Text,
    Tree,
    ends_apart,
)
from graphic_tmm.note.tex import tex
from graphic_tmm.readers.rounding import ROUGH, rounded
from graphic_tmm.readers.sentences import NOTHING, Phrase, grounds, phrase, worth

LEAST = 3
"""A formula has so many sides at least where its letters and its figures differ."""
_INDEX = re.compile(r"_(\w[\w–-]+)")


class Written(NamedTuple):
    """A number as it is printed: its figures, and what they say."""

    text: str
    value: float


DIGITS, FEWEST, FINER = 4, 1, 6
"""Significant digits of a printed number, the fewest that it is cut to, those of one that is lost else."""


def cut_to(value: float, of: str, due: float, language: str, most: int = 4) -> Written:
    """Return a number with no more digits than agree with what printed figures give, within the last of them.

    ``due``: what they give, NaN if nothing; ``of``: the unit, decimals of % being few anyway; ``most``: so many
    significant digits at the most.

    >>> cut_to(0.6183, "", 0.6187, "ru").text, cut_to(97.03, "", 97.05, "en").text
    ('0,618', '97.0')
    >>> cut_to(math.inf, "N", math.inf, "en")
    Written(text='—', value=inf)
    >>> cut_to(0.07, "%", 0.0864, "en").text, cut_to(2.149, "J", math.nan, "en").text
    ('0.1', '2.149')
    """
    if of == "%":
        for places in range(EXACTLY, -1, -1):
            cut = round(value, places)
            if not abs(cut - due) > SLACK * 10.0**-places:
                break
        return Written(number(cut, language), cut)
    told = round(value) if 10.0**most <= abs(value) < math.inf else float(f"{value:.{most}g}")
    whole = Written(number(value, language, most), told)
    if not (math.isfinite(value) and math.isfinite(due) and value):
        return whole
    power = math.floor(math.log10(abs(value)))
    for digits in range(most, FEWEST - 1, -1):
        places = digits - 1 - power
        cut = round(value, places)
        slack = SLACK if digits < most else SLACK + 0.5  # rounded itself, too
        if places < 0 or abs(cut - due) <= slack * 10.0**-places:
            if digits == most or places < 0:
                return whole
            text = (
                fixed(cut, places, language) if power > SMALLEST else number(cut, language, digits)
            )
            return Written(text, cut)
    return whole


SMALLEST = -5
"""Powers of ten below which `number` writes them out."""
SLACK = 1.0 + 1e-6
"""So many of its last digit a number may be off."""


def _by_figures(op: Operation, figures: Sequence[float]) -> float:
    """Return what a formula gives of figures, NaN if nothing."""
    with np.errstate(all="ignore"):
        try:
            return float(np.squeeze(op.run(*(np.array([[one]]) for one in figures))))
        except (ArithmeticError, TypeError, ValueError):
            return math.nan


class NumberSource(NamedTuple):
    """Where the numbers of a view are read: the board's name, the log, the reading, the view, a position.

    ``ruler``: the decimals of a length, mm.
    """

    board: str
    log: Construction
    reading: Reading
    view: str
    place: int
    language: str
    ruler: int = ROUGH

    def value(self, mark: Mark) -> float:
        """Return the value of a mark, as it may be told."""
        row = self.reading.figure(mark)[0]
        return float(row[self.place if row.size > 1 else 0])

    def number(self, mark: Mark, *, unit: bool = False) -> Number:
        """Return the value of a mark as it is written; with its unit, or that of its angle only."""
        value = self.value(mark)
        of = "°" if mark.kind is Angle else "mm" if mark.kind is Length else mark.unit
        source = Source("mark", self.board, str(mark.slot), self.place, self.view)
        told = self.length(value) if mark.kind is Length else self.written(mark, value, of).text
        return Number(told, of if unit or of == "°" else "", source, value)

    def written(self, mark: Mark, value: float, of: str) -> Written:
        """Return a number with as many digits as the figures that are printed before it give.

        Lengths are printed as a ruler reads them: what is calculated of them is known no better.
        """
        key = ("written", mark.slot, self.place, self.language, self.ruler)
        if key not in self.reading.kept:
            step = self.log.step(mark)
            due = math.nan
            if step is not None and step.op.formula:
                due = _by_figures(step.op, [self.printed(one) for one in step.uses])
            most = FINER if mark.slot in self.finer else DIGITS
            self.reading.kept[key] = cut_to(value, of, due, self.language, most)
        found: Written = self.reading.kept[key]
        return found

    @property
    def finer(self) -> frozenset[int]:
        """The slots of what is calculated of given figures alone and lost by four digits: small differences.

        Of what is read by a ruler there is no more to print.
        """
        key = ("finer", self.place)
        if key not in self.reading.kept:
            self.reading.kept[key] = frozenset(self._lost())
        found: frozenset[int] = self.reading.kept[key]
        return found

    def _lost(self) -> Iterator[int]:
        exact: dict[int, bool] = {}
        for step in self.log.steps:
            known = bool(step.op.formula) and step.it.slot in self.reading.values
            known = known and all(
                one.kind is not Length
                and one.slot in self.reading.values
                and exact.get(one.slot, True)
                for one in step.uses
            )
            exact[step.it.slot] = known
            if not known or step.it.kind is Length:
                continue
            value = self.value(step.it)
            figures = [float(f"{self.value(one):.{DIGITS}g}") for one in step.uses]
            due = _by_figures(step.op, figures)
            if not (math.isfinite(value) and math.isfinite(due) and value):
                continue
            last = 10.0 ** (math.floor(math.log10(abs(value))) - DIGITS + 1)
            if abs(float(f"{value:.{DIGITS}g}") - due) > (SLACK + 0.5) * last:
                yield from (one.slot for one in step.uses if one.slot in exact)

    def printed(self, mark: Mark) -> float:
        """Return the value of a mark as it is printed; NaN of one that is not kept."""
        if mark.slot not in self.reading.values:
            return math.nan
        value = self.value(mark)
        if mark.kind is Length:
            read = rounded(value, self.ruler)
            return read or value
        return self.written(mark, value, mark.unit).value

    def length(self, value: float) -> str:
        """Return a length (mm) as a ruler tells it; one that is less than it can tell, as it is."""
        read = rounded(value, self.ruler)
        return (
            fixed(read, self.ruler, self.language)
            if read or not value
            else number(value, self.language)
        )

    def symbol(self, mark: Mark) -> Symbol:
        """Return the letter of a mark; an index of several signs is one."""
        return Symbol(symbol(_INDEX.sub(r"_{\1}", ends_apart(mark.name)), self.language))

    def leaf(self, mark: Mark) -> Leaf:
        """Return the letter of a mark, or its value if it has none."""
        return self.symbol(mark) if mark.name else self.number(mark)


def sentence_runs(told: NumberSource, step: Step) -> Runs:
    """Return what is done in a step, its letters as symbols."""
    return put(phrase(step, told.language, told.reading, told.place), marks_of(step), told)


def reason_runs(told: NumberSource, step: Step) -> Runs:
    """Return why a step is done, its letters as symbols; none if nobody gave a reason."""
    found = grounds(step, told.language, told.reading, told.place)
    return put(found, marks_of(step), told) if found is not None else ()


def marks_of(step: Step) -> dict[str, Mark]:
    """Return the marks of a step by the names that its sentence has for them."""
    return dict(zip(step.op.arguments, step.uses, strict=True)) | {"it": step.it}


def put(said: Phrase, marks: dict[str, Mark], told: NumberSource) -> Runs:
    """Return a sentence: what stands for the names of its template, letters as symbols."""
    template, words = said
    found: list[Run] = []
    for text, name, _, _ in Formatter().parse(template):
        if text:
            found.append(Text(text))
        if name is None:
            continue
        mark, word = marks.get(name), words[name]
        called = spoken(mark, told.language) if mark is not None else ""
        if mark is None or not called or not word.startswith(called):
            found += _number_or_word(told, mark, word)
            continue
        found.append(told.symbol(mark))
        if rest := word.removeprefix(called):
            found.append(Text(rest))
    return tuple(_run_together(found))


def _number_or_word(told: NumberSource, mark: Mark | None, word: str) -> list[Run]:
    if mark is None or mark.name or not any(c.isdigit() for c in word):
        return [Text(word)]
    return [told.number(mark, unit=True)]


def _run_together(runs: Sequence[Run]) -> Iterator[Run]:
    """Yield runs; symbols of a segment that follow each other are one: O–A, pa3."""
    held: Symbol | None = None
    dash = False
    for run in runs:
        if isinstance(run, Symbol) and held is not None:
            held = Symbol(held.markup + ("–" if dash else "") + run.markup)
            dash = False
            continue
        if isinstance(run, Text) and run.text == "–" and held is not None:
            dash = True
            continue
        if held is not None:
            yield held
            if dash:
                yield Text("–")
        held, dash = None, False
        if isinstance(run, Symbol):
            held = run
        else:
            yield run
    if held is not None:
        yield held


def calculated(told: NumberSource, step: Step, terms: tuple[Mark, ...] = ()) -> Formula | None:
    """Return the calculation of a step with its numbers put in, or what was read; None if it has none.

    ``terms``: of a sum that was added up in several steps.
    """
    if step.op.proportion:
        return _proportion(told, step)
    if not worth(step):
        return None
    it = told.symbol(step.it)
    result = told.number(step.it, unit=True)
    if not step.op.formula:
        return Formula((it, result))
    if terms:
        node, marks = _sum(terms)
    else:
        node = tree_of(step.op.formula, FUNCTIONS)
        marks = dict(zip(step.op.arguments, step.uses, strict=True))
    letters = Tree(node, {name: told.leaf(mark) for name, mark in marks.items()})
    figures = Tree(node, {name: told.number(mark) for name, mark in marks.items()})
    sides: list[Leaf | Tree] = [it, letters, figures, result]
    if it in letters.put.values():  # one letter on both sides says nothing
        sides.remove(letters)
    if _same(it, letters, told.language):  # OA + AB is called so
        sides.remove(it)
    if node.head == "±":
        apart = {name: told.number(mark, unit=True) for name, mark in marks.items()}
        return Formula((it, Tree(node, apart)))
    if isinstance(only := _alone(figures), Number) and only.text == result.text:
        sides.remove(figures)
    if it.markup.endswith("/2") and node.head == "/" and len(sides) > LEAST:
        sides.remove(letters)  # the letter says it: half of what it is named after
    return Formula(tuple(sides))


def _same(one: Symbol, other: Tree, language: str) -> bool:
    """Whether a letter is the text of its own formula, but for bars: OA − AB."""
    told = (_SPARE.sub("", tex(side, language)) for side in (one, other))
    return next(told) == next(told)


_SPARE = re.compile(r"\\left|\\right|[\s{}|]")
_SEGMENT = re.compile(r"\{(\w+)\}\{(\w+)\}")


def _proportion(told: NumberSource, step: Step) -> Formula | None:
    """Return the segment sought by the proportion of a figure drawn similar to another: pc = pb·AC/AB."""
    marks = marks_of(step)
    segments = [(marks[a], marks[b]) for a, b in _SEGMENT.findall(step.op.proportion)]
    sizes = [_segment(told, *ends) for ends in segments]
    sought, base, part, whole = sizes
    if not (math.isfinite(sought.value) and min(base.value, whole.value) > NOTHING):
        return None
    node = tree_of("{base}·{part}/{whole}", FUNCTIONS)
    names = [_between(told, *ends) for ends in segments]
    keys = ("base", "part", "whole")
    letters = Tree(node, dict(zip(keys, names[1:], strict=True)))
    figures = Tree(node, dict(zip(keys, (base, part, whole), strict=True)))
    return Formula((names[0], letters, figures, sought._replace(unit="mm")))


def _segment(told: NumberSource, first: Mark, second: Mark) -> Number:
    """Return how long a segment between two points is, mm."""
    rows = (told.reading[mark][0] for mark in (first, second))
    start, end = (row[told.place if row.size > 1 else 0] for row in rows)
    value = float(abs(end - start))
    source = Source("segment", told.board, f"{first.slot} {second.slot}", told.place, told.view)
    return Number(told.length(value), "", source, value)


def _between(told: NumberSource, first: Mark, second: Mark) -> Symbol:
    """Return the letters of a segment."""
    ends = [told.symbol(mark).markup for mark in (first, second)]
    dash = "" if all(END.fullmatch(end) for end in ends) else "–"
    return Symbol(dash.join(ends))


END = re.compile(r"[^\W\d_]\d*′?")
"""Ends of a segment that are told apart as they stand together: OA, aa3."""


def _alone(tree: Tree) -> Leaf | None:
    """Return the only leaf of a tree that is a name."""
    return tree.put.get(tree.node.word) if tree.node.head == "name" else None


def _sum(terms: Sequence[Mark]) -> tuple[Node, dict[str, Mark]]:
    marks = {f"t{k}": mark for k, mark in enumerate(terms)}
    first, *others = (Node("name", (), name) for name in marks)
    for other in others:
        first = Node("+", (first, other))
    return first, marks
