"""How large the places of a plate are drawn; their μ_l."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.loci.record import LOCI_PLAN
from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized
from graphic_tmm.fitting.sizes import Size, Sizing

ROOM = 220.0
"""Room for the construction the longer way, mm."""
SIZES = Sizing(
    sizes=(Size(LOCI, low=0.6, high=1.3, least=0.3),),
    depends={LOCI: lambda scene, role: (LOCI,)},
)


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    made, room = LOCI_PLAN.on(sized), ROOM * sized.sizes[LOCI]
    yield ScaleFactor(made.mu, "l_{max}", made.size, room, lengths=True)


SCALES = ScaleFactors(factors=_factors, keys=lambda project: {LOCI: "mu_l_loci"})
