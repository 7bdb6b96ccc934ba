"""The scale factors of a project: what the scene fixes, else standard ones, found with the exact hand."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard, standard_length
from graphic_tmm.board.values import Point
from graphic_tmm.plans.project import Project
from graphic_tmm.scene.records import Scales

PLANS = ("positions", "velocities", "accelerations")


def choose_scales(
    project: Project, wanted: Scales, room: float, vectors: tuple[float, float]
) -> dict[str, Scale]:
    """Return μ of every plan drawn: what the scene fixes, else a standard one, found with the exact hand.

    A segment fixed in mm (OA, pa, πa) gives its μ; the choice makes the plan of positions and the longest
    vectors as large as ``room`` and ``vectors`` (mm) allow.
    """
    log, given = project.construction, dict(project.given)
    for plan in PLANS:
        if log.view(plan) is not None:
            given[project.scale(plan)] = 1.0
    arm, pin_speed, pin_acceleration = _crank(project)
    points = [m for m in project.marks("positions") if m.kind is Point]
    reading = execute(log, given, points)
    extent = _extent([reading[mark] for mark in points])
    mu_l = wanted.mu_l or (arm / wanted.OA if wanted.OA else standard_length(extent, room))
    scales = {"positions": Scale("μ_l", mu_l, "m/mm")}
    if project.velocities is not None:
        longest = _longest(project, given, "velocities", None)
        mu_v = wanted.mu_v or (
            pin_speed / wanted.pa if wanted.pa else standard(longest, vectors[0])
        )
        if wanted.mu_v_is_mu_l_omega:
            mu_v = mu_l * abs(project.mechanism.drive.speed)
        scales["velocities"] = Scale("μ_v", mu_v, "(m/s)/mm")
    if project.accelerations is not None:
        longest = _longest(project, given, "accelerations", project.accelerated)
        mu_a = wanted.mu_a or (
            pin_acceleration / wanted.pi_a if wanted.pi_a else standard(longest, vectors[1])
        )
        scales["accelerations"] = Scale("μ_a", mu_a, "(m/s²)/mm")
    return scales


def _crank(project: Project) -> tuple[float, float, float]:
    drive, structure = project.mechanism.drive, project.structure
    crank = project.mechanism.by_number[structure.driver]
    arm = abs(crank.points[structure.pin] - crank.points[structure.pivot])
    return arm, abs(drive.speed) * arm, abs(drive.speed**2 + 1j * drive.acceleration) * arm


def _extent(points: list[np.ndarray]) -> float:
    flat = np.concatenate([np.ravel(p) for p in points])
    flat = flat[np.isfinite(flat)]
    width, height = np.ptp(flat.real), np.ptp(flat.imag)
    return float(max(width, height))


def _longest(
    project: Project, given: Mapping[Mark, object], plan: str, at: tuple[int, ...] | None
) -> float:
    points = [m for m in project.marks(plan) if m.kind is Point]
    reading = execute(project.construction, given, points, positions=at)
    lengths = [np.abs(reading[m]) for m in points]
    return max((float(np.nanmax(x)) for x in lengths if np.isfinite(x).any()), default=0.0)


def chart_scales(project: Project, given: Mapping[Mark, object]) -> dict[Mark, float]:
    """Return the values of the scale marks of the graphs, with the plans' own scales ``given``.

    With every scale that may be chosen at 1, an ordinate times its μ is what it stands for.
    """
    free = {chart.mu: 1.0 for chart in project.charts if chart.chosen}
    wanted = [mark for chart in project.charts for mark in (*chart.ordinates, chart.mu)]
    reading = execute(project.construction, {**given, **free}, wanted)
    found = {}
    for chart in project.charts:
        if not chart.chosen:
            continue
        heights = np.abs(
            np.concatenate([np.ravel(reading[m] * reading[chart.mu]) for m in chart.ordinates])
        )
        highest = float(np.max(heights, initial=0.0, where=np.isfinite(heights)))
        found[chart.mu] = chart.wanted or standard(highest, chart.room)
    return found


def chart_scale_values(project: Project, reading: Reading) -> dict[str, Scale]:
    """Return the scales of the graphs as drawn, by view, and that of their base."""
    found = {
        chart.view: Scale(f"μ_{chart.symbol}", float(reading[chart.mu][0, 0]), chart.mu.unit)
        for chart in project.charts
    }
    if project.kinematic is not None:
        mu = project.kinematic.base.mu
        found["base"] = Scale(mu.letter, float(reading[mu][0, 0]), mu.unit)
    return found
