"""How large the cranks of an engine and its polygons are drawn."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.cylinders.plan import CYLINDERS_PLAN
from graphic_tmm.chapters.cylinders.task import CYLINDERS
from graphic_tmm.chapters.cylinders.words import SHAFT, STAR
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized
from graphic_tmm.fitting.sizes import Size, Sizing

STAR_ROOM, SHAFT_ROOM, ROOM = 35.0, 120.0, 80.0
"""Room for the crank, for the length of the shaft or twice the crank, for a polygon, mm."""
SIZES = Sizing(
    sizes=(Size(CYLINDERS, low=0.5, high=1.3, least=0.3),),
    depends={CYLINDERS: lambda scene, role: (CYLINDERS,)},
)


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    made, share = CYLINDERS_PLAN.on(sized), sized.sizes[CYLINDERS]
    crank, places = made.order.crank, [row.of.place for row in made.rows]
    room = share * STAR_ROOM
    yield ScaleFactor(made.scales[STAR], "r", crank, room, lengths=True)
    long = max(max(places) - min(places), 2.0 * crank)
    yield ScaleFactor(made.scales[SHAFT], "l_{z}", long, share * SHAFT_ROOM, lengths=True)
    for polygon in made.polygons.values():
        letter = polygon.closing.letter[0]
        yield ScaleFactor(polygon.mu, f"{letter}_{{max}}", polygon.reach, share * ROOM)


SCALES = ScaleFactors(
    factors=_factors,
    keys=lambda project: {
        view: f"mu_{view.replace('-', '_')}"
        for view in (
            *CYLINDERS_PLAN.on(project).scales, *CYLINDERS_PLAN.on(project).polygons
        )
    },
)  # fmt: skip
