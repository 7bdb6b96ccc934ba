"""Given tooth numbers of a planetary train, checked condition by condition, each with its verdict."""

from __future__ import annotations

import math
from typing import NamedTuple

from graphic_tmm.chapters.planetary import tooth_conditions as c
from graphic_tmm.chapters.planetary.task import (
    PlanetaryTask,
    Scheme,
    Train,
    module_ratio,
    scheme_of,
)
from graphic_tmm.chapters.planetary.tooth_conditions import Teeth, Truths
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


def check(order: PlanetaryTask, train: Train) -> tuple[Verdict, ...]:
    """Return the verdict of every condition on a train; the ratio is one if the order wants it.

    Raises
    ------
    StructureError
        If the order is not sound.
    """
    scheme_of(order)
    scheme, z = train.scheme, c.in_two_rows(train.scheme, train.teeth)
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
    found, name = float(c.ratio(order, scheme, z)[0]), "U_1H" if order.driving == "1" else "U_H1"
    holds = _said(c.within(order, scheme, z))
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
    holds = _said(c.coaxial(scheme, z, q))
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


def _assembly(train: Train, z: Teeth) -> Verdict:
    scheme, k = train.scheme, train.satellites
    number, holds = c.assembly(scheme, z, k), _said(c.assembles(scheme, z, k))
    (found,) = number.found()
    text = said(
        "assembly: {formula} = {found:.6g} is {whole}",
        formula=number.said(),
        found=found,
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
