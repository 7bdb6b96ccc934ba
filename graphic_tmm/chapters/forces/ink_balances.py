"""The equations of moments beside a detached group, the driving link and the lever, read off the log."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.statics import reversed_, tangential
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.detached import Polygon, Reaction
from graphic_tmm.chapters.forces.driving import Driven
from graphic_tmm.chapters.forces.ink_equations import Row
from graphic_tmm.chapters.forces.ink_writer import Sought, Sum, Writer
from graphic_tmm.chapters.forces.lever import Converted, Lever
from graphic_tmm.chapters.forces.loads import Force
from graphic_tmm.chapters.forces.plan import Forces
from graphic_tmm.chapters.forces.statics import Solved
from graphic_tmm.chapters.forces.tool import Tool
from graphic_tmm.chapters.forces.unknowns import Hinged
from graphic_tmm.chapters.forces.wheels import SolvedWheel
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.readers.sentences import letters_of


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
    yield from _leg_rows(writer, made, solved)
    for reaction in solved.reactions:
        yield _read(writer, reaction, solved.polygon)
    if solved.special is not None:
        for one in solved.hinged:
            link = one.leg.link
            if link not in solved.tangents and (total := solved.turning[link]):
                yield from _guided(writer, solved, _heading(one), _sum(made, solved, total))
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


def _leg_rows(writer: Writer, made: Forces, solved: Solved) -> Iterator[Row]:
    """Yield the equations of moments of the legs of a group, then that about the special point of a plate."""
    for hinged in solved.hinged:
        leg = hinged.leg
        total = solved.turning[leg.link]
        if total is None:
            continue
        heading, of = _heading(hinged), _bearing(_sum(made, solved, total), hinged.forces)
        tangent = solved.tangents.get(leg.link)
        for force in hinged.forces:
            yield from _turned(writer, force)
        if tangent is not None:
            sought = Sought(tangent.letter, tangent.value, tangent.arm, -1, "N")
            for parts in writer.sought(heading, of, sought, solved.figure.mu):
                yield Row(parts, tangent.value)
        elif solved.special is None:
            yield from _guided(writer, solved, heading, of)
        else:
            yield from _by_couple(writer, solved, heading, of)
    yield from _third_rows(writer, made, solved)


def _heading(hinged: Hinged) -> str:
    """Return what a sum of moments of a leg is called: by its inner end, and its links."""
    links = ",".join(map(str, hinged.links))
    return f"ΣM_{{{hinged.pin.name}}}^{{({links})}}"


def _turned(writer: Writer, force: Force) -> Iterator[Row]:
    """Yield what a link does to a plate where that is the reverse of what was found before."""
    step = writer.seen.by_mark[force.value]
    if step.op is reversed_:
        found = f"−{writer.letter(step.uses[0].name)}"
        told = f"{writer.signed(force.value)} {unit('N', writer.language)}"
        yield Row([f"{writer.letter(force.letter)} = {found} = {told}"], force.value)


def _bearing(of: Sum, forces: Iterable[Force]) -> Sum:
    """Return a sum with forces in it that were found before, with their signs."""
    known = {one.value: one.letter for one in forces}
    return of._replace(forces={**of.forces, **known}, signed=known)


def _sum(made: Forces, solved: Solved, total: Mark) -> Sum:
    """Return a sum of moments in a group, with what is called how in it."""
    group = solved.closing.group
    return Sum(total, *_names(made, (*group.links, *group.rods)))


def _by_couple(writer: Writer, solved: Solved, heading: str, of: Sum) -> Iterator[Row]:
    """Yield what turns a slider about its pin, the couple by which its guide holds that; what a plate bears."""
    yield Row(writer.summed(heading, of, solved.figure.mu), of.total)
    told, total = heading, of.total
    backs = {step.uses[0]: step.it for step in writer.seen.by_mark.values() if step.op is reversed_}
    while (couple := backs.get(total)) is not None:
        size = f"{writer.figure(couple)} {unit('N·m', writer.language)}"
        yield Row([f"{writer.letter(couple.name)} = {told} = {size}"], couple)
        told, total = writer.letter(couple.name), couple


def _third_rows(writer: Writer, made: Forces, solved: Solved) -> Iterator[Row]:
    """Yield the equation of moments of a plate and its legs about its special point."""
    if (special := solved.special) is None or special.third is None:
        return
    of = _bearing(_sum(made, solved, special.third.total), special.forces)
    third = special.third.given
    sought = Sought(third.letter, third.value, third.arm, writer.sense(third.arm), "N")
    heading = f"ΣM_{{{special.point.name}}}"
    for parts in writer.sought(heading, of, sought, solved.figure.mu):
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
