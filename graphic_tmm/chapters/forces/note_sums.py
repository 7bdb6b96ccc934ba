"""Sums of moments as formulas of a note, each number with its mark; what a note tells of the lever."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board.formula_text import Node
from graphic_tmm.board.operations.statics import on_lever
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.forces.ink_writer import Sought, Sum, Term, Writer
from graphic_tmm.chapters.forces.lever import Carried, Lever
from graphic_tmm.chapters.forces.plan import Forces
from graphic_tmm.chapters.forces.tool import Tool
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.note.document import (
    Block,
    Formula,
    Leaf,
    Number,
    Ref,
    Runs,
    Source,
    Symbol,
    Table,
    Tree,
    text,
)
from graphic_tmm.note.page import Page
from graphic_tmm.note.steps import NumberSource
from graphic_tmm.note.widths import broken
from graphic_tmm.paper.seen import Seen


class Balance(NamedTuple):
    """A sum of moments that was written: its heading, the sum, what it gives, the scale factor of its arms."""

    heading: str
    of: Sum
    sought: Sought | None
    mu: Mark | None


class Kept(Writer):
    """A writer that keeps the sums that it writes, so that they can be told as formulas too."""

    def __init__(self, seen: Seen, index: int, language: str, decimals: int) -> None:
        super().__init__(seen, index, language, decimals)
        self.sums: list[Balance] = []

    def sought(self, heading: str, of: Sum, sought: Sought, mu: Mark | None) -> list[list[str]]:
        """Write a sum that gives something."""
        self.sums.append(Balance(heading, of, sought, mu))
        return super().sought(heading, of, sought, mu)

    def summed(self, heading: str, of: Sum, mu: Mark) -> list[str]:
        """Write a sum that nothing balances."""
        self.sums.append(Balance(heading, of, None, mu))
        return super().summed(heading, of, mu)


def sums(writer: Kept, board: str) -> Iterator[Formula]:
    """Yield the sums that were written since the last time, as formulas."""
    for one in writer.sums:
        yield from _SumFormulas(writer, board, one).formulas()
    writer.sums.clear()


class _SumFormulas:
    """One sum as formulas."""

    def __init__(self, writer: Kept, board: str, one: Balance) -> None:
        self.writer, self.board, self.one = writer, board, one
        self.put: dict[str, Leaf] = {}

    def formulas(self) -> Iterator[Formula]:
        """Yield ΣM by letters, then what it gives with figures."""
        one, writer = self.one, self.writer
        heading = Symbol(writer.letter(one.heading))
        if one.sought is None:
            total = self._signed(one.of.total, "N·m")
            whole = self._tree(self._sum(figures=False)), self._tree(self._sum(figures=True))
            yield from broken(Formula((heading, *whole, total)))
            return
        left = [*self._parts(figures=False), (one.sought.sense, self._last(one.sought))]
        yield from broken(Formula((heading, self._tree(_signed(left)), Symbol("0"))))
        name, value = self._name(one.sought), self._signed(one.sought.value, one.sought.unit)
        yield from broken(Formula((name, self._tree(self._quotient(one.sought)), value)))

    def _sum(self, *, figures: bool) -> Node:
        parts = self._parts(figures=figures)
        return _signed(parts) if parts else self._leaf(Symbol("0"))

    def _tree(self, node: Node) -> Tree:
        return Tree(node, self.put)

    def _leaf(self, leaf: Leaf) -> Node:
        name = f"x{len(self.put)}"
        self.put[name] = leaf
        return Node("name", (), name)

    def _parts(self, *, figures: bool) -> list[tuple[int, Node]]:
        """Return the terms with their signs: forces, times the scale factor if there is one, then couples."""
        terms = [term for term in self.writer.terms(self.one.of) if self.writer.counts(term)]
        forces = [(term.sense, self._term(term, figures)) for term in terms if term.arm]
        couples = [(term.sense, self._term(term, figures)) for term in terms if not term.arm]
        if forces and self.one.mu is not None:
            mu = self._either(self.one.mu, figures)
            if len(forces) == 1:
                forces = [(forces[0][0], Node("·", (forces[0][1], mu)))]
            else:
                forces = [(1, Node("·", (_signed(forces), mu)))]
        return [*forces, *couples]

    def _term(self, term: Term, figures: bool) -> Node:
        of = {**self.one.of.forces, **self.one.of.couples}
        name = of.get(term.acts, term.acts.name)
        acts = self._leaf(self._size(term.acts)) if figures else self._barred(term.acts, name)
        if term.arm is None:
            return acts
        return Node("·", (acts, self._either(term.arm, figures)))

    def _either(self, mark: Mark, figures: bool) -> Node:
        return self._leaf(self._size(mark)) if figures else self._barred(mark, mark.name)

    def _barred(self, mark: Mark, name: str) -> Node:
        """Return the letter of a size, in bars where the letter itself has been told to be negative.

        Arms are told with their signs on the lever only, in a table.
        """
        letter = self._leaf(Symbol(self.writer.letter(name.removeprefix("−"))))
        negative = self.writer.sense(mark) != (-1 if name.startswith("−") else 1)
        told = self.one.mu is None or mark.kind is not Length
        return Node("abs", (letter,)) if negative and told else letter

    def _size(self, mark: Mark) -> Number:
        """Return the size of a mark, a length as the ruler tells it."""
        writer = self.writer
        told = writer.length(mark) if mark.kind is Length else writer.figure(mark)
        return Number(told, "", self._source(mark, "size"), abs(writer.value(mark)))

    def _name(self, sought: Sought) -> Symbol:
        return Symbol(self.writer.letter(sought.letter))

    def _signed(self, mark: Mark, of: str) -> Number:
        """Return a force, a moment with its sign and its unit."""
        told, value = self.writer.signed(mark), self.writer.value(mark)
        return Number(told, of, self._source(mark, "mark"), value)

    def _source(self, mark: Mark, kind: str) -> Source:
        return Source(kind, self.board, str(mark.slot), self.writer.index, mark.view)

    def _last(self, sought: Sought) -> Node:
        """Return the term of what is sought: a force and its arm, times the scale factor, or a couple."""
        name = self._leaf(self._name(sought))
        if sought.by is None:
            return name
        by = self._either(sought.by, False)
        both = (name, by) if sought.by.kind is Length else (by, name)
        product = Node("·", both)
        if self.one.mu is not None:
            product = Node("·", (product, self._either(self.one.mu, False)))
        return product

    def _quotient(self, sought: Sought) -> Node:
        """Return what is sought with figures: the other terms, taken over, by what it is multiplied by."""
        over = -1 if sought.sense > 0 else 1
        terms = [(over * sign, node) for sign, node in self._parts(figures=True)]
        above = _signed(terms) if terms else self._leaf(Symbol("0"))
        if sought.by is None:
            return above
        below = self._either(sought.by, True)
        if self.one.mu is not None:
            below = Node("·", (below, self._either(self.one.mu, True)))
        return Node("/", (above, below))


def _signed(terms: Sequence[tuple[int, Node]]) -> Node:
    """Return terms with their signs as one node."""
    (sign, found), *others = terms
    if sign < 0:
        found = Node("neg", (found,))
    for sign, node in others:
        found = Node("+" if sign > 0 else "−", (found, node))
    return found


LEVER = said(
    "The velocity plan turned by 90° is taken for a rigid lever that can turn about its pole {pole}. All "
    "forces are applied at the images of their points, parallel to themselves, the balancing one too, at "
    "{pin}: the arm of each about the pole then shows the velocity along it, its moment shows its power. The "
    "powers add up to nothing, so the lever is in equilibrium."
)
SOUGHT = said(
    "The velocity plan turned by 90° is taken for a rigid lever that can turn about its pole {pole}. All "
    "forces are applied at the images of their points, parallel to themselves, the unknown one too, at {pin}: "
    "the arm of each about the pole then shows the velocity along it, its moment shows its power. The powers "
    "add up to nothing, so one division gives the unknown force."
)
COUPLES = said(
    "A couple is replaced by one of equal power: by its moment times the image of its link, divided by the "
    "link."
)
ARMS = said("The arms are measured; forces, arms and moments stand in {table}.")
MOMENTS = said("Forces on the lever, their arms and moments about the pole")
FORCE, POINT = said("Force"), said("Image")


def applied(page: Page[Forces], lever: Lever, tool: Tool | None) -> Iterator[Block]:
    """Yield how the loads come to stand on a lever: in words, couples converted, a table of moments."""
    told = page.of(lever.pole.view)
    if told is None:
        return
    says, pin = (LEVER, lever.pin) if tool is None else (SOUGHT, tool.carried.point)
    yield page.says(says, pole=told.symbol(lever.pole), pin=told.symbol(pin))
    if lever.couples:
        yield page.says(COUPLES)
        yield from page.worked_out(*(one.value for one in lever.couples))
    rows = tuple(_row(told, one) for one in lever.forces)
    if rows:
        table = _table(page, lever.pole.view, rows)
        yield page.says(ARMS, table=Ref(table.id))
        yield table


def _row(told: NumberSource, one: Carried) -> tuple[Runs, ...]:
    """Return a row of the table: the force, its size, its image, its arm, its moment."""
    steps = (s for s in told.log.steps if s.op is on_lever and s.it.view == told.view)
    step = next(step for step in steps if step.uses[0] == one.value)
    letter = Symbol(symbol(one.letter, told.language))
    figures = (told.number(mark) for mark in (step.uses[1], step.it))
    return (
        (letter,),
        (told.number(one.value),),
        (told.symbol(one.point),),
        *((figure,) for figure in figures),
    )


def _table(page: Page[Forces], view: str, rows: tuple[tuple[Runs, ...], ...]) -> Table:
    language = page.language
    heads = (
        text(page.speech(FORCE)),
        text(unit("N", language)),
        text(page.speech(POINT)),
        (Symbol("h"), *text(f", {unit('mm', language)}")),
        (Symbol("M"), *text(f", {unit('N·mm', language)}")),
    )
    return Table(
        f"table-{view.replace(' ', '-')}", text(page.speech(MOMENTS)), heads, rows, "lcccc"
    )
