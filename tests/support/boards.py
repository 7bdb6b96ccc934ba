"""Mechanisms and scenes on their board, in the usual size: no sheet is tried."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from graphic_tmm.chapter import MECHANISM
from graphic_tmm.chapters.kinematics.plan import PLANS
from graphic_tmm.drawn import Drawn, DrawnScene, doubted
from graphic_tmm.fitting.scales import executed, reach_of, usual
from graphic_tmm.mechanism.records import Mechanism, Row
from graphic_tmm.project import Project, record
from graphic_tmm.scene.records import Scene


def drawn_of(scene: Scene, *, exact: bool = False) -> Drawn:
    """Draw the mechanism of a scene in its usual size."""
    project = record(scene)
    doubts = doubted(project)
    return executed(project, usual(scene), reach_of(project, doubts), doubts, exact=exact)


def recorded(
    mechanism: Mechanism,
    row: Row,
    *,
    plans: Iterable[str] = PLANS,
    turned: bool = False,
    trajectories: Sequence[str] = (),
    **asked: Any,
) -> Project:
    """Record plans of a mechanism over a row of positions; ``asked``: sections of a scene and what they ask."""
    scene = Scene(
        "", "T", "en", mechanism, row, turned=turned, trajectories=tuple(trajectories)
    ).asking(**asked)
    return record(scene, wanted={*plans, *asked})


def parts(made: DrawnScene) -> tuple[Drawn, ...]:
    """Return the boards of a scene besides that of its mechanism."""
    return tuple(one for one in made.boards if one.board != MECHANISM)
