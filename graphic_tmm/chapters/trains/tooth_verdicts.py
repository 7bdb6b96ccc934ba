"""What is said of the tooth numbers of one train: every condition by name, with its numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from graphic_tmm.chapters.trains import bevel_formulas as bevel
from graphic_tmm.chapters.trains import tooth_conditions as c
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.refusals import scheme_of
from graphic_tmm.chapters.trains.task import Mesh, PlanetaryTask, Scheme, Train, module_ratio
from graphic_tmm.chapters.trains.tooth_conditions import Teeth, Truths
from graphic_tmm.language.said import said

CONDITIONS = ("ratio", "coaxial", "neighbours", "assembly", "undercut", "interference")
"""The names of the conditions, in the order in which they are checked."""


class Verdict(NamedTuple):
    """One condition as checked.

    Attributes
    ----------
    condition : str
        One of `CONDITIONS`.
    of : str
        The wheel ("1"), or the mesh ("3-2"), that it speaks of; "" for the whole train. A common axis is one of
        the wheel whose shift makes up for it.
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
    def noteworthy(self) -> bool:
        """Whether it is told though it holds: of a wheel that is cut with a shift."""
        return not self.holds or (self.condition == "coaxial" and self.of != "")

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
    scheme, found = train.scheme, [*_ratio(order, train)]
    for pair in scheme.pairs:
        z, q = _teeth(train, pair), module_ratio(order) if pair.rows == 2 else Fraction(1)
        single = len(pair.meshes) == 1
        if pair.bevel:
            found += [*_bevel(order, train, q), _assembly(pair, train.satellites, z)]
            continue
        if not (single and c.coaxial(pair, z, q)):
            found.append(_coaxial(order, pair, z, q))
        if pair == scheme.pairs[-1]:
            found.append(_neighbours(order, Train(pair, (), train.satellites), z, q))
        if not single:
            found.append(_assembly(pair, train.satellites, z))
        found += [*_undercut(order, pair, z), *_interference(order, pair, z)]
    return tuple(dict.fromkeys([*found, *_shaft_beside(order, train)]))


def _teeth(train: Train, pair: Scheme) -> Teeth:
    z = dict(zip(train.scheme.wheels, train.teeth, strict=True))
    return c.in_two_rows(pair, [z[wheel] for wheel in pair.wheels])


def _said(fine: Truths) -> bool:
    return bool(fine[0])


def _whole(value: float) -> str:
    return f"{value:g}".replace("-", "−")


def _wheel(scheme: Scheme, name: str) -> str:
    """Return the number of a wheel of the scheme, of its name in the form of two rows."""
    return c.in_places(scheme)[int(name[1]) - 1]


def _ratio(order: PlanetaryTask, train: Train) -> tuple[Verdict, ...]:
    motion = motion_of(order)
    rates = c.held_rates(train.scheme, dict(zip(train.scheme.wheels, train.teeth, strict=True)))
    if not motion.fixed:
        one, other = motion.driving if motion.closing is None else ("1", motion.last)
        if rates[one] == rates[other]:
            says = said(
                "ratio: with the carrier held both central wheels turn alike: the train is locked"
            )
            return (Verdict("ratio", "", False, math.inf, says),)
        if motion.closing is None:
            return ()
        rates = c.closed_rates(motion, rates)[0] | {motion.fixed: Fraction(0)}
    found, name = float(c.ratio_of(motion, rates)), f"U_{motion.first}{motion.driven}"
    holds = bool(c.fits(order, np.asarray(found)))
    if order.ratio is None:
        if holds:
            return ()
        size = "∞" if found else "0"
        stands = said("ratio: {name} = {found}: a shaft stands", name=name, found=size)
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


def _coaxial(order: PlanetaryTask, scheme: Scheme, z: Teeth, q: Fraction) -> Verdict:
    (z1,), (z2,), (z3,), (z4,) = z
    first, second = z1 + scheme.first * z2, float(q) * (z4 + scheme.second * z3)
    signs = ["+" if sense > 0 else "−" for sense in (scheme.first, scheme.second)]
    sides = [f"{z1} {signs[0]} {z2}", f"{z4} {signs[1]} {z3}"]
    if q != 1:
        sides[1] = f"({sides[1]})·{_whole(float(q))}"
    holds = _said(c.coaxial(scheme, z, q))
    fault = (
        said(" is another distance of the axes") if first > 0 else said(": no distance of the axes")
    )
    wheel = scheme.meshes[-1].wheel if _said(c.shifted(order, scheme, z)) else ""
    if wheel:
        fault = said(
            ": wheel {wheel} is cut with a shift, the satellite meshes with both", wheel=wheel
        )
    text = said(
        "coaxial: {first} = {distance}, {second} = {other}{fault}",
        first=sides[0],
        distance=_whole(first),
        second=sides[1],
        other=_whole(second),
        fault="" if holds else fault,
    )
    return Verdict("coaxial", wheel, holds or wheel != "", float(second), text)


def _neighbours(order: PlanetaryTask, train: Train, z: Teeth, q: Fraction) -> Verdict:
    scheme, k = train.scheme, train.satellites
    (z1,), (z2,), _, _ = z
    holds = _said(c.neighbours(scheme, z, k, q, order.ha))
    if k == 1:
        alone = said("neighbours: a single satellite has none")
        return Verdict("neighbours", "", holds, math.inf, alone)
    (axes,), (tips,) = c.room(scheme, z, k, q, order.ha)
    sign = "+" if scheme.first > 0 else "−"
    touch = said(" is not greater than {tips:g}: satellites touch", tips=tips)
    text = said(
        "neighbours: {formula} = {axes:.5g}{relation}",
        formula=f"({z1} {sign} {z2})·sin(180°/{k})",
        axes=axes,
        relation=f" > {tips:g}" if holds else touch,
    )
    return Verdict("neighbours", "", holds, float(axes), text)


