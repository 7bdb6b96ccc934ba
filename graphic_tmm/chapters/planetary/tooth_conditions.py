"""The conditions on the tooth numbers of a planetary train, for many trains at once; given ones checked."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.planetary import formulas as f
from graphic_tmm.chapters.planetary.motion import motion_of
from graphic_tmm.chapters.planetary.refusals import scheme_of
from graphic_tmm.chapters.planetary.task import PlanetaryTask, Scheme, Train, module_ratio
from graphic_tmm.language.said import said

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
    z = teeth if scheme.rows == 2 else (teeth[0], teeth[1], teeth[1], teeth[2])
    return Teeth(*(np.array([n], dtype=np.int64) for n in z))


def of_wheels(scheme: Scheme, z: Teeth) -> Whole:
    """Return the tooth numbers of the wheels of the scheme, (n, wheels)."""
    return np.stack(z if scheme.rows == 2 else (z.z1, z.z2, z.z4), axis=-1)


def member_rates(scheme: Scheme, z: Teeth, fixed: str) -> dict[str, Whole]:
    """Return whole numbers, by member, as the angular velocities are to each other while one member stands.

    With the carrier held those of the central wheels are as u : v (Willis).
    """
    u, v = scheme.first * scheme.second * z.z2 * z.z4, z.z1 * z.z3
    last = scheme.wheels[-1]
    if fixed == "H":
        return {"1": u, last: v}
    return {last: u - v, "H": u} if fixed == "1" else {"1": v - u, "H": v}


def ratio(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> NDArray[np.float64]:
    """Return driving over driven angular velocity, (n,); ∞ where the driven shaft stands."""
    motion = motion_of(order)
    rates = member_rates(scheme, z, motion.fixed)
    above, below = rates[motion.first], rates[motion.driven]
    moves = below != 0
    return np.asarray(np.where(moves, above / np.where(moves, below, 1), np.inf))


def within(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> Truths:
    """Return whether the ratio is the one wanted, within its tolerance; any that moves if none is wanted."""
    found = ratio(order, scheme, z)
    if order.ratio is None:
        return np.asarray(np.isfinite(found) & (found != 0.0))
    allowed = (order.tolerance + SLACK) * abs(order.ratio)
    return np.asarray(np.abs(found - order.ratio) <= allowed)


def coaxial(scheme: Scheme, z: Teeth, q: Fraction) -> Truths:
    """Return whether both rows have one distance of axes."""
    first, second = z.z1 + scheme.first * z.z2, z.z4 + scheme.second * z.z3
    return np.asarray((first * q.denominator == second * q.numerator) & (first > 0))


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


CONDITIONS = ("ratio", "coaxial", "neighbours", "assembly", "undercut", "interference")
"""The names of the conditions, in the order in which they are checked."""


class Verdict(NamedTuple):
    """One condition as checked.

    Attributes
    ----------
    condition : str
        One of `CONDITIONS`.
    of : str
        The wheel ("1"), or the mesh ("3-2"), that it speaks of; "" for the whole train.
    holds : bool
        Whether it is fulfilled.
    found : float
        What was found: the ratio, the number C of the assembly, tooth numbers, lengths in modules of the first
        row.
    text : str
        The condition with its numbers, in words.
    """

    condition: str
    of: str
    holds: bool
    found: float
    text: str

    @property
    def stands(self) -> bool:
        """Whether a shaft of the train cannot move."""
        return self.condition == "ratio" and (self.found == 0.0 or not math.isfinite(self.found))


def check(order: PlanetaryTask, train: Train) -> tuple[Verdict, ...]:
    """Return the verdict of every condition on a train; the ratio is one if the order wants it.

    Raises
    ------
    StructureError
        If the order is not sound.
    """
    scheme_of(order)
    scheme, z = train.scheme, in_two_rows(train.scheme, train.teeth)
    return (
        *_ratio(order, scheme, z),
        _coaxial(order, scheme, z),
        _neighbours(order, train, z),
        _assembly(train, z),
        *_undercut(order, scheme, z),
        *_interference(order, scheme, z),
    )


def _said(fine: Truths) -> bool:
    return bool(fine[0])


def _whole(value: float) -> str:
    return f"{value:g}"


def _wheel(scheme: Scheme, name: str) -> str:
    """Return the number of a wheel of the scheme, of its name in the form of two rows."""
    if scheme.rows == 2:
        return name[1]
    return {"z1": "1", "z2": "2", "z3": "2", "z4": "3"}[name]


def _ratio(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> tuple[Verdict, ...]:
    motion = motion_of(order)
    if not motion.fixed:
        u, v = member_rates(scheme, z, "H").values()
        if motion.driven != "H" or u[0] != v[0]:
            return ()
        says = said(
            "ratio: with the carrier held both central wheels turn alike: the train is locked"
        )
        return (Verdict("ratio", "", False, math.inf, says),)
    found, name = float(ratio(order, scheme, z)[0]), f"U_{motion.first}{motion.driven}"
    holds = _said(within(order, scheme, z))
    if order.ratio is None:
        if holds:
            return ()
        stands = said("ratio: {name} = {found:g}: a shaft stands", name=name, found=found)
        return (Verdict("ratio", "", False, found, stands),)
    miss = 100.0 * (found / order.ratio - 1.0)
    text = said(
        "ratio: {name} = {found:.6g} is {miss:+.2g} % from {wanted:g}, {relation} {percent:.3g} %",
        name=name,
        found=found,
        miss=miss,
        wanted=order.ratio,
        relation=said("within", context="tolerance")
        if holds
        else said("not within", context="tolerance"),
        percent=100.0 * order.tolerance,
    )
    return (Verdict("ratio", "", holds, found, text),)


def _coaxial(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> Verdict:
    q = module_ratio(order)
    (z1,), (z2,), (z3,), (z4,) = z
    first, second = z1 + scheme.first * z2, float(q) * (z4 + scheme.second * z3)
    signs = ["+" if sense > 0 else "−" for sense in (scheme.first, scheme.second)]
    sides = [f"{z1} {signs[0]} {z2}", f"{z4} {signs[1]} {z3}"]
    if q != 1:
        sides[1] = f"({sides[1]})·{_whole(float(q))}"
    holds = _said(coaxial(scheme, z, q))
    fault = (
        said(" is another distance of the axes") if first > 0 else said(": no distance of the axes")
    )
    text = said(
        "coaxial: {first} = {distance}, {second} = {other}{fault}",
        first=sides[0],
        distance=_whole(first),
        second=sides[1],
        other=_whole(second),
        fault="" if holds else fault,
    )
    return Verdict("coaxial", "", holds, float(second), text)


def _neighbours(order: PlanetaryTask, train: Train, z: Teeth) -> Verdict:
    scheme, k, q = train.scheme, train.satellites, module_ratio(order)
    (z1,), (z2,), _, _ = z
    holds = _said(neighbours(scheme, z, k, q, order.ha))
    if k == 1:
        alone = said("neighbours: a single satellite has none")
        return Verdict("neighbours", "", holds, math.inf, alone)
    (axes,), (tips,) = room(scheme, z, k, q, order.ha)
    sign = "+" if scheme.first > 0 else "−"
    touch = said(" is not greater than {tips:g}: satellites touch", tips=tips)
    text = said(
        "neighbours: {formula} = {axes:.5g}{relation}",
        formula=f"({z1} {sign} {z2})·sin(180°/{k})",
        axes=axes,
        relation=f" > {tips:g}" if holds else touch,
    )
    return Verdict("neighbours", "", holds, float(axes), text)


def _assembly(train: Train, z: Teeth) -> Verdict:
    scheme, k = train.scheme, train.satellites
    number, holds = assembly(scheme, z, k), _said(assembles(scheme, z, k))
    (found,) = number.results()
    text = said(
        "assembly: {formula} = {found:.6g} is {whole}",
        formula=number.said(),
        found=found,
        whole=said("whole", context="assembly") if holds else said("not whole", context="assembly"),
    )
    return Verdict("assembly", "", holds, float(found), text)


def _undercut(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> tuple[Verdict, ...]:
    made = []
    for name in external(scheme):
        (count,), wheel = getattr(z, name), _wheel(scheme, name)
        holds = bool(count >= order.limits.least)
        text = said(
            "undercut: {number} = {count} is {relation} {least}",
            number=f"z{wheel}",
            count=count,
            relation=said("not less than", context="teeth")
            if holds
            else said("less than", context="teeth"),
            least=order.limits.least,
        )
        made.append(Verdict("undercut", wheel, holds, float(count), text))
    return tuple(made)


def _interference(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> tuple[Verdict, ...]:
    made = []
    for ring, rim in internal(scheme):
        outer, inner = getattr(z, ring), getattr(z, rim)
        names = _wheel(scheme, ring), _wheel(scheme, rim)
        mesh = "-".join(names)
        between, least = int(outer[0] - inner[0]), order.limits.difference
        holds = between >= least
        text = said(
            "interference: {difference} = {between} is {relation} {least}",
            difference=f"z{names[0]} − z{names[1]}",
            between=between,
            relation=said("not less than", context="teeth")
            if holds
            else said("less than", context="teeth"),
            least=least,
        )
        made.append(Verdict("interference", mesh, holds, float(between), text))
        holds = _said(clear_roots(outer, inner, order.alpha, order.ha))
        text = said(
            "interference: {number} = {teeth}: its tips are {where} the roots of {inner} teeth",
            number=f"z{names[0]}",
            teeth=outer[0],
            where=said("clear of", context="tips") if holds else said("in", context="tips"),
            inner=inner[0],
        )
        made.append(Verdict("interference", mesh, holds, float(outer[0]), text))
    return tuple(made)
