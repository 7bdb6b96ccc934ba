"""The columns of forces: loads, reactions, what balances the crank; what protocols tell of polygons."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.forces.detached import Reaction, Side
from graphic_tmm.chapters.forces.friction import pin_sentences
from graphic_tmm.chapters.forces.levers import Balanced
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.forces.task import FORCES
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols

PLAN = FORCES

TOOL, ADVANTAGE = "P_tool", "advantage"
"""The columns of a force that is sought at a tool: it, and how many times the force at the drive it is."""
DIFFERENCE = "bal_difference"
"""What tables call the difference of both methods, %."""


class Names(NamedTuple):
    """What the columns of a drive are called: what balances it by groups, by its lever, their difference."""

    forces: str
    lever: str
    difference: str


def names_of(made: Forces, one: Balanced) -> Names:
    """Return what the columns of a drive are called; those of further drives bear the number of its link."""
    stem = f"{'P' if one.driven.couple is None else 'M'}_bal"
    if one is not made.first:
        stem = f"{stem}_{one.driven.pair.link}"
        return Names(stem, f"{stem}_lever", f"{stem}_difference")
    forces = f"{stem}_left" if made.tool is not None else f"{stem}_forces"
    return Names(forces, f"{stem}_lever", f"{stem}_difference")


class _Row(NamedTuple):
    """A row to be written: its segment and letter, its unit, the marks of its value, its mm, their scale.

    ``size``: its sign tells only which way its line was drawn.
    """

    segment: str
    letter: str
    unit: str
    value: Mark
    mm: Mark | None = None
    scale: Mark | None = None
    size: bool = False


def force_columns(drawn: Drawn, everywhere: bool = False) -> tuple[Column, ...]:
    """Return the columns of forces at the positions whose forces are asked for, or ``everywhere``."""
    made, count, reading = FORCES_PLAN.on(drawn), len(drawn.names), drawn.reading
    there = drawn.all if everywhere else made.places
    rows = [*_loads(made), *_reactions(made), *_balance(made)]
    found = []
    for row in rows:
        value = _at(reading.figure(row.value, row.scale), there)
        mm = empty(count)
        if row.mm is not None:
            mm = row_of(_at(reading.figure(row.mm), there), there, count)
        if row.unit == "%":
            value = np.round(value, drawn.percent_decimals) + 0.0
        told = row_of(np.abs(value) if row.size else value, there, count)
        found.append(Column(PLAN, row.segment, row.letter, row.unit, mm, told))
    # passes that do not settle leave no force known; without friction each force stands by itself
    if made.first.open is None:
        return tuple(found)
    balances = [one.balance for one in made.balanced]
    unknown = [
        np.isnan(c.value) for c, row in zip(found, rows, strict=True) if row.value in balances
    ]
    return tuple(column.blank(np.any(unknown, axis=0)) for column in found)


def _at(values: Reals, places: tuple[int, ...]) -> Reals:
    """Return a mark's values at the positions asked for."""
    return values[:, list(places)] if values.shape[1] > 1 else values


def _loads(made: Forces) -> list[_Row]:
    forces = {force.value: force.letter for force in (*made.loads.on_lever, *made.loads.forces)}
    found = [_Row(segment_name(k), k, "N", value, size=True) for value, k in forces.items()]
    couples = [(segment_name(one.letter), one) for one in made.loads.couples_on_lever]
    return found + [_Row(name, one.letter, "N·m", one.value) for name, one in couples]


def _reactions(made: Forces) -> list[_Row]:
    found = []
    for reaction in made.reactions:
        segment = segment_name(reaction.letter)
        found.append(_Row(segment, reaction.letter, "N", reaction.value, reaction.length))
        found += _place(reaction)
    return found


def _place(reaction: Reaction) -> list[_Row]:
    if reaction.place is None:
        return []
    name = segment_name(reaction.letter)[1:]
    return [_Row(f"h{name}", f"h_{{{name}}}", "m", reaction.place[0], *reaction.place)]


def balance_segments(made: Forces) -> dict[str, Mark]:
    """Return what balances the drives, by the name of its column: by groups, by the lever.

    Where a force at a tool is sought: that force, and what the groups leave at the drive.
    """
    if made.tool is not None:
        forces, *_ = names_of(made, made.first)
        return {TOOL: made.tool.force.value, forces: made.first.balance}
    found = dict[str, Mark]()
    for one in made.balanced:
        forces, lever, _ = names_of(made, one)
        found |= {forces: one.balance, lever: one.lever.balance}
    return found


def _balance(made: Forces) -> list[_Row]:
    rows = list[_Row]()
    if made.tool is not None:
        rows.append(_Row(TOOL, made.tool.force.letter, "N", made.tool.force.value))
        rows.append(_Row(ADVANTAGE, made.tool.advantage.name, "", made.tool.advantage))
    several = len(made.balanced) > 1
    for one in made.balanced:
        unit = "N" if one.driven.couple is None else "N·m"
        forces, lever, difference = names_of(made, one)
        letters = Names(forces, lever, DIFFERENCE)
        if several:
            link = one.driven.pair.link
            letters = Names(one.driven.letter, one.lever.balance.name, f"Δ_{link}")
        rows.append(_Row(forces, letters.forces, unit, one.balance))
        if made.tool is None:
            rows.append(_Row(lever, letters.lever, unit, one.lever.balance))
        rows.append(_Row(difference, letters.difference, "%", one.difference))
        if one.open is not None:
            name = f"{difference.removesuffix('difference')}open"
            rows.append(_Row(name, one.open.name if several else "bal_open", unit, one.open))
    if made.efficiency is not None:
        rows.append(_Row("efficiency", "η", "%", made.efficiency))
    return rows


TABLE = Tabled(columns=force_columns)


def _views(project: Project) -> Mapping[str, list[str]]:
    """Return the views that forces are drawn in, in the order of the log."""
    return {FORCES: list(FORCES_PLAN.on(project).views)}


def polygon_equation(drawn: Drawn, view: str, language: str) -> list[str]:
    """Return the vector equation of a polygon, in plain text; before it, in the first view, the shared pins."""
    equations = list[str]()
    for polygon in (one for one in FORCES_PLAN.on(drawn).polygons if one.view == view):
        equations.append(f"{_sum_of(polygon.sides, language)} = 0")
        if polygon.parted is not None:
            both = (_sum_of(one, language) for one in polygon.parted[:2])
            equations.append(" = ".join(both))
    first = view == FORCES_PLAN.on(drawn).polygons[0].view
    return [*(map(plain, pin_sentences(drawn, language)) if first else ()), *equations]


def _sum_of(sides: Iterable[Side], language: str) -> str:
    return " + ".join(plain(symbol(letter, language)) for letter, _, _ in sides)


PROTOCOL = Protocols(views=_views, equations=polygon_equation)
