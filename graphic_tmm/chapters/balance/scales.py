"""How large the polar diagram and the graph of the moment may be; μ_Φ, and why."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.chapters.balance.task import ASKED, BALANCE, FORCE, MOMENT
from graphic_tmm.chapters.kinematics.task import POSITIONS
from graphic_tmm.fitting.choice import usual_room
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, extent, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing, graph_size
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import GRAPH as GRAPH_VIEW
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

GRAPHS = graph_size(BALANCE)
POLAR = 150.0
"""The most that a polar diagram takes on an A1, mm: as much as a polygon of forces."""
_POLAR = said(
    "A polar diagram takes {room}; B_Φ is the greater of its width and height, not its largest force.",
    room=usual_room(POLAR),
)


def _fixed(scene: Scene) -> str:
    order = ASKED.of(scene)
    return "balance.mu_F" if order is not None and order.mu is not None else ""


def _sizes(scene: Scene, role: str) -> tuple[str, ...]:
    return {GRAPH_VIEW: (GRAPHS.name,), SCHEME: (POSITIONS,)}.get(role, (BALANCE,))


SCHEME = "balance scheme"
"""The role of the view that shows the mechanism with its counterweights, to the scale of its plan."""
SIZES = Sizing(
    graphs=GRAPHS.name,
    sizes=(
        GRAPHS,
        Size(BALANCE, POLAR, in_mm=True, least=0.1, first=True, fixed=_fixed),
    ),
    depends={BALANCE: _sizes},
)


STATIC = 90.0
"""The most that a polygon of static moments takes on an A1, mm."""
_STATIC = said(
    "A polygon of static moments takes {room}: the side that closes it is measured.",
    room=usual_room(STATIC),
)


def reach(project: Project, doubts: Doubts) -> dict[Mark, float]:
    """Return, by μ, how far the polar diagram reaches (N)."""
    made = BALANCE_PLAN.on(project)
    ends = [one.end for one in made.wholes]
    reading = unscaled(project, doubts, ends)
    return {made.mu: extent([np.array([0j]), *(np.ravel(reading[end]) for end in ends)])}


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    made, far = BALANCE_PLAN.on(sized), sized.reach[BALANCE]
    room = sized.sizes[BALANCE]
    yield ScaleFactor(made.mu, "B_{Φ}", far[made.mu], room, made.order.mu, why=_POLAR)
    for one in made.unbalances:
        most = room * STATIC / POLAR
        yield ScaleFactor(one.polygon.mu, "D_{max}", one.polygon.reach, most, why=_STATIC)


SCALES = ScaleFactors(
    reach=reach,
    factors=_factors,
    scales=lambda fitting: fitting.stretched(BALANCE, [("balance.base", MOMENT, roles.BASE)]),
    keys=lambda project: {
        FORCE: "mu_Phi",
        MOMENT: "mu_M_Phi",
        **{one.polygon.view: f"mu_D_{one.link}" for one in BALANCE_PLAN.on(project).unbalances},
    },
)
