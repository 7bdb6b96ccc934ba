"""Readings as marks of the log: which step each is of, what was read as arrays along the positions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.findings import step_number
from graphic_tmm.board.record import Mark, Step, segment_name
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.checking.cells import Cell, Key, pointed
from graphic_tmm.checking.judging.own_errors import Grain, alone
from graphic_tmm.checking.judging.reader import Reader
from graphic_tmm.checking.readings.units import half_of, taken_figure
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Readings


def steps_of(work: Drawn | None) -> dict[tuple[str, str], Step]:
    """Return the steps of a mechanism that can be read: its lengths, points and rates, by plan and name.

    A plan that no position asks for is recorded where forces need it, and drawn nowhere.
    """
    if work is None:
        return {}
    log = work.construction
    found: dict[tuple[str, str], Step] = {}
    plans = pointed()
    steps = {
        step.it: step for step in alone(log) if step.it in (work.of(step.it.view) or work.reading)
    }
    for mark, step in steps.items():
        if mark.view in plans and mark.kind is Length:
            found.setdefault((mark.view, segment_name(mark.letter)), step)
        if mark.view in plans and mark.kind is Point:
            found.setdefault(mark.key, step)
    for chapter in work.project.chapters:
        for key, mark in Readings.of(chapter).named_marks(work.project).items():
            if mark in steps and mark.kind is Number:
                found[key] = steps[mark]
    return found


def step_name(work: Drawn | None, step: Step | None) -> str:
    """Return a step as a report names it: its number in its plan, its letter; empty for none."""
    if step is None or work is None:
        return ""
    return f"{step_number(work.construction, step)} {step.it.name}"


def scale_of(work: Drawn, plan: str) -> float:
    """Return μ of a plan, SI per mm; NaN if it has none."""
    view = work.construction.view(plan)
    mark = None if view is None else view.scale
    for reading in (work.reading, work.of(plan)):
        if mark is not None and reading is not None and mark in reading:
            return float(reading[mark][0, 0])
    return float("nan")


def as_marks(
    work: Drawn,
    steps: Mapping[tuple[str, str], Step],
    readings: Iterable[Taken],
    cells: Mapping[Key, Cell],
    by: Reader,
) -> tuple[dict[Mark, Any], dict[Mark, Grain]]:
    """Return what was read of marks, and how far it may be off by its rounding alone; arrays (1, position).

    A length that was read in mm and as a quantity is taken in mm.
    """
    names = work.names
    found: dict[Mark, Any] = {}
    grain: dict[Mark, Grain] = {}
    for taken in sorted(readings, key=lambda one: one.mm is not None):
        step = steps.get((taken.plan, taken.segment))
        if step is None or taken.position not in names:
            continue
        read = mark_figure(work, step, taken, cells.get(taken.key), by)
        if read is None:
            continue
        empty = np.full((1, len(names)), np.nan, np.complex128 if taken.pointed else np.float64)
        place = names.index(taken.position)
        found.setdefault(step.it, empty)[0, place] = read[0]
        nothing = Grain(np.zeros((1, len(names))), np.zeros((1, len(names))))
        of = grain.setdefault(step.it, nothing)
        of.read[0, place], of.used[0, place] = read[1:]
    return found, grain


def mark_figure(
    work: Drawn, step: Step, taken: Taken, cell: Cell | None, by: Reader
) -> tuple[complex | float, float, float] | None:
    """Return a reading in the unit of its mark (mm; of a rate its own), and how far rounding may carry it.

    Once as it was read, once as others are calculated with it.
    """
    last = taken.last
    if step.it.kind is Point:
        return (taken.spot, by.lost(last), 0.0) if taken.pointed else None
    if (taken.value is None and taken.mm is None) or cell is None:
        return None
    figure, half = taken_figure(taken, cell), half_of(taken, cell)
    if step.it.kind is Number:
        return figure, half, half
    mu = 1.0 if taken.mm is not None else scale_of(work, taken.plan)
    # a length that is calculated and written as such was never rounded by a slip
    strict = not step.op.reads and by.calculated(figure / mu)
    read = half / mu + by.half if strict else by.unblurred(half / mu)
    return figure / mu, read, half / mu + by.half
