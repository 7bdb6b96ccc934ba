"""The scale factors of a board: what the scene fixes, else standard ones, found with the exact hand."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Protocol

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, common, standard, standard_length
from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Drawn, Findings, hand_of, read_log, view_scales
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.sizes import GRAPHS, Sizes, Sizing
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import narrowest
from graphic_tmm.project import Plan, Project
from graphic_tmm.scene.chapter import MECHANISM, Answer, Chapter, Holder
from graphic_tmm.scene.records import Scene


@dataclass(frozen=True)
class Fitting:
    """What chapters choose their scale factors by.

    ``given``: what is given so far, scale factors chosen before among it; ``reach``: by chapter, what it goes
    by, see `reach_of`.
    """

    project: Project
    sizes: Sizes
    reach: Mapping[str, Any]
    given: Mapping[Mark, object] = field(default_factory=dict)

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self.project.scene

    @property
    def recorded(self) -> Mapping[str, Any]:
        """What the chapters recorded."""
        return self.project.recorded

    def plan_scales(self) -> dict[str, Scale]:
        """Return μ of the plans, by view."""
        found: dict[str, Scale] = {}
        for chapter in self.project.chapters:
            found |= ScaleFactors.of(chapter).plan_scales(self)
        return found

    def stretched(
        self, chapter: str, lengths: Iterable[tuple[str, str, str]]
    ) -> dict[Mark, object]:
        """Return lengths of graphs given in mm (key, view, role) at the share of the chapter's graphs.

        A base grows with the width of its sheet, too. What the scene itself says of a length is kept.
        """
        own = next(one for one in self.project.chapters if one.name == chapter)
        share, wide = self.sizes[Sizing.of(own).graphs], narrowest(_formats(self.scene, own)).base
        found = dict[Mark, object]()
        for key, view, role in lengths:
            times = share * (wide if role == roles.BASE else 1.0)
            if key in self.scene.told or times == 1.0:
                continue
            for mark in self.project.construction.roles(view, role):
                if mark in self.project.given:
                    value = np.ravel(np.asarray(self.project.given[mark]))[0]
                    found[mark] = times * float(value)
        return found


@dataclass(frozen=True)
class ScaleFactor:
    """A scale factor that is chosen by the ``largest`` (SI), called a ``letter``, of what is drawn to it.

    ``room``: mm for that; 0: its value is found elsewhere. ``fixed``: what the scene gives instead, SI a mm;
    ``length``: what the scene calls the segment that shows the largest, and how long it wants it, mm.
    ``lengths``: standard is what ГОСТ 2.302 has; ``why``: the rule by which it has that room. ``apart``: by
    position (index) the largest of those that have a value of their own.
    """

    mu: Mark
    letter: str
    largest: float
    room: float = 0.0
    fixed: float | None = None
    length: tuple[str, float | None] = ("", None)
    lengths: bool = False
    why: str = ""
    apart: Mapping[int, float] = field(default_factory=dict)

    @property
    def value(self) -> float:
        """What the scene gives, else the standard value at which the largest takes its room, SI a mm."""
        return self.fixed or self.of(self.largest)

    def of(self, largest: float) -> float:
        """Return the standard value at which so much takes the room, SI a mm."""
        return (standard_length if self.lengths else standard)(largest, self.room)

    def given(self, count: int) -> float | Reals:
        """Return the value, or one for each of ``count`` positions where some have their own."""
        if self.fixed or not self.apart:
            return self.value
        row = np.full((1, count), self.value)
        row[0, list(self.apart)] = [self.of(largest) for largest in self.apart.values()]
        return row

    @property
    def unit(self) -> str:
        """The unit of the largest."""
        unit = self.mu.unit.removesuffix("/mm").strip("()")
        return "" if unit == "1" else unit


class Sized(Holder, Protocol):
    """Recorded chapters in sizes: scale factors are chosen of it, or were (`Fitting`, `Drawn`)."""

    @property
    def project(self) -> Project:
        """What was recorded."""

    @property
    def given(self) -> Mapping[Mark, object]:
        """What is given, scale factors of plans among it."""

    @property
    def sizes(self) -> Sizes:
        """How large it is drawn."""

    @property
    def reach(self) -> Mapping[str, Any]:
        """What chapters go by, see `reach_of`."""


@dataclass(frozen=True)
class ScaleFactors(Answer):
    """The scale factors of a chapter.

    ``reach``: what they go by, found once. ``plan_scales``: μ of the plans at a size, without drawing them.
    ``factors``: those that the largest of what is drawn rules; ``scales``: the values of others, put into what
    is given. ``named``: these as drawn, by view, of those that were given a value; ``keys``: what machines call
    the scale factors of views.
    """

    stands: ClassVar[str] = "scales.SCALES"
    reach: Callable[[Project, Doubts], Any] = lambda project, doubts: None
    plan_scales: Callable[[Fitting], Mapping[str, Scale]] = lambda fitting: {}
    factors: Callable[[Sized], Iterable[ScaleFactor]] = lambda sized: ()
    scales: Callable[[Fitting], Mapping[Mark, object]] = lambda fitting: {}
    named: Callable[[Project, Reading, Container[Mark]], Mapping[str, Scale]] = (
        lambda project, reading, given: {}
    )
    keys: Callable[[Project], Mapping[str, str]] = lambda project: {}


def scale_keys(project: Project) -> dict[str, str]:
    """Return what machines call the scale factors of views, where chapters have a name for them."""
    found: dict[str, str] = {}
    for chapter in reversed(project.chapters):
        found |= ScaleFactors.of(chapter).keys(project)
    return found


def unscaled(project: Project, doubts: Doubts, marks: Iterable[Mark]) -> Reading:
    """Return marks as the exact hand draws them with every free scale factor 1: a mm is then an SI unit.

    What is lost by ``doubts`` is not there. They know the drawing already; without them its slice is run.
    """
    log = project.construction
    if doubts.drawn:
        values = {mark.slot: doubts.drawn[mark.slot] for mark in marks}
        return Reading(values, len(project.names)).without(doubts.lost)
    return execute(log, {**dict.fromkeys(log.given, 1.0), **project.given}, marks)


def reach_of(project: Project, doubts: Doubts) -> dict[str, Any]:
    """Return, by chapter, what it chooses its scale factors by; under `GRAPHS` what the graphs go by.

    All of it is read off one drawing, see `unscaled`.
    """
    found = {one.name: ScaleFactors.of(one).reach(project, doubts) for one in project.chapters}
    return {**found, GRAPHS: _figures(project, doubts)}


def chosen(
    project: Project, sizes: Sizes, reach: Mapping[str, Any]
) -> tuple[dict[Mark, object], dict[str, Scale]]:
    """Choose the scale factors of what was recorded: all that is given then, and μ of the plans by view."""
    fitting = Fitting(project, sizes, reach, dict(project.given))
    scales = fitting.plan_scales()
    plans = {project.scale(view): scale.value for view, scale in scales.items()}
    fitting = replace(fitting, given={**fitting.given, **plans})
    for chapter in project.chapters:
        own = ScaleFactors.of(chapter)
        found = {one.mu: one.given(len(project.names)) for one in own.factors(fitting)}
        fitting = replace(fitting, given={**fitting.given, **found, **own.scales(fitting)})
    return {**fitting.given, **_graph_scales(fitting)}, scales


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
    given, scales = chosen(project, sizes, reach)
    # a scale factor that nobody has a value for is that of views in which nothing has a length
    idle = {view.scale: 1.0 for view in project.construction.views if view.scale is not None}
    idle = {mu: one for mu, one in idle.items() if mu in project.construction.given}
    told, given = set(given), {**idle, **given}
    scene = project.scene
    hand = EXACT if exact else hand_of(scene)
    doubts = doubts or Doubts(project.construction.steps, given)
    found = read_log(project, given, hand, doubts)
    # on a board of its own every view is drawn to a scale of its own; graphs may share one
    views = view_scales(project, found.whole) if project.board != MECHANISM else {}
    scales |= views | _scales_of_graphs(project, found.whole)
    fitting = Fitting(project, sizes, reach, given)
    last = {view.name for view in project.construction.views if view.last == view.name}
    for chapter in project.chapters:
        own = ScaleFactors.of(chapter)
        scales |= own.named(project, found.whole, told)
        ruled = (one.mu for one in own.factors(fitting) if one.mu.view in last)
        scales |= {mu.view: scale_of(mu, found.whole) for mu in ruled}
    missing = {
        k for one in project.chapters for k in Findings.of(one).undrawn(project, found.whole)
    }
    if missing and len(missing) == len(project.names):
        over = project.ranges(remedies=True)
        raise StructureError(
            said(
                "{source}: none of the positions can be drawn{over}", source=scene.source, over=over
            )
        )
    undrawn = tuple(sorted(missing))
    return Drawn(project, given, scales, found, hand, doubts, undrawn, sizes, reach)


def scale_of(mu: Mark, reading: Reading) -> Scale:
    """Return a scale factor as drawn."""
    row = reading[mu][0]
    value = common(row)
    return Scale(
        mu.name,
        value,
        mu.unit,
        tuple((int(k), float(row[k])) for k in np.flatnonzero(row != value)),
    )


def _figures(project: Project, doubts: Doubts) -> dict[str, float]:
    """Return what the size of every graph stands for (SI), by view.

    With every scale that may be chosen at 1, an ordinate times its μ is what it stands for.
    """
    charts = [chart for chart in project.charts if chart.chosen]
    wanted = [mark for chart in charts for mark in (*chart.ordinates, *chart.figure, chart.mu)]
    reading = unscaled(project, doubts, wanted)
    return {chart.view: _figure(chart, reading) for chart in charts}


def _figure(chart: Chart, reading: Reading) -> float:
    rows = [reading[m].imag for m in chart.figure] or [reading[m] for m in chart.ordinates]
    heights = np.concatenate(list(map(np.ravel, rows))) * float(reading[chart.mu][0, 0])
    there = np.isfinite(heights)
    if chart.room is not None:
        return float(np.max(np.abs(heights), initial=0.0, where=there))
    reach = [float(np.max(sign * heights, initial=0.0, where=there)) for sign in (1.0, -1.0)]
    return sum(reach)


def _graph_scales(fitting: Fitting) -> dict[Mark, float]:
    """Return the values of the scale marks of graphs that may be chosen, all other scale factors being given.

    Graphs that share a scale are all of them held to their room.
    """
    project, found = fitting.project, dict[Mark, float]()
    for one in project.chapters:
        share = fitting.sizes.get(Sizing.of(one).graphs, 1.0)
        height = narrowest(_formats(fitting.scene, one)).graph
        for chart in Plan.of(one).charts(project.recorded[one.name]):
            if chart.chosen:
                room = share * (height if chart.room is None else chart.room)
                mu = chart.wanted or standard(fitting.reach[GRAPHS][chart.view], room)
                found[chart.mu] = max(mu, found.get(chart.mu, 0.0))
    return found


def _formats(scene: Scene, chapter: Chapter) -> list[str]:
    """Return the formats of the sheets that show something of a chapter."""
    own = {place.name for place in chapter.places}
    return [sheet.format for sheet in scene.sheets if own & set(sheet.place)]


def _scales_of_graphs(project: Project, reading: Reading) -> dict[str, Scale]:
    """Return the scales of the graphs as drawn, by view."""
    return {
        chart.view: scale_of(chart.mu, reading)._replace(symbol=chart.scale_name)
        for chart in project.charts
    }


def extent(points: Sequence[np.ndarray], wide: float = 1.0) -> float:
    """Return how far points (mm) reach along the axis of their longer reach; 0 where there are none.

    ``wide``: what their width counts against their height.
    """
    flat = np.concatenate([np.ravel(p) for p in points])
    flat = flat[np.isfinite(flat)]
    if not flat.size:
        return 0.0
    width, height = np.ptp(flat.real), np.ptp(flat.imag)
    return float(max(wide * width, height))
