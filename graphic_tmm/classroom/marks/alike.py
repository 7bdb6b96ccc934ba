"""Hand-ins that are alike: more readings equal to the digit than two honest hands have by chance.

Two people who measure the same length read each with a slip of their own, N(0, s), and round it to g mm. Their
figures are equal with the chance that two such slips round alike,

    p = E max(0, 1 - |d| / g),  d ~ N(0, 2 s²)

whatever else of their drawings differs makes it smaller. The slips of two readings are independent, so that of
n readings, m = sum of p expected equal, k or more are equal with a chance of at most exp(-n D(k/n, m/n)), D the
divergence of a coin k/n from m/n (Chernoff). What follows from others (a rate, a length laid off) is not
counted. s is the slip of the hand that is judged by, less if both drawings are so much nearer to what is due
(whoever draws with a computer has no slip, and nobody is like him by copying). Told is a pair that among honest
ones would be found in one class of a `RARE` only, however large the class.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations
from statistics import median
from typing import NamedTuple

from graphic_tmm.classroom.marks.row import MM, SPOT, VALUE, Figure, Key, Row

RARE = 1000
"""One class of so many has a pair that is told and is honest, at the most."""
FEWEST = 6
"""Fewer equal readings are not told, whatever their chance."""
USUAL = 0.6745
"""The median of what a normal hand is off, in usual errors."""
ROUNDED = 0.2
"""What is off by rounding alone seems to be off by the square root of so many grains; in the median 0.14."""
SURE = 0.01
"""No hand is taken for more than so many times surer than the one that is judged by."""
SAME = 1e-9
"""Figures that differ by a smaller share are the same: they were written alike."""


class Alike(NamedTuple):
    """Two hand-ins (numbers), how many of their measured readings are equal, and of how many in both."""

    one: int
    other: int
    equal: int
    of: int


def alike(rows: Sequence[Row]) -> tuple[Alike, ...]:
    """Return the pairs of hand-ins that are more alike than honest ones are by chance."""
    read = [_measured(row) for row in rows]
    nearness = [_nearness(row) for row in rows]
    pairs = list(combinations(range(len(rows)), 2))
    least = math.log(RARE * max(len(pairs), 1))
    found = []
    for a, b in pairs:
        chances, equal = [], 0
        for one, other in _both(read[a], read[b]):
            p = chance(one, other, max(nearness[a], nearness[b]))
            if p < 1.0:
                chances.append(p)
                equal += _equal(one, other)
        if equal >= FEWEST and rareness(equal, chances) >= least:
            found.append(Alike(a, b, equal, len(chances)))
    return tuple(found)


def chance(one: Figure, other: Figure, nearness: float) -> float:
    """Return the chance that honest figures are equal; ``nearness``: of the surer slip, as a share."""
    grain, slip = max(one.grain, other.grain), min(one.slip, other.slip) * nearness
    each = rounded_alike(grain, slip)
    return each * each if one.kind == SPOT else each


def rounded_alike(grain: float, slip: float) -> float:
    """Return the chance that two slips of a standard deviation, rounded to a grain, are equal.

    >>> round(rounded_alike(0.5, 0.8), 3), rounded_alike(1.0, 0.0)
    (0.173, 1.0)
    """
    spread = math.sqrt(2.0) * slip
    if spread <= 0.0:
        return 1.0
    t = grain / spread
    density = math.sqrt(2.0 / math.pi) * (1.0 - math.exp(-0.5 * t * t)) / t
    return min(1.0, math.erf(t / math.sqrt(2.0)) - density)


def rareness(equal: int, chances: Sequence[float]) -> float:
    """Return how rare it is that so many are equal by chance: minus the logarithm of a bound for it.

    >>> rareness(2, [0.5] * 4), round(rareness(4, [0.5] * 4), 3)
    (0.0, 2.773)
    """
    if not chances:
        return 0.0
    n, p = len(chances), math.fsum(chances) / len(chances)
    share = equal / n
    if share <= p:
        return 0.0
    rest = (1.0 - share) * math.log((1.0 - share) / (1.0 - p)) if share < 1.0 else 0.0
    return n * (share * math.log(share / p) + rest)


def _measured(row: Row) -> Mapping[tuple[Key, str], Figure]:
    """Return the figures that were measured, each once: as a length, a point, or else a quantity."""
    found = {(one.key, one.kind): one for one in row.figures if one.grain > 0.0}
    lengths = {key for key, kind in found if kind == MM}
    return {at: one for at, one in found.items() if not (at[1] == VALUE and at[0] in lengths)}


def _nearness(row: Row) -> float:
    """Return how near to what is due a drawing is, as a share of what the hand is usually off; at most 1.

    What rounding alone brings is taken off: of a drawing by a computer nothing is left.
    """
    read = [one for one in row.figures if one.grain > 0.0 and one.slip > 0.0]
    if not read:
        return 1.0
    off = median(one.off for one in read) / USUAL
    rounding = ROUNDED * median((one.grain / one.slip) ** 2 for one in read)
    return min(1.0, math.sqrt(max(SURE**2, off**2 - rounding)))


def _both(
    one: Mapping[tuple[Key, str], Figure], other: Mapping[tuple[Key, str], Figure]
) -> Iterator[tuple[Figure, Figure]]:
    for at, figure in one.items():
        if (beside := other.get(at)) is not None:
            yield figure, beside


def _equal(one: Figure, other: Figure) -> bool:
    return all(
        abs(a - b) <= SAME * max(1.0, abs(a)) for a, b in zip(one.found, other.found, strict=True)
    )
