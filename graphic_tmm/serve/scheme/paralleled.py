"""A parallelogram that a hand draws is meant as one: opposite sides become equal, it passes its dead places."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, replace
from typing import NamedTuple

from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.parallel import parallel_cranks
from graphic_tmm.mechanism.records import Link, Mechanism, Side
from graphic_tmm.mechanism.sketch import placed
from graphic_tmm.scene.mechanism import DIGITS, Joints
from graphic_tmm.serve.scheme.standing import NEAR, PARALLEL

FINE = 1e-6
"""An oblique side of a parallelogram is rounded so, m: to whole millimetres the other would be another."""
HALF_TURN = 180.0


@dataclass(frozen=True)
class _Sides(Joints):
    """A hand that leaves some lengths as long as they are."""

    kept: tuple[float, ...] = ()

    def rounded(self, metres: float) -> str:
        """Return a length as a scene says it."""
        if any(abs(abs(metres) - one) < FINE for one in self.kept):
            return f"{1000.0 * round(metres / FINE) * FINE:.{DIGITS}g} mm"
        return super().rounded(metres)


class Paralleled(NamedTuple):
    """A mechanism that lies, the hand that writes it, its new cranks that go parallel with the driven one."""

    lies: Mechanism
    hand: Joints
    cranks: frozenset[int] = frozenset()


def paralleled(
    lies: Mechanism, driven: Driven, before: Mechanism | None, hand: Joints
) -> Paralleled:
    """Return a mechanism whose new cranks go parallel with the driven one where they nearly did."""
    if driven.pair.kind != "R":
        return Paralleled(lies, hand)
    known = {one.number for one in before.links} if before is not None else set()
    fixed = before.frame.points if before is not None else {}
    near = hand.near * PARALLEL / NEAR
    kept = dict[int, float]()
    for one in list(parallel_cranks(lies, driven.link, near)):
        if one.number in known:
            continue
        pivot, pin = one.beside
        frame = lies.frame.points
        start = fixed.get(pivot, _rounded(frame[pivot], hand))
        end = fixed.get(one.pivot, start + _way(frame[one.pivot] - start, near, hand))
        there = lies.by_number[driven.link].points[pin] + end - start
        lies = placed(lies, {pivot: start, one.pivot: end, one.pin: there})
        dead = math.degrees(cmath.phase(end - start)) % HALF_TURN
        flipping = Side(1, flips_at=(dead, dead + HALF_TURN))
        links = (_with_side(link, one.number, flipping) for link in lies.links)
        lies = replace(lies, links=tuple(links))
        kept[one.number] = abs(end - start)
    sides = _Sides(hand.to, hand.near, kept=tuple(kept.values()))
    return Paralleled(lies, sides, frozenset(kept))


def _with_side(link: Link, number: int, side: Side) -> Link:
    return replace(link, side=side) if link.number == number else link


def _way(way: complex, near: float, hand: Joints) -> complex:
    """Return the way from pivot to pivot as a hand means it: level or upright if it is nearly so."""
    x, y = (0.0 if abs(axis) < near else axis for axis in (way.real, way.imag))
    return _rounded(complex(x, y), hand)


def _rounded(place: complex, hand: Joints) -> complex:
    """Return a place of the frame as a hand writes it."""
    x, y = (round(axis / hand.to) * hand.to for axis in (place.real, place.imag))
    return complex(x, y if abs(place.imag) >= hand.near else 0.0)
