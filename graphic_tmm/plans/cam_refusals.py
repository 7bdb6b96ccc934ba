"""What makes no sense of a cam is refused before anything is drawn."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.cam_orders import LAWS, CamOrder, FlatFollower, Law, RockerFollower

TURN = 360.0
LEAST = 4
"""Fewer parts of a phase show no curve."""
MOST = 360
"""More parts than this are no drawing."""
SLACK = 1e-9
"""Degrees, or shares of a phase, that differ by less are the same."""
BALANCE = 1e-6
"""Areas of an acceleration diagram that differ by less than this share of themselves are equal."""


def refuse(order: CamOrder) -> None:
    """Refuse what makes no sense.

    Raises
    ------
    StructureError
        Which says what to change.
    """
    phases = (order.rise, order.upper_dwell, order.fall, order.lower_dwell)
    told = " + ".join(f"{angle:g}" for angle in phases)
    if not all(math.isfinite(angle) and angle >= 0.0 for angle in phases):
        raise StructureError(f"cam: phases of {told} degrees: none may be negative")
    if not (order.rise > 0.0 and order.fall > 0.0):
        raise StructureError("cam: the rise and the return need an angle greater than 0")
    if abs(sum(phases) - TURN) > 1e-6:
        raise StructureError(
            f"cam: the phases {told} make {sum(phases):g}°, not 360°: change the lower dwell to "
            f"{TURN - sum(phases[:3]):g}°"
            if sum(phases[:3]) <= TURN
            else f"cam: the phases {told} make {sum(phases):g}°, not 360°: shorten them"
        )
    _refuse_sizes(order)
    for name, law in (("rise", order.rise_law), ("return", order.return_law)):
        _refuse_law(name, law)


def _refuse_sizes(order: CamOrder) -> None:
    positive: list[tuple[str, float | None]] = [
        ("the stroke", order.stroke),
        ("r0", order.r0),
        ("the radius of the roller", order.roller),
        ("the base of the diagrams", order.base),
        ("the height of the diagrams", order.height),
        *((f"the scale {name}", getattr(order, f"mu_{name}")) for name in "SVAl"),
        *(("the pole distance H", pole) for pole in order.poles),
    ]
    follower = order.follower
    if isinstance(follower, RockerFollower):
        positive += [
            ("the length of the lever", follower.lever),
            ("the distance of the centres", follower.centres),
        ]
    for name, value in positive:
        if value is not None and not (math.isfinite(value) and value > 0.0):
            raise StructureError(f"cam: {name} = {value:g} is not greater than 0")
    if isinstance(follower, RockerFollower) and order.stroke >= math.pi:
        raise StructureError(
            f"cam: a lever that rocks by {math.degrees(order.stroke):g}° turns over: its stroke is an angle in "
            "radians, less than π"
        )
    _refuse_choices(order)


def _refuse_choices(order: CamOrder) -> None:
    follower = order.follower
    if isinstance(follower, FlatFollower) and follower.least < 0.0:
        raise StructureError("cam: the least radius of curvature of a flat face's cam is negative")
    for angle in (order.pressure, order.pressure_return):
        if angle is not None and not 0.0 < angle < 90.0:
            raise StructureError(f"cam: a pressure angle of {angle:g}° is not between 0° and 90°")
    if order.turns not in ("clockwise", "counterclockwise"):
        raise StructureError(
            f'cam: it turns "{order.turns}": take "clockwise" or "counterclockwise"'
        )
    for count in (order.divisions, order.per_turn):
        if count is not None and not (count == int(count) and LEAST <= count <= MOST):
            raise StructureError(
                f"cam: {count:g} parts: take a whole number from {LEAST} to {MOST}"
            )
    for name in ("share_of_r0", "share_of_curvature"):
        if not 0.0 < getattr(order, name) < 1.0:
            raise StructureError(
                f"cam: {name} = {getattr(order, name):g} is not between 0 and 1: a roller finds no room"
            )


def _refuse_law(name: str, law: Law) -> None:
    if law.name not in LAWS:
        raise StructureError(f'cam, {name}: no law "{law.name}": take one of {", ".join(LAWS)}')
    if law.name != "diagram":
        if law.points:
            raise StructureError(f'cam, {name}: points belong to the law "diagram" only')
        return
    points, shares = law.points, [share for share, _ in law.points]
    if len(points) < 2 or not np.isfinite(points).all():
        raise StructureError(f"cam, {name}: an acceleration diagram needs two points at least")
    if (
        any(b < a - SLACK for a, b in pairwise(shares))
        or abs(shares[0]) + abs(shares[-1] - 1) > SLACK
    ):
        raise StructureError(f"cam, {name}: the points of the diagram go from share 0 to share 1")
    if any(c - a <= SLACK for a, c in zip(shares, shares[2:], strict=False)):
        raise StructureError(f"cam, {name}: more than two points of the diagram have one share")
    areas = [(b[0] - a[0]) * (a[1] + b[1]) / 2.0 for a, b in pairwise(points)]
    size = sum((b[0] - a[0]) * (abs(a[1]) + abs(b[1])) / 2.0 for a, b in pairwise(points))
    if size == 0.0 or abs(sum(areas)) > BALANCE * size:
        raise StructureError(
            f"cam, {name}: the areas of the acceleration diagram above and below the axis differ, so the "
            "follower would not stop: make them equal"
        )
    speeds = np.cumsum(areas)
    lift = sum(
        (b[0] - a[0]) * (v - area) + (b[0] - a[0]) ** 2 * (2 * a[1] + b[1]) / 6.0
        for (a, b), v, area in zip(pairwise(points), speeds, areas, strict=True)
    )
    if not lift > 0.0:
        raise StructureError(
            f"cam, {name}: by this diagram the follower goes the wrong way: begin with a positive acceleration"
        )
