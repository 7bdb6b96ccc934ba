"""How much rounding does to a drawing: the log is run again, each step shaken by some units in the last place.

Whatever a step makes is moved by a random `SHAKE` of itself, and what comes out is laid over the unshaken
drawing. So an error is magnified, passed on, compensated and lost as in the drawing itself, over any number of
steps and plans: where two loci meet at a small angle 1/κ, a direction taken from their point is off by κ, a
velocity along it by κ², an acceleration by κ³. No operation has to tell how it magnifies.

Points are judged, each against the extent of its plan; lines and quantities show in the points that they lead
to. A step across the row begins anew: it makes one curve of many positions, which have been judged already.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from graphic_tmm.board.execute import BLOCK, Reading
from graphic_tmm.board.geometry import EPS
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Angle, Arc, Curve, Length, Line, Point, Reals, Side

SHAKE = 64 * EPS
"""More than a step's own rounding, so that a few shakes stand for the worst of it."""
SHAKES = 4
"""Each once to and once fro: where one leaves two figures apart, the other brings them together.

Two that cancel each other in one shake seldom do in all of them.
"""


def shares(steps: Sequence[Step], reading: Reading) -> Iterator[tuple[Step, Reals]]:
    """Yield each step with how far shaking moves its point, as a share of the plan's extent.

    (1, position); infinite where every shake leaves nothing of it; 0 if the step leaves no point.
    """
    reading = reading.trial(0)
    values = {mark.slot: reading[mark] for step in steps for mark in (step.it, *step.uses)}
    starts = range(0, reading.positions, BLOCK)
    blocks = [_block(steps, values, slice(start, start + BLOCK)) for start in starts]
    extents = {view: _usual(_joined([found[view] for _, found in blocks])) for view in blocks[0][1]}
    for step in steps:
        off = [found[step.it.slot] for found, _ in blocks if step.it.slot in found]
        if not off:
            yield step, np.zeros((1, 1))
            continue
        moved, extent = _joined(off), extents[step.it.view]
        yield step, np.where(moved == 0.0, 0.0, moved / extent)


def _block(
    steps: Sequence[Step], whole: dict[int, Any], part: slice
) -> tuple[dict[int, Reals], dict[str, Reals]]:
    """Shake a block of positions; return how far points move, by slot, and how far plans reach, by view."""
    values = {slot: _cut(value, part) for slot, value in whole.items()}
    made = {step.it.slot for step in steps}
    given = {mark for step in steps for mark in step.uses if mark.slot not in made}
    shakes = iter(_shakes(len(steps) + len(given)))
    for mark in sorted(given, key=lambda mark: mark.slot):
        if mark.kind in (Point, Length, Angle):
            values[mark.slot] = _shaken(values[mark.slot], next(shakes))
    for step in steps:
        if not step.op.across:
            it = step.op.run(*[values[mark.slot] for mark in step.uses], **step.choice)
            values[step.it.slot] = it if step.op.leaves is Side else _shaken(it, next(shakes))
    points = [s.it.slot for s in steps if s.op.leaves is Point and not s.op.across]
    return {slot: _off(values[slot]) for slot in points}, _extents(steps, values)


def _cut(value: Any, part: slice) -> Any:
    if isinstance(value, Curve):
        return value
    if isinstance(value, tuple):
        return type(value)(*(_cut(array, part) for array in value))
    return value if value.shape[1] == 1 else value[:, part]


def _joined(parts: list[Reals]) -> Reals:
    """Join what was found by blocks; what does not vary along the first block varies nowhere."""
    return parts[0] if parts[0].shape[1] == 1 else np.concatenate(parts, axis=1)


def _shakes(count: int) -> Reals:
    """Return shakes (value, part, trial, 1): none in the first trial, then half to whole ones to and fro."""
    random = np.random.default_rng(0)
    shape = (count, 3, SHAKES)
    sizes = random.uniform(0.5, 1.0, shape) * random.choice((-1.0, 1.0), shape)
    return SHAKE * np.concatenate((np.zeros((count, 3, 1)), sizes, -sizes), axis=2)[..., None]


def _shaken(value: Any, shakes: Reals) -> Any:
    """Move the parts of a value."""
    if isinstance(value, Curve):
        return value
    if isinstance(value, Line):
        at, along = value
        return Line(_shaken(at, shakes), along * (1.0 + 1j * shakes[2]))
    if isinstance(value, Arc):
        return Arc(_shaken(value.centre, shakes), value.radius * (1.0 + shakes[2]))
    if np.iscomplexobj(value):
        return value * (1.0 + shakes[0] + 1j * shakes[1])
    return value * (1.0 + shakes[0])


def _extents(steps: Sequence[Step], values: dict[int, Any]) -> dict[str, Reals]:
    """Return for each plan how far its points reach at each position."""
    points: dict[str, dict[Mark, Any]] = {}
    for step in steps:
        for mark in (step.it, *step.uses):
            if mark.kind is Point:
                points.setdefault(mark.view, {})[mark] = values[mark.slot][:1]
    return {view: _extent(list(found.values())) for view, found in points.items()}


def _extent(points: list[Any]) -> Reals:
    low = high = points[0]
    for point in points[1:]:
        low = np.fmin(low.real, point.real) + 1j * np.fmin(low.imag, point.imag)
        high = np.fmax(high.real, point.real) + 1j * np.fmax(high.imag, point.imag)
    size: Reals = np.abs(high - low)
    return np.where(size == 0.0, np.abs(high), size)


def _usual(size: Reals) -> Reals:
    """Judge a plan that shrinks to a point by what it is along the row."""
    there = size[np.isfinite(size)]
    return np.fmax(size, np.median(there)) if there.size else size


def _off(point: Any) -> Reals:
    off = np.abs(point - point[:1])[1:]
    if not off.size:
        return np.zeros((1, 1))
    lost = np.isnan(off).all(axis=0)
    return np.atleast_2d(np.where(lost, np.inf, np.fmax.reduce(off, axis=0)))
