"""The rim of a flywheel: largest diameter by the speed limit, chosen diameters, mass, width."""

from __future__ import annotations

import math
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import largest_rim, mean, rim_mass, rim_width, share
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import accepted
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.flywheel.task import Rim
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said

_ROUND = said("Sizes are made in round numbers; all that follows is calculated with what is made.")
WIDEST = 0.5
"""A rim wider than this share of its outer diameter is a drum."""
STEP = 0.05
"""Diameters are advised in such steps, m."""


@dataclass(frozen=True)
class DrawnRim:
    """The rim's sizes as marks (Number): limit, outer, inner and mean diameter (m), mass (kg), width (m)."""

    order: Rim
    limit: Mark
    outer: Mark
    inner: Mark
    mean: Mark
    mass: Mark
    width: Mark


def draw_rim(
    draft: Draft,
    inertia: Mark,
    omega: Mark,
    speed: float,
    order: Rim,
    section: str = "flywheel",
) -> DrawnRim:
    """Calculate the rim; ``omega``: the mark of ω1, ``speed`` its value (1/s).

    Raises
    ------
    StructureError
        If the diameter chosen runs faster than the material allows, or the rim has no thickness.
    """
    if order.inner is not None and not 0.0 < order.inner < order.outer:
        says = said("it leaves no rim: make it smaller than D_e")
        raise StructureError(says, f"{section}.D_i", head=section)
    if not 0.0 < order.ratio < 1.0:
        raise StructureError(
            said(
                "D_i/D_e = {ratio:g} leaves no rim: choose a ratio between 0 and 1, such as 0.85",
                ratio=order.ratio,
            ),
            f"{section}.ratio",
            head=section,
        )
    most = 2.0 * order.speed_limit / abs(speed)
    if order.outer > most:
        raise StructureError(
            said(
                "a rim of {outer:g} m runs faster than {limit:g} m/s at this speed: D_e is "
                "{most:.3g} m at most",
                outer=order.outer,
                limit=order.speed_limit,
                most=most,
            ),
            f"{section}.D_e",
            head=section,
        )
    limit = draft.take(Number, "v_{max}", order.speed_limit, "m/s")
    largest = draft.draw(largest_rim, "D_{max}", limit, omega, unit="m")
    outer = draft.take(Number, "D_e", order.outer, "m")
    ratio = draft.take(Number, "k", order.ratio)
    inner = draft.draw(share, "D_i" if order.inner is None else "D_{i0}", outer, ratio, unit="m")
    if order.inner is not None:
        told = draft.take(Number, "", order.inner, "m")
        inner = draft.draw(accepted, "D_i", told, unit="m", why=_ROUND)
    middle = draft.draw(mean, "D_m", outer, inner, unit="m")
    mass = draft.draw(rim_mass, "m_r", inertia, middle, unit="kg")
    density = draft.take(Number, "ρ", order.density, "kg/m³")
    width = draft.draw(rim_width, "b", inertia, density, outer, inner, middle, unit="m")
    return DrawnRim(order, largest, outer, inner, middle, mass, width)


def wanted_outer(outer: float, width: float) -> float | None:
    """Return the outer diameter (m) at which a rim is not too wide; None where it is not as it stands.

    The same moment of inertia at the same D_i/D_e makes the width fall with the fourth power of the diameter.
    """
    if not width > WIDEST * outer:
        return None
    least: float = (width * outer**4 / WIDEST) ** 0.2
    return STEP * math.ceil(least / STEP - 1e-9)
