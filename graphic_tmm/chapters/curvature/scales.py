"""How large the constructions may be drawn; their μ_l, by how far they reach at their positions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.task import CURVATURE
from graphic_tmm.fitting.choice import usual_room
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, extent, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.language.said import said
from graphic_tmm.project import Project

ROOM = 270.0
"""The most that a construction takes on an A1, mm: as much as a plan of positions."""
_WHY = said(
    "The construction takes {room}: lengths and angles are measured on it; B is how far it reaches.",
    room=usual_room(ROOM),
)
SIZES = Sizing(
    sizes=(Size(CURVATURE, ROOM, in_mm=True, least=0.1),),
    depends={CURVATURE: lambda scene, role: (CURVATURE,)},
)


FAR = 25.0
"""A construction that reaches so many times as far as its link and pivots leaves these too small to be read."""


def reach(project: Project, doubts: Doubts) -> Mapping[Mark, Mapping[int, float]]:
    """Return, by μ and position (index), how far a construction reaches, m; none where it cannot be read."""
    made, count = CURVATURE_PLAN.on(project), len(project.names)
    found = {}
    for figure in made.figures:
        points = [mark for mark in project.marks(figure.view) if mark.kind is Point]
        reading = unscaled(project, doubts, points)
        rows = [np.broadcast_to(reading[mark][0], (count,)) for mark in points]
        for circle in figure.circles:
            centre, end = (reading[mark][0] for mark in (circle.middle, circle.end))
            rows += [np.broadcast_to(centre + (end - centre) * 1j**k, (count,)) for k in (1, 3)]
        spots, result = np.array(rows), points.index(figure.results[0])
        own = spots[[points.index(mark) for mark in (figure.origin, *figure.letters.values())]]
        found[figure.mu] = {
            k: far
            for k in made.places
            if np.isfinite(spots[result, k])
            and (far := extent([spots[np.isfinite(spots[:, k]), k]])) <= FAR * extent([own[:, k]])
        }
    return found


def readable_places(held: Sized, mu: Mark) -> list[int]:
    """Return the positions (indices) in which the construction of a μ is drawn."""
    return [*held.reach[CURVATURE][mu]]


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    for figure in CURVATURE_PLAN.on(sized).figures:
        apart, room = sized.reach[CURVATURE][figure.mu], sized.sizes[CURVATURE]
        most = max(apart.values(), default=1.0)
        apart = apart if len(apart) > 1 else {}
        yield ScaleFactor(figure.mu, "B", most, room, lengths=True, why=_WHY, apart=apart)


SCALES = ScaleFactors(
    reach=reach,
    factors=_factors,
    keys=lambda project: {
        one.view: f"mu_l_{one.view}" for one in CURVATURE_PLAN.on(project).figures
    },
)
