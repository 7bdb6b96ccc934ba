"""A mutation made for good: the log and what is given as they are with it, to look for a second one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.mutations.mutation import Change, Mutation


def made(
    log: Construction, given: Mapping[Mark, object], mutation: Mutation, place: int | None = None
) -> tuple[Construction, Mapping[Mark, object]]:
    """Return a log and what is given with a mutation; ``place``: at one position only (its index)."""
    changes, count = mutation.changes, _positions(given)
    steps = tuple(
        _changed(step, changes[step.it.slot], place, count) if step.it.slot in changes else step
        for step in log.steps
    )
    taken: dict[Mark, object] = dict(given)
    for mark in log.given:
        way = mutation.amiss.get(mark.slot)
        if way is not None and mark in given:
            amiss = way.factor * as_value(given[way.source], way.source.kind) + way.plus
            taken[mark] = _only(place, amiss, as_value(given[mark], mark.kind), count)
    return log._replace(steps=steps), taken


def _positions(given: Mapping[Mark, object]) -> int:
    rows = [value for value in given.values() if isinstance(value, np.ndarray) and value.ndim > 1]
    return max((value.shape[1] for value in rows), default=1)


def _changed(step: Step, change: Change, place: int | None, positions: int) -> Step:
    run, count = _run(change), len(step.uses)
    if place is None or step.op.across:
        other = change.step
        return step._replace(op=other.op._replace(run=run), uses=other.uses, choice={})
    right = _run(Change(step))
    at = place

    def either(*values: Any) -> Any:
        due, found = right(*values[:count]), run(*values[count:])
        return _both(found, due, at, positions)

    # what it marks is then told by its place alone, not by the lines of either
    op = step.op._replace(run=either, name=f"{step.op.name} at one position")
    return step._replace(op=op, uses=(*step.uses, *change.step.uses), choice={})


def _run(change: Change) -> Callable[..., Any]:
    step = change.step

    def run(*values: Any) -> Any:
        if change.before >= 0:
            values = tuple(_rolled(v) if k == change.before else v for k, v in enumerate(values))
        value = step.op.run(*values, **step.choice)
        return value if change.factor == 1.0 else value * change.factor

    return run


def _rolled(value: Any) -> Any:
    if isinstance(value, tuple):
        return type(value)(*map(_rolled, value))
    return np.roll(value, 1, axis=1)


def _both(found: Any, due: Any, place: int, count: int) -> Any:
    if isinstance(due, tuple):
        return type(due)(*(_both(f, d, place, count) for f, d in zip(found, due, strict=True)))
    return _only(place, found, due, count)


def _only(place: int | None, found: Any, due: Any, count: int) -> Any:
    if place is None:
        return found
    shape = (max(found.shape[0], due.shape[0]), max(count, found.shape[1], due.shape[1]))
    at = np.arange(shape[1]) == place
    return np.where(at, np.broadcast_to(found, shape), np.broadcast_to(due, shape))
