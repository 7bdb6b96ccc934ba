"""The cosine law: the acceleration is a cosine, which jumps where a phase begins and ends."""

from __future__ import annotations

import math

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import (
    DrawnLaw,
    Ground,
    Semicircle,
    at_levels,
    by_semicircle,
)

SEMICIRCLES = {
    "S": Semicircle(law.cosine_radius, 1, "drop", law.half_around, -1),
    "V": Semicircle(law.cosine_radius_V, 0, "out", law.half_around_outer, -1, True),
    "A": Semicircle(law.cosine_radius_A, 0, "rise", law.half_around, 1),
}


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    levels = by_semicircle(SEMICIRCLES[which], draft, ground, which, height)
    return at_levels(draft, ground, which, levels)


LAW = DrawnLaw("cosine", 2, _points, (math.pi / 2.0, math.pi**2 / 2.0))
