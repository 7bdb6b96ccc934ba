"""What a value was taken for though it does not say so: numbers without a unit, weights for masses."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from graphic_tmm.language.said import Said, said
from graphic_tmm.scene import quantities
from graphic_tmm.scene.units import UNITS, plain_unit


class _Usual(NamedTuple):
    """Between which sizes numbers in SI stand in task sheets; in which units other numbers are given there.

    ``low``: what a number below ``least`` may be in, ``high``: one above ``most``.
    """

    si: str
    least: float
    low: str
    most: float
    high: str


_USUAL = {
    "length": _Usual("m", 1e-4, "", 10.0, "mm"),
    "angular speed": _Usual("rad/s", 0.0, "", 30.0, "rpm"),
    "angular acceleration": _Usual("rad/s^2", 0.0, "", 1e4, "deg/s^2"),
    "acceleration": _Usual("m/s^2", 0.0, "", 100.0, "mm/s^2"),
    "mass": _Usual("kg", 0.0, "", 1e3, "g"),
    "force": _Usual("N", 10.0, "kN", 1e7, "N"),
    "moment": _Usual("N*m", 0.0, "", 1e5, "N*mm"),
    "moment of inertia": _Usual("kg*m^2", 0.0, "", 100.0, "kg*cm^2"),
    "pressure": _Usual("Pa", 1e3, "MPa", 1e9, "Pa"),
    "density": _Usual("kg/m^3", 100.0, "g/cm^3", 1e5, "kg/m^3"),
    "scale of lengths": _Usual("m/mm", 0.0, "", 0.5, "mm/mm"),
}
"""Of machines in courses and in print: 30 rad/s is 286 rpm, where turns a minute begin to be given."""
_RADIANS = math.pi / 12
"""A bare angle that is a whole number of these (15°) to three digits was meant in radians."""


def taken(value: object, dimension: str) -> Iterator[Said]:
    """Yield, a line each, how a value of a dimension was understood where it leaves that open."""
    if dimension == "mass" and isinstance(value, str) and (weight := _weight(value)):
        yield weight
    known = dimension == "angle" or dimension in _USUAL  # a number of a link may have any length
    numbers = [number for number in _numbers(value) if number] if known else []
    if not numbers:
        return
    if dimension == "angle":
        told = [number for number in numbers if _in_radians(number)]
        if len(told) == len(numbers):
            yield _doubt(told[0], "deg", "rad")
    if usual := _USUAL.get(dimension):
        largest = max(numbers, key=abs)
        if abs(largest) > usual.most:
            yield _doubt(largest, usual.si, usual.high)
        elif abs(largest) < usual.least:
            yield _doubt(largest, usual.si, usual.low or "mm")


def _numbers(value: object) -> Iterator[float]:
    """Yield the numbers without a unit in a value and its lists."""
    if isinstance(value, list):
        for item in value:
            yield from _numbers(item)
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield float(value)


def _in_radians(number: float) -> bool:
    parts = abs(number) / _RADIANS
    return number != round(number) and 1 <= round(parts) <= 24 and abs(parts - round(parts)) < 5e-3


def _doubt(number: float, si: str, other: str) -> Said:
    if si == other:
        return said(
            "{number:g} without a unit is {number:g} {si}; write it with the unit that is meant",
            number=number,
            si=si,
        )
    size = number * float(UNITS[plain_unit(si)].factor) / float(UNITS[plain_unit(other)].factor)
    return said(
        '{number:g} without a unit is {number:g} {si} = {size:.10g} {other}; write "{number:g} {other}" '
        'if that is meant, else "{number:g} {si}"',
        number=number,
        si=si,
        size=float(f"{size:.4g}"),
        other=other,
    )


def _weight(value: str) -> Said | None:
    """Return how a weight was taken; a kgf is a kg, and a lbf a lb, without a word."""
    try:
        weight = quantities.in_si(value, "force")
    except ValueError:
        return None
    g = quantities.gravity()
    return (
        None
        if quantities.in_kgf(value)
        else said(
            '"{value}" is a weight: m = G/g = {mass:.4g} kg, with g = {g:.6g} m/s²',
            value=value,
            mass=weight / g,
            g=g,
        )
    )


def grouped(told: Iterable[tuple[str, str]]) -> Iterator[Said]:
    """Yield what is told of keys, that of one kind once: its first key, and how many others there are."""
    kinds: dict[tuple[str, object], list[tuple[str, Said]]] = {}
    for key, says in told:
        assert isinstance(says, Said)
        kinds.setdefault((says.template, says.values.get("si", says)), []).append((key, says))
    for (key, says), *others in kinds.values():
        if others:
            yield said(
                "{key} (and {n} more key): {says}",
                "{key} (and {n} more keys): {says}",
                key=key,
                says=says,
                n=len(others),
            )
        else:
            yield said("{key}: {says}", key=key, says=says)
