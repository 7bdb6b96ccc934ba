"""What a drawing is to other scale factors follows from one: the same marks as if it were executed there."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import SHEETS

from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Curve
from graphic_tmm.drawn import doubted
from graphic_tmm.fitting.rescaled import Rescaled, to_scale
from graphic_tmm.fitting.scales import chosen, reach_of
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.project import Project, record
from graphic_tmm.scene.read import read

SCENES = sorted(
    folder.parent.name
    for folder in SHEETS.glob("*/scene.toml")
    if read(folder).mechanism is not None
)
ROUNDING = 1e-9
"""Of what is largest of a mark: two orders of rounding in a log of some hundred steps."""


def differing(project: Project, given: dict[Mark, object]) -> list[str]:
    """Marks that come out otherwise than executed."""
    due = execute(project.construction, given)
    found = Rescaled(project, doubted(project).drawn, given, to_scale(project))
    off = []
    for mark in due_marks(project):
        for one, other in zip(parts(found[mark.slot]), parts(due[mark]), strict=True):
            one, other = np.broadcast_arrays(one, other)
            there = np.isfinite(other)
            size = np.max(np.abs(other), initial=0.01, where=there)
            apart = np.max(np.abs(one - other), initial=0.0, where=there)
            if (there != np.isfinite(one)).any() or apart > ROUNDING * size:
                off.append(f"{mark.view} {mark.letter}: {apart:.3g} of {size:.3g}")
    return off


def due_marks(project: Project) -> list[Mark]:
    return [step.it for step in project.construction.steps]


def parts(value: object) -> tuple[np.ndarray, ...]:
    if isinstance(value, Curve):
        return value.knots, value.tangents
    return tuple(value) if isinstance(value, tuple) else (np.asarray(value),)


@pytest.mark.parametrize("name", SCENES)
def test_a_drawing_follows_from_the_one_to_scale_one(name: str) -> None:
    scene = read(SHEETS / name)
    project = record(scene)
    reach = reach_of(project, doubted(project))
    for share in (0.7, 1.6):
        sizes = {size: share * room for size, room in usual(scene).items()}
        given = chosen(project, sizes, reach)[0]
        idle = {mark: 1.0 for mark in project.construction.given if mark not in given}
        assert differing(project, {**idle, **given}) == []


def test_plans_and_polygons_are_drawn_to_scale_and_graphs_are_not() -> None:
    views = to_scale(record(read(SHEETS / "windrower")))
    assert {"positions", "velocities", "accelerations", "forces 2-3", "forces 1"} <= views
    assert not any(view in views for view in ("diagram S", "moment", "lever"))
