"""What part of the scheme of centres is drawn, and how large: the mechanism, and the centres near to it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.centres.record import CENTRES_PLAN, Centres
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.fitting.choice import usual_room
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors, Sized, unscaled
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.language.said import said
from graphic_tmm.paper.traced import value_at
from graphic_tmm.paper.window import Window, about
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

NEAR = 0.75
"""Centres are drawn that lie off the mechanism by less than this share of its size; to others arrows lead."""
NATURAL = 260.0
"""The most that the scheme takes on an A1 the longer way, mm."""
_WHY = said(
    "The mechanism and the centres near to it take {room}; arrows lead to those that are farther off.",
    room=usual_room(NATURAL),
)


def room(links: Sequence[complex], centres: Sequence[complex]) -> Window | None:
    """Return what part is drawn; None where the mechanism is not there."""
    there, others = ([z for z in spots if np.isfinite(z)] for spots in (links, centres))
    if not there:
        return None
    near = about(there).grown(NEAR * about(there).reach)
    return about([*there, *filter(near.holds, others)])


def spots(made: Centres, reading: Reading, place: int) -> tuple[list[complex], list[complex]]:
    """Return the points of the mechanism in a position, and the centres that are not at infinity."""
    links = [value_at(reading[mark], place) for mark in made.points.values()]
    return links, [value_at(reading[one.mark], place) for one in made.centres if not one.far]


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
            most = max(most, found.reach)
    return most


def _factors(sized: Sized) -> Iterator[ScaleFactor]:
    made = CENTRES_PLAN.on(sized)
    yield ScaleFactor(
        made.mu, "l_{max}", sized.reach[CENTRES], sized.sizes[CENTRES],
        fixed=made.order.mu_l, lengths=True, why=_WHY,
    )  # fmt: skip


SCALES = ScaleFactors(reach=reach, factors=_factors, keys=lambda project: {CENTRES: "mu_l_centres"})
