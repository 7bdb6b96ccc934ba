"""The law 3-4-5: ordinates calculated from the polynomial 10u³ − 15u⁴ + 6u⁵."""

from __future__ import annotations

import math

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import DrawnLaw, Ground, uprights


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    """Lay off calculated ordinates."""
    (share,) = ground.shares
    if which == "S":
        long = draft.draw(law.polynomial_S, "y", share, height)
    else:
        op = law.polynomial_V if which == "V" else law.polynomial_A
        long = draft.draw(op, "y", share, ground.stroke, ground.phase)
    over = uprights(draft, ground, up=which != "V" or ground.of.sign > 0)
    return (draft.draw(lay_off, which.lower(), over, long, free=True),)


LAW = DrawnLaw("3-4-5", 4, _points, (1.875, 10.0 / math.sqrt(3.0)))
