"""A parallelogram that a hand draws is meant as one: opposite sides become equal, it passes its dead places."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import count
from typing import Any, NamedTuple

from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.parallel import Parallel, parallel_cranks
from graphic_tmm.mechanism.records import Link, Mechanism, Side
from graphic_tmm.mechanism.sketch import placed
from graphic_tmm.scene.document import Document
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
    cranks: Mapping[int, Parallel] = {}


def paralleled(
    lies: Mechanism, driven: Driven, before: Mechanism | None, hand: Joints
) -> Paralleled:
    """Return a mechanism whose new cranks go parallel with the driven one where they nearly did."""
    if driven.pair.kind != "R":
        return Paralleled(lies, hand)
    known = {number for number, _ in _counted(before) & _counted(lies)}
    fixed = before.frame.points if before is not None else {}
    near = hand.near * PARALLEL / NEAR
    kept, cranks = list[float](), dict[int, Parallel]()
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
        kept.append(abs(end - start))
        cranks[one.number] = one
    return Paralleled(lies, _Sides(hand.to, hand.near, kept=tuple(kept)), cranks)


def with_named_sides(
    tables: Document, driven: int, cranks: Mapping[int, Parallel], before: Mechanism | None
) -> Document:
    """Return the tables of a scene in which opposite sides of parallelograms are one named length.

    Whoever types one of them is asked whether the other changes, too. What ``before`` had stays as it is.
    """
    bodies = (before.frame, *before.drawn) if before is not None else ()
    known = {letter for one in bodies for letter in one.points}
    links = {one["number"]: one["points"] for one in tables["link"]}
    names = dict(tables.get("lengths", {}))
    for number, one in cranks.items():
        pivot, pin = one.beside
        coupler = next(k for k, it in links.items() if {pin, one.pin} <= {*it})
        frame = tables["frame"]
        _name(names, "r" if pin not in known else "", [links[driven][pin], links[number][one.pin]])
        if frame[pivot] == [0, 0] == links[coupler][pin]:
            fresh = not {one.pivot, one.pin} & known
            _name(names, "b" if fresh else "", [frame[one.pivot], links[coupler][one.pin]])
    return {**tables, "lengths": names} if names else tables


def _name(names: dict[str, Any], like: str, points: list[Any]) -> None:
    """Call the x of two points on the x axis by one name, where it is the same."""
    (first, off), (second, level) = points
    known = names.get(first) if isinstance(first, str) else None
    if off or level or second != (first if known is None else known) or not (like or known):
        return
    if known is None:
        others = (f"{like}_{k}" for k in count(2))
        first = like if like not in names else next(one for one in others if one not in names)
        names[first] = second
    for one in points:
        one[0] = first


def _with_side(link: Link, number: int, side: Side) -> Link:
    return replace(link, side=side) if link.number == number else link


def _counted(mechanism: Mechanism | None) -> set[tuple[int, bool]]:
    """Return the links of a mechanism, each with whether it is passive."""
    drawn = mechanism.drawn if mechanism is not None else ()
    return {(one.number, mechanism is not None and one in mechanism.passive) for one in drawn}


def _way(way: complex, near: float, hand: Joints) -> complex:
    """Return the way from pivot to pivot as a hand means it: level or upright if it is nearly so."""
    x, y = (0.0 if abs(axis) < near else axis for axis in (way.real, way.imag))
    return _rounded(complex(x, y), hand)


def _rounded(place: complex, hand: Joints) -> complex:
    """Return a place of the frame as a hand writes it."""
    x, y = (round(axis / hand.to) * hand.to for axis in (place.real, place.imag))
    return complex(x, y if abs(place.imag) >= hand.near else 0.0)
