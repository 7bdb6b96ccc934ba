"""From the checked sections of gears and planetary train to the records of what is asked for."""

from __future__ import annotations

from graphic_tmm.chapters.gears.task import GearOrder
from graphic_tmm.chapters.planetary.task import Limits, PlanetaryOrder
from graphic_tmm.scene.wheel_tables import GearsTable, PlanetaryTable


def gears(table: GearsTable) -> GearOrder:
    """Return what the section of a pair of gears asks for."""
    return GearOrder(
        z1=table.z1,
        z2=table.z2,
        m=table.m,
        x1=table.x1,
        x2=table.x2,
        alpha=table.alpha,
        ha=table.ha,
        c=table.c,
        delta_y=table.delta_y,
        steps=table.steps,
        stations=table.stations,
        mu=table.mu_l,
        mu_sliding=table.mu_theta,
    )


def planetary(table: PlanetaryTable) -> PlanetaryOrder:
    """Return what the section of a planetary train asks for."""
    return PlanetaryOrder(
        scheme=table.scheme,
        module=table.module,
        speed=table.speed,
        driving=table.driving,
        ratio=table.ratio,
        tolerance=table.tolerance,
        teeth=table.teeth,
        satellites=table.satellites,
        module_2=table.module_2,
        alpha=table.alpha,
        ha=table.ha,
        c=table.c,
        limits=Limits(table.least, table.most, table.ring_most),
        mu_l=table.mu_l,
        mu_v=table.mu_v,
        pole=table.pole,
    )
