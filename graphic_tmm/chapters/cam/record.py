"""What is recorded of a cam: its plan; aside dwells in radians, what its limits leave, its follower's speed."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.laws import laws
from graphic_tmm.chapters.cam.laws.table import table_of
from graphic_tmm.chapters.cam.phases import Phase
from graphic_tmm.chapters.cam.plan import CAM_PLAN, Cam, record
from graphic_tmm.chapters.cam.refusals import risen
from graphic_tmm.chapters.cam.task import CAM, CamTask, FlatFollower
from graphic_tmm.chapters.cam.task_motion import BY_DIAGRAM, BY_TABLE, SHARED
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

VIEW = "cam-calculation"
"""The view of what is calculated."""


class Aside(NamedTuple):
    """Marks (Number).

    ``along``: what a mm of the diagrams' base stands for, °/mm (m/mm). ``dwells``: of those that there are,
    rad, by the number of the phase. ``left``: what is left up to each limit (Angle, or Number, m), by the name
    of a result. ``velocity`` and ``acceleration`` of the follower at all positions (m/s, m/s²; of a lever 1/s,
    1/s²); None of a cam without a speed. ``peaks``: the largest dS/dφ and d²S/dφ² in size of each phase, by the
    name of a result.
    """

    along: Mark
    dwells: dict[int, Mark]
    left: dict[str, Mark]
    velocity: Mark | None
    acceleration: Mark | None
    peaks: dict[str, Mark]


BESIDE: Recorded[Aside] = Recorded(aside(CAM))


def record_beside(bench: Bench) -> Aside:
    """Calculate what the drawing of a cam does not need."""
    cam, draft = CAM_PLAN.on(bench), bench.draft
    draft.open(VIEW)
    along, dwells = cam.diagrams.base.mu, dict[int, Mark]()
    if not cam.order.slides:
        along = draft.draw(f.degrees_per_mm, "μ_φ", cam.diagrams.base.length, unit="°/mm")
        dwells = _dwells(draft, cam.order)
    left, motion = _left(draft, cam, cam.order), _motion(draft, cam, cam.order)
    return Aside(along, dwells, left, *motion, _peaks(draft, cam))


def _peaks(draft: Draft, cam: Cam) -> dict[str, Mark]:
    """Calculate the largest dS/dφ and d²S/dφ² of every phase by their laws: no position need stand there."""
    found, diagrams = {}, cam.diagrams
    letters = (cam.order.letters["V"], cam.order.letters["A"])
    units = (cam.order.units["V"], cam.order.units["A"])
    rows = zip(diagrams.turn.phases, diagrams.phases, diagrams.strokes, strict=True)
    for phase, extent, stroke in rows:
        ops = (f.peak_velocity, f.peak_acceleration)
        for op, name, letter, factor, unit in zip(
            ops, ("dS", "ddS"), letters, _factors(phase), units, strict=True
        ):
            own = draft.take(Number, f"k_{letter}", factor)
            largest = f"{letter}_{{max}}"
            found[f"{name}_max_{phase.called}"] = draft.draw(
                op, largest, own, stroke, extent, unit=unit, free=True
            )
    return found


def _factors(phase: Phase) -> tuple[float, float]:
    """Return the largest dS/dφ and d²S/dφ² of a law, of h/Φ and h/Φ²."""
    if phase.law.name == BY_TABLE:
        return table_of(phase.law).peaks
    if phase.law.name != BY_DIAGRAM:
        drawn, split = laws()[phase.law.name], phase.law.split
        return (
            (drawn.peaks[0], 2.0 / min(split, 1.0 - split))
            if phase.law.name == SHARED
            else drawn.peaks
        )
    lift, speed = risen(phase.law.points)
    return speed / lift, max(abs(value) for _, value in phase.law.points) / lift


def _dwells(draft: Draft, order: CamTask) -> dict[int, Mark]:
    dwells = {}
    for number, stage in enumerate(order.stages, 1):
        if stage.dwell:
            extent = draft.take(Angle, f"φ_{number}", stage.dwell, "°")
            dwells[number] = draft.draw(f.radians_of, f"Φ_{number}", extent, unit="rad")
    return dwells


def _left(draft: Draft, cam: Cam, order: CamTask) -> dict[str, Mark]:
    """Calculate how far a cam is from each of its limits: negative where it passes one."""
    if isinstance(order.follower, FlatFollower | FlatRockerFollower):
        least = draft.take(Number, "[ρ]", order.follower.least, "m")
        (flattest,) = cam.curvature.extremes
        return {"left_curvature": draft.draw(f.above, "Δρ", flattest.value, least, unit="m")}
    assert cam.pressure is not None
    found = {}
    limits = (order.pressure, order.pressure_return or order.pressure)
    letters = ("[α]", "[α]" if limits[0] == limits[1] else "[α_f]")
    rows = zip(letters, limits, cam.pressure.extremes, cam.diagrams.turn.ways, strict=False)
    for letter, limit, extreme, phase in rows:
        allowed = draft.take(Angle, letter, limit, "°")
        found[f"left_{phase.name}"] = draft.draw(
            f.angle_left, f"Δα_{phase.number}", allowed, extreme.value, unit="°"
        )
    if order.least_rho:
        least = draft.take(Number, "[ρ]", order.least_rho, "m")
        (sharpest,) = cam.curvature.extremes
        found["left_curvature"] = draft.draw(f.above, "Δρ", sharpest.value, least, unit="m")
    if cam.roller is None:
        return found
    radius = cam.roller.radius
    for name, letter, limit_of in (
        ("drum_radius" if order.developed else "r0", "Δr_{r}", cam.roller.by_r0),
        ("profile", "Δr_{ρ}", cam.roller.by_curvature),
    ):
        if limit_of is not None:
            of = f"left_roller_{name}"
            found[of] = draft.draw(f.limit_left, letter, limit_of, radius, unit="m")
    return found


def _motion(draft: Draft, cam: Cam, order: CamTask) -> tuple[Mark | None, Mark | None]:
    """Calculate velocity and acceleration from the ordinates of dS/dφ and d²S/dφ²."""
    if order.speed is None:
        return None, None
    rocks = order.rocks
    letters = ("ω_{B}", "ε_{B}") if rocks else ("v_{B}", "a_{B}")
    units = ("1/s", "1/s²") if rocks else ("m/s", "m/s²")
    omega = draft.take(Number, "ω_1", order.speed, "1/s")
    ops, diagrams = (f.follower_velocity, f.follower_acceleration), cam.diagrams
    velocity, acceleration = (
        draft.draw(op, letter, omega, one.reading, one.chart.mu, unit=unit)
        for op, letter, one, unit in zip(ops, letters, (diagrams.V, diagrams.A), units, strict=True)
    )
    return velocity, acceleration


PLAN = Plan(
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts,
    result=lambda made: (made.least,),
    remedy=said(
        "no centre of the cam keeps the pressure angle within its limit; allow a larger one "
        "(pressure, or a smaller transmission), or a smaller stroke or longer phases"
    ),
)
