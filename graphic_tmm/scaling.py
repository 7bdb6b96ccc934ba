"""The scale factors of a project: what the scene fixes, else standard ones, found with the exact hand."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.charts import HEIGHT, Chart
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale, standard, standard_length
from graphic_tmm.board.values import Curve, Point
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scales

PLANS = ("positions", "velocities", "accelerations")
LEVER = 150.0
"""Room for the lever, mm."""
ENLARGED = (10.0, 5.0, 4.0, 2.5, 2.0, 1.0, 0.5, 0.4, 0.25, 0.2, 0.1)
"""How many times the lever may be larger than the velocity plan."""
TRIANGLE, VECTOR = 60.0, 70.0
"""Room for the largest force of an engine's triangles, and for its rotating vectors, mm."""
POLYGON = 200.0
"""Room for a polygon of forces, mm."""

GRAPH_LENGTHS = (
    ("diagrams.base", "diagram S", roles.BASE),
    ("diagrams.base", "diagram V", roles.BASE),
    ("flywheel.base", "moment", roles.BASE),
    ("flywheel.H", "work", roles.POLE_DISTANCE),
    ("engine.base", "engine", roles.BASE),
)
"""The lengths of graphs that a scene need not give: its key, the view and the role of the mark."""


class Sizes(NamedTuple):
    """How large what is drawn may be.

    ``positions``: room for the plan of positions, ``velocities`` and ``accelerations``: for their longest
    vectors, mm. The others are shares of the usual room: of ``forces`` (polygons), of the arrows on ``groups``,
    of the ``lever``, of an ``engine``'s triangles and vectors, of ``graphs`` (their bases and ordinates), of
    the ``sketch`` of a flywheel.
    """

    positions: float = 230.0
    velocities: float = 80.0
    accelerations: float = 80.0
    forces: float = 1.0
    groups: float = 1.0
    lever: float = 1.0
    engine: float = 1.0
    graphs: float = 1.0
    sketch: float = 1.0

    @property
    def shares(self) -> tuple[float, ...]:
        """The shares alone."""
        return self[3:]


class Extents(NamedTuple):
    """What there is to draw (SI): how far the plan of positions reaches, the longest vectors of the others."""

    positions: float
    velocities: float
    accelerations: float


def extents(project: Project, doubts: Doubts) -> Extents:
    """Return what the choice of μ goes by, found with the exact hand at 1 SI unit to the millimetre.

    The plan of positions reaches as far as what is inked on it: its points in all positions, the circle of the
    crank pin, the paths of points. What is lost by ``doubts`` has no part in it.
    """
    log, given = project.construction, dict(project.given)
    for plan in PLANS:
        if log.view(plan) is not None:
            given[project.scale(plan)] = 1.0
    marks = [m for m in project.marks("positions") if m.kind in (Point, Curve)]
    crank = project.positions.bodies[project.structure.driver]
    pivot = crank.marks[project.structure.pivot]
    reading = execute(log, given, [*marks, pivot]).without(doubts.lost)
    arm = crank_sizes(project)[0]
    spots = [reading[pivot] + arm * np.array([1, 1j, -1, -1j])]
    spots += [reading[m].knots if m.kind is Curve else reading[m] for m in marks]
    places = project.accelerated or project.forced
    return Extents(
        _extent(spots),
        _longest(project, given, "velocities", None, doubts)
        if project.velocities is not None
        else 0.0,
        _longest(project, given, "accelerations", places, doubts)
        if project.accelerations is not None
        else 0.0,
    )


def choose_scales(
    project: Project, wanted: Scales, sizes: Sizes, reach: Extents
) -> dict[str, Scale]:
    """Return μ of every plan drawn: what the scene fixes, else a standard one that gives it its size.

    A segment fixed in mm (OA, pa, πa) gives its μ.
    """
    arm, pin_speed, pin_acceleration = crank_sizes(project)
    mu_l = wanted.mu_l or (
        arm / wanted.OA if wanted.OA else standard_length(reach.positions, sizes.positions)
    )
    scales = {"positions": Scale("μ_l", mu_l, "m/mm")}
    if project.velocities is not None:
        mu_v = wanted.mu_v or (
            pin_speed / wanted.pa if wanted.pa else standard(reach.velocities, sizes.velocities)
        )
        if wanted.mu_v_is_mu_l_omega:
            mu_v = mu_l * abs(project.mechanism.drive.speed)
        scales["velocities"] = Scale("μ_v", mu_v, "(m/s)/mm")
    if project.accelerations is not None:
        mu_a = wanted.mu_a or (
            pin_acceleration / wanted.pi_a
            if wanted.pi_a
            else standard(reach.accelerations, sizes.accelerations)
        )
        scales["accelerations"] = Scale("μ_a", mu_a, "(m/s²)/mm")
    return scales


def base_lengths(project: Project, share: float, told: Container[str]) -> dict[Mark, float]:
    """Return the bases of graphs, and pole distances given in mm, at a share of their usual length.

    ``told``: the keys that the scene itself writes; what it says of a length is kept.
    """
    if share >= 1.0:
        return {}
    log, found = project.construction, {}
    for key, view, role in GRAPH_LENGTHS:
        for mark in log.roles(view, role):
            if mark in project.given and key not in told:
                found[mark] = share * float(np.ravel(np.asarray(project.given[mark]))[0])
    return found


