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

from graphic_tmm.board.execute import Reading
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
    extents = _extents(steps, values)
    for step in steps:
        point = step.op.leaves is Point and not step.op.across
        value = values[step.it.slot]
        yield step, _share(value, extents[step.it.view]) if point else np.zeros((1, 1))


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
    """Return for each plan how far its points reach at each position, at least half as far as in the row."""
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
    size = np.where(size == 0.0, np.abs(high), size)
    there = size[np.isfinite(size)]
    # a plan that shrinks to a point is judged by what it is along the row
    return np.fmax(size, np.median(there)) if there.size else size


def _share(point: Any, extent: Reals) -> Reals:
    off = np.abs(point - point[:1])[1:]
    lost = np.isnan(off).all(axis=0)
    worst = np.where(lost, np.inf, np.fmax.reduce(off, axis=0))
    return np.atleast_2d(np.where(worst == 0.0, 0.0, worst / extent))
