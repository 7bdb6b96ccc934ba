"""The scale factors of the diagrams of a flywheel for a cycle."""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.chapters.flywheel.names import VIEWS
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import GRAPHS

SCALE_KEYS = {
    VIEWS["moment"]: "mu_M_cycle",
    VIEWS["work"]: "mu_A_cycle",
    VIEWS["energy"]: "mu_T_cycle",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(
    scales=lambda fitting: fitting.shorter(
        GRAPHS,
        [
            ("cycle.base", VIEWS["moment"], roles.BASE),
            ("cycle.H", VIEWS["work"], roles.POLE_DISTANCE),
        ],
    ),
    key=lambda view: SCALE_KEYS.get(view, ""),
)
