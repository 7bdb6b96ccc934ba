"""The law of constant velocity, eased by a parabola over the first and the last sixth of the phase.

With nothing between a dwell and an even motion the velocity would jump, and the acceleration be infinite: a
hard shock. Over a share σ at either end the acceleration is constant instead; the velocity between is then
h/(Φ·(1 − σ)) and the acceleration h/(Φ²·σ·(1 − σ)): with a sixth 1.2·h/Φ and 7.2·h/Φ².
"""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    meet,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.laws.ground import DrawnLaw, Ground, foot_at, top, uprights

EASED = 1 / 6
"""The share of the phase over which the follower speeds up, and that over which it slows down: as usual."""

PEAK = 1.0 / (1.0 - EASED)
"""The velocity of the even motion, of h/Φ."""


def _from_outer(ground: Ground, stretch: int) -> int:
    """Return which stretch it is counted from the outer end: 0 is eased, 1 even, 2 eased."""
    return stretch if ground.of.sign > 0 else len(ground.shares) - 1 - stretch


def _eased(draft: Draft) -> Mark:
    return draft.take(Number, "σ", EASED)


def _foot(draft: Draft, ground: Ground, share: float, letter: str) -> Mark:
    return foot_at(draft, ground, share, letter, why.EASED_END)


def _displacements(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw the straight line that cuts the base and the upper level half-way through each end; its parabolas.

    It touches a parabola at the end of its sixth. The parabola is drawn by rays from its vertex to even
    divisions of the perpendicular over that place.
    """
    peak = top(draft, ground, height)
    low = _foot(draft, ground, EASED / 2, "t")
    below = _foot(draft, ground, 1.0 - EASED / 2, "t")
    upright = draft.draw(square, "(t)", below, ground.along, sense=1)
    line = draft.draw(
        join, "(tt)", low, draft.draw(lay_off, "t", upright, height, free=True), why=why.EVEN_LINE
    )
    found, eased = [], _eased(draft)
    for k, share in enumerate(ground.shares):
        over, part = uprights(draft, ground, k), _from_outer(ground, k)
        if part == 1:
            found.append(draft.draw(meet, "s", over, line, free=True))
            continue
        foot = _foot(draft, ground, EASED if part == 0 else 1.0 - EASED, "e")
        above = draft.draw(square, "(e)", foot, ground.along, sense=1)
        op = law.eased_rise if part == 0 else law.eased_rise_back
        even = draft.draw(op, "x_h", share, eased, height)
        spots = draft.draw(lay_off, "d", above, even, free=True, why=why.PARABOLA_RAY)
        rays = draft.draw(
            join, "(d)", ground.near if part == 0 else peak, spots, why=why.PARABOLA_RAY
        )
        found.append(draft.draw(meet, "s", over, rays, free=True))
    return tuple(found)


def _velocities(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw the level of the even motion and the straight lines that rise to it over the ends."""
    most = draft.draw(law.eased_V, "h_V", ground.stroke, ground.phase, _eased(draft))
    found, sense = [], ground.of.sign
    for k in range(len(ground.shares)):
        part = _from_outer(ground, k)
        over = uprights(draft, ground, k, up=sense > 0)
        if part == 1:
            found.append(draft.draw(lay_off, "v", over, most, free=True))
            continue
        foot = _foot(draft, ground, EASED if part == 0 else 1.0 - EASED, "e")
        above = draft.draw(square, "(e)", foot, ground.along, sense=sense)
        corner = draft.draw(lay_off, "k", above, most, free=True)
        begins = ground.near if part == 0 else ground.far
        side = draft.draw(join, "(k)", begins, corner, why=why.TRIANGLE_SIDE)
        found.append(draft.draw(meet, "v", over, side, free=True))
    return tuple(found)


def _accelerations(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Lay off the constant accelerations of the ends: upward at the outer one, downward at the inner one."""
    much = draft.draw(law.eased_A, "h_A", ground.stroke, ground.phase, _eased(draft))
    none = draft.take(Length, "0", 0.0, "mm")
    return tuple(
        draft.draw(
            lay_off,
            "a",
            uprights(draft, ground, k, up=_from_outer(ground, k) != 2),
            none if _from_outer(ground, k) == 1 else much,
            free=True,
        )
        for k in range(len(ground.shares))
    )


_DRAWN = {"S": _displacements, "V": _velocities, "A": _accelerations}


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    return _DRAWN[which](draft, ground, height)


LAW = DrawnLaw(
    "constant velocity", 5, _points, (PEAK, PEAK / EASED), (EASED, 1.0 - EASED), also=("uniform",)
)
