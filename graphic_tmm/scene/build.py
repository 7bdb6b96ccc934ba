"""From the checked sections of a file to the records of a scene."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from graphic_tmm.chapters.engine.task import EngineOrder
from graphic_tmm.chapters.forces.task import ForcesOrder
from graphic_tmm.mechanism.masses import shared
from graphic_tmm.mechanism.records import Drive, Extreme, Guide, Link, Mechanism, Row, Side, Slide
from graphic_tmm.scene import build_cam, build_forces, build_orders, build_wheels, geometry
from graphic_tmm.scene import models as m
from graphic_tmm.scene.checks import centres_of
from graphic_tmm.scene.force_tables import EffectsTable
from graphic_tmm.scene.records import (
    PART_PLACES,
    PLAN_PLACES,
    SECTIONS,
    Scales,
    Scene,
    SheetOrder,
    Task,
)
from graphic_tmm.scene.sections import Parts
from graphic_tmm.scene.values import CLOCKWISE, MU_L_OMEGA

DIVISIONS = {"exact": 0.1, "cad": 0.01, "careful": 0.1, "student": 0.5}
"""Divisions of the rulers of named hands, mm."""


def scene(parts: Parts, source: str) -> Scene:
    """Return the scene of sections in which no fault was found.

    Parameters
    ----------
    parts : Parts
        All of them understood.
    source : str
        The file they come from.
    kgf : bool
        Whether a quantity in it is given in kgf.
    """
    head, frame, drive = parts.head, parts.frame, parts.drive
    plans, scales, hand, block = parts.plans, parts.scales, parts.hand, parts.title_block
    assert head is not None
    assert plans is not None
    assert scales is not None
    assert hand is not None
    assert block is not None
    links = [link for link in parts.links if link is not None]
    sheets = [sheet for sheet in parts.sheets if sheet is not None] or [m.SheetTable()]
    usual = _usual(parts)
    mechanism = _mechanism(frame, links, drive) if frame and drive else None
    return Scene(
        source=source,
        title=head.title,
        language=head.language,
        mechanism=mechanism,
        row=_row(drive) if drive else Row(),
        turned=plans.velocities == "turned",
        common_pole=plans.velocity_pole == "common",
        main=plans.main,
        diagrams=build_orders.diagrams(parts.diagrams) if parts.diagrams else None,
        flywheel=build_orders.flywheel(parts.flywheel, parts.indicator) if parts.flywheel else None,
        forces=_forces(parts, mechanism) if mechanism is not None else None,
        engine=_engine(parts),
        cam=build_cam.cam(parts.cam) if parts.cam else None,
        gears=build_wheels.gears(parts.gears) if parts.gears else None,
        planetary=build_wheels.planetary(parts.planetary) if parts.planetary else None,
        behind=parts.planetary.behind if parts.planetary else (),
        trajectories=plans.trajectories,
        scales=_scales(scales),
        ruler=_division(hand),
        hand=hand.name,
        seed=hand.seed,
        sheets=tuple(SheetOrder(sheet.format, sheet.place or usual) for sheet in sheets),
        title_block={key: text for key, text in block if text},
        task=_task(parts.task) if parts.task else None,
    )


def _usual(parts: Parts) -> tuple[str, ...]:
    """Return what stands on a sheet that does not say what does: all that the scene calls for."""
    plans = PLAN_PLACES if parts.drive is not None else ()
    asked = {place for name in SECTIONS if getattr(parts, name) for place in SECTIONS[name]}
    optional = {place for places in SECTIONS.values() for place in places}
    usual = (*plans, *PART_PLACES)
    return tuple(place for place in usual if place in asked or place not in optional)


def _division(table: m.HandTable) -> float | None:
    """Return the division of the ruler, mm: as told, else the hand's own, 0.1 mm for the exact one."""
    if isinstance(table.ruler, float):
        return table.ruler
    if table.ruler == "exact":
        return None
    return DIVISIONS[table.name]


