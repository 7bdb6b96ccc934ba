"""An acceleration diagram that was read off paper: how far a ruler errs on it, what makes it one that closes.

On paper neither the places of jumps nor the areas are exact. A jump is put where a position of the cam stands;
the ordinates below the axis are multiplied by one factor that makes both areas equal, so that the follower
stops. Both are done within what a ruler can read only, and told.
"""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

READ = 0.5
"""What a ruler leaves open on a diagram, mm: half of its division."""
HIGH, WHOLE = 40.0, 240.0
"""The largest ordinate of the acceleration diagram, and the turn on the one that was read, mm."""
EVEN = 1e-6
"""Areas of an acceleration diagram that differ by less than this share of themselves are equal."""
SLACK = 1e-9
"""Shares of a phase that differ by less are the same."""

Points = tuple[tuple[float, float], ...]
"""Share of the phase, acceleration."""


class Changed(NamedTuple):
    """How a diagram was changed: a ``factor`` of ordinates below the axis, jumps ``moved`` (share, place)."""

    factor: float = 1.0
    moved: tuple[tuple[float, float], ...] = ()


def plain(points: Points) -> Points:
    """Return the points without those within a jump: it goes from the first of one share to the last."""

    def within(k: int) -> bool:
        return 0 < k < len(points) - 1 and points[k + 1][0] - points[k - 1][0] <= SLACK

    return tuple(point for k, point in enumerate(points) if not within(k))


def jumps(points: Points) -> list[float]:
    """Return the shares inside a phase at which the acceleration jumps."""
    double = [a[0] for a, b in pairwise(points) if b[0] - a[0] <= SLACK]
    return [share for share in double if SLACK < share < 1.0 - SLACK]


def areas(points: Points) -> tuple[float, float]:
    """Return the area under the diagram, those below the axis negative, and all of it taken positive."""
    steps = [(b[0] - a[0], a[1], b[1]) for a, b in pairwise(points)]
    whole = sum(wide * (a + b) / 2.0 for wide, a, b in steps)
    return whole, sum(wide * (abs(a) + abs(b)) / 2.0 for wide, a, b in steps)


def legible(points: Points, base: float) -> float:
    """Return how far the area may be off by reading; ``base``: how long the phase is, mm, HIGH its diagram.

    Each ordinate and each share is off by READ; of a jump both points go together.
    """
    most = max(abs(value) for _, value in points)
    turns = sum(abs(a[1] - c[1]) / 2.0 for a, c in zip(points, points[2:], strict=False))
    return most * READ / HIGH + turns * READ / base


def balanced(points: Points) -> tuple[Points, float]:
    """Return the points with equal areas, and the factor of the ordinates below the axis that makes them so.

    The area is linear in the ordinates: each counts with half of the widths on both sides of it.
    """
    whole, size = areas(points)
    if abs(whole) <= EVEN * size:
        return points, 1.0
    below = areas(tuple((share, min(value, 0.0)) for share, value in points))[0]
    factor = (below - whole) / below
    return tuple((u, value * factor if value < 0.0 else value) for u, value in points), factor


def risen(points: Points) -> tuple[float, float]:
    """Return what the follower rises by points of its acceleration, and its largest speed, in their unit."""
    speed = lift = most = 0.0
    for (u, a), (w, b) in pairwise(points):
        if a * b < 0.0:
            most = max(most, abs(speed + a * a * (w - u) / (2.0 * (a - b))))
        lift += (w - u) * speed + (w - u) ** 2 * (2 * a + b) / 6.0
        speed += (w - u) * (a + b) / 2.0
        most = max(most, abs(speed))
    return lift, most


def moved(points: Points, parts: int, base: float) -> tuple[Points, list[float]] | None:
    """Return the points with each jump at the next of ``parts`` even divisions, and the shares of the jumps.

    None where a jump would go farther than a ruler leaves open, to an end, to another jump or past a corner.
    """
    told = jumps(points)
    places = [round(share * parts) / parts for share in told]
    put = dict(zip(told, places, strict=True))
    found = tuple((put.get(share, share), value) for share, value in points)
    near = all(abs(place - share) * base <= READ for share, place in put.items())
    inside = all(b - a > 0.5 / parts for a, b in pairwise((0.0, *places, 1.0)))
    ordered = all(b[0] >= a[0] for a, b in pairwise(found))
    return (
        (found, places) if near and inside and ordered and len(jumps(found)) == len(told) else None
    )
