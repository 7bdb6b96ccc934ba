"""The step that leaves a figure of a table: of results, forces and diagrams, whose readings blame no step.

A table may call a figure otherwise than the log calls the mark. It is known again by its name and what it is
due, or, where nothing in its plan is called so, by what it is due and its unit alone.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Length, Number
from graphic_tmm.checking.cells import RESULTS, Cell
from graphic_tmm.checking.judging.own_errors import exact
from graphic_tmm.checking.lessons.steps import Steps, Told
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.units import unit_name
from graphic_tmm.readers.protocol import Protocols

SAME = 1e-9
"""Figures that differ by less than this share are one: what two ways of calculating leave is some 1e-12."""


def step_of_figure(steps: Steps, taken: Taken) -> Told | None:
    """Return the step that leaves the figure of a reading; None where none can be told for sure."""
    cell = steps.cells.get(taken.key)
    if cell is None or taken.pointed:
        return None
    there = [told for told in _of_plan(steps, taken.plan) if _same(told, cell, taken.position)]
    named = [told for told in there if taken.segment in _names(told.step.it)]
    if named:
        return named[0]
    whole = cell.value is None or float(cell.value).is_integer()
    # a whole number is many things: teeth, positions, wheels
    return there[0] if len(there) == 1 and not whole else None


def _of_plan(steps: Steps, plan: str) -> Iterator[Told]:
    """Yield the steps of the views of a plan; of results those of all views."""
    views: dict[str, set[str]] = {}
    for told in steps.in_turn:
        board = told.board
        if board.board not in views:
            views[board.board] = {plan, *_views(board, plan)}
        if plan == RESULTS or told.step.it.view in views[board.board]:
            yield told


def _views(board: Drawn, plan: str) -> Iterator[str]:
    for chapter in board.project.chapters:
        yield from Protocols.of(chapter).views(board.project).get(plan, ())


def _names(mark: Mark) -> tuple[str, ...]:
    """Return what a table may call a mark: R12, r_b1, rb1."""
    return (
        mark.name,
        mark.name.translate({ord(sign): None for sign in "{}"}),
        segment_name(mark.letter),
    )


def _same(told: Told, cell: Cell, position: str) -> bool:
    """Whether a step leaves just what a figure is due, in mm or as a quantity of its unit."""
    mark, names = told.step.it, told.board.names
    if mark.kind is Length:
        due = cell.mm
    elif mark.kind is Number and unit_name(mark.unit, told.board.scene.language) == cell.unit:
        due = cell.value
    else:
        return False
    row = np.ravel(exact(told.board, mark))
    place = names.index(position) if position in names else 0
    value = row[place] if row.size > place else row[0]
    if due is None or not due or not cmath.isfinite(value):
        return False
    return bool(abs(abs(value) - abs(due)) <= SAME * abs(due))
