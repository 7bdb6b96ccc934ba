"""The hard places of a turn: where its range ends, where lines hardly cross, where a point stands still."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Reals, undefined

ROW = 1440
"""Crank angles tried over a turn: every quarter of a degree."""
SHIFT = 0.0617
"""Degrees by which they lie beside round angles, at which mechanisms often stand still."""
SHARP = 0.1
"""A crossing that magnifies rounding more than 1/SHARP times costs a digit: it is a hard place."""
HALVED, NARROWED, PARTS, FINER = 60, 18, 33, 8.0
"""How often a bracket is halved; how often a minimum is narrowed, by how many angles, how many times."""
STANDS = 1e-6
"""A point slower than this share of its largest speed stands still."""
SAME = 1e-3
"""Degrees: places nearer to each other than this are one place."""
ROUND, ROUNDED = 3, 1e-9
"""Decimals of a round angle; a place nearer to it than this, degrees, is there."""
FLAT, TOUCHES = 1e-5, 1e-6
"""How well an angle is known, degrees, where two figures touch: where the sine is less than this."""

Truths = NDArray[np.bool_]
Angles = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class AnyAngle:
    """A log that runs at any angles of the crank: what is the same at all of them, and what is not."""

    log: Construction
    still: Mapping[Mark, Any]
    known: Callable[[Reals], Mapping[Mark, Any]]

    def given(self, angles: Angles) -> dict[Mark, Any]:
        """Return what the log begins with at angles, degrees, (angle,)."""
        with np.errstate(all="ignore"):
            return {**self.still, **self.known(angles[None, :])}

    def read(self, angles: Angles, marks: Sequence[Mark]) -> Reading:
        """Run what some marks need at angles, degrees, (angle,)."""
        return execute(self.log, self.given(angles), marks)

    def row(self, angles: Angles, mark: Mark) -> NDArray[Any]:
        """Return a mark along the angles, (angle,)."""
        return self.rows(angles, [mark])[0]

    def rows(self, angles: Angles, marks: Sequence[Mark]) -> list[NDArray[Any]]:
        """Return marks along the angles, each (angle,)."""
        reading = self.read(angles, marks)
        return [np.broadcast_to(reading[mark][0], angles.shape) for mark in marks]


Kind = Literal["end", "sharp", "still"]


class HardPlace(NamedTuple):
    """A hard place: the angle of the crank, degrees.

    ``kind``: "end" of the range that the crank can reach, "sharp" crossing, or points that stand "still".
    ``step``: what ends or crosses there, if that is known, and how many times it magnifies rounding;
    ``still``: the points that stand still.
    """

    angle: float
    kind: Kind
    step: Step | None = None
    times: float = 0.0
    still: tuple[Mark, ...] = ()


def hard_places(
    of: AnyAngle, places: Sequence[Mark], velocities: Sequence[Mark]
) -> tuple[HardPlace, ...]:
    """Return the hard places of a turn, by angle.

    ``places``: the points of the mechanism; ``velocities``: the images of those that move.
    """
    row: Angles = SHIFT + np.arange(ROW + 1, dtype=np.float64) * (360.0 / ROW)
    with np.errstate(all="ignore"):
        sharp = list(_sharp(of, row))
        ends = [_caused(one, sharp) for one in _ends(of, row, places)]
        still = _still(of, row, velocities)
    found: list[HardPlace] = []
    for one in (*ends, *sharp, *still):
        if all(degrees_apart(one.angle, there.angle) > SAME for there in found):
            found.append(one)
    return tuple(sorted(found))


def degrees_apart(first: float, second: float) -> float:
    """Return how far two angles of the crank are apart, degrees."""
    return abs((first - second + 180.0) % 360.0 - 180.0)


def _caused(end: HardPlace, sharp: Sequence[HardPlace]) -> HardPlace:
    """Return an end with the step that hardly crosses beside it."""
    near = [one for one in sharp if degrees_apart(one.angle, end.angle) <= SAME]
    return end._replace(step=near[0].step, times=near[0].times) if near else end


def _ends(of: AnyAngle, row: Angles, places: Sequence[Mark]) -> Iterator[HardPlace]:
    """Yield the angles at which everything is there for the last time, and for the first."""

    def there(angles: Angles) -> Truths:
        return np.asarray(np.isfinite(sum(of.rows(angles, places))))

    inside = there(row)
    at = np.flatnonzero(inside[1:] != inside[:-1])
    if at.size:
        low, high = _halved(row[at], row[at + 1], lambda angles: there(angles) == inside[at])
        for angle in np.where(inside[at], low, high):
            yield HardPlace(_within(float(angle)), "end")


def _halved(low: Angles, high: Angles, same: Callable[[Angles], Truths]) -> tuple[Angles, Angles]:
    """Halve brackets until nothing is between them; ``same``: where it is as at their low ends."""
    for _ in range(HALVED):
        middle = (low + high) / 2.0
        lower = same(middle)
        low, high = np.where(lower, middle, low), np.where(lower, high, middle)
    return low, high


def _sharp(of: AnyAngle, row: Angles) -> Iterator[HardPlace]:
    """Yield where the crossing of two loci is sharpest, of those that cost a digit; the worst first."""
    steps = [step for step in of.log.steps if step.op.condition is not None]
    if not steps:
        return
    rows = _sines(of, row[:-1], steps)
    lows = (rows <= np.roll(rows, 1, axis=1)) & (rows < np.roll(rows, -1, axis=1)) & (rows < SHARP)
    which, at = np.nonzero(lows)
    if not at.size:
        return
    centre, reach = row[at], 360.0 / ROW
    every = np.arange(at.size)
    for _ in range(NARROWED):
        tried = centre[:, None] + reach * np.linspace(-1.0, 1.0, PARTS)[None, :]
        sines = _sines(of, tried.ravel(), steps).reshape(len(steps), *tried.shape)[which, every]
        best = np.argmin(sines, axis=1)
        centre, least, reach = tried[every, best], sines[every, best], reach / FINER
    order = sorted(zip(np.round(least, 9), which, centre, strict=True), key=lambda one: one[:2])
    for sine, k, angle in order:
        times = 1.0 / float(sine) if sine > 0.0 else np.inf
        near = FLAT if sine < TOUCHES else ROUNDED
        yield HardPlace(_within(float(angle), near), "sharp", steps[k], times)


def _sines(of: AnyAngle, angles: Angles, steps: Sequence[Step]) -> Reals:
    """Return by how much steps lessen the digits of what they take, (step, angle): 1 by nothing, 0 by all."""
    reading = of.read(angles, [mark for step in steps for mark in (step.it, *step.uses)])
    found = np.full((len(steps), angles.size), np.inf)
    for k, step in enumerate(steps):
        assert step.op.condition is not None
        sine = 1.0 / step.op.condition(*(reading[mark] for mark in step.uses))
        found[k] = np.where(undefined(reading[step.it]) | np.isnan(sine), np.inf, sine)[0]
    return found


def _still(of: AnyAngle, row: Angles, images: Sequence[Mark]) -> Iterator[HardPlace]:
    """Yield where points stand still and turn back: their velocities point the other way behind it."""
    if not images:
        return
    values = np.stack(of.rows(row, images))
    sped = np.abs(values)
    moves = sped > STANDS * np.fmax.reduce(sped, axis=1, keepdims=True)
    back = (np.conj(values[:, :-1]) * values[:, 1:]).real < 0.0
    back &= moves[:, :-1] & moves[:, 1:]
    which, at = np.nonzero(back)
    if not at.size:
        return
    begun, every = values[which, at], np.arange(at.size)

    def same(angles: Angles) -> Truths:
        now = np.stack(of.rows(angles, images))[which, every]
        return np.asarray((np.conj(begun) * now).real > 0.0)

    low, _ = _halved(row[at], row[at + 1], same)
    left = np.abs(np.stack(of.rows(low, images))[which, every])
    # one that turns sharply and goes on does not stand still
    stands = left <= STANDS * np.fmax.reduce(sped, axis=1)[which]
    turned: dict[float, list[Mark]] = {}
    for k in np.flatnonzero(stands):
        angle = _within(float(low[k]))
        same_place = next((one for one in turned if degrees_apart(one, angle) <= SAME), angle)
        turned.setdefault(same_place, []).append(images[which[k]])
    for angle, marks in turned.items():
        yield HardPlace(angle, "still", still=tuple(marks))


def _within(angle: float, near: float = ROUNDED) -> float:
    """Return an angle from 0 to 360 degrees, a round one where it is so near."""
    rounded = round(angle, ROUND)
    return (rounded if abs(rounded - angle) <= near else angle) % 360.0
