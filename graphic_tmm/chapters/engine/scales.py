"""How large an engine's figures may be; μ_F of its triangles, of all its forces, of its vectors, and why."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.chapters.engine.record import BESIDE
from graphic_tmm.chapters.engine.task import ENGINE, HARMONICS, TRANSFER, TRANSFER_PLACE, VIEW
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing, graph_size
from graphic_tmm.paper.drawing import GRAPH as GRAPH_VIEW
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene


def _plan(scene: Scene, role: str) -> tuple[str, ...]:
    return (GRAPHS.name,) if role == GRAPH_VIEW else ("engine", POSITIONS)


GRAPHS = graph_size(ENGINE)
SIZES = Sizing(
    graphs=GRAPHS.name,
    sizes=(
        GRAPHS,
        Size("engine", least=0.5),
        Size(TRANSFER, least=0.5),
    ),
    depends={
        "engine": _plan,
        TRANSFER_PLACE: lambda scene, role: (TRANSFER, POSITIONS),
        "engine diagrams": lambda scene, role: (GRAPHS.name,),
    },
)


TRIANGLE, VECTOR, FORCE = 80.0, 85.0, 65.0
"""Room for the largest force of an engine's triangles, for its rotating vectors, for the largest force of the
figure of all, mm."""
LARGEST = "F_{max}"
"""What the largest force is called."""
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


def factors(sized: Sized) -> Iterator[ScaleFactor]:
    """Yield μ_F of an engine's force triangles, its rotating vectors and all its forces."""
    made, known = ENGINE_PLAN.on(sized), sized.reach[ENGINE]
    share, transfer = sized.sizes["engine"], sized.sizes[TRANSFER]
    yield ScaleFactor(made.mu, LARGEST, known[VIEW], TRIANGLE * share)
    yield ScaleFactor(made.harmonics.mu, LARGEST, known[HARMONICS], VECTOR * share)
    mu = BESIDE.on(sized).transfer.mu
    yield ScaleFactor(mu, LARGEST, known[TRANSFER], FORCE * transfer)


SCALES = ScaleFactors(
    reach=reach,
    factors=factors,
    scales=lambda fitting: fitting.stretched(ENGINE, [("engine.base", VIEW, roles.BASE)]),
    keys=lambda project: SCALE_KEYS,
)
