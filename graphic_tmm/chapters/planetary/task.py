"""What is asked of a planetary train 2K–H: its scheme, its ratio or its tooth numbers, limits (SI).

Two central wheels on the main axis, satellites on a carrier H. Wheel 1 meshes with the satellites' rim 2, their
rim 3 with the other central wheel 4, which is fixed. In a single row the satellites have one rim, 2, and the
fixed ring is wheel 3.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType

from graphic_tmm.bounds import PLANETARY, POSITIVE, Bound, OrderError
from graphic_tmm.chapter import Asked


@dataclass(frozen=True)
class Scheme:
    """One of the four usual schemes: its name, the senses of its two meshes, its rows.

    ``first``, ``second``: +1 where the wheels of the mesh both have external teeth, −1 where the central wheel
    is a ring.
    """

    name: str
    first: int
    second: int
    rows: int

    @property
    def wheels(self) -> tuple[str, ...]:
        """The wheels by their numbers; the last one is fixed."""
        return ("1", "2", "3", "4")[: self.rows + 2]

    @property
    def opposed(self) -> bool:
        """Whether, with the carrier held, the central wheels turn in opposite senses."""
        return self.first * self.second < 0


SCHEMES: Mapping[str, Scheme] = MappingProxyType(
    {
        scheme.name: scheme
        for scheme in (
            Scheme("ring", 1, -1, 1),
            Scheme("external-internal", 1, -1, 2),
            Scheme("external-external", 1, 1, 2),
            Scheme("internal-internal", -1, -1, 2),
        )
    }
)
"""The schemes by name."""


@dataclass(frozen=True)
class Limits:
    """Limits on tooth numbers: ``least`` and ``most`` of a wheel with external teeth, ``ring_most`` of a ring.

    ``least`` is the number that is cut without undercut: 17 for α = 20°, h_a* = 1. ``difference``: by how much
    a ring has more teeth than the satellite inside it at the least, so that their tips pass each other.
    """

    least: int = 17
    most: int = 150
    ring_most: int = 300
    difference: int = 8


@dataclass(frozen=True)
class PlanetaryOrder:
    """A planetary train that is wanted, or that is given to be checked and drawn.

    Parameters
    ----------
    scheme : str
        "ring", "external-internal", "external-external" or "internal-internal".
    module : float
        Module of the first row, m.
    speed : float
        Angular velocity of the driving shaft, rad/s, with its sign.
    driving : str
        "1" or "H": the shaft that drives; the other one is driven.
    ratio : float, optional
        The ratio wanted: driving over driven angular velocity, U_1H or U_H1, with its sign.
    tolerance : float
        By what share of itself the ratio may be missed.
    teeth : tuple of (int or None)
        A tooth number for every wheel of the scheme, None for one that is to be found; () for all of them.
    satellites : tuple of int
        Numbers of satellites that are allowed.
    module_2 : float, optional
        Module of the second row, m; that of the first if left out.
    alpha, ha, c : float
        Pressure angle (degrees), factors of the addendum and of the clearance.
    mu_l, mu_v : float, optional
        Scale factors, m/mm and (m/s)/mm; standard ones are chosen if left out.
    pole : float, optional
        Pole distance of the plan of angular velocities, mm; a round one is chosen if left out.
    """

    scheme: str
    module: float
    speed: float
    driving: str = "1"
    ratio: float | None = None
    tolerance: float = 0.01
    teeth: tuple[int | None, ...] = ()
    satellites: tuple[int, ...] = (3,)
    module_2: float | None = None
    alpha: float = 20.0
    ha: float = 1.0
    c: float = 0.25
    limits: Limits = Limits()
    mu_l: float | None = None
    mu_v: float | None = None
    pole: float | None = None


@dataclass(frozen=True)
class Train:
    """A train that is settled: its scheme, a tooth number for every wheel, the number of satellites."""

    scheme: Scheme
    teeth: tuple[int, ...]
    satellites: int


def scheme_of(order: PlanetaryOrder) -> Scheme:
    """Return the scheme of a sound order.

    Raises
    ------
    OrderError
        If the scheme is not one of the four, or anything asked for is no quantity of a train.
    """
    scheme = SCHEMES.get(order.scheme)
    if scheme is None:
        raise OrderError(
            "planetary", "scheme", f'no scheme "{order.scheme}": take one of {", ".join(SCHEMES)}'
        )
    _refuse_sizes(order, scheme)
    _refuse_counts(order, scheme)
    _refuse_ratio(order)
    return scheme


def module_ratio(order: PlanetaryOrder) -> Fraction:
    """Return module_2/module as the ratio of small whole numbers that it is."""
    if order.module_2 is None:
        return Fraction(1)
    return Fraction(order.module_2 / order.module).limit_denominator(1000)


def _refuse(key: str, message: str) -> OrderError:
    return OrderError("planetary", key, message)


def _bounded(key: str, value: object, bound: Bound | None = None) -> None:
    """Refuse a value outside the bounds of a key, or outside others."""
    (PLANETARY[key] if bound is None else bound).refuse("planetary", key, value)


def _refuse_sizes(order: PlanetaryOrder, scheme: Scheme) -> None:
    for name, value in (
        ("module", order.module),
        ("module_2", order.module_2),
        ("mu_l", order.mu_l),
        ("mu_v", order.mu_v),
        ("pole", order.pole),
    ):
        if value is not None:
            _bounded(name, value, POSITIVE)
    for name in ("alpha", "ha", "c"):
        _bounded(name, getattr(order, name))
    if not (math.isfinite(order.speed) and order.speed != 0.0):
        raise _refuse(
            "speed", f"the driving shaft turns at {order.speed}: give its angular velocity"
        )
    if order.driving not in ("1", "H"):
        raise _refuse(
            "driving", f'wheel "{order.driving}" cannot drive: take "1" or "H", the other is driven'
        )
    if order.module_2 is None:
        return
    if scheme.rows == 1:
        raise _refuse("module_2", "a single row has one module: leave module_2 out")
    if abs(order.module * float(module_ratio(order)) - order.module_2) > 1e-9 * order.module_2:
        raise _refuse(
            "module_2",
            f"modules of {order.module:g} and {order.module_2:g} m have no simple ratio: "
            "take standard ones",
        )


def _refuse_counts(order: PlanetaryOrder, scheme: Scheme) -> None:
    if order.teeth and len(order.teeth) != len(scheme.wheels):
        raise _refuse(
            "teeth",
            f'scheme "{scheme.name}" has wheels {", ".join(scheme.wheels)}, '
            f"not {len(order.teeth)}: give a tooth number for each, or none",
        )
    for z in order.teeth:
        if z is not None:
            _bounded("teeth", z)
    if not order.satellites:
        raise _refuse("satellites", "no number of satellites is allowed: give one, such as 3")
    for k in order.satellites:
        _bounded("satellites", k)
    limits = order.limits
    for name in ("least", "most", "ring_most", "difference"):
        _bounded(name, getattr(limits, name), PLANETARY["least"])
    if limits.least > limits.most:
        raise _refuse("least", f"from {limits.least} to {limits.most} there is no tooth number")


def _refuse_ratio(order: PlanetaryOrder) -> None:
    if order.ratio is None:
        if not order.teeth or None in order.teeth:
            raise _refuse(
                "ratio", "neither a ratio nor all tooth numbers are given: give one of them"
            )
        return
    _bounded("ratio", order.ratio)
    if order.ratio == 0.0:
        raise _refuse("ratio", "a ratio of 0 is none")
    _bounded("tolerance", order.tolerance)


ASKED: Asked[PlanetaryOrder] = Asked("planetary")
