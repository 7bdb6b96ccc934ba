"""Planetary trains proven another way: rolling contacts as linear equations, teeth counted one by one."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator
from fractions import Fraction as F

import mpmath as mp  # type: ignore[import-untyped]

from graphic_tmm.chapters.trains.task import PlanetaryTask

SENSES = {
    "ring": (1, -1),
    "external-internal": (1, -1),
    "external-external": (1, 1),
    "internal-internal": (-1, -1),
}
"""+1: both wheels external; −1: the central one a ring. Of the mesh 1–2, and of the fixed wheel's."""

MESHES = {
    "ring": ("1+2", "3-2"),
    "external-internal": ("1+2", "4-3"),
    "external-external": ("1+2", "4+3"),
    "internal-internal": ("1-2", "4-3"),
    "external": ("1+2",),
    "internal": ("1-2",),
    "3K": ("1+2", "3-2", "5-4"),
}
"""Of every scheme: which central wheel touches which rim of the satellites, from outside (+) or as a ring."""

Four = tuple[int, int, int, int]


def four(scheme: str, teeth: tuple[int, ...]) -> Four:
    """Two rows; in a single row the rim 2 meshes with both central wheels."""
    if scheme == "ring":
        z1, z2, z3 = teeth
        return z1, z2, z2, z3
    z1, z2, z3, z4 = teeth
    return z1, z2, z3, z4


def radii(scheme: str, z: Four, q: F) -> tuple[F, F, F]:
    """Where A (1–2), B (the satellite's axis) and C (3–4) stand above the main axis, in modules."""
    first, _ = SENSES[scheme]
    return F(z[0], 2), F(z[0] + first * z[1], 2), q * F(z[3], 2)


def rates(scheme: str, z: Four, q: F = F(1)) -> tuple[F, F]:
    """Satellite and carrier over wheel 1, from pure rolling at A and at C: two linear equations.

    The satellite moves at A as wheel 1 does and stands at C, its axis moves with the carrier:
    ω_H·y_B + ω_2·(y_A − y_B) = ω_1·y_A and ω_H·y_B + ω_2·(y_C − y_B) = 0.
    """
    a, b, c = radii(scheme, z, q)
    satellite = a / (a - c)
    return satellite, (b - c) * satellite / b


def ratio(scheme: str, z: Four, driving: str, q: F = F(1)) -> F | None:
    """Driving over driven; None where the driven shaft stands."""
    a, _, c = radii(scheme, z, q)
    if a == c:  # A of wheel 1 is the point where the satellite stands: wheel 1 cannot move
        return F(0) if driving == "1" else None
    _, carrier = rates(scheme, z, q)
    return carrier if driving == "H" else 1 / carrier


def coaxial(scheme: str, z: Four, q: F) -> bool:
    first, second = SENSES[scheme]
    return F(z[0] + first * z[1]) == q * (z[3] + second * z[2]) and z[0] + first * z[1] > 0


def phases(scheme: str, z: Four, k: int) -> bool:
    """Whether k blocks, all alike, find teeth to mesh with at even places: their turns tried one by one.

    Angles in turns. Wheel 1 and the fixed wheel stand as the first block, at 0 and not turned, wants them. A
    block at θ turned by ψ meshes with wheel 1 where z1·(θ − φ1) + s·z2·(θ − ψ) is whole (s: the sense of the
    mesh), φ1 being free for the whole train; with the fixed one likewise. The carrier is set to the next place
    by turning it, so wheel 1 may stand anywhere that serves all places at once: φ1 = 0 serves the first.
    """
    first, second = SENSES[scheme]
    z1, z2, z3, z4 = z

    def fits(theta: F) -> bool:
        for n in range(z3):  # all turns at which the block meshes with the fixed wheel
            turn = theta + second * (z4 * theta - n) / z3
            if (z1 * theta + first * z2 * (theta - turn)).denominator == 1:
                return True
        return False

    return all(fits(F(place, k)) for place in range(k))


def involutes_begin(ring: int, rim: int, alpha: float, ha: float) -> bool:
    """Whether the ring's tip circle cuts the line of action before the rim's base circle touches it."""
    with mp.workdps(40):
        turn = mp.radians(alpha)
        limit = mp.hypot(mp.mpf(ring) / 2 * mp.cos(turn), mp.mpf(ring - rim) / 2 * mp.sin(turn))
        return bool(mp.mpf(ring) / 2 - ha >= limit)


def apart(scheme: str, z: Four, q: F, k: int, ha: float) -> bool:
    """Whether the tip circles of two neighbours do not meet, from their places in the plane."""
    if k == 1:
        return True
    _, reach, _ = radii(scheme, z, q)
    with mp.workdps(40):
        places = [reach * mp.expjpi(mp.mpf(2 * n) / k) for n in range(2)]
        tips = max(z[1] + 2 * F(ha), q * (z[2] + 2 * F(ha)))
        gap = abs(places[1] - places[0]) - mp.mpf(tips.numerator) / tips.denominator
        return bool(gap > mp.mpf(10) ** -30)


def sound(order: PlanetaryTask, z: Four, q: F, k: int) -> bool:
    """Whether a train fulfils every condition but the ratio."""
    first, second = SENSES[order.scheme]
    wheels = [z[1], z[2]] + [n for n, sense in ((z[0], first), (z[3], second)) if sense > 0]
    rings = [(c, s) for c, s, sense in ((z[0], z[1], first), (z[3], z[2], second)) if sense < 0]
    return (
        min(wheels) >= order.limits.least
        and all(c - s >= order.limits.difference for c, s in rings)
        and all(involutes_begin(c, s, order.alpha, order.ha) for c, s in rings)
        and coaxial(order.scheme, z, q)
        and phases(order.scheme, z, k)
        and apart(order.scheme, z, q, k, order.ha)
    )


