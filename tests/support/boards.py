"""Mechanisms and scenes on their board, in the usual size: no sheet is tried."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from graphic_tmm.chapters.kinematics.task import PLANS
from graphic_tmm.drawn import Drawn, DrawnScene, doubted
from graphic_tmm.fitting.given import drawn_as
from graphic_tmm.fitting.scales import executed, reach_of
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.mechanism.records import Mechanism, Row
from graphic_tmm.project import Project, own_boards, record
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import draws_mechanism


def drawn_of(scene: Scene, *, exact: bool = False) -> Drawn:
    """Draw the mechanism of a scene in its usual size."""
    project = record(scene)
    doubts = doubted(project)
    return executed(project, usual(scene), reach_of(project, doubts), doubts, exact=exact)


def in_usual_size(scene: Scene, *, exact: bool = False) -> DrawnScene:
    """Draw all that a scene calls for in its usual size: what tests read that ask nothing of a sheet."""
    mechanism = draws_mechanism(scene, own_boards(scene))
    return DrawnScene(scene, drawn_as(scene, {}, exact=exact, wanted=None, mechanism=mechanism))


def usual_part(board: str, scene: Scene) -> Drawn:
    """Draw a part of a scene with the exact hand in its usual size."""
    return next(one for one in in_usual_size(scene, exact=True).boards if one.board == board)


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
