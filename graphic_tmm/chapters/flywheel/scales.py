"""The scale factors of the diagrams of a flywheel."""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.chapters.flywheel.names import ENERGY_MASS, VIEWS
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import GRAPHS

SCALE_KEYS = {
    VIEWS["moment"]: "mu_M",
    VIEWS["work"]: "mu_A",
    VIEWS["energy"]: "mu_T",
    ENERGY_MASS: "mu_J",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(
    scales=lambda fitting: fitting.shorter(
        GRAPHS,
        [
            ("flywheel.base", VIEWS["moment"], roles.BASE),
            ("flywheel.H", VIEWS["work"], roles.POLE_DISTANCE),
        ],
    ),
    key=lambda view: SCALE_KEYS.get(view, ""),
)
