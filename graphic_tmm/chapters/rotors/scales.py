"""How large a rotor is drawn: its two views by radius and length, its polygons by how far they reach."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.rotors.plan import END, MU_M, ROTOR_PLAN, SIDE
from graphic_tmm.chapters.rotors.task import ROTOR
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized
from graphic_tmm.fitting.sizes import Size, Sizing

ROOMS = {END: 45.0, SIDE: 150.0}
"""Room for the largest radius, and for the length along the axis, mm."""
ROOM = 120.0
"""Room for a polygon, mm."""
SIZES = Sizing(
    sizes=(Size(ROTOR, low=0.5, high=1.3, least=0.3),),
    depends={ROTOR: lambda scene, role: (ROTOR,)},
)


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    rotor, share = ROTOR_PLAN.on(sized), sized.sizes[ROTOR]
    radius, length = rotor.reach
    for view, letter, largest in ((END, "r_{max}", radius), (SIDE, "l", length)):
        if view in rotor.scales and largest > 0.0:
            yield ScaleFactor(
                rotor.scales[view], letter, largest, share * ROOMS[view], lengths=True
            )
    for polygon in rotor.polygons.values():
        moments = polygon.mu.name == MU_M[0]
        fixed = rotor.order.mu_M if moments else rotor.order.mu_D
        letter = "M_{max}" if moments else "D_{max}"
        yield ScaleFactor(polygon.mu, letter, polygon.reach, share * ROOM, fixed=fixed)


SCALES = ScaleFactors(
    factors=_factors,
    keys=lambda project: {
        view: f"mu_{view.replace('-', '_')}" for view in ROTOR_PLAN.on(project).views
    },
)
