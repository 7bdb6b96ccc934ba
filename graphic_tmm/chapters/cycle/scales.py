"""How large the views of a flywheel for a cycle may be, and the scale factors of its diagrams."""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.chapters.cycle.task import CYCLE
from graphic_tmm.chapters.flywheel.task import SKETCH, VIEWS
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import Size, Sizing, graph_size

GRAPHS = graph_size(CYCLE)
SIZES = Sizing(
    graphs=GRAPHS.name,
    sizes=(GRAPHS, Size("cycle sketch", low=1.0, high=1.0)),
    depends={CYCLE: lambda scene, role: ("cycle sketch" if role == SKETCH else GRAPHS.name,)},
)


SCALE_KEYS = {
    VIEWS["moment"]: "mu_M_cycle",
    VIEWS["work"]: "mu_A_cycle",
    VIEWS["energy"]: "mu_T_cycle",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(
    scales=lambda fitting: fitting.stretched(
        CYCLE,
        [
            ("cycle.base", VIEWS["moment"], roles.BASE),
            ("cycle.H", VIEWS["work"], roles.POLE_DISTANCE),
        ],
    ),
    keys=lambda project: SCALE_KEYS,
)
