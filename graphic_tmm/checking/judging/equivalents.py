"""Other constructions of the same point that are as right: by angles, by lengths, by an angle and a length.

A point is fixed by two conditions. The log draws it in one way; a student may draw it in another, and slips
then as that way does: off a ray by its swing, off an arc by the opening of the compass. One small table tells
the ways of each operation; the milder verdict counts.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import cache
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.operations.instruments import join
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Arc, Line
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.scatter import Limits, Scatter, limited
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Crossed, Readings

RAY, ARC, LINE = "ray", "arc", "line"
WAYS: Mapping[str, tuple[tuple[str, str], ...]] = {
    # by the angles of the triangle or square to the sides of the link; by the ratios of the sides; by an angle
    # and a ratio, from either end
    "similar": (
        ("ray base_a", "ray base_b"),
        ("arc base_a of base_a base_b", "arc base_b of base_a base_b"),
        ("ray base_a", "arc base_a of base_a base_b"),
        ("ray base_b", "arc base_b of base_a base_b"),
    ),
    "homologous": (("ray start", "arc start of a b"),),
    # by an angle and a length, from either end
    "cross": (("ray first", "arc first"), ("ray second", "arc second")),
    # by an angle and a length; by two arcs, where the line goes through a second point
    "place": (("ray on", "arc on"), ("arc on", "arc on.end")),
}
"""By operation, the two conditions of each other way: a ray or an arc about an argument (of a line: its
beginning, with ``.end`` the point through which it was joined), the opening calculated from a length that is
measured between two others."""
LEAST_SINE = math.sin(math.radians(15.0))
"""Two rays, or two arcs, that meet at less than 15° do not fix a point: nobody draws it so. Handbooks of
drawing ask for 30°; half of that leaves room for who does not keep to it."""
SAMPLE = 400
"""The larger of two normal errors is known by so many of its quantiles: as finely as a hand's own drawings."""


class Limb(NamedTuple):
    """One of two conditions: of which ``kind``, about which mark, ``of`` which length measured (two marks).

    A line goes through its mark and the point ``of``, or along that line.
    """

    kind: str
    centre: Mark
    of: tuple[Mark, ...] = ()


class Off(NamedTuple):
    """How far a point is off one condition, mm, and how large a hand makes that."""

    error: float
    size: float


def ways_of(step: Step, lines: Mapping[Mark, Step]) -> tuple[tuple[Limb, Limb], ...]:
    """Return the other ways of a step; ``lines``: the steps of the log by their marks."""
    found = []
    for one, other in WAYS.get(step.op.name, ()):
        first, second = _limb(step, one, lines), _limb(step, other, lines)
        if first is not None and second is not None:
            found.append((first, second))
    return tuple(found)


def crossings(project: Project) -> dict[Mark, tuple[tuple[Limb, Limb], ...]]:
    """Return of points the other pairs of lines that meet there, as chapters know them."""
    found: dict[Mark, tuple[tuple[Limb, Limb], ...]] = {}
    for chapter in project.chapters:
        told = Readings.of(chapter).crossings(project)
        found |= {mark: tuple(map(_crossing, lines)) for mark, lines in told.items()}
    return found


def _crossing(lines: Crossed) -> tuple[Limb, Limb]:
    """Return two lines, of which one goes through two points, or one along a line, as conditions."""
    (first, to), (second, end) = lines
    return Limb(LINE, first, (to,)), Limb(LINE, second, (end,))


def _limb(step: Step, told: str, lines: Mapping[Mark, Step]) -> Limb | None:
    kind, centre, *of = told.replace(" of ", " ").split()
    name, _, end = centre.partition(".")
    mark = step.uses[step.op.arguments.index(name)]
    if end:
        line = lines.get(mark)
        if line is None or line.op is not join:
            return None
        mark = line.uses[1]
    return Limb(kind, mark, tuple(step.uses[step.op.arguments.index(one)] for one in of))


def offs(
    way: tuple[Limb, Limb],
    found: complex,
    due: complex,
    value: Callable[[Mark], Any],
    hand: Hand,
    pointing: float,
    *,
    placed: bool = False,
) -> tuple[Off, ...]:
    """Return how far a point is off the two conditions of a way; none if it cannot be drawn so.

    ``value``: what the log, run with what was read, has of a mark; ``pointing``: the slip of the coordinates;
    ``placed``: it stands where it is due, so that two lines fixed it, however sharp they cross.
    """
    centres = [spot_of(limb.centre, value(limb.centre)) for limb in way]
    with np.errstate(all="ignore"):
        if way[0].kind == LINE:
            u, v = (_along(limb, spot, value) for limb, spot in zip(way, centres, strict=True))
            sharp = abs((u.conjugate() * v).imag) < LEAST_SINE * abs(u) * abs(v)
            if sharp and not placed:
                return ()
        elif way[0].kind == way[1].kind and not _fixed(way[0].kind, found, due, *centres):
            return ()
        told = tuple(
            Off(*_off(limb, centre, found, due, value, hand, pointing))
            for limb, centre in zip(way, centres, strict=True)
        )
    return told if all(math.isfinite(one.error + one.size) for one in told) else ()


def _fixed(kind: str, found: complex, due: complex, first: complex, second: complex) -> bool:
    """Whether two rays or arcs fix a point, and it is the due one of two meetings."""
    if kind == ARC and slips.off_meeting(found, due, slips.reflected(due, first, second)) > 0.0:
        return False
    return bool(slips.sine_between(due, first, second) >= LEAST_SINE)


def _off(
    limb: Limb,
    centre: complex,
    found: complex,
    due: complex,
    value: Callable[[Mark], Any],
    hand: Hand,
    pointing: float,
) -> tuple[float, float]:
    far = abs((found if limb.kind == LINE else due) - centre)
    if limb.kind == LINE:
        along = _along(limb, centre, value)
        error = ((found - centre) * along.conjugate()).imag / abs(along)
        if limb.of[0].kind is Line:
            slip = slips.swung(far, hand.swing)
        else:  # what both ends are off turns and moves it
            share = far / abs(along)
            slip = math.hypot(hand.prick, pointing) * math.hypot(share, 1.0 - share)
    elif limb.kind == RAY:
        error, slip = slips.off_ray(found, due, centre), slips.swung(far, hand.swing)
    else:
        base = np.abs(value(limb.of[1]) - value(limb.of[0])) if limb.of else math.inf
        half = 0.5 * (hand.ruler or 0.0)
        share = float(far / base)
        error = slips.off_opening(found, due, centre)
        slip = slips.opened(share, hand.compass, hand.reading, half)
    return float(error), slips.found_within(slip, hand.prick, pointing)


def _along(limb: Limb, centre: complex, value: Callable[[Mark], Any]) -> complex:
    """Return the direction of a line."""
    other = value(limb.of[0])
    return np.complex128(other.along if limb.of[0].kind is Line else other - centre)


def spot_of(mark: Mark, value: Any) -> complex:
    """Return the point about which a condition is: a point, the beginning of a line, the centre of an arc."""
    if mark.kind is Line:
        value = value.at
    elif mark.kind is Arc:
        value = value.centre
    return np.complex128(value)


@cache
def pair(limits: Limits) -> Scatter:
    """Return the limits of the larger of two errors of a hand, each measured by its root mean square."""
    shares = (np.arange(SAMPLE) + 0.5) / SAMPLE
    normal = NormalDist()
    larger = np.array([normal.inv_cdf(0.5 + 0.5 * math.sqrt(share)) for share in shares])
    found = limited(larger, limits)
    return found._replace(wrong=max(limits.wrong, limits.beyond * larger[-1], found.doubtful))
