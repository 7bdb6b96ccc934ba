"""The log that a setting records, with all that is given but the hand: μ stay those of the scene's sheets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.cost import REFINEMENT
from graphic_tmm.board import roles
from graphic_tmm.board.charts import Chart
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Length, Point
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.flywheel.plan import VIEWS as FLYWHEEL
from graphic_tmm.chapters.gears.plan import Gear
from graphic_tmm.chapters.kinematics.survey import survey
from graphic_tmm.chapters.planetary.plan import Planetary
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.mechanism.records import Extreme
from graphic_tmm.parts import draw_parts, draws_mechanism
from graphic_tmm.project import Project
from graphic_tmm.scaling import Sizes, extents
from graphic_tmm.scene.records import Scene
from graphic_tmm.work import doubted, executed, record

MECHANISM = "mechanism"
PER_MM = "/mm"
Pinned = Mapping[tuple[str, str, str], object]
"""Scale factors as given on a board, by board, view and letter."""


class Trial(NamedTuple):
    """A smaller construction that is tried at an angle until the reading changes its sign."""

    log: Construction
    angle: Mark
    reading: Mark


@dataclass(frozen=True)
class Drawing:
    """A log and what is given on it: a ``board`` ("mechanism", "cam", "gears", "planetary"), what was drawn.

    ``count``: positions of the closed row, or of the axis of a part. ``tried``: what a refinement tries, by the
    mark that it leaves.
    """

    board: str
    made: Project | Cam | Gear | Planetary
    log: Construction
    given: Mapping[Mark, object]
    count: int
    tried: Mapping[Mark, Trial] = field(default_factory=dict)


def pinned(made: DrawnScene) -> dict[tuple[str, str, str], object]:
    """Return the scale factors of a scene as drawn, and how often its lever is enlarged."""
    found: dict[tuple[str, str, str], object] = {}
    for board, log, given in _boards(made):
        for mark in log.given:
            if mark in given and mark.unit.endswith(PER_MM):
                found[board, *mark.key] = given[mark]
    if made.mechanism is not None and made.mechanism.project.forces is not None:
        times = made.mechanism.project.forces.lever.times
        found[MECHANISM, *times.key] = made.mechanism.given[times]
    return found


def _boards(made: DrawnScene) -> list[tuple[str, Construction, Mapping[Mark, object]]]:
    found = [(part.kind, part.construction, part.given) for part in made.parts]
    if made.mechanism is not None:
        found.append((MECHANISM, made.mechanism.construction, made.mechanism.given))
    return found


def draw(
    scene: Scene, scales: Pinned, enlarged: float = 1.0, pole: float = 1.0
) -> tuple[Drawing, ...]:
    """Record the logs of a scene, with the scales that are pinned, ``enlarged`` times as large.

    ``pole``: how many times farther the poles of its diagrams and of its flywheel's stand.

    Raises
    ------
    TmmError
        If the scene cannot be drawn so.
    """
    found = []
    parts = draw_parts(scene, exact=True)
    if draws_mechanism(scene, parts):
        project = record(scene)
        given = _pin(MECHANISM, dict(project.given), project.construction, scales)
        if missing := [m for m in project.construction.given if m not in given]:
            doubts = doubted(project)
            reach = extents(project, doubts)
            free = executed(scene, project, Sizes(), reach, doubts, exact=True).given
            given |= {mark: free[mark] for mark in missing}
        if pole != 1.0:
            given |= _farther(project, given, pole)
        log, tried = project.construction, _tried(scene, project)
        found.append(Drawing(MECHANISM, project, log, given, project.count, tried))
    for part in parts:
        given = _pin(part.kind, dict(part.given), part.construction, scales)
        count = part.reading.positions
        found.append(Drawing(part.kind, part.made, part.construction, given, count))
    return tuple(_enlarged(one, enlarged) if enlarged != 1.0 else one for one in found)


def _tried(scene: Scene, project: Project) -> dict[Mark, Trial]:
    """Return what is tried where an extreme position is found by trying."""
    zero = scene.row.zero
    steps = [s.it for s in project.construction.steps if s.op.name == REFINEMENT]
    if not steps or not isinstance(zero, Extreme):
        return {}
    small = survey(project.mechanism, project.structure)
    along = "x" if zero.at in ("left", "right") else "y"
    trial = Trial(small.construction, small.positions.phi, small.axes[zero.point, along])
    return dict.fromkeys(steps, trial)


def finer(start: str, times: float) -> dict[str, float]:
    """Return how μ of each diagram that is found from another changes where poles stand so many times farther.

    What is differentiated comes out so much larger, once or twice; what is integrated so much smaller.
    """
    if start == "velocity":
        return {"S": times, "a": 1.0 / times}
    return {"V": 1.0 / times, "a": 1.0 / times**2}


def _farther(project: Project, given: Mapping[Mark, object], times: float) -> dict[Mark, object]:
    """Return what is given for poles so many times farther: their distances, or the scales they follow from."""
    kinematic, flywheel = project.kinematic, project.flywheel
    charts: list[tuple[Chart, float]] = []
    if kinematic is not None:
        changes = finer(kinematic.order.start, times).items()
        charts += [(kinematic.charts[symbol], change) for symbol, change in changes]
    if flywheel is not None:
        charts += [(chart, times) for chart in flywheel.charts if chart.view == FLYWHEEL["work"]]
    found: dict[Mark, object] = {
        chart.mu: np.asarray(given[chart.mu]) * change for chart, change in charts if chart.chosen
    }
    return found | {
        mark: np.asarray(value) * times
        for mark, value in given.items()
        if mark.role == roles.POLE_DISTANCE
    }


def _pin(
    board: str, given: dict[Mark, object], log: Construction, scales: Pinned
) -> dict[Mark, object]:
    """Enter the pinned scales; polygons of earlier passes of friction take the scale of the last."""
    last = {view.name: view.last for view in log.views}
    for mark in log.given:
        view, letter = mark.key
        for key in ((board, last.get(view, view), letter), (board, view, letter)):
            if key in scales:
                given[mark] = scales[key]
    return given


def _enlarged(drawing: Drawing, times: float) -> Drawing:
    """Return the same drawing larger: every length and point given in mm, and every μ by so much finer."""

    def sized(mark: Mark, value: object) -> object:
        if mark.kind in (Length, Point):
            return np.asarray(value) * times
        return np.asarray(value) / times if mark.unit.endswith(PER_MM) else value

    return replace(drawing, given={mark: sized(mark, v) for mark, v in drawing.given.items()})
