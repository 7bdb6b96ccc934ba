"""The conditions on the tooth numbers of a planetary train, for many trains at once; given ones checked."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.trains import formulas as f
from graphic_tmm.chapters.trains.motion import Motion, motion_of
from graphic_tmm.chapters.trains.task import PlanetaryTask, Scheme, Train, module_ratio

Whole = NDArray[np.int64]
Truths = NDArray[np.bool_]
SLACK = 1e-12
"""A ratio that misses its tolerance by less than this share of itself is within it: it is rounding."""


class Teeth(NamedTuple):
    """Tooth numbers in the form of two rows, (n,) each."""

    z1: Whole
    z2: Whole
    z3: Whole
    z4: Whole

    def at(self, where: Any) -> Teeth:
        """Return the trains that an index or a mask names."""
        return Teeth(*(z[where] for z in self))


class Calculated(NamedTuple):
    """A formula of the plan and what it is worked out on: of many trains at once, or of one."""

    op: Operation
    values: tuple[Any, ...]

    def results(self) -> Reals:
        """Return the results, (n,)."""
        with np.errstate(all="ignore"):
            result: Reals = self.op.run(*self.values)
        return result

    def said(self) -> str:
        """Return the formula with the numbers of one train put in."""
        numbers = (int(np.ravel(value)[0]) for value in self.values)
        return self.op.formula.format(**dict(zip(self.op.arguments, numbers, strict=True)))


def in_two_rows(scheme: Scheme, teeth: Sequence[int]) -> Teeth:
    """Return the tooth numbers of one train in the form of two rows, (1,)."""
    z = dict(zip(scheme.wheels, teeth, strict=True))
    return Teeth(*(np.array([z[wheel]], dtype=np.int64) for wheel in in_places(scheme)))


def in_places(scheme: Scheme) -> tuple[str, str, str, str]:
    """Return the wheels that stand for z1 … z4, of the first mesh and of the last."""
    first, last = scheme.meshes[0], scheme.meshes[-1]
    return first.wheel, first.rim, last.rim, last.wheel


def of_wheels(scheme: Scheme, z: Teeth) -> Whole:
    """Return the tooth numbers of the wheels of the scheme, (n, wheels)."""
    return np.stack(z if scheme.rows == 2 else (z.z1, z.z2, z.z4), axis=-1)


def held_rates(scheme: Scheme, z: Mapping[str, Any]) -> dict[str, Any]:
    """Return whole numbers, by body: with the carrier held angular velocities are as they are (Willis).

    ``z``: tooth numbers by the wheel; a satellite is called by its first rim.
    """
    whole = math.prod(z[mesh.wheel] for mesh in scheme.meshes)
    rates = {m.wheel: -m.sense * z[m.rim] * (whole // z[m.wheel]) for m in scheme.meshes}
    return rates | {"H": 0 * whole, scheme.rims[0]: whole}


def rates_of(train: Train, motion: Motion) -> tuple[dict[str, Any], float]:
    """Return the rates with the carrier held, and times how much (1/s) its members have them as they move."""
    rates = held_rates(train.scheme, dict(zip(train.scheme.wheels, train.teeth, strict=True)))
    if motion.closing is not None:
        relative, spin = closed_rates(motion, rates)
        return rates, float(motion.driving[motion.first] / relative[motion.first] * spin)
    known = dict(motion.driving) | ({motion.fixed: 0.0} if motion.fixed else {})
    (one, at_one), (other, at_other) = known.items()
    return rates, (at_one - at_other) / (rates[one] - rates[other])


def closed_rates(motion: Motion, rates: Mapping[str, Any]) -> tuple[dict[str, Fraction], Fraction]:
    """Return how members of a closed differential turn by each other; times how much they have their rates."""
    assert motion.closing is not None
    joint, other, ratio = motion.closing
    spin, carrier = 1 - ratio, ratio * rates[joint] - rates[other]
    return {name: carrier + spin * rate for name, rate in rates.items()}, spin


def stands_still(train: Train, motion: Motion) -> bool:
    """Return whether what is driven stands, all but rounding, while others move."""
    rates, spin = rates_of(train, motion)
    own: float = motion.driving[motion.first] + spin * (rates[motion.driven] - rates[motion.first])
    return abs(own) <= SLACK * max(map(abs, motion.driving.values()))


def ratio(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> NDArray[np.float64]:
    """Return driving over driven angular velocity, (n,); ∞ where the driven shaft stands."""
    teeth = dict(zip(in_places(scheme), z, strict=True))
    return ratio_of(motion_of(order), held_rates(scheme, teeth))


def ratio_of(motion: Motion, rates: Mapping[str, Any]) -> NDArray[np.float64]:
    """Return driving over driven angular velocity of the rates with the carrier held; as `ratio`."""
    above, below = (
        np.asarray(rates[name] - rates[motion.fixed]) for name in (motion.first, motion.driven)
    )
    moves = below != 0
    return np.asarray(np.where(moves, above / np.where(moves, below, 1), np.inf))


def within(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> Truths:
    """Return whether the ratio is the one wanted, within its tolerance; any that moves if none is wanted."""
    return fits(order, ratio(order, scheme, z))


def fits(order: PlanetaryTask, found: NDArray[np.float64]) -> Truths:
    """Return whether a ratio is the one wanted; as `within`."""
    if order.ratio is None:
        return np.asarray(np.isfinite(found) & (found != 0.0))
    allowed = (order.tolerance + SLACK) * abs(order.ratio)
    return np.asarray(np.abs(found - order.ratio) <= allowed)


def coaxial(scheme: Scheme, z: Teeth, q: Fraction) -> Truths:
    """Return whether both rows have one distance of axes."""
    first, second = z.z1 + scheme.first * z.z2, z.z4 + scheme.second * z.z3
    return np.asarray((first * q.denominator == second * q.numerator) & (first > 0))


def shifted(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> Truths:
    """Return whether one wide satellite meshes with both wheels, the last one cut with a shift (Ferguson).

    Both rims are alike. cos α_w = cos α·(z4 + z3)/(z1 + z2) and inv α_w give the shift x_Σ, the distance of
    axes y: teeth of full height keep some of their clearance c where 0 ≤ x_Σ − y ≤ c.
    """
    if scheme.rows == 1 or scheme.bevel or scheme.first < 0 or scheme.second < 0:
        return np.zeros(z.z1.shape, dtype=np.bool_)
    alpha, own, due = math.radians(order.alpha), z.z4 + z.z3, z.z1 + z.z2
    cosine = math.cos(alpha) * own / due
    there = (cosine > 0.0) & (cosine <= 1.0)
    angle = np.arccos(np.where(there, cosine, 1.0))
    shift = own * (np.tan(angle) - angle - math.tan(alpha) + alpha) / (2.0 * math.tan(alpha))
    less = shift - (due - own) / 2.0
    alike = (z.z2 == z.z3) & (z.z1 != z.z4) & (module_ratio(order) == 1)
    return np.asarray(there & (less >= 0.0) & (less <= order.c) & alike)


def neighbours(scheme: Scheme, z: Teeth, k: Any, q: Fraction, ha: float) -> Truths:
    """Return whether the tips of neighbouring satellites stand clear of each other; ``k``: int, or (n,)."""
    between, tips = room(scheme, z, k, q, ha)
    return np.asarray((between > tips) | (np.asarray(k) == 1))


def room(scheme: Scheme, z: Teeth, k: Any, q: Fraction, ha: float) -> tuple[Reals, Reals]:
    """Return the distance of the axes of neighbouring satellites, and what their tips take of it, modules."""
    to_axis = f.axes_outside if scheme.first > 0 else f.axes_inside
    axes = Calculated(to_axis, (1.0, z.z1, z.z2)).results()
    between = Calculated(f.neighbouring_axes, (axes, np.asarray(k))).results()
    tips = [Calculated(f.tip_diameter, (m, rim, ha)) for m, rim in ((1.0, z.z2), (float(q), z.z3))]
    return between, np.maximum(*(tip.results() for tip in tips))


def assembly(scheme: Scheme, z: Teeth, k: Any) -> Calculated:
    """Return the number of the assembly: satellites all alike can be put in evenly if it is whole.

    The central wheel 1, turned until the next place stands where the first one did, must find a satellite
    there turned by whole teeth of its rim 3.
    """
    if scheme.rows == 1:
        return Calculated(f.assembly_of_row, (z.z1, z.z4, k))
    op = f.assembly_opposed if scheme.opposed else f.assembly_alike
    return Calculated(op, (*z, k, f.common_divisor.run(z.z2, z.z3)))


def assembles(scheme: Scheme, z: Teeth, k: Any) -> Truths:
    """Return whether ``k`` satellites can be put in evenly: a quotient that is not whole is far from it."""
    found = assembly(scheme, z, k).results()
    return np.asarray(found == np.rint(found))


def external(scheme: Scheme) -> tuple[str, ...]:
    """Return which of z1 … z4 are wheels with external teeth."""
    first = ("z1",) if scheme.first > 0 else ()
    second = ("z4",) if scheme.second > 0 else ()
    return (*first, "z2", *(("z3",) if scheme.rows == 2 else ()), *second)


def internal(scheme: Scheme) -> tuple[tuple[str, str], ...]:
    """Return the rings among z1 … z4, each with the satellite's rim inside it."""
    first = (("z1", "z2"),) if scheme.first < 0 else ()
    return (*first, *((("z4", "z3"),) if scheme.second < 0 else ()))


