"""What makes no sense of a cam is refused before it is drawn; how far a diagram read off paper may be off."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.bounds import POSITIVE, TaskError
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.kinds_spring import NO_SPEED
from graphic_tmm.chapters.cam.task import CamTask, RockerFollower
from graphic_tmm.chapters.cam.task_motion import (
    BY_DIAGRAM,
    BY_TABLE,
    EVEN_SHARES,
    NO_LINES,
    SHARED,
    TURN,
    Law,
    Stage,
    names,
    refuse_phases,
    size_of,
)
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import bound_of

READ = 0.5
"""What a ruler leaves open on a diagram, mm: half of its division."""
HIGH, WHOLE = 40.0, 240.0
"""The largest ordinate of the acceleration diagram, and the turn on the one that was read, mm."""
EVEN = 1e-6
"""Areas of an acceleration diagram that differ by less than this share of themselves are equal."""
LEADS = 10.0
"""By so many strokes a spring is compressed in the lowest place at most: beyond, its line is all but level."""
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


def keys_of_law(order: CamTask, motion: Stage) -> tuple[str, str]:
    """Return the keys of a scene that tell the law of a phase, and its points."""
    if order.phases:
        return "phase", "phase"
    name = motion.law.name if motion.law is not None else ""
    of = {SHARED: "shares", BY_TABLE: "table"}.get(name, "points")
    if motion.sign > 0:
        return "law", of if name == SHARED else f"law_{of}"
    return "return_law", f"return_{of}"


def refuse(order: CamTask) -> None:
    """Refuse what makes no sense.

    Raises
    ------
    StructureError
        Which says what to change, and by which key of a scene.
    """
    if order.phases:
        refuse_phases(order.phases, rocks=order.rocks, slides=order.slides)
    else:
        _refuse_turn(order)
    _refuse_sizes(order)
    for motion in order.stages:
        if motion.law is not None:
            _refuse_law(keys_of_law(order, motion), motion.law, WHOLE * motion.angle / order.whole)
            if motion.law.name == BY_TABLE and (says := _fault_of_table(order, motion)):
                raise TaskError("cam", keys_of_law(order, motion)[1], says)


def _refuse_turn(order: CamTask) -> None:
    """Refuse phases of the usual cam that do not make a turn."""
    if order.slides:
        _bounded("rise", order.rise)
        return
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
    if isinstance(follower, FlatRockerFollower):
        sizes |= {"face": follower.face, "centres": follower.centres}
    for name, value in sizes.items():
        if value is not None:
            _bounded(name, value)
    others = {"mu_S": order.mu_S, "mu_dS": order.mu_V, "mu_ddS": order.mu_A, "speed": order.speed}
    for name, value in (*others.items(), *(("H", pole) for pole in order.poles)):
        if value is not None:
            POSITIVE.refuse("cam", name, value)
    if order.rocks and order.stroke >= math.pi:
        says = said(
            "a lever that rocks by {stroke:g}° turns over: take less than 180°",
            stroke=math.degrees(order.stroke),
        )
        raise TaskError("cam", "stroke", says)
    _refuse_choices(order)


def _refuse_choices(order: CamTask) -> None:
    _bounded("least_curvature", order.allowed_rho)
    if order.spring is not None:
        _bounded("reserve", order.spring.reserve)
        if order.speed is None:
            raise TaskError("cam", "speed", NO_SPEED)
        lead = order.spring.lead
        if lead is not None and not 0.0 < lead <= LEADS * order.stroke:
            says = said("it is greater than 0, and {most:g} strokes at most", most=LEADS)
            raise TaskError("cam", "lead", says)
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


def _refuse_law(keys: tuple[str, str], law: Law, base: float) -> None:
    """Refuse a law that is none; ``keys`` as `keys_of_law`; ``base``: how long its phase is on paper, mm."""
    if law.name not in names():
        raise TaskError(
            "cam",
            keys[0],
            said('no law "{name}": take one of {listed}', name=law.name, listed=", ".join(names())),
        )
    if law.shares != EVEN_SHARES and law.name != SHARED:
        raise TaskError(
            "cam", keys[0], said("only the law of constant acceleration has shares; leave them out")
        )
    if law.size and law.name != BY_TABLE:
        raise TaskError(
            "cam", keys[0], said('only {law} = "table" takes a table; leave it out', law="law")
        )
    if law.name != BY_DIAGRAM:
        if law.points and law.name != BY_TABLE:
            raise TaskError("cam", keys[0], said('points belong to the law "diagram" only'))
        return
    if fault := _fault_of(law, base):
        raise TaskError("cam", keys[1], fault)


def _fault_of_table(order: CamTask, motion: Stage) -> str:
    """Return what is wrong with the table of a phase; "" if nothing is."""
    assert motion.law is not None
    points, steps = motion.law.points, bound_of(CamTask, "parts")
    if not points:
        return NO_LINES
    shares, heights = ([one[k] for one in points] for k in (0, 1))
    if not steps.holds(len(points) - 1):
        return said(
            "a table of displacements has {least} to {most} steps, not {steps}",
            least=int(steps.least), most=int(steps.most), steps=len(points) - 1,
        )  # fmt: skip
    if abs(heights[0]) > EVEN or max(heights) > 1.0 + EVEN or min(heights) < -EVEN:
        return said(
            "the displacements of the table go from 0 to the stroke, or back, and not beyond"
        )
    if any(after - before <= EVEN for before, after in pairwise(shares)):
        return said("the first values of the lines of the table go up from line to line")
    for told, due in zip(motion.law.size, (motion.angle, motion.stroke or 0.0), strict=False):
        if abs(told - due) > EVEN * due:
            return said(
                "the table is {long} long and {high} high, its phase {angle} and {stroke}: make them the same",
                long=_extent_of(motion.law.size[0], order), high=size_of(motion.law.size[1], order.rocks),
                angle=_extent_of(motion.angle, order), stroke=size_of(motion.stroke or 0.0, order.rocks),
            )  # fmt: skip
    return ""


def _extent_of(value: float, order: CamTask) -> str:
    return size_of(value, rocks=False) if order.slides else f"{value:g}°"


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
