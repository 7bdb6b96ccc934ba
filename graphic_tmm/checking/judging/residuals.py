"""Readings judged by what all others of their position tell of them; a drawing judged as a whole."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.values import Reals
from graphic_tmm.checking.judging.counted import CountedReading, counted_readings
from graphic_tmm.checking.judging.covariance import Covariance, Usual, tail, without, worse_than
from graphic_tmm.checking.judging.scatter import LEAST, Limits
from graphic_tmm.checking.judging.taken_marks import step_name
from graphic_tmm.checking.judging.yardstick import Yardstick
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Judged, Whole
from graphic_tmm.drawn import DrawnScene

RARE = 0.001
"""As a whole a drawing is told to be off where so few of the hand's drawings are."""


class _Set(NamedTuple):
    """Readings of a position judged together: their numbers, how they go together, whether they are points."""

    numbers: list[int]
    together: Covariance
    pointed: bool


def sharpened(
    made: DrawnScene, judged: Sequence[Judged], by: Yardstick
) -> tuple[tuple[Judged, ...], Whole | None]:
    """Return readings with those wrong that are so given the others, each with its doubt, and the whole.

    A reading is never wrong that is fine by itself. The largest residual is the wrong reading's own, so that
    it is taken out and the rest judged again; what is wrong by itself tells nothing of others. The whole is
    told of the readings that are not wrong, if it is rare.
    """
    rows = counted_readings(made, judged, by)
    sets = [one for one in sets_of(rows, by) if not one.pointed]
    if not sets:
        return tuple(judged), _whole(rows, by)
    usual = by.covariances.usual([one.together for one in sets])
    limit = usual.limit * by.limits.wrong / Limits().wrong
    worse = _worse(rows, sets, usual)
    found = {id(one): one for one in judged}
    for some in sets:
        for k, residual, size in _eliminated(rows, some, limit * worse):
            was = rows[k].judged
            doubt = min(max((residual / size / worse - LEAST) / (limit - LEAST), 0.0), 1.0)
            new = was._replace(doubt=doubt if was.verdict == DOUBTFUL else was.doubt)
            if residual > limit * worse * size and was.verdict == DOUBTFUL:
                step = was.step or step_name(made.mechanism, rows[k].step)
                new = new._replace(verdict=WRONG, quantile=0.0, step=step, doubt=1.0)
            found[id(was)] = new
    told = tuple(found[id(one)] for one in judged)
    return told, _whole([r._replace(judged=found[id(r.judged)]) for r in rows], by)


def sets_of(rows: Sequence[CountedReading], by: Yardstick) -> Iterator[_Set]:
    """Yield the readings that are judged together: of a position the lengths of its plans, its points.

    Figures of tables and diagrams are left out: the hand's own drawings have them without a slip of reading.
    """
    together: dict[tuple[str, bool], list[int]] = defaultdict(list)
    for k, one in enumerate(rows):
        if one.step is not None:
            together[one.judged.taken.position, one.judged.taken.pointed].append(k)
    for (_, pointed), numbers in together.items():
        covariance = by.covariances.of([rows[k].hand for k in numbers])
        if covariance is not None:
            yield _Set(numbers, covariance, pointed)


def _times(rows: Sequence[CountedReading], some: _Set) -> Reals:
    return np.array([rows[k].times for k in some.numbers])


def _residuals(rows: Sequence[CountedReading], some: _Set) -> Reals:
    times, precision = _times(rows, some), some.together.precision
    return np.asarray(np.abs(precision @ times) / np.sqrt(np.diag(precision)))


def _worse(rows: Sequence[CountedReading], sets: Sequence[_Set], usual: Usual) -> float:
    """Return how many times farther off than usual a drawing is, by the median of its residuals."""
    some = np.concatenate([_residuals(rows, one) / one.together.sizes for one in sets])
    return worse_than(usual.median, float(np.median(some)), some.size)


def _eliminated(
    rows: Sequence[CountedReading], some: _Set, limit: float
) -> Iterator[tuple[int, float, float]]:
    """Yield the readings of a set that are not wrong by themselves: number, residual given the rest, its size.

    The largest is taken out, and the rest judged without it, as long as it is beyond the limit. One that is
    fine by itself is taken out, too, and yielded with no residual: the rest shall not be blamed for it.
    """
    times = _times(rows, some)
    precision, sizes = some.together.precision, some.together.sizes
    left: NDArray[Any] = np.arange(times.size)
    for wrong in [i for i, k in enumerate(some.numbers) if rows[k].judged.verdict == WRONG]:
        at = int(np.flatnonzero(left == wrong)[0])
        left, precision = np.delete(left, at), without(precision, at)
    while left.size:
        residuals = np.abs(precision @ times[left]) / np.sqrt(np.diag(precision))
        at = int(np.argmax(residuals / sizes[left]))
        if residuals[at] <= limit * sizes[left[at]]:
            yield from (
                (some.numbers[i], float(one), float(sizes[i]))
                for i, one in zip(left, residuals, strict=True)
            )
            return
        k = some.numbers[left[at]]
        fine = rows[k].judged.verdict == FINE
        yield k, 0.0 if fine else float(residuals[at]), float(sizes[left[at]])
        left, precision = np.delete(left, at), without(precision, at)


def _whole(rows: Sequence[CountedReading], by: Yardstick) -> Whole | None:
    """Return how rare a drawing is as a whole, by its readings that are not wrong; None if it is not.

    By how far off they are, position by position; and by the sums of each segment over all positions, in which
    what is off in the same way adds up. It is rare by the rarer of the two.
    """
    rows = [one for one in rows if one.judged.verdict != WRONG]
    sets = list(sets_of(rows, by))
    if not sets:
        return None
    chances = [_chance([(_times(rows, one), one.together) for one in sets], by)]
    sums = _sums([rows[k] for one in sets for k in one.numbers], by)
    together = by.covariances.of([hand for _, hand in sums])
    if together is not None:
        chances.append(_chance([(np.array([here for here, _ in sums]), together)], by))
    rare = len(chances) * min(chances)
    if rare >= RARE:
        return None
    doubtful = sum(one.judged.verdict == DOUBTFUL for one in rows)
    return Whole(rare, doubtful, (1.0 - by.limits.doubtful) * len(rows), len(rows))


def _chance(some: Sequence[tuple[Reals, Covariance]], by: Yardstick) -> float:
    """Return in which share of a hand's drawings sets of figures are together so far off."""
    here = sum(float(times @ one.precision @ times) for times, one in some)
    return tail(here, by.covariances.usual([one for _, one in some]).squares)


def _sums(rows: Sequence[CountedReading], by: Yardstick) -> list[tuple[float, Reals]]:
    """Return how far off each segment is in all positions together: here, and in the hand's drawings.

    Long ones count for more: most mistakes make a segment so many times too long. Measured by what is usual.
    """
    together: dict[tuple[str, str, bool], list[CountedReading]] = defaultdict(list)
    for one in rows:
        taken = one.judged.taken
        together[taken.plan, taken.segment, taken.pointed].append(one)
    found = []
    for some in together.values():
        shares = np.array([abs(one.judged.due) for one in some])
        longest = float(np.max(shares))
        shares = shares / longest if longest > 0.0 else np.ones(len(some))
        size, hand = by.covariances.summed([one.hand for one in some], shares)
        found.append((float(shares @ [one.times for one in some]) / size, hand))
    return found
