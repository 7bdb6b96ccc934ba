"""What a law is drawn on, and what it declares of itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import lay_off, square
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam import reasons as why
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
    size, of h/Φ and h/Φ².
    """

    name: str
    number: int
    points: Callable[[Draft, Ground, str, Mark], tuple[Mark, ...]]
    peaks: tuple[float, float]
    jumps: tuple[float, ...] = ()


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
