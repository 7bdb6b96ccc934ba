"""Whose variant a hand-in is of: its own, or another of the table that it fits better.

Counted are the readings that tell the two variants apart: what is due of both is so far apart that hardly
any reading is within the hand's limits of both. A drawing of the own variant, with whatever mistake, has none
or few of these within the limits of another; one of the other variant has nearly all of them there, and few at
its own. Variants that are too near each other for that are told apart where a hand-in is alike another one
(`copied`): of the two, which is nearer to the other's variant than to its own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from graphic_tmm.classroom.marks.row import SPOT, Figure, Key, Row

FEWEST = 6
"""So many readings, at the least, tell one variant from another."""
MOST_OWN, LEAST_OTHER = 0.25, 0.75
"""Of these so large a share, at the most, fits the own variant; so large a one, at the least, the other."""
TELLING = 1.5
"""What is due of both is apart by so many limits of the hand in a reading that tells one from the other."""
SUSPECT = 0.1
"""A drawing of which a smaller share is beyond the limits is of its own variant."""

SAME = 1e-6
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
    return off >= FEWEST * LEAST_OTHER and off >= SUSPECT * len(row.figures)


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
        if (due := dues.get((one.key, one.kind))) is not None and _between(one, due) > SAME
    ]
    if len(nearer) < FEWEST or sum(nearer) < LEAST_OTHER * len(nearer):
        return None
    return Other(variant, sum(nearer), len(nearer))


def _compared(row: Row, name: str, dues: Dues) -> Other | None:
    own = other = count = 0
    for one, due in _telling(row, dues):
        count += 1
        own += _apart(one, one.due) <= one.limit
        other += _apart(one, due) <= one.limit
    if count < FEWEST or own > MOST_OWN * count or other < LEAST_OTHER * count:
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
