"""The scale factors of a project: what the scene fixes, else standard ones, found with the exact hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale, standard, standard_length
from graphic_tmm.board.values import Point
from graphic_tmm.plans.charts import HEIGHT, Chart
from graphic_tmm.plans.forces import VIEW
from graphic_tmm.plans.project import Project
from graphic_tmm.scene.records import Scales

PLANS = ("positions", "velocities", "accelerations")
LEVER = 150.0
"""Room for the lever, mm."""
ENLARGED = (10.0, 5.0, 4.0, 2.5, 2.0, 1.0)
"""How many times the lever may be larger than the velocity plan."""
TRIANGLE, VECTOR = 60.0, 70.0
"""Room for the largest force of an engine's triangles, and for its rotating vectors, mm."""
POLYGON = 200.0
"""Room for a polygon of forces, mm."""


def choose_scales(
    project: Project,
    wanted: Scales,
    room: float,
    vectors: tuple[float, float],
    doubts: Doubts,
) -> dict[str, Scale]:
    """Return μ of every plan drawn: what the scene fixes, else a standard one, found with the exact hand.

    A segment fixed in mm (OA, pa, πa) gives its μ; the choice makes the plan of positions and the longest
    vectors as large as ``room`` and ``vectors`` (mm) allow. What is lost by ``doubts`` has no part in it.
    """
    log, given = project.construction, dict(project.given)
    for plan in PLANS:
        if log.view(plan) is not None:
            given[project.scale(plan)] = 1.0
    arm, pin_speed, pin_acceleration = _crank(project)
    points = [m for m in project.marks("positions") if m.kind is Point]
    reading = execute(log, given, points).without(doubts.lost)
    extent = _extent([reading[mark] for mark in points])
    mu_l = wanted.mu_l or (arm / wanted.OA if wanted.OA else standard_length(extent, room))
    scales = {"positions": Scale("μ_l", mu_l, "m/mm")}
    if project.velocities is not None:
        longest = _longest(project, given, "velocities", None, doubts)
        mu_v = wanted.mu_v or (
            pin_speed / wanted.pa if wanted.pa else standard(longest, vectors[0])
        )
        if wanted.mu_v_is_mu_l_omega:
            mu_v = mu_l * abs(project.mechanism.drive.speed)
        scales["velocities"] = Scale("μ_v", mu_v, "(m/s)/mm")
    if project.accelerations is not None:
        places = project.accelerated or project.forced
        longest = _longest(project, given, "accelerations", places, doubts)
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
    project: Project,
    given: Mapping[Mark, object],
    plan: str,
    at: tuple[int, ...] | None,
    doubts: Doubts,
) -> float:
    points = [m for m in project.marks(plan) if m.kind is Point]
    reading = execute(project.construction, given, points, positions=at).without(doubts.lost, at)
    lengths = [np.abs(reading[m]) for m in points]
    return max((float(np.nanmax(x)) for x in lengths if np.isfinite(x).any()), default=0.0)


def polygon_scales(project: Project) -> list[Mark]:
    """Return the marks of μ of every polygon of forces."""
    views = project.construction.views if project.forces is not None else ()
    return [view.scale for view in views if view.scale is not None and view.name.startswith(VIEW)]


def force_scales(
    project: Project, given: Mapping[Mark, object], doubts: Doubts
) -> dict[Mark, float]:
    """Return μ of every polygon of forces: what the scene fixes, else a standard one.

    The largest side of a polygon in any position whose forces are asked for takes `POLYGON` mm at most. A
    polygon whose forces are all nothing has no μ but the scene's.
    """
    made = project.forces
    if made is None:
        return {}
    log, scales = project.construction, polygon_scales(project)
    ones = {**given, **_free(project), **dict.fromkeys(scales, 1.0)}
    marks = [
        step.it for step in log.steps if step.it.view.startswith(VIEW) and step.it.kind is Point
    ]
    reading = execute(log, ones, marks).without(doubts.lost)
    found = {}
    for mu in scales:
        spots = [_at(_told(reading, m, doubts), project.forced) for m in marks if m.view == mu.view]
        extent = _extent([np.concatenate([[0j], *spots])])
        if made.order.mu or extent > 0.0:
            found[mu] = made.order.mu or standard(extent, POLYGON)
    return found | {made.lever.times: _enlarged(project, {**ones, **found}, doubts)}


def _told(reading: Reading, mark: Mark, doubts: Doubts) -> np.ndarray:
    """Return where a point is, with all scales 1; what is nothing but rounding is at the beginning."""
    return np.asarray(doubts.figure(mark, reading[mark]))


