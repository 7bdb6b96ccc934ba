"""Rows of positions that begin at an extreme one: their plan of positions, and what is read off it."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.mechanism.records import Extreme, Mechanism, Row
from graphic_tmm.project import Project
from support.boards import recorded


def project_of(
    mechanism: Mechanism, point: str, at: str, *extra: float | Extreme | None, **row: int
) -> Project:
    """Draw the positions of a row that begins where ``point`` is extreme; None: the other extreme."""
    zero = Extreme(point, at)
    also = tuple(zero.opposite if one is None else one for one in extra)
    wanted = Row(row.get("count", 12), row.get("first", 0), zero, also)
    return recorded(mechanism, wanted, plans=["positions"])


def places(project: Project, letter: str) -> np.ndarray:
    """Return the places of a point over the positions, m."""
    mark = KINEMATICS_PLAN.on(project).positions.point(letter)
    return np.ravel(
        execute(
            project.construction, project.given | {KINEMATICS_PLAN.on(project).mu_l: 1.0}, [mark]
        )[mark]
    )


def apart(one: float, other: float) -> float:
    """Return how far two crank angles are apart, degrees."""
    return abs((one - other + 180) % 360 - 180)
