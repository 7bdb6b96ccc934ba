"""How large the views of a flywheel may be, and the scale factors of its diagrams."""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.chapters.flywheel.task import ENERGY_MASS, FLYWHEEL, SKETCH, VIEWS
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import Size, Sizing, graph_size

GRAPHS = graph_size(FLYWHEEL)
SIZES = Sizing(
    graphs=GRAPHS.name,
    sizes=(GRAPHS, Size(SKETCH, low=1.0, high=1.0)),
    depends={FLYWHEEL: lambda scene, role: (SKETCH if role == SKETCH else GRAPHS.name,)},
)


SCALE_KEYS = {
    VIEWS["moment"]: "mu_M",
    VIEWS["work"]: "mu_A",
    VIEWS["energy"]: "mu_T",
    ENERGY_MASS: "mu_J",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(
    scales=lambda fitting: fitting.stretched(
        FLYWHEEL,
        [
            ("flywheel.base", VIEWS["moment"], roles.BASE),
            ("flywheel.H", VIEWS["work"], roles.POLE_DISTANCE),
        ],
    ),
    keys=lambda project: SCALE_KEYS,
)