def span(order: PlanetaryTask, z: Four, q: F) -> F:
    """The diameter that the teeth take about the main axis, in modules of the first row."""
    first, second = SENSES[order.scheme]
    out = {1: F(order.ha), -1: F(order.ha) + F(order.c)}
    _, reach, _ = radii(order.scheme, z, q)
    return 2 * max(
        F(z[0], 2) + out[first],
        q * (F(z[3], 2) + out[second]),
        reach + F(z[1], 2) + F(order.ha),
        reach + q * (F(z[2], 2) + F(order.ha)),
    )


def every(order: PlanetaryTask) -> Iterator[Four]:
    """All tooth numbers within the limits, in the form of two rows, whatever they are worth."""
    first, second = SENSES[order.scheme]
    limits = order.limits
    wheel = range(limits.least, limits.most + 1)
    ring = range(limits.least, limits.ring_most + 1)
    central = {1: wheel, -1: ring}
    if order.scheme == "ring":
        for z1, z2, z3 in itertools.product(wheel, wheel, ring):
            yield z1, z2, z2, z3
        return
    yield from itertools.product(central[first], wheel, wheel, central[second])


def brute_force(order: PlanetaryTask) -> set[tuple[Four, int]]:
    """All trains that fulfil every condition, with their numbers of satellites, tried one by one."""
    assert order.ratio is not None
    q = F(1) if order.module_2 is None else F(order.module_2 / order.module).limit_denominator(100)
    due, allowed = F(order.ratio), F(order.tolerance) * abs(F(order.ratio))
    found = set()
    for z in every(order):
        if not coaxial(order.scheme, z, q):
            continue
        u = ratio(order.scheme, z, order.driving, q)
        if u is None or abs(u - due) > allowed * (1 + F(1, 10**11)):
            continue
        found |= {(z, k) for k in order.satellites if sound(order, z, q, k)}
    return found


def is_close(a: float, b: float) -> bool:
    return math.isclose(a, b, rel_tol=1e-12)


def valid(draw: random.Random, scheme: str) -> PlanetaryTask:
    """A random train that fulfils every condition."""
    while True:
        k, q = draw.choice((2, 3, 4)), draw.choice((F(1), F(1), F(5, 4), F(4, 5)))
        z1, z2, z3 = draw.randint(17, 130), draw.randint(17, 80), draw.randint(17, 80)
        first, second = SENSES[scheme]
        if scheme == "ring":
            q, teeth = F(1), (z1, z2, z1 + 2 * z2)
        else:
            z4 = (z1 + first * z2) / q - second * z3
            if z4.denominator != 1 or z4 < 1 or z1 + first * z2 < 1:
                continue
            teeth = (z1, z2, z3, int(z4))
        order = PlanetaryTask(
            scheme, 0.004, draw.choice((-1, 1)) * draw.uniform(1.0, 500.0), draw.choice("1H"),
            teeth=teeth, satellites=(k,), module_2=None if q == 1 else 0.004 * float(q),
        )  # fmt: skip
        rows = four(scheme, teeth)
        u = ratio(scheme, rows, order.driving, q)
        if u and sound(order, rows, q, k):
            return order


def solved(scheme: str, teeth: tuple[int, ...], given: dict[str, F]) -> dict[str, F] | None:
    """ω of all bodies from two of them, by pure rolling in every mesh; None if there is no one answer.

    In a mesh at y the central wheel and the satellite move alike: ω_w·y = ω_H·y_B + ω_2·(y − y_B).
    """
    meshes = MESHES[scheme]
    z = dict(
        zip(sorted({name for mesh in meshes for name in (mesh[0], mesh[2])}), teeth, strict=True)
    )
    axis = F(z["1"] + (1 if meshes[0][1] == "+" else -1) * z["2"], 2)
    names = [*(mesh[0] for mesh in meshes), "H", "2"]
    rows = []
    for mesh in meshes:
        y = F(z[mesh[0]], 2)
        due = {mesh[0]: y, "H": -axis, "2": axis - y}
        rows.append([due.get(name, F(0)) for name in names] + [F(0)])
    rows += [[F(int(name == one)) for one in names] + [value] for name, value in given.items()]
    for k in range(len(names)):
        pivot = next((n for n in range(k, len(names)) if rows[n][k] != 0), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [one / rows[k][k] for one in rows[k]]
        for n in range(len(names)):
            if n != k:
                rows[n] = [x - rows[n][k] * y for x, y in zip(rows[n], rows[k], strict=True)]
    return {name: row[-1] for name, row in zip(names, rows, strict=True)}


def random_teeth(draw: random.Random, scheme: str) -> tuple[int, ...]:
    """Tooth numbers of one distance of axes, whether or not they can be made."""
    while True:
        z1, z2, z3 = (draw.randint(6, 60) for _ in range(3))
        if scheme == "ring":
            return z1, z2, z1 + 2 * z2
        if scheme == "3K":
            return z1, z2, z1 + 2 * z2, z3, z1 + z2 + z3
        if scheme in ("external", "internal"):
            return (z1, z2) if scheme == "external" else (z1 + z2, z2)
        first, second = SENSES[scheme]
        z4 = z1 + first * z2 - second * z3
        if z4 > 0 and z1 + first * z2 > 0:
            return z1, z2, z3, z4
