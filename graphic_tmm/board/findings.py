"""What could not be drawn, and what was drawn at the edge of its possibility: named after the fact.

A plan runs without a branch; a mark that cannot be drawn is NaN. Only then is the log run once more at the
positions concerned, to name the step that failed while everything it used was there.

Doubt is carried along the log: a mark bears the product of the conditions of the steps that led to it (of
several ways, the worst one), since each of them magnifies the errors it is handed. So where two loci meet at a
small angle 1/κ, directions taken from their point are off by κ·ε, velocities drawn along these by κ²·ε and
accelerations by κ³·ε, as shares of the longest vectors of their plans. A reading is off by the rounding of its
ends, which is little against its plan, but much against itself where it is short: whoever divides by it
inherits that. The step at which the product passes the limit is named; those behind it are not. A step across
the row begins anew: it makes one curve of many positions, and these have been told of already.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading, execute, needed
from graphic_tmm.board.geometry import TANGENT
from graphic_tmm.board.grammar import WHOLE_ROW, Gap
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Curve, Reals, undefined

DOUBTFUL = 1e8
"""Steps that magnify errors more than this together leave half of the digits of a float at the best."""


class Finding(NamedTuple):
    """``kind``: "undrawn", "touching" or "doubtful"; the step; the positions (indices); mm, or product of
    conditions.
    """

    kind: str
    step: Step
    number: int
    positions: tuple[int, ...]
    amount: float
    gap: Gap | None = None


def step_number(construction: Construction, step: Step) -> int:
    """Return the number of a step within its view, from 1."""
    same = [s for s in construction.steps if s.it.view == step.it.view]
    return same.index(step) + 1


def examine(
    construction: Construction,
    given: Mapping[Mark, object],
    wanted: Iterable[Mark],
    *,
    hand: Hand = EXACT,
    positions: Sequence[int] | None = None,
) -> tuple[Finding, ...]:
    """Return what happened on the way to the wanted marks, in the order of the log.

    ``positions``: the indices looked at; None for all. Findings name the indices of the whole axis.
    """
    steps = needed(construction, wanted)
    if not steps:
        return ()
    marks = {mark for step in steps for mark in (step.it, *step.uses)}
    reading = execute(construction, given, marks, hand=hand, positions=positions)
    found: list[Finding] = []
    carried: dict[Mark, Reals] = {}
    short: dict[Mark, Reals] = {}
    with np.errstate(all="ignore"):
        broken: set[str] = set()
        for step in steps:
            if step.op.across:
                found += _across(construction, step, reading, broken)
                continue
            values = [reading[mark] for mark in step.uses]
            before, own = _worst(carried, step), _own(short, step, values)
            if step.op.reads and own is not None:
                short[step.it], own = own, None
            told, left = _of_step(construction, step, values, reading[step.it], (before, own))
            found += told
            if left is not None:
                carried[step.it] = left
    if positions is None:
        return tuple(found)
    return tuple(f._replace(positions=tuple(positions[i] for i in f.positions)) for f in found)


def _across(
    construction: Construction, step: Step, reading: Reading, broken: set[str]
) -> list[Finding]:
    """Return that a step which needs its whole row lacks some of it; of a view the first such step only.

    A curve that is drawn where its points are needs no more than they: their absence is told already.
    """
    row, view = step.choice.get("row"), step.it.view
    whole = step.op.fails_en == WHOLE_ROW[0] and row is not None
    if row is None or not whole or view in broken or not undefined(reading[step.it]).any():
        return []
    missing = np.zeros(row, dtype=bool)
    for mark in step.uses:
        value = reading[mark]
        if not isinstance(value, Curve):
            there = np.broadcast_to(
                undefined(value), (undefined(value).shape[0], reading.positions)
            )
            missing |= there[:, :row].any(axis=0)
    if not missing.any():
        return []
    broken.add(view)
    places = tuple(int(i) for i in np.flatnonzero(missing))
    return [Finding("undrawn", step, step_number(construction, step), places, 0.0)]


def _worst(carried: Mapping[Mark, Reals], step: Step) -> Reals | None:
    """Return the largest product of conditions that comes into a step; None if no condition led there."""
    named = zip(step.op.arguments, step.uses, strict=True)
    marks = [mark for name, mark in named if name not in step.op.damps]
    parts = {id(part): part for mark in marks if (part := carried.get(mark)) is not None}
    return reduce(np.maximum, parts.values()) if parts else None


def _own(short: Mapping[Mark, Reals], step: Step, values: list[Any]) -> Reals | None:
    """Return how much a step itself magnifies, at least 1: its condition, and those of what it divides by."""
    named = zip(step.op.arguments, step.uses, strict=True)
    parts = [short[mark] for name, mark in named if name in step.op.divides and mark in short]
    if step.op.condition is not None:
        parts.append(np.fmax(step.op.condition(*values), 1.0))
    return reduce(np.multiply, parts) if parts else None


def _of_step(
    construction: Construction,
    step: Step,
    values: list[Any],
    result: Any,
    conditions: tuple[Reals | None, Reals | None],
) -> tuple[list[Finding], Reals | None]:
    """Return what happened in a step, and the product of conditions that its mark bears.

    ``conditions``: that product before the step, and the step's own condition; None for 1.
    """
    number = step_number(construction, step)
    there = [undefined(value) for value in values if not isinstance(value, Curve)]
    bad = undefined(result)
    fine = ~np.logical_or.reduce(np.broadcast_arrays(np.zeros(bad.shape, bool), *there))
    failed = fine & bad
    found = []
    if failed.any():
        gap, amount = _worst_gap(step, values, failed)
        found.append(Finding("undrawn", step, number, _where(failed), amount, gap))
    touched = np.zeros_like(fine)
    for gap in step.op.gaps:
        room = gap.measure(*values)
        touching = fine & ~failed & (np.abs(room) <= 4 * TANGENT * _size(values))
        touched = touched | (touching & gap.root)
        if touching.any():
            found.append(Finding("touching", step, number, _where(touching), 0.0, gap))
    came, own = conditions
    if own is None:
        return found, came
    before = np.ones((1, 1)) if came is None else came
    product = before * own
    doubtful = fine & ~failed & ~touched & (before <= DOUBTFUL) & (product > DOUBTFUL)
    if doubtful.any():
        worst = float(np.max(np.where(doubtful, product, 0.0)))
        found.append(Finding("doubtful", step, number, _where(doubtful), worst))
    # two roots that touch are off by a rounding's root at the most: only what magnifies that is in doubt
    return found, np.where(touched, np.minimum(product, DOUBTFUL), product)


def _worst_gap(step: Step, values: list[Any], failed: Any) -> tuple[Gap | None, float]:
    """Return the gap that is missed by the most among the failed positions, and by how many mm."""
    worst: tuple[Gap | None, float] = (None, 0.0)
    for gap in step.op.gaps:
        short = float(np.nanmax(np.where(failed, -gap.measure(*values), -np.inf)))
        if short > worst[1]:
            worst = (gap, short)
    return worst


def _size(values: list[Any]) -> Any:
    parts = [part for value in values for part in (value if isinstance(value, tuple) else (value,))]
    return sum(np.abs(part) for part in parts)


def _where(mask: Any) -> tuple[int, ...]:
    return tuple(int(i) for i in np.flatnonzero(mask.any(axis=0)))
