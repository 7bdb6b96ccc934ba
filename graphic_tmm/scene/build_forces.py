"""From the checked sections of effects, loads, forces and friction to the record of what is asked for."""

from __future__ import annotations

from graphic_tmm.chapters.engine.task import EngineOrder
from graphic_tmm.chapters.forces.task import AGAINST, GRAVITY, ForcesOrder, Friction, Load, Travel
from graphic_tmm.chapters.indicator.task import IndicatorOrder
from graphic_tmm.mechanism.masses import pins
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.scene.force_tables import (
    EffectsTable,
    EngineTable,
    ForcesTable,
    FrictionTable,
    LoadTable,
)


def forces(
    table: ForcesTable,
    effects: EffectsTable,
    loads: list[LoadTable],
    rubbing: FrictionTable | None,
    indicator: IndicatorOrder | None,
    mechanism: Mechanism,
) -> ForcesOrder:
    """Return what the sections ask for; an effect that is not named leaves nothing behind."""
    return ForcesOrder(
        positions=table.positions,
        loads=tuple(_load(load) for load in loads),
        gravity=effects.gravity,
        inertia=effects.inertia,
        gas=indicator if effects.gas else None,
        friction=_friction(rubbing, mechanism) if effects.friction and rubbing else None,
        balance=table.balance,
        couples=table.couples,
        single=table.single,
        limit=table.limit,
        mu=table.mu_F,
        g=GRAVITY if effects.g is None else effects.g,
    )


def engine(table: EngineTable, gas: IndicatorOrder) -> EngineOrder:
    """Return what the section of the engine asks for."""
    return EngineOrder(
        gas, table.point, table.share, table.mass, table.inertia == "series", table.unit, table.base
    )


def _load(table: LoadTable) -> Load:
    size: float | tuple[float, ...] = 0.0
    for told in (table.force, table.moment, table.by_position):
        size = told if told is not None else size
    direction: float | str = 0.0 if table.direction is None else table.direction
    travel = None
    if table.of is not None:
        travel = Travel(table.of, table.out or (), table.back or ())
    return Load(
        link=table.link,
        point=table.point,
        size=size,
        direction=AGAINST if table.resists else direction,
        by_angle=table.by_angle or (),
        travel=travel,
    )


def _friction(table: FrictionTable, mechanism: Mechanism) -> Friction:
    """Return the coefficient and the radius of every pair, its own or the common one."""
    guides = [slide.guide.name for link in mechanism.links for slide in link.slides]
    bodies, joined = (mechanism.frame, *mechanism.links), pins(mechanism)
    turning = [k for k in dict.fromkeys(k for link in bodies for k in link.points) if k in joined]
    return Friction(
        {name: table.pairs.get(name, table.f) for name in (*turning, *guides)},
        {name: table.radii.get(name, table.radius or 0.0) for name in turning},
        table.passes,
    )
