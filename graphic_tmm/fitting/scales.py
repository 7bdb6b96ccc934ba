"""The scale factors of a board: what the scene fixes, else standard ones, found with the exact hand."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

import numpy as np

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.scales import Scale, standard
from graphic_tmm.chapter import chapters
from graphic_tmm.drawn import Drawn, hand_of, read
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import joined, said
from graphic_tmm.paper.formats import FORMATS, USUAL, narrowest
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

Sizes = Mapping[str, float]
"""How large what is drawn may be, by the names that chapters give to sizes."""


def usual(scene: Scene) -> dict[str, float]:
    """Return the usual sizes, which the formats of a scene's sheets suggest."""
    return {size.name: size.usual(scene) for one in chapters() for size in one.sizes}


@dataclass(frozen=True)
class Fitting:
    """What chapters choose their scale factors by.

    ``given``: what is given so far, scale factors chosen before among it; ``reach``: by chapter, what it goes
    by. What is lost by ``doubts`` sets no scale factor, and is not there.
    """

    project: Project
    sizes: Sizes
    doubts: Doubts
    reach: Mapping[str, Any]
    given: Mapping[Mark, object] = field(default_factory=dict)

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.project.scene

    @property
    def made(self) -> Mapping[str, Any]:
        """What the chapters made."""
        return self.project.made

    @property
    def ones(self) -> dict[Mark, object]:
        """What is given, with all scales of graphs that may be chosen 1: a mm of them is what it stands for."""
        free = {chart.mu: 1.0 for chart in self.project.charts if chart.chosen}
        return {**self.given, **free}

    def plan_scales(self) -> dict[str, Scale]:
        """Return μ of the plans, by view."""
        found: dict[str, Scale] = {}
        for chapter in self.project.chapters:
            found |= chapter.plan_scales(self)
        return found

    def shorter(self, size: str, lengths: Iterable[tuple[str, str, str]]) -> dict[Mark, object]:
        """Return lengths given in mm (key, view, role) at a share of their usual one.

        What the scene itself says of a length is kept.
        """
        share, found = self.sizes[size], {}
        if share < 1.0:
            for key, view, role in lengths:
                for mark in self.project.construction.roles(view, role):
                    if mark in self.project.given and key not in self.scene.told:
                        value = np.ravel(np.asarray(self.project.given[mark]))[0]
                        found[mark] = share * float(value)
        return dict[Mark, object](found)


def reach_of(project: Project, doubts: Doubts) -> dict[str, Any]:
    """Return, by chapter, what it chooses its scale factors by."""
    return {one.name: one.reach(project, doubts) for one in project.chapters}


def executed(
    project: Project,
    sizes: Sizes,
    reach: Mapping[str, Any],
    doubts: Doubts | None,
    *,
    exact: bool,
) -> Drawn:
    """Choose the scale factors of what was recorded, and execute it.

    ``reach``: see `reach_of`; ``doubts``: what rounding does to it, if that is known before its scale factors
    are: else it is found with these. ``exact`` switches the rounding of the ruler off.

    Raises
    ------
    StructureError
        If none of the positions can be drawn.
    """
    fitting = Fitting(project, sizes, doubts or Doubts((), {}), reach, dict(project.given))
    scales = fitting.plan_scales()
    chosen = {project.scale(view): scale.value for view, scale in scales.items()}
    fitting = replace(fitting, given={**fitting.given, **chosen})
    for chapter in project.chapters:
        fitting = replace(fitting, given={**fitting.given, **chapter.scales(fitting)})
    given = {**fitting.given, **_graph_scales(fitting)}
    # a scale factor that nobody has a value for is that of views in which nothing has a length
    idle = {view.scale: 1.0 for view in project.construction.views if view.scale is not None}
    idle = {mu: one for mu, one in idle.items() if mu in project.construction.given}
    told, given = set(given), {**idle, **given}
    scene = project.scene
    hand = EXACT if exact else hand_of(scene)
    doubts = doubts or Doubts(project.construction.steps, given)
    numbers = read(project, given, hand, doubts)
    named: dict[str, Scale] = {}
    for chapter in project.chapters:
        named |= chapter.named(project, numbers.whole, told)
    graphs = _told(project, numbers.whole)
    scales |= {view: scale for view, scale in graphs.items() if view not in named} | named
    missing = {k for one in project.chapters for k in one.undrawn(project, numbers.whole)}
    if missing and len(missing) == len(project.names):
        over = joined("", (one.ranges(project) for one in project.chapters))
        raise StructureError(
            said(
                "{source}: none of the positions can be drawn{over}", source=scene.source, over=over
            )
        )
    undrawn = tuple(sorted(missing))
    return Drawn(project, given, scales, numbers, hand, doubts, undrawn, sizes, reach)


def _graph_scales(fitting: Fitting) -> dict[Mark, float]:
    """Return the values of the scale marks of the graphs, all other scale factors being given."""
    project, share = fitting.project, fitting.sizes.get("graphs", 1.0)
    heights: dict[str, float] = {}
    for one in project.chapters:
        height = _graphs_on(fitting.scene, {place.name for place in one.places})
        heights |= {chart.view: height * share for chart in one.charts(project.made[one.name])}
    charts = [chart.shrunk(share) for chart in project.charts]
    return free_scales(charts, project.construction, fitting.given, heights, fitting.doubts.lost)


def _graphs_on(scene: Scene, places: set[str]) -> float:
    """Return how high a graph of some places may be on the sheets that show them, mm."""
    return narrowest(sheet.format for sheet in scene.sheets if places & set(sheet.place)).graph


def free_scales(
    charts: Sequence[Chart],
    construction: Construction,
    given: Mapping[Mark, object],
    heights: Mapping[str, float] = MappingProxyType({}),
    lost: Mapping[int, np.ndarray] = MappingProxyType({}),
) -> dict[Mark, float]:
    """Return the values of the scale marks of graphs that may be chosen, all else ``given``.

    With every scale that may be chosen at 1, an ordinate times its μ is what it stands for. Graphs that share a
    scale are all of them held to their room. ``heights``: how high a whole figure may be, by view, mm.
    """
    free = {chart.mu: 1.0 for chart in charts if chart.chosen}
    wanted = [mark for chart in charts for mark in (*chart.ordinates, *chart.figure, chart.mu)]
    reading = execute(construction, {**given, **free}, wanted).without(lost)
    found: dict[Mark, float] = {}
    for chart in charts:
        if chart.chosen:
            height = heights.get(chart.view, FORMATS[USUAL].graph)
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


def _told(project: Project, reading: Reading) -> dict[str, Scale]:
    """Return the scales of the graphs as drawn, by view."""
    return {
        chart.view: Scale(f"μ_{chart.symbol}", float(reading[chart.mu][0, 0]), chart.mu.unit)
        for chart in project.charts
    }


def extent(points: Sequence[np.ndarray]) -> float:
    """Return how far points (mm) reach along the axis of their longer reach; 0 where there are none."""
    flat = np.concatenate([np.ravel(p) for p in points])
    flat = flat[np.isfinite(flat)]
    if not flat.size:
        return 0.0
    width, height = np.ptp(flat.real), np.ptp(flat.imag)
    return float(max(width, height))
