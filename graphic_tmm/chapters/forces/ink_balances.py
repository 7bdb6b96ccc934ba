"""The equations beside a detached group, the driving link and the lever, in lettering."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.statics import tangential
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.balances import Sought, Sum, Writer
from graphic_tmm.chapters.forces.lever import Converted
from graphic_tmm.chapters.forces.plan import Forces
from graphic_tmm.chapters.forces.polygons import Polygon, Reaction
from graphic_tmm.chapters.forces.statics import Solved, summed_links
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Label
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.lettering.letters import (
    letter,
)
from graphic_tmm.readers.sentences import letters_of

WIDE = 34.0
"""How wide a block of equations may be, in heights of its letters; a longer line is broken at its terms."""
LEAD = 0.7
"""Clear height between two lines, in heights of their letters."""
INDENT = 2.0
"""How far the rest of a broken line stands in, in heights of its letters."""


class Row(NamedTuple):
    """A line of lettering: the parts between which it may break, the mark that it finds."""

    parts: Sequence[str]
    of: Mark


def group_rows(writer: Writer, made: Forces, solved: Solved) -> Iterator[Row]:
    """Yield the equations of moments of a group, what they give, and the reactions of its polygon."""
    closing, figure = solved.closing, solved.figure
    names = _names(made, closing.group.links)
    for leg in closing.legs:
        total = solved.turning[leg.link]
        if total is None:
            continue
        links = ",".join(map(str, summed_links(closing, leg)))
        heading, of = f"ΣM_{{{closing.point.name}}}^{{({links})}}", Sum(total, *names)
        tangent = solved.tangents.get(leg.link)
        if tangent is not None:
            sought = Sought(tangent.letter, tangent.value, tangent.arm, -1, "N")
            for parts in writer.sought(heading, of, sought, figure.mu):
                yield Row(parts, tangent.value)
            continue
        yield from _guided(writer, solved, heading, of)
    for reaction in solved.reactions:
        yield _read(writer, reaction, solved.polygon)
    for force in made.lever.forces:  # friction along guides, read off the polygon
        step = writer.seen.by_mark.get(force.value)
        if step and step.op is in_si and step.uses[0].view == solved.polygon.view:
            yield _along(writer, force.value, solved.polygon)


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
            if couple == total:
                return pushes, reaction.place[0]
    return None


def driver_rows(writer: Writer, made: Forces, pivot: Mark, link: int) -> Iterator[Row]:
    """Yield the equation of moments of the driving link, what balances it, the frame's reaction."""
    driven = made.driven
    of = Sum(driven.total, *_names(made, (link,)))
    if driven.force is not None:
        sought = Sought("P_b", driven.balance, driven.arm, 1, "N")
    else:
        sought = Sought("M_b", driven.balance, None, 1, "N·m")
    for parts in writer.sought(f"ΣM_{{{pivot.name}}}", of, sought, driven.figure.mu):
        yield Row(parts, driven.balance)
    yield _read(writer, driven.reaction, driven.polygon)


def lever_rows(writer: Writer, made: Forces) -> Iterator[Row]:
    """Yield the couples as they are converted, ΣM about the pole, and what balances the lever."""
    lever = made.lever
    for force in lever.forces:
        step = writer.seen.by_mark.get(force.value)
        if step and step.op is tangential:  # of a pair that stands for a couple
            yield _formula(writer, force.value, "N")
    for one in lever.couples:
        yield _converted(writer, one)
    sought = Sought("P_{bl}", lever.force, lever.segment, 1, "N")
    names = {force.value: force.letter for force in lever.forces}
    heading = f"ΣM_{{{lever.pole.name}}}"
    for parts in writer.sought(heading, Sum(lever.total, names, {}), sought, None):
        yield Row(parts, lever.force)
    if lever.balance != lever.force:
        yield _formula(writer, lever.balance, "N·m")


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


def _measured(writer: Writer, of: tuple[str, Mark, Mark], polygon: Polygon) -> Row:
    """A force by its mm; ``of``: its letter, its length on the polygon, its value."""
    letter_, length, value = of
    language = writer.language
    mm = f"{writer.length(length)} {unit('mm', language)}"
    mu = f"{number(writer.value(polygon.mu), language)} {unit('N/mm', language)}"
    told = writer.with_unit(value, "N")
    return Row([f"{writer.letter(letter_)} = {mm}·{mu} = {told}"], value)


def _converted(writer: Writer, one: Converted) -> Row:
    row = _formula(writer, one.value, "N·mm")
    told = _COUNTER if writer.sense(one.value) > 0 else _CLOCKWISE
    first, last = row.parts
    return row._replace(parts=[first, f"{last}, {speaking(writer.language)(told)}"])


_CLOCKWISE, _COUNTER = said("clockwise"), said("counter-clockwise")
"""The sense of a couple on the lever."""


def _formula(writer: Writer, mark: Mark, of: str) -> Row:
    """A calculation of the log by sizes: its letters, its figures, its result."""
    step = writer.seen.by_mark[mark]
    names = letters_of(step, lambda used: writer.letter(used.name))
    told = step.op.formula.format(**names).removeprefix("−")
    put = step.op.formula.format(**letters_of(step, writer.figure)).removeprefix("−")
    return Row(
        [f"{writer.letter(mark.name)} = {told} = ", f"{put} = {writer.with_unit(mark, of)}"], mark
    )


def draw_balances(name: str, title: str, rows: Iterable[Row], index: int, high: Heights) -> Drawing:
    """Return equations under their title, each broken where it is too wide."""
    labels, base = list[Label](), 0.0
    size, wide = high.point, WIDE * high.point
    lines: list[tuple[str, float, float, tuple[int, ...]]] = [(title, high.title, 0.0, ())]
    for row in rows:
        for k, text in enumerate(_broken(row.parts, size, wide)):
            lines.append((text, size, INDENT * size if k else 0.0, (row.of.slot,)))
    for text, height, x, of in lines:
        made = letter(text, size=height)
        base -= made.ascent + (LEAD * height if labels else 0.0)
        position = index if of else None
        labels.append(Label(text, complex(x, base), height, of=of, position=position))
        base -= made.descent
    return Drawing(name, title, labels=tuple(labels))


def _broken(parts: Sequence[str], size: float, wide: float) -> list[str]:
    lines: list[str] = []
    for part in parts:
        longer = f"{lines[-1]} {part.strip()}" if lines else part.strip()
        if lines and letter(longer, size=size).width > wide - (len(lines) > 1) * INDENT * size:
            lines.append(part.strip())
        elif lines:
            lines[-1] = longer
        else:
            lines = [longer]
    return lines
