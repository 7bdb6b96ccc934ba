"""The log run again, each step shaken by some units in the last place, or by what a ruler leaves open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.blocks import part_of, spread
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.operations.instruments import bearing
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import (
    Angle,
    Arc,
    Curve,
    Length,
    Line,
    Point,
    Reals,
    Side,
    places,
    undefined,
)

SHAKE = 64 * EPS
"""More than a step's own rounding, so that a few shakes stand for the worst of it."""
SHAKES = 4
"""Each once to and once fro: where one leaves two figures apart, the other brings them together.

Two that cancel each other in one shake seldom do in all of them.
"""
BLOCK = 1024
"""Positions shaken at once."""
NOTHING = np.zeros((1, 1))


class Shaken(NamedTuple):
    """By slot: what a mark is unshaken, and how far shaking moves it, both (1, position).

    A point's place and a figure in their own units, a line's direction in radians, an arc's opening as a share.
    """

    values: dict[int, Any]
    bounds: dict[int, Reals]


def shaken(
    steps: Sequence[Step], given: Mapping[Mark, Any], positions: int, ruler: float | None = None
) -> Shaken:
    """Run steps at so many positions, from values (1, position) of what they begin with.

    ``ruler``: its division (mm); each reading is then moved by up to half of it, and nothing else.
    """
    across = any(step.op.across for step in steps)
    size = positions if across else BLOCK
    blocks, counts = [], []
    with np.errstate(all="ignore"):
        for start in range(0, positions, size):
            part = slice(start, min(start + size, positions))
            blocks.append(_block(steps, {m: part_of(v, part) for m, v in given.items()}, ruler))
            counts.append(part.stop - start)
    if len(blocks) == 1:
        return blocks[0]
    return Shaken(*(_joined(parts, counts) for parts in zip(*blocks, strict=True)))


def _block(steps: Sequence[Step], given: Mapping[Mark, Any], ruler: float | None) -> Shaken:
    """Run the steps, the values in the first trial unshaken."""
    shakes = iter(_shakes(len(steps) + len(given)))
    values = {mark.slot: value for mark, value in given.items()}
    still, bounds = dict(values), dict[int, Reals]()
    count = max(map(places, values.values()), default=1)
    rooted, parted = {step.it.view for step in steps if step.op.gaps}, dict[int, Any]()
    for mark in given:
        if mark.kind in (Point, Length, Angle) and ruler is None:
            values[mark.slot] = _moved(values[mark.slot], next(shakes))
    for step in steps:
        takes = [values[mark.slot] for mark in step.uses]
        if step.op.across:
            takes = [spread(value, count) for value in takes]
        value = step.op.run(*takes, **step.choice)
        slot = step.it.slot
        values[slot] = value = _with_error(step, value, next(shakes), ruler)
        apart = [parted[mark.slot] for mark in step.uses if mark.slot in parted]
        if step.op.gaps:
            apart.append(_gone(value).any(axis=0, keepdims=True))
        if apart and (there := np.logical_or.reduce(np.broadcast_arrays(*apart))).any():
            parted[slot] = there
        gone = None if step.it.view in rooted else parted.get(slot)
        still[slot], bounds[slot] = _first(value), _off(value, gone)
    return Shaken(still, bounds)


def _with_error(step: Step, value: Any, shakes: Reals, ruler: float | None) -> Any:
    if step.op.leaves is Side:
        return value
    if (
        step.op is bearing
    ):  # of a line to the left 180° and −180° are one: no trial jumps from one to the other
        value = value - 360.0 * np.round((value - value[:1]) / 360.0)
    if ruler is None:
        return _moved(value, shakes)
    return value + shakes[0] / SHAKE * (ruler / 2.0) if step.op.reads else value


def _joined(parts: Sequence[dict[int, Any]], counts: Sequence[int]) -> dict[int, Any]:
    """Join what was found by blocks of so many positions."""
    return {slot: _row([part[slot] for part in parts], counts) for slot in parts[0]}


def _row(parts: Sequence[Any], counts: Sequence[int]) -> Any:
    """Join a value; a bound may vary along some blocks alone, where what it was drawn from touches."""
    first = parts[0]
    if isinstance(first, tuple):
        return type(first)(*(_row(arrays, counts) for arrays in zip(*parts, strict=True)))
    if all(part.shape[1] == 1 for part in parts):
        return first
    return np.concatenate([spread(part, n) for part, n in zip(parts, counts, strict=True)], axis=1)


def _shakes(count: int) -> Reals:
    """Return shakes (value, part, trial, 1): none in the first trial, then half to whole ones to and fro."""
    random = np.random.default_rng(0)
    shape = (count, 3, SHAKES)
    sizes = random.uniform(0.5, 1.0, shape) * random.choice((-1.0, 1.0), shape)
    return SHAKE * np.concatenate((np.zeros((count, 3, 1)), sizes, -sizes), axis=2)[..., None]


def _moved(value: Any, shakes: Reals) -> Any:
    """Move the parts of a value."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, Line):
        at, along = value
        return Line(_moved(at, shakes), along * (1.0 + 1j * shakes[2]))
    if isinstance(value, Arc):
        return Arc(_moved(value.centre, shakes), value.radius * (1.0 + shakes[2]))
    if np.iscomplexobj(value):
        return value * (1.0 + shakes[0] + 1j * shakes[1])
    return value * (1.0 + shakes[0])


def _first(value: Any) -> Any:
    """Return a value of the unshaken trial, without holding the others."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*map(_first, value))
    return value[:1].copy()


def _gone(value: Any) -> Any:
    """Return where the shaken trials, each for itself, are not there though the first is."""
    return undefined(value) & ~undefined(_first(value))


def _off(value: Any, parted: Any = None) -> Reals:
    """Return how far the shaken trials are from the first, at most; without end where none of them is there.

    What is not there in the first cannot be off. ``parted``: where shaking parts figures of another plan that
    touch. That moves their point by its own root the other way; a direction that is taken from it may be any.
    """
    if isinstance(value, Curve):
        return NOTHING
    if isinstance(value, Line):
        value = value.along
    elif isinstance(value, Arc):
        value = value.radius / np.abs(value.radius[:1])
    off = np.abs(value - value[:1])[1:]
    if not off.size:
        return NOTHING
    gone = np.isnan(off)
    lost = gone.all(axis=0) if parted is None else gone.all(axis=0) | (gone.any(axis=0) & parted)
    off = np.where(lost, np.inf, np.fmax.reduce(off, axis=0))
    return np.atleast_2d(np.where(np.isfinite(value[0]), off, 0.0))
