"""Hand-ins that may be copies: equal to the digit more often than by chance, or nearer another variant."""

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


FEWEST_TELLING = 6
"""So many readings, at the least, tell one variant from another."""
MOST_OWN, LEAST_OTHER = 0.25, 0.75
"""Of these so large a share, at the most, fits the own variant; so large a one, at the least, the other."""
TELLING = 1.5
"""What is due of both is apart by so many limits of the hand in a reading that tells one from the other."""
SUSPECT = 0.1
"""A drawing of which a smaller share is beyond the limits is of its own variant."""

SAME_VARIANT = 1e-6
"""What is due of both is the same if it differs by less, mm or its unit."""

Dues = Mapping[tuple[Key, str], tuple[float, ...]]


class Other(NamedTuple):
    """The variant that a hand-in looks like: how many of the readings that tell both apart fit it."""

    variant: str
    fits: int
    of: int


def is_suspect(row: Row) -> bool:
    """Whether so much of a hand-in is beyond the limits that it may be another variant's."""
    off = sum(_apart(one, one.due) > one.limit for one in row.figures)
    return row.whole or (off >= FEWEST_TELLING * LEAST_OTHER and off >= SUSPECT * len(row.figures))


def looks_like(row: Row, variants: Mapping[str, Dues]) -> Other | None:
    """Return the variant that a hand-in fits though it is not its own; None if it does not.

    ``variants``: what is due of all others, by name.
    """
    found = [one for name, dues in variants.items() if (one := _compared(row, name, dues))]
    return max(found, key=lambda one: (one.fits / one.of, one.fits), default=None)


def copied(row: Row, variant: str, dues: Dues) -> Other | None:
    """Return a variant, if most of a hand-in's readings are nearer to it than to the own one; else None.

    It means little by itself: of a hand-in that is alike one of that variant it tells who drew for whom.
    """
    nearer = [
        _apart(one, due) < _apart(one, one.due)
        for one in row.figures
        if (due := dues.get((one.key, one.kind))) is not None and _between(one, due) > SAME_VARIANT
    ]
    if len(nearer) < FEWEST_TELLING or sum(nearer) < LEAST_OTHER * len(nearer):
        return None
    return Other(variant, sum(nearer), len(nearer))


def _compared(row: Row, name: str, dues: Dues) -> Other | None:
    own = other = count = 0
    for one, due in _telling(row, dues):
        count += 1
        own += _apart(one, one.due) <= one.limit
        other += _apart(one, due) <= one.limit
    if count < FEWEST_TELLING or own > MOST_OWN * count or other < LEAST_OTHER * count:
        return None
    return Other(name, other, count)


def _telling(row: Row, dues: Dues) -> Iterator[tuple[Figure, tuple[float, ...]]]:
    """Yield the readings that tell a variant from the own one, each with what is due of that."""
    for one in row.figures:
        due = dues.get((one.key, one.kind))
        if due is not None and _between(one, due) > TELLING * one.limit:
            yield one, due


def _between(one: Figure, due: tuple[float, ...]) -> float:
    return _distance(one.kind, one.due, due)


def _apart(one: Figure, due: tuple[float, ...]) -> float:
    return _distance(one.kind, one.found, due)


def _distance(kind: str, one: tuple[float, ...], other: tuple[float, ...]) -> float:
    """Return how far two figures are apart; lengths and quantities without their sense."""
    if kind == SPOT:
        return math.dist(one, other)
    return abs(abs(one[0]) - abs(other[0]))
