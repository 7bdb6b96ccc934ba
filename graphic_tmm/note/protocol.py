"""The protocol of a view in one position as blocks: sentences, formulas on lines of their own, headings.

What is done is told as running text, a calculation where it stands, or all of them in a table; what was told
already is not told again.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si, rescaled, to_board
from graphic_tmm.board.operations.statics import moment, on_lever
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.note.calculations import READ, CalculationRow, parts_of
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Once,
    Paragraph,
    Run,
    Runs,
    Symbol,
    Text,
)
from graphic_tmm.note.gather import ELEMENTARY, DrawingStep, gathered
from graphic_tmm.note.steps import NumberSource, calculated, reason_runs, sentence_runs
from graphic_tmm.note.tex import tex
from graphic_tmm.note.widths import broken
from graphic_tmm.readers.equations import by_group, equations, heading
from graphic_tmm.readers.narration import ProtocolLine, defined, protocol, remark

PLAIN = (to_board, rescaled, in_si, on_lever, moment)
"""Formulas that stand among words: what is carried to the board or from it, a moment of one force."""
LEAST = 2
"""A formula of more sides than these stands on a line of its own; what is only read stands in its sentence."""

RELATIONS = "=∥⊥"
"""By these a remark before a step is a formula: v_A = ω_1·l_OA, v_B ∥ x; a name else."""
MEASURED = said("Read off the drawing, with their signs: ")

Known = set[Runs | str]
"""What was told already: sentences, formulas."""


class Manner(NamedTuple):
    """How a view is told.

    ``turned``: the plan is turned by 90°. ``elsewhere``: other positions by index and name, see
    `readers.narration.protocol`. ``known``: what was told already and is not told again; that of this view is
    entered. ``bare``: only what is calculated or read is told; ``usual``: operations that go without saying, by
    name; ``brief``: steps of drawing without a reason that is new are left out.
    """

    turned: bool = False
    elsewhere: Sequence[tuple[int, str]] = ()
    known: Known | None = None
    bare: bool = False
    usual: Container[str] = ()
    brief: bool = False


def protocol_blocks(told: NumberSource, manner: Manner) -> Iterator[Block]:
    """Yield the protocol of a view as blocks: headings of groups, equations, sentences, formulas.

    What is not there in the position is left out.
    """
    page = _Page(told, manner, listed=False)
    for line in page.lines():
        yield from page.line(line)
    yield from page.worked()
    yield from page.flushed()


class Parts(NamedTuple):
    """The protocol of a view in parts: the equations that its groups begin with, its sentences."""

    equations: tuple[Block, ...]
    sentences: tuple[Runs, ...]


def protocol_parts(told: NumberSource, manner: Manner) -> Parts:
    """Return the protocol of a view in parts, calculations of one kind together; see `protocol_blocks`."""
    page = _Page(told, manner, listed=True)
    for line in page.lines():
        _all(page.line(line))
    _all(page.worked())
    sentences = parts_of(page.rows, page.parts, told.language)
    return Parts(tuple(page.equations), sentences)


def _all(blocks: Iterator[Block]) -> None:
    """Go on to the end of what yields no block, or none that is wanted."""
    for _ in blocks:
        pass


class _Page:
    """What was told so far and stands in no block yet: words, or formulas on lines of their own."""

    def __init__(self, told: NumberSource, manner: Manner, *, listed: bool) -> None:
        self.told, self.manner, self.listed = told, manner, listed
        self.known: Known = set() if manner.known is None else manner.known
        self.before = frozenset(self.known)
        self.places = [told.place, *(k for k, _ in manner.elsewhere)]
        self.solved = by_group(equations(told.log, told.view, turned=manner.turned))
        self.steps = [step for step in told.log.steps if step.it.view == told.view]
        self.heads: list[Block] = []
        self.words: list[Run] = []
        self.formulas: list[Formula] = []
        self.rows: list[CalculationRow] = []
        self.parts: list[Runs] = []
        self.work: list[DrawingStep] = []
        self.readings: list[Formula] = []
        self.waiting: list[Once] = []
        self.group = ""
        self.behind: tuple[Symbol, ...] = ()
        self.equations: list[Block] = []
        self.after = 0

    def lines(self) -> Iterator[ProtocolLine]:
        """Yield the lines of the protocol that tell a step."""
        told, manner = self.told, self.manner
        where = told.log, told.view, told.reading, told.place, told.language
        for line in protocol(*where, turned=manner.turned, elsewhere=manner.elsewhere):
            if line.number:
                yield line

    def line(self, line: ProtocolLine) -> Iterator[Block]:
        """Tell a line of the protocol; yield the blocks that are whole by then."""
        notes = [note for step in self.steps[self.after : line.number] for note in _notes(step)]
        if notes:
            yield from self.worked()
            yield from self.flushed()
            self.heads = [one for note in notes for one in self.heading(note)]
        step = self.steps[line.number - 1]
        some = self.steps[max(line.first, 1) - 1 : line.number]
        self.after = line.number
        reading = self.told.reading
        at = next((k for k in self.places if defined(reading, step.it, k)), self.told.place)
        if defined(reading, step.it, at):
            terms = _terms(some) if len(some) > 1 else ()
            yield from self.step(self.told._replace(place=at), step, terms)

    def step(self, here: NumberSource, step: Step, terms: tuple[Mark, ...]) -> Iterator[Block]:
        """Tell a step: as a formula on a line of its own, or as a sentence."""
        formula = calculated(here, step, terms)
        if formula is None:
            yield from self.read()
            if not self.manner.bare and step.op.name not in self.manner.usual:
                self.work.append(DrawingStep(here, step))
        elif self.listed:
            self.row(here, step, formula)
        elif not step.op.formula and not step.op.proportion:
            yield from self.drawn()
            self.readings.append(formula._replace(flat=True))
            if self.wait(here, step):
                yield from self.read()
        else:
            yield from self.worked()
            yield from self.calculated(here, step, formula)

    def wait(self, here: NumberSource, step: Step) -> bool:
        """Keep why something is read until it is told; return whether that is new."""
        new = bool(step.reason) and step.reason not in self.known
        if new:
            self.known.add(step.reason)
            self.waiting.append(Once(step.reason, reason_runs(here, step)))
        return new

    def calculated(self, here: NumberSource, step: Step, formula: Formula) -> Iterator[Block]:
        """Tell a calculation: on a line of its own, or among words."""
        alone = bool(step.op.formula) and step.op not in PLAIN
        if not alone or len(formula.sides) <= LEAST:
            self.known.add(sentence_runs(here, step))
            yield from self.say(_sentence(sentence_runs(here, step), formula), new=True)
            yield from self.reason(here, step)
            return
        yield from self.reason(here, step)
        if repr(formula) not in self.known:
            self.known.add(repr(formula))
            yield from self.paragraph()
            yield from self.begun()
            formula, self.behind = formula._replace(behind=self.behind), ()
            self.formulas += broken(formula)

    def worked(self) -> Iterator[Block]:
        """Tell what was drawn and read since a calculation was told."""
        yield from self.drawn()
        yield from self.read()

    def drawn(self) -> Iterator[Block]:
        """Tell the steps of pure drawing so far, together."""
        work, self.work = self.work, []
        if self.listed:
            self.parts += self.sentences(work)
            return
        for runs, steps in gathered(work):
            yield from self.say(runs)
            for one in steps:
                if one.step.why or one.step.op not in ELEMENTARY:
                    yield from self.reason(*one)

    def sentences(self, work: Sequence[DrawingStep]) -> Iterator[Runs]:
        """Yield what was drawn, each sentence with its reasons; the first behind the name of its group."""
        head = self.group
        for runs, steps in gathered(work):
            if runs in self.known:
                continue
            self.known.add(runs)
            if self.told_before([one.step for one in steps]):
                continue
            found: list[Run] = [Text(f"{head}: ", "emphasis"), *runs] if head else [*runs]
            head = ""
            for here, step in steps:
                if _reasoned(step):
                    self.known.add(step.reason)
                    found += [Text(" "), Once(step.reason, reason_runs(here, step))]
            yield tuple(found)

    def told_before(self, steps: Sequence[Step]) -> bool:
        """Whether steps go without saying: a view before told their like with its reasons."""
        reasons = {step.reason for step in steps if _reasoned(step)}
        if self.manner.brief:
            return reasons <= self.known
        return bool(reasons) and reasons <= self.before

    def read(self) -> Iterator[Block]:
        """Tell what was read off the drawing so far, together."""
        if self.readings:
            some, self.readings = self.readings, []
            runs: list[Run] = [Text(speaking(self.told.language)(MEASURED))]
            for k, one in enumerate(some):
                runs += [Text(", "), one] if k else [one]
            waiting, self.waiting = self.waiting, []
            yield from self.say((*runs, Text(".")), new=True)
            for reason in waiting:
                yield from self.say((reason,), new=True)

    def row(self, here: NumberSource, step: Step, formula: Formula) -> None:
        """Keep a calculation for the table; what was read is of one kind, whatever it was read with."""
        told = {tex(formula, here.language), repr(formula)}
        if told & self.known:
            return
        self.known |= told
        plain = step.op in PLAIN or not step.op.formula
        kind = step.op.name if step.op.formula else READ
        runs = reason_runs(here, step)
        reason: Runs = (Once(step.reason, runs),) if runs and plain else runs
        self.rows.append(
            CalculationRow(kind, self.group, step.reason, reason, formula._replace(flat=True))
        )

    def reason(self, here: NumberSource, step: Step) -> Iterator[Block]:
        """Say why a step is done; once, whatever letters it is said of."""
        if step.reason and step.reason not in self.known:
            self.known.add(step.reason)
            yield from self.say((Once(step.reason, reason_runs(here, step)),), new=True)

    def say(self, runs: Runs, *, new: bool = False) -> Iterator[Block]:
        """Add a sentence to the words, unless it is known; ``new``: it is none that could be."""
        if not runs or (not new and runs in self.known):
            return
        if not new:
            self.known.add(runs)
        yield from self.display()
        yield from self.begun()
        self.words += [Text(" "), *runs] if self.words else runs

    def begun(self) -> Iterator[Block]:
        """Yield the headings under which something is told now."""
        yield from self.heads
        self.heads = []

    def paragraph(self) -> Iterator[Block]:
        """Yield the words told so far, which begin anew."""
        if self.words:
            yield Paragraph(tuple(self.words))
            self.words = []

    def display(self) -> Iterator[Block]:
        """Yield the formulas that stand on lines of their own so far, which begin anew."""
        if self.formulas:
            yield Display(tuple(self.formulas))
            self.formulas = []

    def flushed(self) -> Iterator[Block]:
        """Yield all that was told; headings under which nothing is new are dropped."""
        yield from self.display()
        yield from self.paragraph()
        self.heads = []

    def heading(self, note: str) -> Iterator[Block]:
        """Yield what stands before a step: a heading with the equations of its group, or a formula."""
        language, solved = self.told.language, self.solved.get(note, ())
        told = symbol(heading(note, language), language)
        if any(sign in told for sign in RELATIONS):
            sides, *behind = (Symbol(one) for one in told.split(",  "))
            self.behind = tuple(behind)
            self.equations.append(Display((Formula((sides,), behind=self.behind),)))
            return
        group = remark(note, language)
        self.group = f"{group[:1].upper()}{group[1:]}"
        yield Paragraph((Text(self.group + ":", "emphasis"),))
        if solved:
            lines = [line for one in solved for line in (one.markup, one.directions)]
            told_ = Display(tuple(Formula((Symbol(symbol(one, language)),)) for one in lines))
            self.equations += [Paragraph((Text(self.group + ":", "emphasis"),)), told_]
            yield told_


def _reasoned(step: Step) -> bool:
    """Whether a step has a reason beyond elementary geometry."""
    return bool(step.reason) and bool(step.why or step.op not in ELEMENTARY)


def _notes(step: Step) -> list[str]:
    return [note for note in step.note.split("\n") if note]


def _terms(steps: Sequence[Step]) -> tuple[Mark, ...]:
    """Return the terms of a sum that was added up in several steps."""
    return (*steps[0].uses, *(mark for step in steps[1:] for mark in step.uses[1:]))


def _sentence(runs: Runs, formula: Formula) -> Runs:
    """Return a sentence with its formula; of one that only says what is calculated the formula."""
    flat, last = formula._replace(flat=True), runs[-1]
    if isinstance(last, Text) and last.text == "." and len(formula.sides) > LEAST:
        return (flat, Text("."))
    if isinstance(last, Text) and last.text.endswith("."):
        runs = (*runs[:-1], Text(last.text[:-1] + ": "))
    return (*runs, flat, Text("."))
