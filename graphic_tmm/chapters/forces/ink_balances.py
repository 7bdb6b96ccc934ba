"""The equations beside a detached group, the driving link and the lever, in lettering."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.balances import Sought, Sum, Writer
from graphic_tmm.chapters.forces.lever import Converted
from graphic_tmm.chapters.forces.plan import Forces
from graphic_tmm.chapters.forces.polygons import Polygon, Reaction
from graphic_tmm.chapters.forces.statics import Solved, summed_links
from graphic_tmm.language.numbers import number
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
        else:
            yield Row(writer.summed(heading, of, figure.mu), total)
    for reaction in solved.reactions:
        yield _read(writer, reaction, solved.polygon)
        if reaction.place is not None and math.isfinite(writer.value(reaction.place[0])):
            yield _formula(writer, reaction.place[0], "mm")


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
    language = writer.language
    mm = f"{writer.length(reaction.length)} {unit('mm', language)}"
    mu = f"{number(writer.value(polygon.mu), language)} {unit('N/mm', language)}"
    value = writer.with_unit(reaction.value, "N")
    name = writer.letter(reaction.letter)
    return Row([f"{name} = {mm}·{mu} = {value}"], reaction.value)


def _converted(writer: Writer, one: Converted) -> Row:
    return _formula(writer, one.value, "N·mm")


def _formula(writer: Writer, mark: Mark, of: str) -> Row:
    """A calculation of the log: by its letters, with its figures, its result."""
    step = writer.seen.by_mark[mark]

    def put(used: Mark) -> str:
        text = number(writer.value(used), writer.language)
        return f"({text})" if text.startswith("−") else text

    told = step.op.formula.format(**letters_of(step, lambda used: writer.letter(used.name)))
    figures = step.op.formula.format(**letters_of(step, put))
    value = f"{number(writer.value(mark), writer.language)} {unit(of, writer.language)}"
    return Row([f"{writer.letter(mark.name)} = {told} = ", f"{figures} = {value}"], mark)


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
