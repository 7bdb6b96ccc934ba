"""The protocol of one plan: its steps in order, each a sentence and a calculation, with remarks, equations."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.fitting.choice import SCALES
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.readers.equations import Equation, by_group, equations, heading
from graphic_tmm.readers.sentences import calculation, reason, sentence, step_figure
from graphic_tmm.scene.captions import Named, captions, view_name
from graphic_tmm.scene.chapter import chapters


class ProtocolLine(NamedTuple):
    """One line of the protocol: its number (0 for a remark), its text, its calculation ("" if none).

    ``first``: the number of the first step where a line describes several. ``why``: the reason of the step.
    ``step``: the step itself, None for a remark; ``place``: the position (index) of its figures; ``equation``:
    of a remark that is one. ``value``: the figure that the step leaves, in its ``unit``; None if it is none.
    """

    number: int
    text: str
    calculation: str = ""
    first: int = 0
    why: str = ""
    step: Step | None = None
    place: int = 0
    equation: Equation | None = None
    value: float | None = None
    unit: str = ""

    @property
    def label(self) -> str:
        """The number of the step, or the numbers of the steps: 8, 8–9."""
        return f"{self.first}–{self.number}" if 0 < self.first < self.number else str(self.number)


def protocol(
    construction: Construction,
    plan: str,
    reading: Reading,
    place: int,
    language: str,
    *,
    turned: bool = False,
    elsewhere: Sequence[tuple[int, str]] = (),
) -> Iterator[ProtocolLine]:
    """Yield the numbered protocol of one plan in one position, with equations and the calculation note.

    ``place``: the index of the position in ``reading``; ``turned``: the plan is turned by 90°. ``elsewhere``:
    other positions by index and name; a step without a value in the first is printed in one of them. Steps
    without a value in all of them are left out; one remark at the end lists their numbers.
    """
    told, own = place, {place: "", **dict(elsewhere)}
    solved = by_group(equations(construction, plan, turned=turned))
    steps = [step for step in construction.steps if step.it.view == plan]
    sums = _sums(steps)
    first, remarks, left_out = 0, list[ProtocolLine](), list[ProtocolLine]()
    for counted, step in enumerate(steps, 1):
        remarks = _remarks(step, solved, language) or remarks
        first = first or counted
        terms = sums.get(step.it, ())
        if step.it in sums and not terms:
            continue  # told with the sum that it is a part of
        at = next((k for k in own if defined(reading, step.it, k)), None)
        if at is None:
            left_out.append(ProtocolLine(counted, "", first=first))
            first = 0
            continue
        yield from remarks
        remarks = []
        if at != told and own.get(at) and not _still(reading, step.it):
            yield ProtocolLine(0, f"{captions(language)['position']} {own[at]}")
            told = at
        note = calculation(step, reading, at, language, terms)
        why = reason(step, language, reading, at)
        told_so = sentence(step, language, reading, at)
        value, of = step_figure(step, reading, at, language)
        yield ProtocolLine(counted, told_so, note, first, why, step, at, value=value, unit=of)
        first = 0
    yield from _left_out(left_out, language)


def _left_out(lines: Sequence[ProtocolLine], language: str) -> Iterator[ProtocolLine]:
    """Yield the remark that lists the numbers of steps, consecutive ones as a range."""
    stretches: list[ProtocolLine] = []
    for one in lines:
        if stretches and stretches[-1].number + 1 == one.first:
            one = one._replace(first=stretches.pop().first)
        stretches.append(one)
    if listed := ", ".join(one.label for one in stretches):
        text = said("steps that do not exist here: {listed}", listed=listed)
        yield ProtocolLine(0, speaking(language)(text))


def _remarks(
    step: Step, solved: Mapping[str, Sequence[Equation]], language: str
) -> list[ProtocolLine]:
    """Return what stands before a step: its remarks, and the equations that they begin."""
    found = []
    for note in filter(None, step.note.split("\n")):
        heading = view_name if step.it.view == SCALES else remark
        found.append(ProtocolLine(0, heading(note, language)))
        for equation in solved.get(note, ()):
            found.append(ProtocolLine(0, _equation_text(equation, language), equation=equation))
    return found


def _equation_text(equation: Equation, language: str) -> str:
    """Return an equation and its directions as plain text, its indices in a language."""
    text = symbol(equation.text, language).replace("{", "").replace("}", "")
    ways = plain(symbol(equation.directions, language))
    # points are lettered here as where they are named: W3
    ways = re.sub(r"([A-Z])_([0-9])", r"\1\2", ways)
    return f"{text};  {ways}"


def defined(reading: Reading, mark: Mark, place: int) -> bool:
    """Whether a mark has a value in a position (an index); a curve is of all positions."""
    if mark.kind is Curve:
        return True
    row = undefined(reading[mark])[0]
    return not row[place if row.size > 1 else 0]


def _still(reading: Reading, mark: Mark) -> bool:
    """Whether a mark is the same in all positions."""
    return mark.kind is Curve or undefined(reading[mark]).shape[1] == 1


def _sums(steps: Sequence[Step]) -> dict[Mark, tuple[Mark, ...]]:
    """Return the terms of each sum that was added up in several steps; none for the sums on the way to it."""
    found: dict[Mark, tuple[Mark, ...]] = {}
    before: Step | None = None
    for step in steps:
        both = before is not None and before.it.role == step.it.role == roles.SUM
        if both and before is not None and before.it == step.uses[0]:
            found[step.it] = (*(found.get(before.it) or before.uses), *step.uses[1:])
            found[before.it] = ()
        before = step
    return found


_EXTREMES = {
    "left": said("extreme left position of {point}"),
    "right": said("extreme right position of {point}"),
    "top": said("extreme upper position of {point}"),
    "bottom": said("extreme lower position of {point}"),
}


def remark(note: str, language: str) -> str:
    """Return a remark of the log in words: "D: left" is the extreme left position of D.

    What else a remark is called its chapter says.
    """
    words = captions(language)
    if f"phase {note}" in words:
        return words[f"phase {note}"]
    named = (Named.of(one).called(note, speaking(language)) for one in chapters())
    if name := next(filter(None, named), ""):
        return name
    letter, _, way = note.partition(": ")
    return (
        speaking(language)(_EXTREMES[way], point=letter)
        if way in _EXTREMES
        else plain(symbol(heading(note, language), language))
    )
