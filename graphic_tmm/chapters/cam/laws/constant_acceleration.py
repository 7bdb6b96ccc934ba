"""The law of constant acceleration: two parabolas, two straight lines, two levels; it jumps at mid-phase."""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import join, lay_off, meet, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import DrawnLaw, Ground, top, uprights


def _parabola(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw two parabolas by rays to even divisions of the perpendicular over the middle of the phase."""
    peak_of_stroke = top(draft, ground, height)
    middle = draft.draw(halve, "m", ground.near, ground.far, free=True)
    line = draft.draw(square, "(m)", middle, ground.along, sense=1, why=why.MIDDLE)
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
    """Draw two straight lines from the ends of the phase to the peak over its middle."""
    most = draft.draw(law.parabola_V, "h_V", ground.stroke, ground.phase)
    middle = draft.draw(halve, "m", ground.near, ground.far, free=True)
    line = draft.draw(parallel, "(m)", middle, ground.rise, sense=ground.of.sign, why=why.MIDDLE)
    peak = draft.draw(lay_off, "k", line, most, free=True)
    found = []
    for k in range(len(ground.shares)):
        side = draft.draw(
            join, "(k)", ground.near if ground.outer(k) else ground.far, peak, why=why.TRIANGLE_SIDE
        )
        found.append(draft.draw(meet, "v", uprights(draft, ground, k), side, free=True))
    return tuple(found)


def _steps(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Lay off the constant accelerations: upward over the outer half, downward over the inner one."""
    much = draft.draw(law.parabola_A, "h_A", ground.stroke, ground.phase)
    lines = [uprights(draft, ground, k, up=ground.outer(k)) for k in range(len(ground.shares))]
    return tuple(draft.draw(lay_off, "a", over, much, free=True) for over in lines)


_DRAWN = {"S": _parabola, "V": _triangle, "A": _steps}


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    return _DRAWN[which](draft, ground, height)


LAW = DrawnLaw("constant acceleration", 3, _points, (2.0, 4.0), (0.5,))
