"""How large a synthesis may be drawn; its μ_l, by how far the construction reaches."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.linkage_synthesis.plan import SYNTHESIS_PLAN
from graphic_tmm.chapters.linkage_synthesis.task import ASKED, CHAPTER_NAME, SYNTHESIS
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

ROOM = 200.0
"""Room for the construction the longer way, mm."""


def _fixed(scene: Scene) -> str:
    return "synthesis.mu_l" if "synthesis.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(SYNTHESIS, low=0.6, high=1.3, least=0.3, fixed=_fixed),),
    depends={SYNTHESIS: lambda scene, role: (SYNTHESIS,)},
)


def reach(project: Project, doubts: Doubts) -> float:
    """Return how far the points of the construction are apart, across or upright, m."""
    marks = [mark for mark in project.marks(SYNTHESIS) if mark.kind is Point]
    reading = unscaled(project, doubts, marks)
    spots = np.concatenate([[0j], *(reading[mark][0] for mark in marks)])
    spots = spots[np.isfinite(spots)]
    return float(max(np.ptp(spots.real), np.ptp(spots.imag)))


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    made, room = SYNTHESIS_PLAN.on(sized), ROOM * sized.sizes[SYNTHESIS]
    order = ASKED.of(sized.project.scene)
    fixed = order.mu_l if order is not None else None
    yield ScaleFactor(
        made.mu, "l_{max}", sized.reach[CHAPTER_NAME], room, fixed=fixed, lengths=True
    )


SCALES = ScaleFactors(
    reach=reach, factors=_factors, keys=lambda project: {SYNTHESIS: "mu_l_synthesis"}
)