def uncut(scheme: Scheme, z: Teeth, least: int) -> Truths:
    """Return whether no wheel with external teeth has fewer than ``least``."""
    return np.asarray(np.all([getattr(z, name) >= least for name in external(scheme)], axis=0))


def has_least_ring(rim: float, alpha: float, ha: float) -> bool:
    """Return whether some ring is clear of a rim: of very few teeth none is."""
    return 2.0 * rim * math.sin(math.radians(alpha)) ** 2 > 4.0 * ha


def clear_roots(ring: Whole, rim: Whole, alpha: float, ha: float) -> Truths:
    """Return whether the tips of a ring end where the involutes of the rim inside it begin, or before.

    The tip circle of the ring then cuts the line of action outside the rim's base circle:
    (z_r − 2h_a*)² ≥ (z_r·cos α)² + ((z_r − z_s)·sin α)². No ring is clear of a rim of very few teeth.
    """
    return np.asarray(ring >= Calculated(f.least_ring, (rim, alpha, ha)).results())


def meshes(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> Truths:
    """Return whether no ring fouls the satellites inside it, at their roots or with its tips."""
    fine = np.ones(z.z1.shape, dtype=np.bool_)
    for ring, rim in internal(scheme):
        outer, inner = getattr(z, ring), getattr(z, rim)
        fine &= outer - inner >= order.limits.difference
        fine &= clear_roots(outer, inner, order.alpha, order.ha)
    return fine


def size(order: PlanetaryTask, scheme: Scheme, z: Teeth, q: Fraction) -> NDArray[np.float64]:
    """Return the diameter about the main axis that the teeth of all wheels take, in modules, (n,).

    Wheels and satellites reach to their tips, rings to the roots of their teeth.
    """
    tip, root, second = 2.0 * order.ha, 2.0 * (order.ha + order.c), float(q)
    satellites = np.maximum(z.z2 + tip, second * (z.z3 + tip))
    centre = (z.z1 + (tip if scheme.first > 0 else root)) * 1.0
    fixed = second * (z.z4 + (tip if scheme.second > 0 else root))
    about = z.z1 + scheme.first * z.z2 + satellites
    return np.asarray(np.maximum(np.maximum(centre, fixed), about))
