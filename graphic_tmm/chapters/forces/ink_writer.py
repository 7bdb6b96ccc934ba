"""Equations of moments by letters and with figures, terms and signs, read off the log."""

from __future__ import annotations

import math
from collections.abc import Container, Iterator, Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.statics import moment, on_lever
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen


class Term(NamedTuple):
    """A term of a sum of moments: what acts and its arm (None: it is a couple), +1 if counter-clockwise."""

    acts: Mark
    arm: Mark | None
    sense: int


class Sum(NamedTuple):
    """A sum of moments: what forces and couples are called where it stands, by their values.

    A couple may be a sum itself. ``signed``: what was told with its sign before: in bars if that is −.
    """

    total: Mark
    forces: Mapping[Mark, str]
    couples: Mapping[Mark, str]
    signed: Container[Mark] = ()


class Sought(NamedTuple):
    """What a sum of moments gives: its letter, its value, what it is multiplied by, its sense.

    ``by``: its arm (Length), or the force whose arm is sought; None: it is a couple. ``sense``: +1 if it turns
    counter-clockwise where it is positive: what is sought keeps its sign, all else stands by its size with the
    sign of its sense.
    """

    letter: str
    value: Mark
    by: Mark | None
    sense: int
    unit: str


class Writer:
    """Writes equations of one position; ``decimals``: to how many a length is told."""

    def __init__(self, seen: Seen, index: int, language: str, decimals: int) -> None:
        self.seen, self.index = seen, index
        self.language, self.decimals = language, decimals

    def letter(self, name: str) -> str:
        """Return what a letter of the log is called on the sheet."""
        return markup(symbol(name, self.language))

    def figure(self, mark: Mark) -> str:
        """Return the size of a mark, without its sign."""
        degrees = unit("°", self.language) if mark.kind is Angle else ""
        return f"{number(abs(self.value(mark)), self.language)}{degrees}"

    def value(self, mark: Mark) -> float:
        """Return the value of a mark, as it may be told."""
        row = self.seen.reading.figure(mark)[0]
        return float(row[self.index if row.size > 1 else 0])

    def length(self, mark: Mark) -> str:
        """Return a length as the ruler tells it, without its sign, mm."""
        return fixed(abs(self.value(mark)), self.decimals, self.language)

    def signed(self, mark: Mark) -> str:
        """Return the value of a mark with its sign."""
        return number(self.value(mark), self.language)

    def sense(self, mark: Mark) -> int:
        """Return −1 where a mark is negative, otherwise 1."""
        return -1 if self.value(mark) < 0 else 1

    def terms(self, of: Sum) -> Iterator[Term]:
        """Yield the terms of a sum, as they were added up."""
        step = self.seen.by_mark.get(of.total)
        if of.total in of.couples or step is None:
            yield self._couple(of.total)
        elif step.op is added:
            for part in step.uses:
                yield from self.terms(of._replace(total=part))
        elif step.op in (moment, on_lever):
            force, arm = step.uses[:2]
            turns = self.value(force) * self.value(arm)
            yield Term(force, arm, -1 if turns < 0 else 1)
        else:
            yield self._couple(of.total)

    def _couple(self, mark: Mark) -> Term:
        return Term(mark, None, self.sense(mark))

    def name(self, mark: Mark, of: Sum) -> str:
        """Return the letter of a force or couple, for a term: its size."""
        known = {**of.forces, **of.couples}
        name = self.letter(known.get(mark, mark.name).removeprefix("−"))
        return f"|{name}|" if mark in of.signed and self.sense(mark) < 0 else name

    def _term(self, term: Term, of: Sum, *, figures: bool) -> str:
        """Return a term, by its letters or with its figures."""
        if figures:
            factors = [self.figure(term.acts)] + ([self.length(term.arm)] if term.arm else [])
        else:
            factors = [self.name(term.acts, of)] + (
                [self.letter(term.arm.name)] if term.arm else []
            )
        return "·".join(factors)

    def parts(self, of: Sum, mu: str, *, figures: bool, over: bool = False) -> list[str]:
        """Return the signed terms of a sum, forces first and times ``mu`` ("" where moments are in mm).

        ``over``: taken over to the other side of an equation.
        """
        terms = [term for term in self.terms(of) if self.counts(term)]
        forces = [term for term in terms if term.arm is not None]
        couples = [term for term in terms if term.arm is None]

        def term_text(term: Term) -> str:
            return f"{_sign(term.sense, over)}{self._term(term, of, figures=figures)}"

        found = [term_text(term) for term in forces]
        if len(found) > 1 and mu:
            found[0] = f"+ ({found[0].removeprefix('+ ')}"
            found[-1] += ")"
        if found and mu:
            found[-1] += f"·{mu}"
        return found + [term_text(term) for term in couples]

    def counts(self, term: Term) -> bool:
        """Whether a term is there at all: a force without an arm turns nothing."""
        told = self.value(term.acts)
        turns = told if term.arm is None else told * self.value(term.arm)
        return math.isfinite(turns) and turns != 0.0

    def sought(self, heading: str, of: Sum, sought: Sought, mu: Mark | None) -> list[list[str]]:
        """Return ΣM = 0 by letters, then what it gives with figures; each as parts between which it may break.

        ``mu``: the scale factor of the arms; None on the lever, where moments stay in N·mm.
        """
        told, put = self._factor(mu)
        name, by = self.letter(sought.letter), sought.by
        factors = [name] if by is None else [name, self.letter(by.name)]
        if by is not None and by.kind is not Length:  # a force stands before its arm
            factors.reverse()
        last = "·".join([*factors, told] if told and by is not None else factors)
        left = [*self.parts(of, told, figures=False), f"{_sign(sought.sense)}{last}"]
        above = self.parts(of, put, figures=True, over=sought.sense > 0) or ["0"]
        below = [] if by is None else [self._put(by), *([put] if put else [])]
        value = f"{self.signed(sought.value)} {unit(sought.unit, self.language)}"
        figures = _divided(_bare(above), below)
        left[-1] += " = 0"
        return [[f"{heading} = ", *_bare(left)], [f"{name} = ", *figures, f"= {value}"]]

    def summed(self, heading: str, of: Sum, mu: Mark) -> list[str]:
        """Return a sum of moments that nothing balances, with what it comes to and its sign."""
        told, put = self._factor(mu)
        left = _bare(self.parts(of, told, figures=False))
        total = f"{number(self.value(of.total), self.language)} {unit('N·m', self.language)}"
        if not left:
            return [f"{heading} = ", total]
        figures = _bare(self.parts(of, put, figures=True))
        figures[0] = f"= {figures[0]}"
        return [f"{heading} = ", *left, *figures, f"= {total}"]

    def _put(self, mark: Mark) -> str:
        """Return the size of a length as the ruler tells it, of anything else as a figure."""
        return self.length(mark) if mark.kind is Length else self.figure(mark)

    def _factor(self, mu: Mark | None) -> tuple[str, str]:
        if mu is None:
            return "", ""
        return self.letter(mu.name), number(self.value(mu), self.language)


def _sign(sense: int, over: bool = False) -> str:
    return "+ " if (sense > 0) != over else "− "


def _bare(parts: list[str]) -> list[str]:
    """Return the terms of a sum; the first bears no plus."""
    return [part.removeprefix("+ ") if k == 0 else part for k, part in enumerate(parts)]


def _divided(above: list[str], below: list[str]) -> list[str]:
    """Return a sum over a product."""
    if not below:
        return above
    if len(above) > 1 or above[0].startswith("− "):
        above = [f"[{above[0]}", *above[1:]]
        above[-1] += "]"
    product = "·".join(below)
    above[-1] += f"/({product})" if len(below) > 1 else f"/{product}"
    return above
