"""The protocol of a view in a table: its calculations, each kind once by its letters, and its construction.

Formulas of one operation are of one kind: the first stands whole, the others with their figures only.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import (
    Block,
    Formula,
    Once,
    Paragraph,
    Run,
    Runs,
    Symbol,
    Table,
    Text,
    leaves,
    text,
)
from graphic_tmm.note.widths import width

READ = "read"
"""The kind of what was read off the drawing."""
LABELS = {
    READ: said("Read off the drawing, with signs"),
    "to_board": said("Lengths on the drawing"),
    "rescaled": said("Lengths in another scale"),
    "in_si": said("Values of lengths by their scale"),
}
"""What kinds are called whose reasons are told once."""
BOTH = said("{title}: construction and calculation")
NUMBER, DONE = said("No."), said("Construction and calculation")
FEW = 3
"""So many kinds and steps are told among words, more in a table. Chosen by eye."""
WHOLE = 4
"""Sides of a formula that stands whole: what is found, its letters, its figures, its value."""
LONG, SHORT, SIGN = 400, 260, 4
"""So many letters of a construction stand in one row of a table, of calculations; what a symbol counts."""


class CalculationRow(NamedTuple):
    """One calculation: its kind, the group of steps it belongs to ("" for none), its reason, its formula.

    ``why`` tells the reason again, whatever letters it is said of.
    """

    kind: str
    group: str
    why: str
    reason: Runs
    formula: Formula


class Section(NamedTuple):
    """What is told of a view: what it is called, its sentences, the equations that it begins with."""

    title: str
    parts: tuple[Runs, ...]
    equations: tuple[Block, ...] = ()


def parts_of(
    rows: Sequence[CalculationRow], drawn: Sequence[Runs], language: str
) -> tuple[Runs, ...]:
    """Return calculations and what is drawn as sentences.

    What is calculated of what was read stands behind what is drawn.
    """
    first = next((k for k, row in enumerate(rows) if row.kind == READ), len(rows))
    before = {row.kind for row in rows[:first]}
    early, late = list[CalculationRow](), list[CalculationRow]()
    for row in rows:
        waits = row.kind not in before or _follows(row, late)
        (late if waits else early).append(row)
    return (*_sentences(early, language), *drawn, *_sentences(late, language))


def as_table(sections: Sequence[Section], id: str, title: str, language: str) -> Iterator[Block]:
    """Yield sections as one table, each below its title, or a few sentences as they are."""
    told = [one for one in sections if one.parts]
    if sum(len(one.parts) for one in told) <= FEW:
        yield from (Paragraph(part) for one in told for part in one.parts)
        return
    rows: list[tuple[Runs, ...]] = []
    count = 0
    for one in told:
        for k, part in enumerate(_run_together(one.parts)):
            count += 1
            begun = text(f"{one.title}. ", "strong") if k == 0 and len(told) > 1 else ()
            rows.append((text(str(count)), (*begun, *part)))
    _ = speaking(language)
    heads = text(_(NUMBER)), text(_(DONE))
    caption = text(_(BOTH, title=title))
    yield Table(id.replace(" ", "-"), caption, heads, tuple(rows), "cl", long=True)


def _run_together(parts: Sequence[Runs]) -> Iterator[Runs]:
    """Yield sentences, those that are short together."""
    held: Runs = ()
    for part in parts:
        most = SHORT if _calculates(held) or _calculates(part) else LONG
        if held and _length(held) + _length(part) > most:
            yield held
            held = part
        else:
            held = (*held, Text(" "), *part) if held else part
    if held:
        yield held


def _calculates(runs: Runs) -> bool:
    return any(isinstance(run, Formula) for run in runs)


def _length(runs: Runs) -> float:
    """Return about how many letters runs have."""
    inside = (run.runs if isinstance(run, Once) else (run,) for run in runs)
    return sum(_letters(one) for some in inside for one in some)


def _letters(run: Run) -> float:
    if isinstance(run, Formula):
        return sum(width(side) for side in run.sides)
    return len(run.text) if isinstance(run, Text) else SIGN


def _kinds(rows: Sequence[CalculationRow]) -> Iterator[tuple[str, list[CalculationRow]]]:
    """Yield calculations of one kind together; one that needs another is told behind it."""
    found: list[list[CalculationRow]] = []
    for row in rows:
        at = max((k for k, some in enumerate(found) if some[0].kind == row.kind), default=-1)
        if at < 0 or any(_follows(row, some) for some in found[at + 1 :]):
            found.append([row])
        else:
            found[at].append(row)
    yield from ((some[0].kind, some) for some in found)


def _follows(row: CalculationRow, others: Sequence[CalculationRow]) -> bool:
    """Whether a letter of a calculation is what others find."""
    used = [leaf for side in row.formula.sides[1:] for leaf in leaves(side)]
    return any(one.formula.sides[0] in used for one in others)


def _reasons(rows: Sequence[CalculationRow]) -> Runs:
    found: list[Run] = []
    for runs in {row.why: row.reason for row in reversed(rows) if row.reason}.values():
        found = [*runs, Text(" "), *found] if found else [*runs]
    return tuple(found)


def _sentences(rows: Sequence[CalculationRow], language: str) -> Iterator[Runs]:
    """Yield calculations as sentences: why, and then what; what has a name, and then why."""
    for kind, some in _kinds(rows):
        reasons, label = _reasons(some), LABELS.get(kind)
        found: list[Run] = []
        if label:
            found.append(Text(f"{speaking(language)(label)}: "))
        elif reasons:
            found += [*reasons, Text(" ")]
        found += [*_formulas(some, goes_on=bool(label)), Text(".")]
        if label and reasons:
            found += [Text(" "), *reasons]
        yield tuple(found)


def _formulas(rows: Sequence[CalculationRow], *, goes_on: bool) -> Runs:
    """Return formulas of one kind one after another, each behind the name of its group where there are two.

    ``goes_on``: words of the same sentence stand before them.
    """
    groups = {row.group for row in rows}
    found: list[Run] = []
    group, known = "", set[str]()
    for row in rows:
        begun = bool(found)
        if begun:
            found.append(Text("; "))
        if row.group != group and row.group and len(groups) > 1:
            name = f"{row.group[:1].lower()}{row.group[1:]}" if begun or goes_on else row.group
            found.append(Text(f"{name}: "))
        group, stem = row.group, "" if row.kind in LABELS else _stem(row.formula)
        found.append(without_letters(row.formula) if stem in known else row.formula)
        known.add(stem)
    return tuple(found)


def _stem(one: Formula) -> str:
    """Return the letter of what is calculated, without the figures that tell it from others of its kind."""
    first = one.sides[0]
    return re.sub(r"[\d′*{}]", "", first.markup) if isinstance(first, Symbol) else ""


def without_letters(one: Formula) -> Formula:
    """Return a formula without its side of letters: one like it was told just before."""
    if len(one.sides) != WHOLE or one.follows:
        return one
    return one._replace(sides=(one.sides[0], *one.sides[2:]))