def _assembly(scheme: Scheme, k: int, z: Teeth) -> Verdict:
    number, holds = c.assembly(scheme, z, k), _said(c.assembles(scheme, z, k))
    (found,) = number.results()
    text = said(
        "assembly: {formula} = {sign}{found:.6g} is {whole}",
        formula=number.said(),
        sign="−" if found < 0 else "",
        found=abs(found),
        whole=said("whole", context="assembly") if holds else said("not whole", context="assembly"),
    )
    return Verdict("assembly", "", holds, float(found), text)


def _undercut(order: PlanetaryTask, scheme: Scheme, z: Teeth) -> tuple[Verdict, ...]:
    made = []
    for name in c.external(scheme):
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
    for ring, rim in c.internal(scheme):
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
        holds = _said(c.clear_roots(outer, inner, order.alpha, order.ha))
        text = said(
            "interference: {number} = {teeth}: its tips are {where} the roots of {inner} teeth",
            number=f"z{names[0]}",
            teeth=outer[0],
            where=said("clear of", context="tips") if holds else said("in", context="tips"),
            inner=inner[0],
        )
        made.append(Verdict("interference", mesh, holds, float(outer[0]), text))
    return tuple(made)


def _shaft_beside(order: PlanetaryTask, train: Train) -> Iterator[Verdict]:
    """Yield that the shaft from one side of a closed differential to the other goes through the train."""
    if "1" not in (name for name, _ in order.closed):
        return
    (_, row), *_ = order.closed
    apart = 0.5 * order.module * (2 * sum(row) - row[0] - row[-1])
    (most,) = c.size(order, train.scheme, _teeth(train, train.scheme), module_ratio(order))
    reach = 0.5 * order.module * float(most)
    if apart <= reach:
        text = said(
            "interference: the shaft that closes the differential runs {apart:.4g} mm off the axis, through "
            "the wheels, which reach out to {reach:.4g} mm; take more teeth for those on it",
            apart=1000.0 * apart,
            reach=1000.0 * reach,
        )
        yield Verdict("interference", "closed", False, apart, text)


def _bevel(order: PlanetaryTask, train: Train, q: Fraction) -> Iterator[Verdict]:
    """Yield what is broken of bevel wheels: flat cones, rims clear of wheels, neighbours."""
    (first, last), k = train.scheme.meshes, train.satellites
    z = dict(zip(train.scheme.wheels, train.teeth, strict=True))
    if train.scheme.rows == 1:
        wide = _flat(first.wheel, last.wheel, first.rim, z)
        yield from wide
        if wide:
            return
    else:
        radii = {w: z[w] * (q if w in last[:2] else 1) for w in z}
        for mesh, other in ((first, last), (last, first)):
            yield from _rim(order, mesh, other, radii)
    if k == 1:
        return
    for rim, (between, tips) in bevel.tip_cones(train, float(q), order.ha).items():
        text = said(
            "neighbours: their axes are {between:.4g}° apart, not more than the {tips:.4g}° of the tip cone of "
            "rim {rim}: satellites touch; take fewer, or smaller ones",
            between=between,
            tips=tips,
            rim=rim,
        )
        if between <= tips:
            yield Verdict("neighbours", rim, False, between, text)


def _flat(one: str, other: str, rim: str, z: Mapping[str, int]) -> tuple[Verdict, ...]:
    """Return that the larger central wheel would have to be more than flat to touch the satellite."""
    if z[one] < z[other]:
        one, other = other, one
    found, most = z[one] * (z[one] - z[other]), 2 * z[rim] ** 2
    if found <= most:
        return ()
    text = said(
        "coaxial: z{one}·(z{one} − z{other}) = {found} is more than 2·z{rim}² = {most}: wheel {one} would be "
        "more than flat, its cone would be wider than 90°; take more teeth for the satellite",
        one=one,
        other=other,
        rim=rim,
        found=found,
        most=most,
    )
    return (Verdict("coaxial", "", False, float(found), text),)


def _rim(
    order: PlanetaryTask, mesh: Mesh, other: Mesh, z: Mapping[str, Fraction | int]
) -> Iterator[Verdict]:
    """Yield that a rim reaches past the other one, and the wheel there past its own; ``z``: first modules."""
    rim, past, wheel, own = names = (mesh.rim, other.rim, other.wheel, mesh.wheel)
    a, b, c, d = (500.0 * order.module * float(z[name]) for name in names)
    if z[rim] >= z[past] and z[wheel] >= z[own] and (z[rim], z[wheel]) != (z[past], z[own]):
        text = said(
            "interference: rim {rim} cuts into wheel {wheel}: r{rim} = {a:.4g} is not less than r{past} = "
            "{b:.4g} mm, r{wheel} = {c:.4g} not less than r{own} = {d:.4g} mm",
            rim=rim, past=past, wheel=wheel, own=own, a=a, b=b, c=c, d=d,
        )  # fmt: skip
        yield Verdict("interference", f"{wheel}-{rim}", False, a, text)
