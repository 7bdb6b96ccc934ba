"""The equations of moments beside a detached group, the driving link and the lever, read off the log."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.statics import moment, on_lever, tangential
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Length
from graphic_tmm.chapters.forces.detached import Polygon, Reaction
from graphic_tmm.chapters.forces.driving import Driven
from graphic_tmm.chapters.forces.ink_equations import Row
from graphic_tmm.chapters.forces.lever import Converted, Lever
from graphic_tmm.chapters.forces.plan import Forces
from graphic_tmm.chapters.forces.statics import Solved, summed_links
from graphic_tmm.chapters.forces.tool import Tool
from graphic_tmm.chapters.forces.wheels import SolvedWheel
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen
from graphic_tmm.readers.sentences import letters_of


class Term(NamedTuple):
    """A term of a sum of moments: what acts and its arm (None: it is a couple), +1 if counter-clockwise."""

    acts: Mark
    arm: Mark | None
    sense: int


class Sum(NamedTuple):
    """A sum of moments: what forces and couples are called where it stands, by their values.

    A couple may be a sum itself.
    """

    total: Mark
    forces: Mapping[Mark, str]
    couples: Mapping[Mark, str]


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
        return self.letter(known.get(mark, mark.name).removeprefix("−"))

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


def _wheel_rows(writer: Writer, made: Forces, solved: SolvedWheel) -> Iterator[Row]:
    """Yield the equation of moments of a wheel, parts of the tooth's force or the belt's pull, reactions."""
    (across, *along), leg = solved.parts, solved.wheel.leg
    of = Sum(solved.total, *_names(made, solved.links))
    sought = Sought(across.letter, across.value, across.arm, 1, "N")
    for parts in writer.sought(f"ΣM_{{{leg.pivot.name}}}", of, sought, solved.figure.mu):
        yield Row(parts, across.value)
    for part in along:
        yield _formula(writer, part.value, "N")
    for reaction in solved.reactions:
        yield _read(writer, reaction, solved.polygon)


def group_rows(writer: Writer, made: Forces, solved: Solved | SolvedWheel) -> Iterator[Row]:
    """Yield the equations of moments of a group, what they give, and the reactions of its polygon."""
    if isinstance(solved, SolvedWheel):
        yield from _wheel_rows(writer, made, solved)
        return
    closing, figure = solved.closing, solved.figure
    names = _names(made, (*closing.group.links, *closing.group.rods))
    for leg in closing.legs:
        total = solved.turning[leg.link]
        if total is None:
            continue
        links = ",".join(map(str, summed_links(closing, leg)))
        heading, of = f"ΣM_{{{closing.pin(leg).name}}}^{{({links})}}", Sum(total, *names)
        tangent = solved.tangents.get(leg.link)
        if tangent is not None:
            sought = Sought(tangent.letter, tangent.value, tangent.arm, -1, "N")
            for parts in writer.sought(heading, of, sought, figure.mu):
                yield Row(parts, tangent.value)
            continue
        yield from _guided(writer, solved, heading, of)
    yield from _third_rows(writer, solved, *names)
    for reaction in solved.reactions:
        yield _read(writer, reaction, solved.polygon)
    rods = [one for one in made.driven if one.pair.link in solved.rods]
    for driven in rods:
        length, *_ = writer.seen.by_mark[driven.balance].uses
        own = driven.letter, length, driven.balance
        yield _measured(writer, own, solved.polygon, signed=True)
    shown = {one.balance for one in rods}
    for force in (one for one in made.first.lever.forces if one.value not in shown):
        step = writer.seen.by_mark.get(force.value)  # friction along guides, read off the polygon
        if step and step.op is in_si and step.uses[0].view == solved.polygon.view:
            yield _along(writer, force.value, solved.polygon)


def _third_rows(
    writer: Writer, solved: Solved, forces: dict[Mark, str], couples: dict[Mark, str]
) -> Iterator[Row]:
    """Yield the equation of moments of a plate and its legs about its special point."""
    if (special := solved.special) is None:
        return
    for couple in special.couples:
        yield _formula(writer, couple.value, "N·m")
    forces = {**forces, **{force.value: force.letter for force in special.forces}}
    third = special.third
    sought = Sought(third.letter, third.value, third.arm, writer.sense(third.arm), "N")
    heading = f"ΣM_{{{special.point.name}}}"
    for parts in writer.sought(
        heading, Sum(special.total, forces, couples), sought, solved.figure.mu
    ):
        yield Row(parts, third.value)


def _guided(writer: Writer, solved: Solved, heading: str, of: Sum) -> Iterator[Row]:
    """Yield the equation of the moments that a guide holds, and how far off its reaction acts."""
    held = _held(writer, solved, of.total)
    if held is None:
        yield Row(writer.summed(heading, of, solved.figure.mu), of.total)
        return
    pushes, place = held
    if pushes not in {reaction.value for reaction in solved.reactions}:
        yield _along(writer, pushes, solved.polygon)
    sought = Sought(place.name, place, pushes, -writer.sense(of.total), "mm")
    for parts in writer.sought(heading, of, sought, solved.figure.mu):
        yield Row(parts, place)


def _held(writer: Writer, solved: Solved, total: Mark) -> tuple[Mark, Mark] | None:
    """Return the force that a guide holds a moment with, and how far off it acts; None if there is none."""
    for reaction in solved.reactions:
        if reaction.place is not None and math.isfinite(writer.value(reaction.place[0])):
            couple, pushes, _ = writer.seen.by_mark[reaction.place[0]].uses
            if couple == total and writer.value(pushes):  # else 0/0
                return pushes, reaction.place[0]
    return None


def driver_rows(writer: Writer, made: Forces, driven: Driven) -> Iterator[Row]:
    """Yield the equation of moments of a driving link, what balances it, the frame's reaction."""
    alone, letter = driven.alone, driven.letter
    assert alone is not None
    if driven.couple is None and alone.arm is None:
        length, *_ = writer.seen.by_mark[driven.balance].uses
        yield _measured(writer, (letter, length, driven.balance), alone.polygon, signed=True)
    else:
        assert alone.total is not None
        of = Sum(alone.total, *_names(made, (driven.pair.link,)))
        sought = (
            Sought(letter, driven.balance, alone.arm, 1, "N")
            if driven.couple is None
            else Sought(letter, driven.balance, None, 1, "N·m")
        )
        for parts in writer.sought(f"ΣM_{{{alone.about.name}}}", of, sought, alone.figure.mu):
            yield Row(parts, driven.balance)
    yield _read(writer, alone.reaction, alone.polygon)


