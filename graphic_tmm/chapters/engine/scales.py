"""μ_F of an engine's force triangles and of its rotating vectors."""

from __future__ import annotations

from collections.abc import Container

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard
from graphic_tmm.chapters.engine.harmonics import VIEW as HARMONICS
from graphic_tmm.chapters.engine.plan import ENGINE, VIEW
from graphic_tmm.fitting.scales import GRAPHS, Fitting, unscaled
from graphic_tmm.project import Project

TRIANGLE, VECTOR = 60.0, 70.0
"""Room for the largest force of an engine's triangles, and for its rotating vectors, mm."""
SCALE_KEYS = {VIEW: "mu_F_engine", HARMONICS: "mu_F_harmonics"} | {
    f"{VIEW} {symbol}": f"mu_{symbol}_engine" for symbol in "PNQTKM"
}
"""What the scale factors are called where machines read them."""


def reach(project: Project, doubts: Doubts) -> dict[str, float]:
    """Return the largest force of the triangles and of the rotating vectors (N), by view."""
    made = ENGINE.on(project)
    force, vector = made.values["P′"], made.harmonics.ends[0]
    reading = unscaled(project, doubts, [force, vector])
    largest = {VIEW: np.abs(reading[force]), HARMONICS: np.abs(reading[vector])}
    return {
        view: float(np.max(size, initial=0.0, where=np.isfinite(size)))
        for view, size in largest.items()
    }


def engine_scales(fitting: Fitting) -> dict[Mark, object]:
    """Return μ_F of an engine's force triangles and of its rotating vectors: standard ones."""
    made, share = ENGINE.on(fitting), fitting.sizes["engine"]
    known: dict[str, float] = fitting.reach[ENGINE.chapter]
    found: dict[Mark, object] = {
        made.mu: standard(known[VIEW], TRIANGLE * share),
        made.harmonics.mu: standard(known[HARMONICS], VECTOR * share),
    }
    return fitting.shorter(GRAPHS, [("engine.base", VIEW, roles.BASE)]) | found


def named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return both scales as drawn."""
    made = ENGINE.on(project)
    marks = {VIEW: made.mu, HARMONICS: made.harmonics.mu}
    return {view: Scale("μ_F", float(reading[mu][0, 0]), mu.unit) for view, mu in marks.items()}
