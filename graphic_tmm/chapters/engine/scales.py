"""μ_F of an engine's force triangles and of its rotating vectors."""

from __future__ import annotations

from collections.abc import Container

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard
from graphic_tmm.chapters.engine.harmonics import VIEW as HARMONICS
from graphic_tmm.chapters.engine.plan import ENGINE, VIEW
from graphic_tmm.fitting.scales import Fitting
from graphic_tmm.project import Project

TRIANGLE, VECTOR = 60.0, 70.0
"""Room for the largest force of an engine's triangles, and for its rotating vectors, mm."""
SCALE_KEYS = {VIEW: "mu_F_engine", HARMONICS: "mu_F_harmonics"} | {
    f"{VIEW} {symbol}": f"mu_{symbol}_engine" for symbol in "PNQTKM"
}
"""What the scale factors are called where machines read them."""


def engine_scales(fitting: Fitting) -> dict[Mark, object]:
    """Return μ of an engine's force triangles and of its rotating vectors: standard ones."""
    made = ENGINE.on(fitting)
    given = {**fitting.given, **fitting.shorter("graphs", [("engine.base", VIEW, roles.BASE)])}
    ones = {**given, **fitting.ones, made.mu: 1.0, made.harmonics.mu: 1.0}
    ends = list(made.harmonics.ends)
    wanted = [made.values["P′"], *ends]
    reading = execute(fitting.project.construction, ones, wanted).without(fitting.doubts.lost)
    largest = {
        made.mu: np.abs(reading[made.values["P′"]]),
        made.harmonics.mu: np.abs(reading[ends[0]]),
    }
    share = fitting.sizes["engine"]
    found: dict[Mark, object] = {
        mu: standard(float(np.max(size, initial=0.0, where=np.isfinite(size))), room * share)
        for (mu, size), room in zip(largest.items(), (TRIANGLE, VECTOR), strict=True)
    }
    return fitting.shorter("graphs", [("engine.base", VIEW, roles.BASE)]) | found


def named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return both scales as drawn."""
    made = ENGINE.on(project)
    marks = {VIEW: made.mu, HARMONICS: made.harmonics.mu}
    return {view: Scale("μ_F", float(reading[mu][0, 0]), mu.unit) for view, mu in marks.items()}