def _forces(parts: Parts, mechanism: Mechanism) -> ForcesOrder | None:
    if parts.forces is None:
        return None
    gas = build_orders.indicator(parts.indicator) if parts.indicator else None
    loads = [load for load in parts.loads if load is not None]
    effects = parts.effects or EffectsTable()
    return build_forces.forces(parts.forces, effects, loads, parts.friction, gas, mechanism)


def _engine(parts: Parts) -> EngineOrder | None:
    if parts.engine is None or parts.indicator is None:
        return None
    return build_forces.engine(parts.engine, build_orders.indicator(parts.indicator))


def _mechanism(frame: m.FrameTable, links: list[m.LinkTable], drive: m.DriveTable) -> Mechanism:
    bodies: dict[int, m.FrameTable | m.LinkTable] = {link.number: link for link in links}
    bodies[frame.number] = frame
    fixed = Link(frame.number, dict(frame.points), _guides(frame.guides))
    sign = _sign(drive)
    pins = shared(body.points for body in bodies.values())
    return Mechanism(
        frame=fixed,
        links=tuple(
            replace(_link(link, bodies, frame.number), centre=_centre(link, pins)) for link in links
        ),
        drive=Drive(drive.link, sign * drive.speed, sign * drive.acceleration),
    )


def _centre(table: m.LinkTable, pins: Collection[str]) -> str | None:
    """Return the mass centre that a link declares; of one that has a mass, else its only point in no pair."""
    found = centres_of(table, pins)
    return found[0] if len(found) == 1 else None


def _sign(drive: m.DriveTable) -> int:
    return -1 if drive.turns == CLOCKWISE else 1


def _guides(tables: dict[str, m.GuideTable]) -> tuple[Guide, ...]:
    return tuple(Guide(name, table.through, table.angle) for name, table in tables.items())


def _link(table: m.LinkTable, bodies: dict[int, m.FrameTable | m.LinkTable], frame: int) -> Link:
    side = Side(*table.side, flips_at=table.flips_at) if table.side else None
    return Link(
        number=table.number,
        points=dict(table.points),
        guides=_guides(table.guides),
        slides=tuple(_slide(slide, bodies, frame) for slide in table.pairs),
        name=table.name,
        mass=table.mass,
        inertia=table.J,
        side=side,
    )


def _slide(table: m.SlideTable, bodies: dict[int, m.FrameTable | m.LinkTable], frame: int) -> Slide:
    on = frame if isinstance(table.on, str) else table.on
    line = geometry.guide(table.along, bodies[on].points, bodies[on].guides)
    side = None
    if table.side is not None:
        sign = geometry.sense(table.side, line, fixed=on == frame)
        side = Side(sign, flips_at=table.flips_at)
    return Slide(on, line, table.offset, table.angle, side)


def _row(drive: m.DriveTable) -> Row:
    zero = drive.zero
    accelerations = drive.accelerations
    if accelerations == ("all",):
        numbers = range(drive.first, drive.first + drive.positions)
        accelerations = tuple(str(number) for number in numbers)
    return Row(
        count=drive.positions,
        first=drive.first,
        zero=Extreme(zero.point, zero.at) if isinstance(zero, m.ExtremeTable) else zero,
        extra=drive.extra,
        accelerations=accelerations,
    )


def _scales(table: m.ScalesTable) -> Scales:
    by_crank = table.mu_v == MU_L_OMEGA
    return Scales(
        mu_l=table.mu_l,
        mu_v=table.mu_v if isinstance(table.mu_v, float) else None,
        mu_a=table.mu_a,
        mu_v_is_mu_l_omega=by_crank,
        OA=table.OA,
        pa=table.pa,
        pi_a=table.pi_a,
    )


def _task(table: m.TaskTable) -> Task:
    given = {"K_v": table.K_v, "stroke": table.stroke, "OB": table.OB}
    return Task(table.kind, given)
