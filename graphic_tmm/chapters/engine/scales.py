"""How large an engine's figures may be; μ_F of its triangles, of all its forces, of its vectors, and why."""

from __future__ import annotations

from collections.abc import Container

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, standard
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.chapters.engine.record import BESIDE
from graphic_tmm.chapters.engine.task import ENGINE, HARMONICS, TRANSFER, TRANSFER_PLACE, VIEW
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger
from graphic_tmm.fitting.scales import Fitting, ScaleFactors, unscaled
from graphic_tmm.fitting.sizes import GRAPH, GRAPHS, Size, Sizing
from graphic_tmm.paper.drawing import GRAPH as GRAPH_VIEW
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene


def _plan(scene: Scene, role: str) -> tuple[str, ...]:
    return (GRAPHS,) if role == GRAPH_VIEW else ("engine", POSITIONS)


SIZES = Sizing(
    sizes=(
        GRAPH,
        Size("engine", least=0.5, small=0.7, cap=0.4),
        Size(TRANSFER, least=0.5, small=0.7),
    ),
    depends={
        "engine": _plan,
        TRANSFER_PLACE: lambda scene, role: (TRANSFER, POSITIONS),
        "engine diagrams": lambda scene, role: (GRAPHS,),
    },
)


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
    reach=reach, scales=engine_scales, named=named, keys=lambda project: SCALE_KEYS
)


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how each scale factor was chosen: by the largest force."""
    made, known = ENGINE_PLAN.on(drawn), drawn.reach[ENGINE]
    marks = {VIEW: made.mu, HARMONICS: made.harmonics.mu, TRANSFER: BESIDE.on(drawn).transfer.mu}
    for view, mu in marks.items():
        ledger.of(view)
        most = ledger.quantity("F_{max}", known[view], mu.unit.removesuffix("/mm"))
        ledger.fitting(mu, most, ledger.value_of(drawn, mu))


CHOICE = Choice(choose)
