"""μ_F of an engine's force triangles, of the figure of all its forces, of its rotating vectors."""

from __future__ import annotations

from collections.abc import Container

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard
from graphic_tmm.chapters.engine.beside import BESIDE
from graphic_tmm.chapters.engine.names import ENGINE, HARMONICS, TRANSFER, VIEW
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.fitting.scales import Fitting, ScaleFactors, unscaled
from graphic_tmm.fitting.sizes import GRAPHS
from graphic_tmm.project import Project

TRIANGLE, VECTOR, FORCE = 60.0, 70.0, 55.0
"""Room for the largest force of an engine's triangles, for its rotating vectors, for the largest force of the
figure of all, mm."""
SCALE_KEYS = {VIEW: "mu_F_engine", HARMONICS: "mu_F_harmonics", TRANSFER: "mu_F_148"} | {
    f"{VIEW} {symbol}": f"mu_{symbol}_engine" for symbol in "PNQTKM"
}
"""What the scale factors are called where machines read them."""


def reach(project: Project, doubts: Doubts) -> dict[str, float]:
    """Return the largest force of the triangles, of the rotating vectors (N) and of all, by view."""
    made = ENGINE_PLAN.on(project)
    force, gas, vector = made.values["P′"], made.values["P"], made.harmonics.ends[0]
    reading = unscaled(project, doubts, [force, gas, vector])
    largest = {VIEW: (force,), HARMONICS: (vector,), TRANSFER: (force, gas)}
    return {view: max(_most(reading[mark]) for mark in marks) for view, marks in largest.items()}


def _most(values: np.ndarray) -> float:
    size = np.abs(values)
    return float(np.max(size, initial=0.0, where=np.isfinite(size)))


def engine_scales(fitting: Fitting) -> dict[Mark, object]:
    """Return μ_F of an engine's force triangles, its rotating vectors and all its forces: standard ones."""
    made, share = ENGINE_PLAN.on(fitting), fitting.sizes["engine"]
    known: dict[str, float] = fitting.reach[ENGINE]
    found: dict[Mark, object] = {
        made.mu: standard(known[VIEW], TRIANGLE * share),
        made.harmonics.mu: standard(known[HARMONICS], VECTOR * share),
        BESIDE.on(fitting).transfer.mu: standard(known[TRANSFER], FORCE * fitting.sizes[TRANSFER]),
    }
    return fitting.shorter(GRAPHS, [("engine.base", VIEW, roles.BASE)]) | found


def named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return the scales as drawn."""
    made = ENGINE_PLAN.on(project)
    marks = {VIEW: made.mu, HARMONICS: made.harmonics.mu, TRANSFER: BESIDE.on(project).transfer.mu}
    return {view: Scale("μ_F", float(reading[mu][0, 0]), mu.unit) for view, mu in marks.items()}


SCALES = ScaleFactors(
    reach=reach, scales=engine_scales, named=named, key=lambda view: SCALE_KEYS.get(view, "")
)
