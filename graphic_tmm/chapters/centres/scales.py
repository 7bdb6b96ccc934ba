"""How large the scheme of centres may be drawn; its μ_l, by the mechanism and the centres near to it."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.chapters.centres.extent import room, spots
from graphic_tmm.chapters.centres.plan import CENTRES_PLAN
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.fitting.choice import usual_room
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.language.said import said
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

NATURAL = 260.0
"""The most that the scheme takes on an A1 the longer way, mm."""
_WHY = said(
    "The mechanism and the centres near to it take {room}; arrows lead to those that are farther off.",
    room=usual_room(NATURAL),
)


def _fixed(scene: Scene) -> str:
    return "centres.mu_l" if "centres.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(CENTRES, NATURAL, in_mm=True, low=0.6, high=1.3, least=0.4, fixed=_fixed),),
    depends={CENTRES: lambda scene, role: (CENTRES,)},
)


def reach(project: Project, doubts: Doubts) -> float:
    """Return how far the mechanism and the centres near to it reach in the positions asked for, m."""
    made = CENTRES_PLAN.on(project)
    marks = [*made.points.values(), *(one.mark for one in made.centres if not one.far)]
    reading = unscaled(project, doubts, marks)
    most = 0.0
    for place in made.places:
        if (found := room(*spots(made, reading, place))) is not None:
            most = max(most, found.size.real, found.size.imag)
    return most


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    made = CENTRES_PLAN.on(sized)
    yield ScaleFactor(
        made.mu, "l_{max}", sized.reach[CENTRES], sized.sizes[CENTRES],
        fixed=made.order.mu_l, lengths=True, why=_WHY,
    )  # fmt: skip


SCALES = ScaleFactors(reach=reach, factors=_factors, keys=lambda project: {CENTRES: "mu_l_centres"})
