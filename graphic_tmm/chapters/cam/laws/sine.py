"""The sine law: the acceleration is a sine; the displacement is carried along the chord of the phase."""

from __future__ import annotations

import math

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import join, meet, parallel
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import (
    DrawnLaw,
    Ground,
    Semicircle,
    at_levels,
    by_semicircle,
    top,
)

SEMICIRCLES = {
    "S": Semicircle(law.sine_radius, 0, "out", law.around_outer, 1),
    "V": Semicircle(law.sine_radius_V, 1, "drop", law.around_lowest, -1, True),
    "A": Semicircle(law.sine_radius_A, 0, "out", law.around_outer, -1),
}


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    levels = by_semicircle(SEMICIRCLES[which], draft, ground, which, height)
    if which == "S":
        feet = draft.draw(meet, "r", ground.rise, levels, free=True)
        chord = draft.draw(join, "(oh)", ground.near, top(draft, ground, height))
        levels = draft.draw(parallel, "(r)", feet, chord)
    return at_levels(draft, ground, which, levels)


LAW = DrawnLaw("sine", 1, _points, (2.0, 2.0 * math.pi))
