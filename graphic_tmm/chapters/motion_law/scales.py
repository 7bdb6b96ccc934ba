"""How large the views of a law of motion may be, and the scale factors of its graphs."""

from __future__ import annotations

from graphic_tmm.board import roles
from graphic_tmm.chapters.motion_law.task import (
    ACCELERATION,
    ENERGY,
    MASS,
    MOMENT,
    MOTION_LAW,
    SLOWNESS,
    SPEED,
    TIME,
    WORK,
)
from graphic_tmm.fitting.scales import ScaleFactors
from graphic_tmm.fitting.sizes import Sizing, graph_size

GRAPHS = graph_size(MOTION_LAW)
SIZES = Sizing(
    graphs=GRAPHS.name,
    sizes=(GRAPHS,),
    depends={MOTION_LAW: lambda scene, role: (GRAPHS.name,)},
)
SCALE_KEYS = {
    MOMENT: "mu_M_motion",
    WORK: "mu_A_motion",
    ENERGY: "mu_T_motion",
    MASS: "mu_J_motion",
    SPEED: "mu_omega_motion",
    ACCELERATION: "mu_epsilon_motion",
    SLOWNESS: "mu_slowness_motion",
    TIME: "mu_t_motion",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(
    scales=lambda fitting: fitting.stretched(MOTION_LAW, [("motion_law.base", MOMENT, roles.BASE)]),
    keys=lambda project: SCALE_KEYS,
)