def _enlarged(project: Project, given: Mapping[Mark, object], doubts: Doubts) -> float:
    """Return how many times the lever is larger than the velocity plan, so that arms can be measured."""
    assert project.forces is not None
    lever = project.forces.lever
    images = list(dict.fromkeys(mark for marks in lever.images.values() for mark in marks))
    reading = execute(project.construction, {**given, lever.times: 1.0}, [*images, lever.pole])
    reading = reading.without(doubts.lost)
    extent = _extent([np.concatenate([[0j], *(_at(reading[m], project.forced) for m in images)])])
    return next((k for k in ENLARGED if k * extent <= LEVER), 1.0)


def _at(values: np.ndarray, places: tuple[int, ...]) -> np.ndarray:
    return np.asarray(values[0, list(places)] if values.shape[1] > 1 else values[0])


def engine_scales(
    project: Project, given: Mapping[Mark, object], doubts: Doubts
) -> dict[Mark, float]:
    """Return μ of an engine's force triangles and of its rotating vectors: standard ones."""
    made = project.engine
    if made is None:
        return {}
    ones = {**given, **_free(project), made.mu: 1.0, made.harmonics.mu: 1.0}
    ends = list(made.harmonics.ends)
    reading = execute(project.construction, ones, [made.values["P′"], *ends]).without(doubts.lost)
    sizes = {
        made.mu: np.abs(reading[made.values["P′"]]),
        made.harmonics.mu: np.abs(reading[ends[0]]),
    }
    return {
        mu: standard(float(np.max(size, initial=0.0, where=np.isfinite(size))), room)
        for (mu, size), room in zip(sizes.items(), (TRIANGLE, VECTOR), strict=True)
    }


def chart_scales(
    project: Project, given: Mapping[Mark, object], doubts: Doubts, format_: str
) -> dict[Mark, float]:
    """Return the values of the scale marks of the graphs, with the plans' own scales ``given``.

    With every scale that may be chosen at 1, an ordinate times its μ is what it stands for.
    """
    return free_scales(project.charts, project.construction, given, format_, doubts.lost)


def free_scales(
    charts: Sequence[Chart],
    construction: Construction,
    given: Mapping[Mark, object],
    format_: str = "A1",
    lost: Mapping[int, np.ndarray] = MappingProxyType({}),
) -> dict[Mark, float]:
    """Return the values of the scale marks of graphs that may be chosen, all else ``given``.

    Graphs that share a scale are all of them held to their room.
    """
    free = {chart.mu: 1.0 for chart in charts if chart.chosen}
    wanted = [mark for chart in charts for mark in (*chart.ordinates, *chart.figure, chart.mu)]
    reading = execute(construction, {**given, **free}, wanted).without(lost)
    found: dict[Mark, float] = {}
    for chart in charts:
        if chart.chosen:
            mu = chart.wanted or standard(*_figure(chart, reading, format_))
            found[chart.mu] = max(mu, found.get(chart.mu, 0.0))
    return found


def _figure(chart: Chart, reading: Reading, format_: str) -> tuple[float, float]:
    """Return what the size of a graph stands for (SI), and the room for it, mm."""
    rows = [reading[m].imag for m in chart.figure] or [reading[m] for m in chart.ordinates]
    heights = np.concatenate(list(map(np.ravel, rows))) * float(reading[chart.mu][0, 0])
    there = np.isfinite(heights)
    if chart.room is not None:
        return float(np.max(np.abs(heights), initial=0.0, where=there)), chart.room
    reach = [float(np.max(sign * heights, initial=0.0, where=there)) for sign in (1.0, -1.0)]
    return sum(reach), HEIGHT[format_]


def _free(project: Project) -> dict[Mark, float]:
    """Return the scales of graphs that may be chosen, all of them 1: with them a mm is what it stands for."""
    return {chart.mu: 1.0 for chart in project.charts if chart.chosen}


def chart_scale_values(project: Project, reading: Reading) -> dict[str, Scale]:
    """Return the scales of the graphs as drawn, by view, and that of their base."""
    found = {
        chart.view: Scale(f"μ_{chart.symbol}", float(reading[chart.mu][0, 0]), chart.mu.unit)
        for chart in project.charts
    }
    if project.kinematic is not None:
        mu = project.kinematic.base.mu
        found["base"] = Scale(mu.name, float(reading[mu][0, 0]), mu.unit)
    return found
