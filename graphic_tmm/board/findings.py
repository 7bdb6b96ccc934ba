"""What could not be drawn, and what was drawn at the edge of its possibility: named after the fact.

A plan runs without a branch; a mark that cannot be drawn is NaN. Only then is the log run once more at the
positions concerned, to name the step that failed while everything it used was there.

A point is in doubt where rounding alone (see `doubt`) moves it by more than a millionth of its plan; the first
step of which that is true is named, those that use what it left are not. Where two roots touch, rounding moves
them by its own root, which is less: that is told as what it is, and what magnifies it further is in doubt.
Where it leaves no digit of a figure, that figure is left out; in every plan those that are left out are named.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.doubt import DOUBTFUL, Doubts
from graphic_tmm.board.execute import Reading, execute, needed
from graphic_tmm.board.geometry import TANGENT
from graphic_tmm.board.grammar import WHOLE_ROW, Gap
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.sizes import FIGURES
from graphic_tmm.board.values import Curve, Line, Reals, undefined


class Finding(NamedTuple):
    """``kind``: "undrawn", "touching", "doubtful", "lost" or "idle"; the step; the positions (indices).

    ``amount``: what is missing, mm; of a doubtful point how far rounding moves it, as a share of its plan.
    ``marks``: the figures of which no digit is sure; ``idle`` is a polygon of no forces.
    """

    kind: str
    step: Step
    number: int
    positions: tuple[int, ...]
    amount: float
    gap: Gap | None = None
    marks: tuple[Mark, ...] = ()


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
    doubts: Doubts | None = None,
    drawn: Reading | None = None,
) -> tuple[Finding, ...]:
    """Return what happened on the way to the wanted marks, in the order of the log; then what is left out.

    ``positions``: the indices looked at; None for all. Findings name the indices of the whole axis.
    ``doubts``: of the steps at these positions, if they are known; ``drawn``: the drawing by the hand, if it
    is made already.
    """
    steps = needed(construction, wanted)
    if not steps:
        return ()
    marks = {mark for step in steps for mark in (step.it, *step.uses)}
    reading = drawn or execute(construction, given, marks, hand=hand, positions=positions)
    if doubts is None:
        doubts = Doubts(
            steps, {mark: reading[mark] for mark in marks if mark in construction.given}
        )
    found: list[Finding] = []
    with np.errstate(all="ignore"):
        broken: set[str] = set()
        lost: dict[Mark, Any] = {}
        for step in steps:
            if step.op.across:
                found += _across(construction, step, reading, broken)
                continue
            told, lost[step.it] = _own_share(step, doubts.share(step.it), lost)
            values = [reading[mark] for mark in step.uses]
            result = reading[step.it]
            found += _of_step(construction, step, values, result, told)
    found += _left_out(construction, steps, reading, doubts)
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
    whole = step.op.fails == WHOLE_ROW and row is not None
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


def _left_out(
    construction: Construction, steps: Sequence[Step], reading: Reading, doubts: Doubts
) -> list[Finding]:
    """Return, plan by plan, the figures of which no digit is sure, together those that are so alike."""
    groups: dict[tuple[str, tuple[int, ...]], list[Step]] = {}
    for step in steps:
        if step.it.slot in doubts.lost and step.it.kind in FIGURES:
            there = ~undefined(reading[step.it]) & doubts.lost[step.it.slot]
            there = there & _matters(step, steps, doubts)
            if there.any():
                spread = np.broadcast_to(there, (there.shape[0], reading.positions))
                groups.setdefault((step.it.view, _where(spread)), []).append(step)
    return [
        Finding(
            "lost",
            first := some[0],
            step_number(construction, first),
            places,
            0.0,
            marks=tuple(step.it for step in some),
        )
        for (_, places), some in groups.items()
    ]


def _matters(step: Step, steps: Sequence[Step], doubts: Doubts) -> Any:
    """Return where it matters that a figure is lost, (1, position).

    It does not where a line has no direction, for it is that of nothing, and what is made of its arm is sure.
    """
    if all(use.kind is not Line for use in step.uses):
        return np.ones((1, 1), bool)
    none = np.zeros((1, 1), bool)
    after = [doubts.lost.get(s.it.slot, none) for s in steps if step.it in s.uses]
    return np.logical_or.reduce(np.broadcast_arrays(*after)) if after else ~none


def _own_share(step: Step, share: Reals, lost: Mapping[Mark, Any]) -> tuple[Reals, Any]:
    """Return the share by which a step is in doubt that used nothing in doubt, and where its mark is lost."""
    before = np.logical_or.reduce(
        np.broadcast_arrays(np.zeros((1, 1), bool), *(lost[m] for m in step.uses if m in lost))
    )
    return np.where(before, 0.0, share), before | (share > DOUBTFUL)


def _of_step(
    construction: Construction,
    step: Step,
    values: list[Any],
    result: Any,
    share: Reals,
) -> list[Finding]:
    there = [undefined(value) for value in values if not isinstance(value, Curve)]
    bad = undefined(result)
    fine = ~np.logical_or.reduce(np.broadcast_arrays(np.zeros_like(bad), *there))
    failed = fine & bad
    found = []
    if failed.any():
        gap, amount = _worst_gap(step, values, failed)
        found.append(Finding("undrawn", step, 0, _where(failed), amount, gap))
    touched = np.zeros_like(fine)
    for gap in step.op.gaps:
        room = gap.measure(*values)
        touching = fine & ~failed & (np.abs(room) <= 4 * TANGENT * _size(values))
        touched = touched | touching
        if touching.any():
            found.append(Finding("touching", step, 0, _where(touching), 0.0, gap))
    doubtful = fine & ~failed & ~touched & (share > DOUBTFUL)
    if doubtful.any():
        worst = float(np.max(np.where(doubtful, share, 0.0)))
        found.append(Finding("doubtful", step, 0, _where(doubtful), worst))
    # the number is counted for what is told only: a log has thousands of steps
    return [one._replace(number=step_number(construction, step)) for one in found]


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