def lever_rows(writer: Writer, lever: Lever, tool: Tool | None) -> Iterator[Row]:
    """Yield the couples as they are converted, ΣM about the pole, and what balances a lever."""
    for force in lever.forces:
        step = writer.seen.by_mark.get(force.value)
        if step and step.op is tangential:  # of a pair that stands for a couple
            yield _formula(writer, force.value, "N")
    for one in lever.couples:
        yield _converted(writer, one)
    sought = Sought(lever.force.name, lever.force, lever.segment, 1, "N")
    if tool is not None:
        turns = writer.sense(tool.arm)
        sought = Sought(tool.force.letter, tool.force.value, tool.arm, turns, "N")
    names = {force.value: force.letter for force in lever.forces}
    heading = f"ΣM_{{{lever.pole.name}}}"
    for parts in writer.sought(heading, Sum(lever.total, names, {}), sought, None):
        yield Row(parts, sought.value)
    if tool is not None:
        yield _formula(writer, tool.advantage, "")
        yield _formula(writer, lever.force, "N")
    if lever.balance != lever.force:
        yield _formula(writer, lever.balance, "N·m", signed=True)


def _names(made: Forces, links: tuple[int, ...]) -> tuple[dict[Mark, str], dict[Mark, str]]:
    """Return what the forces and the couples on links are called, by their values."""
    forces = [f for link in links for f in made.acting.forces.get(link, [])]
    couples = [c for link in links for c in made.acting.couples.get(link, [])]
    return {f.value: f.letter for f in forces}, {c.value: c.letter for c in couples}


def _read(writer: Writer, reaction: Reaction, polygon: Polygon) -> Row:
    """A reaction as it was measured on its polygon."""
    return _measured(writer, (reaction.letter, reaction.length, reaction.value), polygon)


def _along(writer: Writer, force: Mark, polygon: Polygon) -> Row:
    """A component of a reaction as it was measured on its polygon."""
    (length, *_) = writer.seen.by_mark[force].uses
    return _measured(writer, (force.name, length, force), polygon)


def _measured(
    writer: Writer, of: tuple[str, Mark, Mark], polygon: Polygon, *, signed: bool = False
) -> Row:
    """A force by its mm; ``of``: its letter, its length on the polygon, its value; its size, or ``signed``."""
    letter_, length, value = of
    language, sign = writer.language, "−" if signed and writer.sense(value) < 0 else ""
    mm = f"{sign}{writer.length(length)} {unit('mm', language)}"
    mu = f"{number(writer.value(polygon.mu), language)} {unit('N/mm', language)}"
    told = f"{sign}{writer.figure(value)} {unit('N', language)}"
    return Row([f"{writer.letter(letter_)} = {mm}·{mu} = {told}"], value)


def _converted(writer: Writer, one: Converted) -> Row:
    row = _formula(writer, one.value, "N·mm")
    told = _COUNTER if writer.sense(one.value) > 0 else _CLOCKWISE
    first, last = row.parts
    return row._replace(parts=[first, f"{last}, {speaking(writer.language)(told)}"])


_CLOCKWISE, _COUNTER = said("clockwise"), said("counter-clockwise")
"""The sense of a couple on the lever."""


def _formula(writer: Writer, mark: Mark, of: str, *, signed: bool = False) -> Row:
    """A calculation of the log: its letters, its figures, its result; by sizes, or ``signed``."""
    step, figure = writer.seen.by_mark[mark], writer.signed if signed else writer.figure
    told = step.op.formula.format(**letters_of(step, lambda used: writer.letter(used.name)))
    put = step.op.formula.format(**letters_of(step, figure))
    told, put = (text if signed else text.removeprefix("−") for text in (told, put))
    value = f"{figure(mark)} {unit(of, writer.language)}"
    return Row([f"{writer.letter(mark.name)} = {told} = ", f"{put} = {value}"], mark)
