"""The tooth numbers of a planetary train: all that fulfil every condition, the smallest train first.

Of two rows z1, z2 and z3 are free and z4 follows from the common distance of the axes. The ratio wanted leaves
only a few z3 to each z1 and z2, so no train is looked at that misses it by much.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.chapters.trains import tooth_conditions as c
from graphic_tmm.chapters.trains.motion import Motion, motion_of
from graphic_tmm.chapters.trains.refusals import scheme_of
from graphic_tmm.chapters.trains.task import PlanetaryTask, Scheme, Train, module_ratio
from graphic_tmm.chapters.trains.tooth_conditions import Teeth, Truths, Whole
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said


@dataclass(frozen=True, eq=False)
class Solutions:
    """Trains that fulfil all conditions, ranked by size, then by how well they meet the ratio.

    Attributes
    ----------
    scheme : Scheme
        Their scheme.
    teeth : ndarray of int64, (n, wheels)
        A tooth number for every wheel.
    satellites : ndarray of int64, (n,)
        Numbers of satellites.
    ratio : ndarray of float, (n,)
        Driving over driven angular velocity.
    size : ndarray of float, (n,)
        The diameter that the teeth take about the main axis, m.
    """

    scheme: Scheme
    teeth: Whole
    satellites: Whole
    ratio: NDArray[np.float64]
    size: NDArray[np.float64]

    def __len__(self) -> int:
        """How many there are."""
        return int(self.satellites.size)

    def train(self, rank: int = 0) -> Train:
        """Return one of them, the smallest by default."""
        z = tuple(int(n) for n in self.teeth[rank])
        return Train(self.scheme, z, int(self.satellites[rank]))


Left = tuple[str, int]


def search(order: PlanetaryTask) -> Solutions:
    """Return all trains with the ratio that fulfil the conditions, none if there is none.

    Raises
    ------
    StructureError
        If the order is not sound, or wants no ratio and leaves tooth numbers open.
    """
    return _search(order)[0]


def choose(order: PlanetaryTask) -> Train:
    """Return the smallest train of an order, or the one whose tooth numbers it gives.

    Teeth that are given may break conditions (`check` tells them), but the train has to close and to move.

    Raises
    ------
    StructureError
        If the tooth numbers given close no train, or there are none to be found (which condition leaves none is
        told).
    """
    scheme = scheme_of(order)
    if order.teeth and None not in order.teeth:
        return _checked(order, scheme)
    found, left = _search(order)
    if len(found):
        return found.train()
    at = [count for _, count in left].index(0)
    name, before = left[at][0], left[at - 1][1]
    raise StructureError(
        said(
            'no train of scheme "{scheme}" {wanted}: {remedy}',
            scheme=scheme.name,
            wanted=_wanted(order),
            remedy=_emptied(name, before),
        ),
        "planetary.ratio",
        "planetary.teeth",
        head="planetary",
    )


def _wanted(order: PlanetaryTask) -> str:
    motion = motion_of(order)
    name = f"U_{motion.first}{motion.driven}"
    given = "".join(f", z{i} = {z}" for i, z in enumerate(order.teeth, 1) if z is not None)
    return said(
        "has {name} = {ratio:g} within {percent:.3g} %{given}",
        name=name,
        ratio=order.ratio,
        percent=100.0 * order.tolerance,
        given=given,
    )


_REMEDIES = {
    "ratio": said(
        "none reaches the ratio: allow a larger tolerance or more teeth, or take another scheme"
    ),
    "undercut": said("all are undercut: allow a lesser number of teeth"),
    "interference": said("rings foul satellites: take another scheme or more teeth"),
    "neighbours": said("neighbouring satellites touch: take fewer"),
    "assembly": said("the satellites cannot be put in evenly: allow another number of them"),
}


def _emptied(name: str, before: int) -> str:
    remedy = _REMEDIES[name]
    if name == "ratio":
        return remedy
    return said("of {n} left till then, {remedy}", n=before, remedy=remedy)


def _checked(order: PlanetaryTask, scheme: Scheme) -> Train:
    """Return the train given, with the number of satellites that breaks the fewest conditions."""
    teeth = tuple(z for z in order.teeth if z is not None)
    broken = {
        k: [one for one in check(order, Train(scheme, teeth, k)) if not one.holds]
        for k in order.satellites
    }
    best = min(broken, key=lambda k: len(broken[k]))
    none = [
        one.text for one in broken[best] if (one.condition, one.of) == ("coaxial", "") or one.stands
    ]
    if none:
        says = joined(" ", (", ".join(map(str, teeth)), joined("; ", none)))
        raise StructureError(says, "planetary.teeth", head="planetary")
    return Train(scheme, teeth, best)


def _search(order: PlanetaryTask) -> tuple[Solutions, list[Left]]:
    """Return the solutions, and how many trains each condition left."""
    scheme, q = scheme_of(order), module_ratio(order)
    if order.ratio is None:
        raise StructureError(
            said("tooth numbers are sought, but no ratio is wanted: give it"),
            "planetary.ratio",
            head="planetary",
        )
    z = _candidates(order, scheme, q)
    z = z.at(c.within(order, scheme, z) & _within_limits(order, scheme, z))
    left = [("ratio", z.z1.size)]
    z = z.at(c.uncut(scheme, z, order.limits.least))
    left.append(("undercut", z.z1.size))
    z = z.at(c.meshes(order, scheme, z))
    left.append(("interference", z.z1.size))
    counts = np.array(sorted(set(order.satellites)), dtype=np.int64)
    k, z = np.repeat(counts, z.z1.size), z.at(np.tile(np.arange(z.z1.size), counts.size))
    kept = c.neighbours(scheme, z, k, q, order.ha)
    k, z = k[kept], z.at(kept)
    left.append(("neighbours", k.size))
    kept = c.assembles(scheme, z, k)
    k, z = k[kept], z.at(kept)
    left.append(("assembly", k.size))
    return _ranked(order, scheme, z, k, q), left


def _ranked(order: PlanetaryTask, scheme: Scheme, z: Teeth, k: Whole, q: Fraction) -> Solutions:
    assert order.ratio is not None
    sizes, ratios = c.size(order, scheme, z, q), c.ratio(order, scheme, z)
    miss = np.abs(ratios - order.ratio)
    rank = np.lexsort((z.z4, z.z3, z.z2, z.z1, -k, miss.round(12), sizes.round(9)))
    teeth = c.of_wheels(scheme, z)[rank]
    return Solutions(scheme, teeth, k[rank], ratios[rank], sizes[rank] * order.module)


def _bounds(order: PlanetaryTask, scheme: Scheme) -> list[tuple[int, int]]:
    """Return from where to where z1 … z4 are sought; a given one is sought at its own place only."""
    limits, rings = order.limits, {ring for ring, _ in c.internal(scheme)}
    given = dict(zip(scheme.wheels, order.teeth, strict=False))
    names = ("1", "2", "3", "4") if scheme.rows == 2 else ("1", "2", "2", "3")
    found = []
    for place, wheel in enumerate(names, 1):
        z = given.get(wheel)
        most = limits.ring_most if f"z{place}" in rings else limits.most
        found.append((limits.least, most) if z is None else (z, z))
    return found


def _within_limits(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> Truths:
    inside = [
        (n >= low) & (n <= high) for n, (low, high) in zip(z, _bounds(order, scheme), strict=True)
    ]
    return np.asarray(np.all(inside, axis=0))


def _candidates(order: PlanetaryTask, scheme: Scheme, q: Fraction) -> Teeth:
    """Return the trains with one distance of axes whose ratio may be the one wanted."""
    (low1, high1), (low2, high2), third, _ = _bounds(order, scheme)
    grid = np.mgrid[low1 : high1 + 1, low2 : high2 + 1].reshape(2, -1)
    z1, z2 = grid[0].astype(np.int64), grid[1].astype(np.int64)
    if scheme.rows == 1:
        return Teeth(z1, z2, z2, z1 + 2 * z2)
    axes = z1 + scheme.first * z2
    sum4, rest = np.divmod(axes * q.denominator, q.numerator)
    whole = (rest == 0) & (axes > 0)
    z1, z2, sum4 = z1[whole], z2[whole], sum4[whole]
    low, high = _window(order, scheme, Teeth(z1, z2, sum4, sum4), third)
    count = np.maximum(high - low + 1, 0)
    start = np.repeat(np.cumsum(count) - count, count)
    z3 = np.repeat(low, count) + np.arange(count.sum()) - start
    z1, z2, sum4 = (np.repeat(n, count) for n in (z1, z2, sum4))
    return Teeth(z1, z2, z3, sum4 - scheme.second * z3)


def _held(motion: Motion, ratio: float) -> float:
    """Return the ratio of wheel 1 to the last one while the carrier is held, of the ratio of a train."""
    if motion.first == "H" or (motion.fixed == "H" and motion.first != "1"):
        ratio = 1.0 / ratio
    if motion.fixed == "H":
        return ratio
    if motion.fixed == "1":
        return 1.0 / (1.0 - ratio) if ratio != 1.0 else math.inf
    return 1.0 - ratio


def _window(
    order: PlanetaryTask, scheme: Scheme, z: Teeth, third: tuple[int, int]
) -> tuple[Whole, Whole]:
    """Return the least and the most z3 of each z1, z2 that can give the ratio; ``z.z3``: z4 ± z3.

    z4/z3 = (z4 ± z3)/z3 ∓ 1 falls as z3 grows and never reaches ∓1; the ends are taken one wider than they
    come out.
    """
    assert order.ratio is not None
    ends = [order.ratio * (1.0 + sign * (order.tolerance + c.SLACK)) for sign in (-1.0, 1.0)]
    held = [_held(motion_of(order), end) for end in ends]
    shares = sorted(scheme.first * scheme.second * one for one in held)
    if shares[0] < 0.0 < shares[1] or not np.isfinite(shares).all():
        shares = [0.0, math.inf]
    found = []
    for share in shares[::-1]:
        steep = share * z.z1 / z.z2 + scheme.second
        found.append(z.z3 / np.where(steep > 0.0, steep, 1e-9))
    low, high = np.floor(found[0]) - 1, np.ceil(found[1]) + 1
    low = np.clip(low, third[0], third[1] + 1)
    high = np.clip(high, third[0] - 1, third[1])
    return low.astype(np.int64), high.astype(np.int64)
