"""The hard places of a drive: where its range ends, where lines hardly cross, where a point stands still."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.accuracy.hard.span import Coordinates, Span
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Reals, undefined

SHARP = 0.1
"""A crossing that magnifies rounding more than 1/SHARP times costs a digit: it is a hard place."""
BLUNT = 0.5
"""On the row tried no crossing sharper than SHARP is blunter: at an end of the range it falls like a root."""
HALVED, NARROWED, PARTS, FINER = 60, 18, 33, 8.0
"""How often a bracket is halved; how often a minimum is narrowed, by how many places, how many times."""
STANDS = 1e-6
"""A point slower than this share of its largest speed stands still."""
SAME = 1e-4
"""Places nearer to each other than this share of the farthest off (10°: `Span.offs`) are one place."""
ROUND, ROUNDED = 4, 1e-10
"""Decimals of a round coordinate in it; a place nearer to that than this share is there."""
FLAT, TOUCHES = 1e-6, 1e-6
"""How well, as a share of it, a place is known where two figures touch: where the sine is less than this."""

Truths = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class AnyPlace:
    """A log that runs wherever its drive stands: what is the same everywhere, and what is not.

    ``known``: by degrees or m of the drive, (1, place); ``span``: what it is walked through, degrees or mm.
    """

    log: Construction
    still: Mapping[Mark, Any]
    known: Callable[[Reals], Mapping[Mark, Any]]
    span: Span

    def given(self, row: Coordinates) -> dict[Mark, Any]:
        """Return what the log begins with along a row of coordinates, (place,)."""
        with np.errstate(all="ignore"):
            return {**self.still, **self.known(self.span.in_si * row[None, :])}

    def read(self, row: Coordinates, marks: Sequence[Mark]) -> Reading:
        """Run what some marks need along a row of coordinates, (place,)."""
        return execute(self.log, self.given(row), marks)

    def rows(self, row: Coordinates, marks: Sequence[Mark]) -> list[NDArray[Any]]:
        """Return marks along a row of coordinates, each (place,)."""
        reading = self.read(row, marks)
        return [np.broadcast_to(reading[mark][0], row.shape) for mark in marks]

    def there(self, row: Coordinates, marks: Sequence[Mark]) -> Truths:
        """Return where all of some marks can be drawn, (place,)."""
        return np.asarray(np.isfinite(sum(self.rows(row, marks))))

    def same(self, one: float, other: float) -> bool:
        """Return whether two hard places are one."""
        return self.span.apart(one, other) <= SAME * self.span.offs[0]

    def rounded(self, place: float, near: float = ROUNDED) -> float:
        """Return a coordinate, over a turn from 0 to 360 degrees; a round one where it is so near."""
        grain = self.span.offs[0]
        rounded = round(place, ROUND - round(np.log10(grain)))
        return self.span.within(rounded if abs(rounded - place) <= near * grain else place)


Kind = Literal["end", "sharp", "still"]


class HardPlace(NamedTuple):
    """A hard place: ``at`` which coordinate, degrees or mm.

    ``kind``: "end" of the range that the drive can reach, "sharp" crossing, or points that stand "still".
    ``step``: what ends or crosses there, if that is known, and how many times it magnifies rounding;
    ``still``: the points that stand still.
    """

    at: float
    kind: Kind
    step: Step | None = None
    times: float = 0.0
    still: tuple[Mark, ...] = ()


def hard_places(
    of: AnyPlace, places: Sequence[Mark], velocities: Sequence[Mark]
) -> tuple[HardPlace, ...]:
    """Return the hard places of a drive, in order.

    ``places``: the points of the mechanism; ``velocities``: the images of those that move.
    """
    row = of.span.tried
    with np.errstate(all="ignore"):
        sharp = list(_sharp(of, row))
        ends = [_caused(of, one, sharp) for one in _ends(of, row, places)]
        still = _still(of, row, velocities)
    found: list[HardPlace] = []
    for one in (*ends, *sharp, *still):
        if not any(of.same(one.at, there.at) for there in found):
            found.append(one)
    return tuple(sorted(found))


def _caused(of: AnyPlace, end: HardPlace, sharp: Sequence[HardPlace]) -> HardPlace:
    """Return an end with the step that hardly crosses beside it."""
    near = [one for one in sharp if of.same(one.at, end.at)]
    return end._replace(step=near[0].step, times=near[0].times) if near else end


def _ends(of: AnyPlace, row: Coordinates, places: Sequence[Mark]) -> Iterator[HardPlace]:
    """Yield where everything is there for the last time, and for the first."""
    inside = of.there(row, places)
    at = np.flatnonzero(inside[1:] != inside[:-1])
    if at.size:
        low, high = _halved(row[at], row[at + 1], lambda now: of.there(now, places) == inside[at])
        for place in np.where(inside[at], low, high):
            yield HardPlace(of.rounded(float(place)), "end")


def _halved(
    low: Coordinates, high: Coordinates, same: Callable[[Coordinates], Truths]
) -> tuple[Coordinates, Coordinates]:
    """Halve brackets until nothing is between them; ``same``: where it is as at their low ends."""
    for _ in range(HALVED):
        middle = (low + high) / 2.0
        lower = same(middle)
        low, high = np.where(lower, middle, low), np.where(lower, high, middle)
    return low, high


def _sharp(of: AnyPlace, row: Coordinates) -> Iterator[HardPlace]:
    """Yield where the crossing of two loci is sharpest, of those that cost a digit; the worst first."""
    steps = [step for step in of.log.steps if step.op.condition is not None]
    if not steps:
        return
    row = row[:-1] if of.span.period else row
    rows = _sines(of, row, steps)
    before, after = np.roll(rows, 1, axis=1), np.roll(rows, -1, axis=1)
    if not of.span.period:
        before[:, 0] = after[:, -1] = 0.0
    lows = (rows <= before) & (rows < after) & (rows < BLUNT)
    which, at = np.nonzero(lows)
    if not at.size:
        return
    centre, reach = row[at], of.span.step
    every = np.arange(at.size)
    for _ in range(NARROWED):
        tried = centre[:, None] + reach * np.linspace(-1.0, 1.0, PARTS)[None, :]
        sines = _sines(of, tried.ravel(), steps).reshape(len(steps), *tried.shape)[which, every]
        best = np.argmin(sines, axis=1)
        centre, least, reach = tried[every, best], sines[every, best], reach / FINER
    order = sorted(zip(np.round(least, 9), which, centre, strict=True), key=lambda one: one[:2])
    for sine, k, place in order:
        if sine >= SHARP:
            return
        times = 1.0 / float(sine) if sine > 0.0 else np.inf
        near = FLAT if sine < TOUCHES else ROUNDED
        yield HardPlace(of.rounded(float(place), near), "sharp", steps[k], times)


def _sines(of: AnyPlace, row: Coordinates, steps: Sequence[Step]) -> Reals:
    """Return by how much steps lessen the digits of what they take, (step, place): 1 by nothing, 0 by all."""
    reading = of.read(row, [mark for step in steps for mark in (step.it, *step.uses)])
    found = np.full((len(steps), row.size), np.inf)
    for k, step in enumerate(steps):
        assert step.op.condition is not None
        sine = 1.0 / step.op.condition(*(reading[mark] for mark in step.uses))
        found[k] = np.where(undefined(reading[step.it]) | np.isnan(sine), np.inf, sine)[0]
    return found


def _still(of: AnyPlace, row: Coordinates, images: Sequence[Mark]) -> Iterator[HardPlace]:
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

    def same(row: Coordinates) -> Truths:
        now = np.stack(of.rows(row, images))[which, every]
        return np.asarray((np.conj(begun) * now).real > 0.0)

    low, _ = _halved(row[at], row[at + 1], same)
    left = np.abs(np.stack(of.rows(low, images))[which, every])
    # one that turns sharply and goes on does not stand still
    stands = left <= STANDS * np.fmax.reduce(sped, axis=1)[which]
    turned: dict[float, list[Mark]] = {}
    for k in np.flatnonzero(stands):
        place = of.rounded(float(low[k]))
        at_one = next((one for one in turned if of.same(one, place)), place)
        turned.setdefault(at_one, []).append(images[which[k]])
    for place, marks in turned.items():
        yield HardPlace(place, "still", still=tuple(marks))
