"""How large a Geneva wheel may be drawn; its μ_l, by the distance of the centres."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.geneva.plan import GENEVA_PLAN
from graphic_tmm.chapters.geneva.task import GENEVA
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized
from graphic_tmm.fitting.sizes import Size, Sizing

ROOM = 130.0
"""Room for the distance of the centres, mm: the wheel takes nearly twice as much."""
SIZES = Sizing(
    sizes=(Size(GENEVA, low=0.6, high=1.3, least=0.3),),
    depends={GENEVA: lambda scene, role: (GENEVA,)},
)


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    wheel = GENEVA_PLAN.on(sized)
    letter, room = f"l_{{{wheel.apart.letter}}}", ROOM * sized.sizes[GENEVA]
    yield ScaleFactor(wheel.mu, letter, wheel.distance, room, lengths=True)


SCALES = ScaleFactors(factors=_factors, keys=lambda project: {GENEVA: "mu_l_geneva"})
