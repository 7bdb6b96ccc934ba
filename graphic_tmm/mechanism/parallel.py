"""Cranks that go parallel: with the frame and a link that both are pinned to they make a parallelogram."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.mechanism.records import Mechanism


class Parallel(NamedTuple):
    """A crank that goes parallel with another: its number, where it is pivoted, its pin on the coupler.

    ``beside``: pivot and pin of the other crank.
    """

    number: int
    pivot: str
    pin: str
    beside: tuple[str, str]


def parallel_cranks(lies: Mechanism, number: int, near: float) -> Iterator[Parallel]:
    """Yield the cranks of a mechanism that lies which go parallel with one of them, or nearly so, m."""
    fixed = lies.frame.points
    crank = next((one for one in lies.drawn if one.number == number), None)
    pivots = [letter for letter in crank.points if letter in fixed] if crank is not None else []
    if crank is None or len(pivots) != 1:
        return
    (pivot,) = pivots
    for pin in (letter for letter in crank.points if letter != pivot):
        couplers = [one for one in lies.links if one is not crank and pin in one.points]
        for coupler in couplers:
            for other in lies.drawn:
                if other is crank or other is coupler:
                    continue
                ends = [letter for letter in other.points if letter in fixed]
                pins = [k for k in other.points if k in coupler.points and k not in (*fixed, pin)]
                for end, there in ((a, b) for a in ends for b in pins if a != pivot):
                    way = fixed[end] - fixed[pivot]
                    if abs(coupler.points[there] - coupler.points[pin] - way) < near:
                        yield Parallel(other.number, end, there, (pivot, pin))
