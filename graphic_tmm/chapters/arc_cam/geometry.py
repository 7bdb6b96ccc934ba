"""Where the arcs of a contour lie and when the follower is on each: what is chosen before the log is written.

Everything here is told for a cam that turns clockwise, with its nose downward: then the follower begins above
the cam, goes round it counter-clockwise in reversed motion, and meets the flank of the rise on the left. A cam
that turns the other way is its mirror image.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.arc_cam.task import ASKED, FLAT, FLAT_ROCKER, ROCKER, ArcTask, Flank
from graphic_tmm.language.said import said

TURN = 360.0
SAME = 1e-9
"""Angles that differ by less, degrees, or shares, are one: far above rounding, far below what is seen."""
ARCS = ("rise", "nose", "return")
"""The arcs of a contour on which the follower is while it moves, in the order in which it meets them."""
PROBES = 180
"""At how many places of each arc it is tried whether the follower goes on round the cam there."""


class Lie(NamedTuple):
    """How a contour lies: the angles of the cam (degrees) at which the follower goes from arc to arc.

    ``changes``: from the base to the flank of the rise, to the nose, to the flank of the return, to the base.
    """

    changes: tuple[float, float, float, float]

    @property
    def work(self) -> float:
        """The angle of the cam over which the follower moves, degrees."""
        return self.changes[3] - self.changes[0]

    @property
    def whole(self) -> bool:
        """Whether the follower is on one arc all the way round: that of an eccentric."""
        return abs(self.work - TURN) < SAME

    def arcs_at(self, shares: Reals) -> Any:
        """Return which arcs (`ARCS`) it is on at shares of that angle; where two meet the one before."""
        if self.whole:
            return np.full(np.shape(shares), ARCS.index("nose"))
        inner = [(change - self.changes[0]) / self.work for change in self.changes[1:3]]
        return sum((shares > change + SAME).astype(int) for change in inner)


def lie(order: ArcTask) -> Lie:
    """Return how the contour lies.

    Raises
    ------
    TaskError
        If the arcs do not touch, or the follower does not reach them; it says what to change.
    """
    if order.eccentric:
        return _round(order)
    _refuse_circles(order)
    for flank, name in ((order.rise, "flank"), (order.fall, "return_flank")):
        _refuse_flank(order, flank, name)
    _refuse_follower(order)
    ways = (*normals(order, order.rise, 1), *normals(order, order.fall, -1)[::-1])
    reach = order.roller
    nose = -1j * order.distance
    centres = (
        (order.base + reach) * ways[0],
        nose + (order.nose + reach) * ways[1],
        nose + (order.nose + reach) * ways[2],
        (order.base + reach) * ways[3],
    )
    angles = [_angle(order, *one) for one in zip(centres, ways, strict=True)]
    _refuse_turning_back(order, angles)
    _refuse_turning_back(order, [angles[0], *_along(order, centres)])
    # past a whole turn it goes on: a lever may begin its work late in one
    first, second, third, last = (one + TURN * (one < angles[0] - SAME) for one in angles)
    return Lie((first, second, third, last))


def _round(order: ArcTask) -> Lie:
    """Return how an eccentric lies: the follower begins where it is at its lowest, opposite the centre."""
    if not order.base > 0.0:
        says = said(
            "the shaft stands outside the disc: take an eccentricity less than {most:g} mm",
            most=1000.0 * order.nose,
        )
        raise TaskError(ASKED.section, "eccentricity", says)
    _refuse_follower(order)
    lowest, centre = 1j * (order.base + order.roller), -1j * order.distance
    begin = _angle(order, lowest, 1j)
    if not order.flat:
        spots = centre + (lowest - centre) * np.exp(2j * np.pi * np.linspace(0.0, 1.0, 2 * PROBES))
        _refuse_turning_back(order, [_angle(order, complex(z), 1j) for z in spots[:-1]])
    return Lie((begin, begin, begin + TURN, begin + TURN))


def normals(order: ArcTask, flank: Flank, side: int) -> tuple[complex, complex]:
    """Return the outward normals where a flank meets the base circle and the nose; ``side``: 1 to the left."""
    d, nose = order.distance, -1j * order.distance
    if flank.radius is None:
        lift = (order.base - order.nose) / d
        normal = complex(-side * math.sqrt(1.0 - lift * lift), -lift)
        return normal, normal
    sign = -1.0 if flank.hollow else 1.0
    near, far = (flank.radius - sign * r for r in (order.base, order.nose))
    down = (near * near + d * d - far * far) / (2.0 * d)
    across = math.sqrt(max(near * near - down * down, 0.0))
    centre = complex(side * sign * across, -down)
    return -sign * centre / abs(centre), sign * (nose - centre) / abs(nose - centre)


def _angle(order: ArcTask, centre: complex, normal: complex) -> float:
    """Return the angle of the cam at which the roller's centre (a flat face's normal) stands so."""
    if order.follower == FLAT:
        turned = cmath.phase(normal)
    elif order.follower == FLAT_ROCKER:
        assert order.centres is not None
        far = (centre * normal.conjugate()).real
        along = math.sqrt(max(order.centres**2 - far**2, 0.0))
        turned = cmath.phase(complex(far, -along if order.same_sense else along) * normal)
    elif order.follower == ROCKER:
        assert order.lever is not None
        assert order.centres is not None
        far, base, arm = abs(centre), order.centres, order.lever
        cosine = (base * base + far * far - arm * arm) / (2.0 * base * far)
        between = math.acos(min(1.0, max(-1.0, cosine)))
        turned = cmath.phase(centre) + between * (-1.0 if order.same_sense else 1.0)
    else:
        turned = cmath.phase(centre) - math.asin(order.offset / abs(centre))
    return math.degrees(turned - math.pi / 2.0) % TURN


def side_on_straight(order: ArcTask, flank: Flank, side: int) -> int:
    """Return on which side of the foot of the lever's pivot the roller's centre is on a straight flank.

    1 where it is reached to the left of the flank's outward normal.
    """
    normal = normals(order, flank, side)[0]
    middle = (order.base + order.roller) * normal + 1e-3j * side * normal * order.distance
    assert order.centres is not None
    pivot = 1j * order.centres * cmath.exp(1j * math.radians(_angle(order, middle, normal)))
    return 1 if ((middle - pivot) * (1j * normal).conjugate()).real > 0.0 else -1


# ---------------------------------------------------------------- refusals


def _refuse_circles(order: ArcTask) -> None:
    at, mm = ASKED.section, 1000.0
    if not order.nose < order.base:
        says = said(
            "the nose of {nose:g} mm is not smaller than the base circle of {base:g} mm: take a smaller one",
            nose=mm * order.nose,
            base=mm * order.base,
        )
        raise TaskError(at, "nose", says)
    if not order.distance > order.base - order.nose:
        says = said(
            "the nose does not stand out of the base circle, so nothing is lifted: take a distance greater "
            "than {least:g} mm",
            least=mm * (order.base - order.nose),
        )
        raise TaskError(at, "distance", says)


def _refuse_flank(order: ArcTask, flank: Flank, name: str) -> None:
    at, mm, d = ASKED.section, 1000.0, order.distance
    if flank.radius is None:
        if flank.hollow:
            says = said("a straight flank is not hollow: write its radius, or leave hollow out")
            raise TaskError(at, "hollow", says)
        if order.flat:
            says = said(
                "a flat face would strike the straight flank all at once: take an arc, or a roller"
            )
            raise TaskError(at, name, says)
        return
    both = order.base + order.nose
    least = (d - both) / 2.0 if flank.hollow else (d + both) / 2.0
    if not flank.radius > least:
        says = said(
            "an arc of {radius:g} mm does not touch base circle and nose: take a radius greater than "
            "{least:g} mm",
            radius=mm * flank.radius,
            least=mm * least,
        )
        raise TaskError(at, name, says)
    if not flank.hollow:
        return
    if order.flat:
        says = said("a flat face does not reach a hollow flank: take a roller, or leave hollow out")
        raise TaskError(at, "hollow", says)
    if not flank.radius > order.roller:
        says = said(
            "the roller of {roller:g} mm does not go into the hollow flank of {radius:g} mm: take a smaller "
            "roller",
            roller=mm * order.roller,
            radius=mm * flank.radius,
        )
        raise TaskError(at, "roller", says)


def _refuse_follower(order: ArcTask) -> None:
    at, mm, low = ASKED.section, 1000.0, order.base + order.roller
    high = order.distance + order.nose + order.roller
    if not abs(order.offset) < low:
        says = said(
            "the guide passes the base circle by: take an offset less than {most:g} mm",
            most=mm * low,
        )
        raise TaskError(at, "offset", says)
    if not order.rocks:
        return
    assert order.centres is not None
    if order.follower == FLAT_ROCKER:
        if not order.centres > high:
            says = said(
                "the nose would strike the lever's pivot: take centres more than {least:g} mm apart",
                least=mm * high,
            )
            raise TaskError(at, "centres", says)
        return
    assert order.lever is not None
    least, most = abs(order.centres - order.lever), order.centres + order.lever
    if not (least < low and high < most):
        says = said(
            "the roller's centre goes from {low:g} to {high:g} mm from the cam's centre, the lever reaches "
            "from {least:g} to {most:g} mm: change lever or centres",
            low=mm * low,
            high=mm * high,
            least=mm * least,
            most=mm * most,
        )
        raise TaskError(at, "lever", says)
    if not order.centres > order.distance + order.nose:
        says = said(
            "the nose would strike the lever's pivot: take centres more than {least:g} mm apart",
            least=mm * (order.distance + order.nose),
        )
        raise TaskError(at, "centres", says)


def _refuse_turning_back(order: ArcTask, run: Sequence[float]) -> None:
    """Refuse a follower whose angles (degrees), met in turn, do not grow within a turn from the first."""
    if any(b < a - SAME for a, b in pairwise((one - run[0] + SAME) % TURN for one in run)):
        says = said(
            "the follower does not stay on the cam all the way round: take a smaller offset, a longer "
            "lever or another roller"
        )
        key = "lever" if order.follower == ROCKER else "offset"
        raise TaskError(ASKED.section, key, says)


def _along(order: ArcTask, centres: tuple[complex, ...]) -> list[float]:
    """Return the angles of the cam at places along the path of the roller's centre, in their order."""
    if order.flat:
        return []
    reach, nose = order.roller, -1j * order.distance
    ends = [(centres[0], centres[1]), (centres[1], centres[2]), (centres[2], centres[3])]
    middles: list[tuple[complex | None, float]]
    middles = [centre_of(order, order.rise, 1), (nose, order.nose + reach)]
    middles.append(centre_of(order, order.fall, -1))
    found: list[float] = []
    for (start, end), (centre, radius) in zip(ends, middles, strict=True):
        share = np.linspace(0.0, 1.0, PROBES)
        if centre is None:
            spots = start + share * (end - start)
        else:
            first, turn = (start - centre) / (radius or 1.0), 0.0
            if radius > 0.0:
                turn = cmath.phase((end - centre) / (start - centre))
            spots = centre + radius * first * np.exp(1j * share * turn)
        found += [_angle(order, complex(z), z / abs(z)) for z in spots]
    return found


def centre_of(order: ArcTask, flank: Flank, side: int) -> tuple[complex | None, float]:
    """Return the centre of a flank's arc, and the radius on which the roller's centre goes about it."""
    if flank.radius is None:
        return None, 0.0
    sign = -1.0 if flank.hollow else 1.0
    normal = normals(order, flank, side)[0]
    centre = (order.base - sign * flank.radius) * normal
    return centre, flank.radius + sign * order.roller
