"""The positions in which a mechanism cannot be drawn."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.chapters.kinematics.names import POSITIONS
from graphic_tmm.chapters.kinematics.views import warned
from graphic_tmm.drawn import Findings
from graphic_tmm.project import Project
from graphic_tmm.readers.warnings import Warned


def _undrawn(project: Project, reading: Reading) -> tuple[int, ...]:
    """Return the positions in which a mark of the plan of positions is not there."""
    bad = np.zeros((1, len(project.names)), dtype=bool)
    for mark in project.marks(POSITIONS):
        if mark.kind is not Curve:
            bad = bad | undefined(reading[mark]).any(axis=0, keepdims=True)
    return tuple(int(i) for i in np.flatnonzero(bad[0]))


FINDINGS = Findings(undrawn=_undrawn)


WARNINGS = Warned(warned)
