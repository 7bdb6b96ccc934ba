"""How large the constructions may be drawn; their μ_l, by crank and rod in one line."""

from __future__ import annotations

from graphic_tmm.board.scales import Scale, standard_length
from graphic_tmm.chapters.klein.plan import KLEIN_PLAN
from graphic_tmm.chapters.klein.task import KLEIN, VIEWS
from graphic_tmm.fitting.scales import Fitting, ScaleFactors
from graphic_tmm.fitting.sizes import Size, Sizing

ROOM = 200.0
"""Room for crank and rod in one line, mm on an A1, on other formats in proportion."""

SIZES = Sizing(
    sizes=(Size(KLEIN, ROOM, in_mm=True, low=0.6, high=1.5, least=0.3),),
    depends={KLEIN: lambda scene, role: (KLEIN,)},
)


def _scales(fitting: Fitting) -> dict[str, Scale]:
    made = KLEIN_PLAN.of(fitting)
    if made is None:
        return {}
    mu = standard_length(made.of.crank + made.of.length, fitting.sizes[KLEIN])
    return {view: Scale("μ_l", mu, "m/mm") for view in made.figures}


SCALES = ScaleFactors(plan_scales=_scales, keys=lambda project: {v: f"mu_l_{v}" for v in VIEWS})
