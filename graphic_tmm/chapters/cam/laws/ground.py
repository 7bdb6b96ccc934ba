"""What a law is drawn on, and what it declares of itself; the semicircles of the sine and the cosine law."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure,
    meet,
    parallel,
    square,
    strike,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.laws import formulas as law
from graphic_tmm.chapters.cam.operations import divide_semicircle
from graphic_tmm.chapters.cam.phases import Phase


class Ground(NamedTuple):
    """One phase on the axes of one diagram.

    ``shares`` and ``feet``: for each stretch, the share of the phase from its outer end (Number) and the foot
    on the base, both missing at other positions. ``near`` and ``far``: the feet of the outer and of the inner
    end; ``out``: the line from the outer end away from the phase; ``rise`` and ``drop``: the perpendicular
    there, upward and downward. ``phase``: the angle of the phase (Number, rad); ``stroke`` and ``mu``
    (Number).
    """

    of: Phase
    shares: tuple[Mark, ...]
    feet: tuple[Mark, ...]
    along: Mark
    near: Mark
    far: Mark
    out: Mark
    rise: Mark
    drop: Mark
    phase: Mark
    stroke: Mark
    mu: Mark

    def outer(self, stretch: int) -> bool:
        """Whether the first or the second of two stretches is the one at the outer end."""
        return (stretch == 0) == (self.of.sign > 0)


@dataclass(frozen=True)
class DrawnLaw:
    """A law: its name in scenes, its ``number`` among the laws, how it is drawn.

    ``points``: draft, ground, the diagram ("S", "V" or "A"), the stroke on the diagram of S (Length) -> the
    points of the diagram over one phase, one mark for each stretch. ``jumps``: the shares of the phase at which
    its acceleration jumps: a stretch stands on either side of each. ``peaks``: the largest dS/dφ and d²S/dφ² in
    size, of h/Φ and h/Φ². ``also``: what else scenes may call it.
    """

    name: str
    number: int
    points: Callable[[Draft, Ground, str, Mark], tuple[Mark, ...]]
    peaks: tuple[float, float]
    jumps: tuple[float, ...] = ()
    also: tuple[str, ...] = ()


def uprights(draft: Draft, ground: Ground, stretch: int = 0, *, up: bool = True) -> Mark:
    """Erect the perpendiculars over the positions of a stretch."""
    foot = ground.feet[stretch]
    return draft.draw(
        square, f"({foot.letter})", foot, ground.along, sense=1 if up else -1, why=why.OVER_POSITION
    )


def top(draft: Draft, ground: Ground, height: Mark) -> Mark:
    """Mark the point of the stroke over the inner end of the phase."""
    line = draft.draw(square, "(h)", ground.far, ground.along, sense=1, why=why.STROKE_TOP)
    return draft.draw(lay_off, "h", line, height, free=True, why=why.STROKE_TOP)


def foot_at(draft: Draft, ground: Ground, share: float, letter: str, why: str) -> Mark:
    """Mark on the base the place at a share of the phase from its outer end."""
    part = draft.take(Number, "u", share)
    long = draft.draw(measure, "l", ground.near, ground.far)
    far = draft.draw(law.even_height, "x", part, long)
    inward = draft.draw(parallel, "(o)", ground.near, ground.along, sense=ground.of.sign)
    return draft.draw(lay_off, letter, inward, far, free=True, why=why)


_PRIMES = {"S": "", "V": "'", "A": "''"}
"""What tells the radii of a phase apart: as S is told from its derivatives."""


class Semicircle(NamedTuple):
    """How a semicircle gives one diagram of a law, told for the rise.

    ``centre``: how many radii above the base its centre stands; ``begin``: where the division begins, "out" or
    "drop" or "rise"; ``by``: the formula of the angle; ``sense`` of the division; ``odd``: in the return the
    figure stands below the base.
    """

    radius: Operation
    centre: int
    begin: str
    by: Operation
    sense: int
    odd: bool = False


def by_semicircle(how: Semicircle, draft: Draft, ground: Ground, which: str, height: Mark) -> Mark:
    """Return the levels of the points: through the divisions of a semicircle, parallel to the base."""
    down = how.odd and ground.of.sign < 0
    uses = (height,) if which == "S" else (ground.stroke, ground.phase)
    radius = draft.draw(how.radius, f"R{_PRIMES[which]}_{ground.of.number}", *uses)
    centre = ground.near
    if how.centre:
        centre = draft.draw(
            lay_off,
            "C",
            ground.drop if down else ground.rise,
            radius,
            free=True,
            why=why.WAVE_CENTRE,
        )
    circle = draft.draw(strike, "(R)", centre, radius, why=why.WAVE_CIRCLE)
    begin = {"out": ground.out, "drop": ground.drop, "rise": ground.rise}[how.begin]
    if down and how.begin != "out":
        begin = ground.rise if how.begin == "drop" else ground.drop
    # the return is mirrored, and mirrored once more where its figure stands below the base
    sense = how.sense * (1 if ground.of.sign > 0 or down else -1)
    (share,) = ground.shares
    angle = draft.draw(how.by, "θ", share, unit="°")
    points = draft.draw(divide_semicircle, "q", circle, begin, angle, sense=sense, free=True)
    return draft.draw(parallel, "(q)", points, ground.along, why=why.WAVE_LEVEL)


def at_levels(draft: Draft, ground: Ground, which: str, levels: Mark) -> tuple[Mark, ...]:
    """Return the points of a diagram over the positions, at their levels."""
    over = uprights(draft, ground)
    return (draft.draw(meet, which.lower(), over, levels, free=True, why=why.WAVE_AT),)