def crank_sizes(project: Project) -> tuple[float, float, float]:
    """Return the length of the crank, the speed and the acceleration of its pin (SI)."""
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
    return [
        view.scale for view in views if view.scale is not None and view.role == roles.FORCE_POLYGON
    ]


def force_scales(
    project: Project, given: Mapping[Mark, object], doubts: Doubts, sizes: Sizes
) -> dict[Mark, float]:
    """Return μ of every polygon of forces: what the scene fixes, else a standard one.

    The largest side of a polygon in any position whose forces are asked for takes its share of `POLYGON` mm at
    most. A polygon whose forces are all nothing has no μ but the scene's.
    """
    made = project.forces
    if made is None:
        return {}
    log, scales = project.construction, polygon_scales(project)
    ones = {**given, **_free(project), **dict.fromkeys(scales, 1.0)}
    views = {mu.view for mu in scales}
    marks = [step.it for step in log.steps if step.it.view in views and step.it.kind is Point]
    reading = execute(log, ones, marks).without(doubts.lost)
    found = {}
    for mu in scales:
        spots = [_at(_told(reading, m, doubts), project.forced) for m in marks if m.view == mu.view]
        extent = _extent([np.concatenate([[0j], *spots])])
        if made.order.mu or extent > 0.0:
            found[mu] = made.order.mu or standard(extent, POLYGON * sizes.forces)
    room = LEVER * sizes.lever
    return found | {made.lever.times: _enlarged(project, {**ones, **found}, doubts, room)}


def _told(reading: Reading, mark: Mark, doubts: Doubts) -> np.ndarray:
    """Return where a point is, with all scales 1; what is nothing but rounding is at the beginning."""
    return np.asarray(doubts.figure(mark, reading[mark]))


def _enlarged(project: Project, given: Mapping[Mark, object], doubts: Doubts, room: float) -> float:
    """Return how many times the lever is larger than the velocity plan, so that arms can be measured."""
    assert project.forces is not None
    lever = project.forces.lever
    images = list(dict.fromkeys(mark for marks in lever.images.values() for mark in marks))
    reading = execute(project.construction, {**given, lever.times: 1.0}, [*images, lever.pole])
    reading = reading.without(doubts.lost)
    extent = _extent([np.concatenate([[0j], *(_at(reading[m], project.forced) for m in images)])])
    return next((k for k in ENLARGED if k * extent <= room), ENLARGED[-1])


def _at(values: np.ndarray, places: tuple[int, ...]) -> np.ndarray:
    return np.asarray(values[0, list(places)] if values.shape[1] > 1 else values[0])


def engine_scales(
    project: Project, given: Mapping[Mark, object], doubts: Doubts, sizes: Sizes
) -> dict[Mark, float]:
    """Return μ of an engine's force triangles and of its rotating vectors: standard ones."""
    made = project.engine
    if made is None:
        return {}
    ones = {**given, **_free(project), made.mu: 1.0, made.harmonics.mu: 1.0}
    ends = list(made.harmonics.ends)
    reading = execute(project.construction, ones, [made.values["P′"], *ends]).without(doubts.lost)
    largest = {
        made.mu: np.abs(reading[made.values["P′"]]),
        made.harmonics.mu: np.abs(reading[ends[0]]),
    }
    return {
        mu: standard(float(np.max(size, initial=0.0, where=np.isfinite(size))), room * sizes.engine)
        for (mu, size), room in zip(largest.items(), (TRIANGLE, VECTOR), strict=True)
    }


def chart_scales(
    project: Project, given: Mapping[Mark, object], doubts: Doubts, sizes: Sizes, format_: str
) -> dict[Mark, float]:
    """Return the values of the scale marks of the graphs, with the plans' own scales ``given``.

    With every scale that may be chosen at 1, an ordinate times its μ is what it stands for.
    """
    charts = [chart.shrunk(sizes.graphs) for chart in project.charts]
    height = HEIGHT[format_] * sizes.graphs
    return free_scales(charts, project.construction, given, height, doubts.lost)


def free_scales(
    charts: Sequence[Chart],
    construction: Construction,
    given: Mapping[Mark, object],
    height: float = HEIGHT["A1"],
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
            mu = chart.wanted or standard(*_figure(chart, reading, height))
            found[chart.mu] = max(mu, found.get(chart.mu, 0.0))
    return found


def _figure(chart: Chart, reading: Reading, height: float) -> tuple[float, float]:
    """Return what the size of a graph stands for (SI), and the room for it, mm."""
    rows = [reading[m].imag for m in chart.figure] or [reading[m] for m in chart.ordinates]
    heights = np.concatenate(list(map(np.ravel, rows))) * float(reading[chart.mu][0, 0])
    there = np.isfinite(heights)
    if chart.room is not None:
        return float(np.max(np.abs(heights), initial=0.0, where=there)), chart.room
    reach = [float(np.max(sign * heights, initial=0.0, where=there)) for sign in (1.0, -1.0)]
    return sum(reach), height


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
