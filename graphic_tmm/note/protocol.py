"""The protocol of a view in one position as blocks: sentences, formulas on lines of their own, headings.

What is done is told as running text, a calculation where it stands; what was told already is not told again.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from graphic_tmm.board.operations.choice import scale_of
from graphic_tmm.board.operations.formulas import in_si, rescaled, to_board
from graphic_tmm.board.operations.statics import moment, on_lever
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.captions import view_name
from graphic_tmm.fitting.choice import SCALES
from graphic_tmm.language.symbols import symbol
from graphic_tmm.note.document import Block, Display, Formula, Paragraph, Run, Runs, Symbol, Text
from graphic_tmm.note.steps import Told, calculated, reason_runs, sentence_runs
from graphic_tmm.note.widths import broken
from graphic_tmm.readers.equations import Equation, equations, heading
from graphic_tmm.readers.narration import Line, defined, protocol, remark

PLAIN = (to_board, rescaled, in_si, on_lever, moment, scale_of)
"""Formulas that stand among words: what is carried to the board or from it, a moment of one force, a scale."""
LEAST = 2
"""A formula of more sides than these stands on a line of its own; what is only read stands in its sentence."""

Known = set[Runs | str]
"""What was told already: sentences, formulas."""


def protocol_blocks(
    told: Told,
    *,
    turned: bool = False,
    elsewhere: Sequence[tuple[int, str]] = (),
    known: Known | None = None,
    bare: bool = False,
    usual: Container[str] = (),
) -> Iterator[Block]:
    """Yield the protocol of a view as blocks: headings of groups, equations, sentences, formulas.

    ``elsewhere``: other positions by index and name, see `readers.narration.protocol`. ``known``: what was told
    already and is not told again; that of this view is entered. ``bare``: only what is calculated or read is
    told; ``usual``: operations that go without saying, by name. What is not there in the position is left out.
    """
    lines = protocol(
        told.log,
        told.view,
        told.reading,
        told.place,
        told.language,
        turned=turned,
        elsewhere=elsewhere,
    )
    solved = {one.group: one for one in equations(told.log, told.view, turned=turned)}
    places = [told.place, *(k for k, _ in elsewhere)]
    page = _Page(told, places, solved, set() if known is None else known, usual)
    page.bare = bare
    for line in lines:
        if line.number:
            yield from page.line(line)
    yield from page.flushed()


class _Page:
    """What was told so far and stands in no block yet: words, or formulas on lines of their own."""

    def __init__(
        self,
        told: Told,
        places: Sequence[int],
        solved: dict[str, Equation],
        known: Known,
        usual: Container[str],
    ) -> None:
        self.told, self.places, self.solved = told, places, solved
        self.known, self.usual, self.bare = known, usual, False
        self.steps = [step for step in told.log.steps if step.it.view == told.view]
        self.heads: list[Block] = []
        self.words: list[Run] = []
        self.formulas: list[Formula] = []
        self.after = 0

    def line(self, line: Line) -> Iterator[Block]:
        """Tell a line of the protocol; yield the blocks that are whole by then."""
        notes = [note for step in self.steps[self.after : line.number] for note in _notes(step)]
        if notes:
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

    def step(self, here: Told, step: Step, terms: tuple[Mark, ...]) -> Iterator[Block]:
        """Tell a step: as a formula on a line of its own, or as a sentence."""
        formula = calculated(here, step, terms)
        alone = bool(step.op.formula) and step.op not in PLAIN
        if alone and formula is not None and len(formula.sides) > LEAST:
            yield from self.reason(here, step)
            if repr(formula) not in self.known:
                self.known.add(repr(formula))
                yield from self.paragraph()
                yield from self.begun()
                self.formulas += broken(formula)
        elif formula is not None:
            self.known.add(sentence_runs(here, step))
            yield from self.say(_sentence(sentence_runs(here, step), formula), new=True)
            yield from self.reason(here, step)
        elif not self.bare and step.op.name not in self.usual:
            yield from self.say(sentence_runs(here, step))
            yield from self.reason(here, step)

    def reason(self, here: Told, step: Step) -> Iterator[Block]:
        """Say why a step is done; once, whatever letters it is said of."""
        if step.reason and step.reason not in self.known:
            self.known.add(step.reason)
            yield from self.say(reason_runs(here, step))

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
        language, equation = self.told.language, self.solved.get(note)
        if self.told.view == SCALES:
            self.words.append(Text(f"{view_name(note, language)}.", "emphasis"))
            return
        told = symbol(heading(note, language), language)
        if "=" in told:
            sides, _, behind = told.partition(",  ")
            more = (Symbol(behind),) if behind else ()
            yield Display((Formula((Symbol(sides),), behind=more),))
            return
        yield Paragraph((Text(remark(note, language) + ":", "emphasis"),))
        if equation is not None:
            lines = (equation.markup, equation.directions)
            yield Display(tuple(Formula((Symbol(symbol(one, language)),)) for one in lines))


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
