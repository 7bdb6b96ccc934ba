"""What makes no sense of a cam is refused before anything is drawn."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from graphic_tmm.bounds import POSITIVE, TaskError
from graphic_tmm.chapters.cam.read_off import (
    EVEN,
    WHOLE,
    areas,
    balanced,
    legible,
    plain,
    risen,
)
from graphic_tmm.chapters.cam.task import (
    BY_DIAGRAM,
    CamTask,
    FlatFollower,
    Law,
    RockerFollower,
    names,
)
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import bound_of

TURN = 360.0
"""A turn, degrees."""
SLACK = 1e-9
"""Degrees, or shares of a phase, that differ by less are the same. Far above rounding, far below what a
protractor shows."""


def refuse(order: CamTask) -> None:
    """Refuse what makes no sense.

    Raises
    ------
    StructureError
        Which says what to change, and by which key of a scene.
    """
    phases = (order.rise, order.upper_dwell, order.fall, order.lower_dwell)
    told = " + ".join(f"{angle:g}" for angle in phases)
    moving = sum(phases[:3])
    if moving <= TURN and abs(moving + order.lower_dwell - TURN) > 1e-6:
        says = said(
            "the phases {told} make {sum:g}°, not 360°: change the lower dwell to {dwell:g}°",
            told=told,
            sum=sum(phases),
            dwell=TURN - moving,
        )
        raise TaskError("cam", "lower_dwell", says)
    for name in ("rise", "upper_dwell", "fall"):
        _bounded(name, getattr(order, name))
    if moving > TURN + 1e-6:
        says = said(
            "the phases {told} make {sum:g}°, not 360°: shorten them", told=told, sum=sum(phases)
        )
        raise TaskError("cam", "rise", says)
    _bounded("lower_dwell", order.lower_dwell)
    _refuse_sizes(order)
    for key, law, extent in (
        ("law", order.rise_law, order.rise),
        ("return_law", order.return_law, order.fall),
    ):
        _refuse_law(key, law, WHOLE * extent / TURN)


def _bounded(key: str, value: object) -> None:
    """Refuse a value outside the bounds of a key."""
    bound_of(CamTask, key).refuse("cam", key, value)


def _refuse_sizes(order: CamTask) -> None:
    sizes = {
        name: getattr(order, name) for name in ("stroke", "r0", "roller", "base", "height", "mu_l")
    }
    follower = order.follower
    if isinstance(follower, RockerFollower):
        sizes |= {"lever": follower.lever, "centres": follower.centres}
    for name, value in sizes.items():
        if value is not None:
            _bounded(name, value)
    others = {"mu_S": order.mu_S, "mu_dS": order.mu_V, "mu_ddS": order.mu_A, "speed": order.speed}
    for name, value in (*others.items(), *(("H", pole) for pole in order.poles)):
        if value is not None:
            POSITIVE.refuse("cam", name, value)
    if isinstance(follower, RockerFollower) and order.stroke >= math.pi:
        says = said(
            "a lever that rocks by {stroke:g}° turns over: take less than 180°",
            stroke=math.degrees(order.stroke),
        )
        raise TaskError("cam", "stroke", says)
    _refuse_choices(order)


def _refuse_choices(order: CamTask) -> None:
    follower = order.follower
    if isinstance(follower, FlatFollower):
        _bounded("least_curvature", follower.least)
    for name in ("pressure", "pressure_return", "share_of_r0", "share_of_curvature"):
        value = getattr(order, name)
        if value is not None:
            _bounded(name, value)
    for count in (order.divisions, order.per_turn):
        if count is not None:
            _bounded("parts", count)
    if order.turns not in ("clockwise", "counterclockwise"):
        raise StructureError(
            said('it turns "{turns}": take "clockwise" or "counterclockwise"', turns=order.turns),
            "cam.turns",
            head="cam",
        )


def _refuse_law(key: str, law: Law, base: float) -> None:
    """Refuse a law that is none; ``base``: how long its phase is on paper, mm."""
    if law.name not in names():
        raise TaskError(
            "cam",
            key,
            said('no law "{name}": take one of {listed}', name=law.name, listed=", ".join(names())),
        )
    if law.name != BY_DIAGRAM:
        if law.points:
            raise TaskError("cam", key, said('points belong to the law "diagram" only'))
        return
    if says := _fault_of(law, base):
        raise TaskError("cam", {"law": "law_points", "return_law": "return_points"}[key], says)


def _fault_of(law: Law, base: float) -> str:
    """Return what is wrong with the points of an acceleration diagram; "" if nothing is."""
    points, shares = law.points, [share for share, _ in law.points]
    if len(points) < 2 or not np.isfinite(points).all():
        return said("an acceleration diagram needs two points at least")
    if (
        any(b < a - SLACK for a, b in pairwise(shares))
        or abs(shares[0]) + abs(shares[-1] - 1) > SLACK
    ):
        return said("the points of the diagram go from share 0 to share 1")
    whole, size = areas(points)
    if not size > 2.0 * abs(whole) or abs(whole) > max(legible(points, base), EVEN * size):
        return said(
            "the areas of the acceleration diagram above and below the axis differ, so the follower would not "
            "stop: make them equal"
        )
    if not risen(balanced(plain(points))[0])[0] > 0.0:
        return said(
            "by this diagram the follower goes the wrong way: begin with a positive acceleration"
        )
    return ""
