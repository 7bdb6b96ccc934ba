"""The law of constant acceleration: two parabolas, two straight lines, two levels; it jumps at mid-phase.

The shares of speeding up and of slowing down may be unequal: the largest velocity, 2h/Φ, stands where the one
goes over into the other, and the accelerations are as the shares turned round.
"""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import join, lay_off, meet, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import DrawnLaw, Ground, foot_at, top, uprights
from graphic_tmm.chapters.cam.task_motion import SHARED


def _outer(ground: Ground) -> float:
    """Return the share of the phase from its outer end to where the acceleration changes its sign."""
    return ground.of.law.split if ground.of.sign > 0 else 1.0 - ground.of.law.split


def _middle(draft: Draft, ground: Ground) -> tuple[Mark, str]:
    """Mark where the acceleration changes its sign; return why, too."""
    if ground.of.law.split == 0.5:
        return draft.draw(halve, "m", ground.near, ground.far, free=True), why.MIDDLE
    return foot_at(draft, ground, _outer(ground), "m", why.SHARED), why.SHARED


def _parabola(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw two parabolas by rays to even divisions of the perpendicular that stands between them."""
    peak_of_stroke = top(draft, ground, height)
    middle, reason = _middle(draft, ground)
    line = draft.draw(square, "(m)", middle, ground.along, sense=1, why=reason)
    found = []
    for k, share in enumerate(ground.shares):
        even = draft.draw(law.even_height, "x_h", share, height)
        spots = draft.draw(lay_off, "d", line, even, free=True, why=why.PARABOLA_RAY)
        rays = draft.draw(
            join,
            "(d)",
            ground.near if ground.outer(k) else peak_of_stroke,
            spots,
            why=why.PARABOLA_RAY,
        )
        found.append(draft.draw(meet, "s", uprights(draft, ground, k), rays, free=True))
    return tuple(found)


def _triangle(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw two straight lines from the ends of the phase to the peak between them."""
    most = draft.draw(law.parabola_V, "h_V", ground.stroke, ground.phase)
    middle, reason = _middle(draft, ground)
    line = draft.draw(parallel, "(m)", middle, ground.rise, sense=ground.of.sign, why=reason)
    peak = draft.draw(lay_off, "k", line, most, free=True)
    found = []
    for k in range(len(ground.shares)):
        side = draft.draw(
            join, "(k)", ground.near if ground.outer(k) else ground.far, peak, why=why.TRIANGLE_SIDE
        )
        found.append(draft.draw(meet, "v", uprights(draft, ground, k), side, free=True))
    return tuple(found)


def _steps(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Lay off the constant accelerations: upward over the outer part, downward over the inner one."""
    outer, found = _outer(ground), []
    if outer == 0.5:
        much = [draft.draw(law.parabola_A, "h_A", ground.stroke, ground.phase)] * 2
    else:
        shares = (draft.take(Number, "u", share) for share in (outer, 1.0 - outer))
        much = [draft.draw(law.shared_A, "h_A", ground.stroke, ground.phase, u) for u in shares]
    lines = [uprights(draft, ground, k, up=ground.outer(k)) for k in range(len(ground.shares))]
    for k, over in enumerate(lines):
        found.append(draft.draw(lay_off, "a", over, much[0 if ground.outer(k) else 1], free=True))
    return tuple(found)


_DRAWN = {"S": _parabola, "V": _triangle, "A": _steps}


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    return _DRAWN[which](draft, ground, height)


LAW = DrawnLaw(SHARED, 3, _points, (2.0, 4.0), (0.5,))
