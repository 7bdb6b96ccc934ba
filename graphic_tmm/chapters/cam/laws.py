"""Laws of motion on the board: the points of S, dS/dφ and d²S/dφ² of one phase, as a draughtsman finds them.

The return is the rise seen in a mirror: everything is drawn from the outer end of a phase, the beginning of the
rise or the end of the return. Sine and cosine come from semicircles that stand outside of that end.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import join, lay_off, meet, parallel, square, strike
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.cam import law_formulas as law
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


SEMICIRCLES = {
    ("sine", "S"): Semicircle(law.sine_radius, 0, "out", law.around_outer, 1),
    ("sine", "V"): Semicircle(law.sine_radius_V, 1, "drop", law.around_lowest, -1, True),
    ("sine", "A"): Semicircle(law.sine_radius_A, 0, "out", law.around_outer, -1),
    ("cosine", "S"): Semicircle(law.cosine_radius, 1, "drop", law.half_around, -1),
    ("cosine", "V"): Semicircle(law.cosine_radius_V, 0, "out", law.half_around_outer, -1, True),
    ("cosine", "A"): Semicircle(law.cosine_radius_A, 0, "rise", law.half_around, 1),
}
"""By law and diagram; the displacement of the sine law is then carried along the chord of the phase."""


def draw_law(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    """Draw the points of a diagram ("S", "V" or "A") over one phase, one mark for each stretch.

    ``height``: the stroke on the diagram of S (Length).
    """
    name = ground.of.law.name
    if name == "constant acceleration":
        return _PARABOLA[which](draft, ground, height)
    if name == "3-4-5":
        return _polynomial(draft, ground, which, height)
    return _by_semicircle(draft, ground, which, height)


def _by_semicircle(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    how = SEMICIRCLES[ground.of.law.name, which]
    down = how.odd and ground.of.sign < 0
    uses = (height,) if which == "S" else (ground.stroke, ground.phase)
    radius = draft.draw(how.radius, "R", *uses)
    centre = ground.near
    if how.centre:
        centre = draft.draw(lay_off, "C", ground.drop if down else ground.rise, radius, free=True)
    circle = draft.draw(strike, "(R)", centre, radius)
    begin = {"out": ground.out, "drop": ground.drop, "rise": ground.rise}[how.begin]
    if down and how.begin != "out":
        begin = ground.rise if how.begin == "drop" else ground.drop
    # the return is mirrored, and mirrored once more where its figure stands below the base
    sense = how.sense * (1 if ground.of.sign > 0 or down else -1)
    (share,) = ground.shares
    angle = draft.draw(how.by, "θ", share, unit="°")
    points = draft.draw(divide_semicircle, "q", circle, begin, angle, sense=sense, free=True)
    levels = draft.draw(parallel, "(q)", points, ground.along)
    if (ground.of.law.name, which) == ("sine", "S"):
        feet = draft.draw(meet, "r", ground.rise, levels, free=True)
        chord = draft.draw(join, "(oh)", ground.near, _top(draft, ground, height))
        levels = draft.draw(parallel, "(r)", feet, chord)
    return (draft.draw(meet, which.lower(), uprights(draft, ground), levels, free=True),)


def uprights(draft: Draft, ground: Ground, stretch: int = 0, *, up: bool = True) -> Mark:
    """Erect the perpendiculars over the positions of a stretch."""
    foot = ground.feet[stretch]
    return draft.draw(square, f"({foot.letter})", foot, ground.along, sense=1 if up else -1)


def _top(draft: Draft, ground: Ground, height: Mark) -> Mark:
    """Mark the point of the stroke over the inner end of the phase."""
    line = draft.draw(square, "(h)", ground.far, ground.along, sense=1)
    return draft.draw(lay_off, "h", line, height, free=True)


def _parabola(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw two parabolas by rays to even divisions of the perpendicular over the middle of the phase."""
    top = _top(draft, ground, height)
    middle = draft.draw(halve, "m", ground.near, ground.far, free=True)
    line = draft.draw(square, "(m)", middle, ground.along, sense=1)
    found = []
    for k, share in enumerate(ground.shares):
        even = draft.draw(law.even_height, "x_h", share, height)
        spots = draft.draw(lay_off, "d", line, even, free=True)
        rays = draft.draw(join, "(d)", ground.near if ground.outer(k) else top, spots)
        found.append(draft.draw(meet, "s", uprights(draft, ground, k), rays, free=True))
    return tuple(found)


def _triangle(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Draw two straight lines from the ends of the phase to the peak over its middle."""
    most = draft.draw(law.parabola_V, "h_V", ground.stroke, ground.phase)
    middle = draft.draw(halve, "m", ground.near, ground.far, free=True)
    line = draft.draw(parallel, "(m)", middle, ground.rise, sense=ground.of.sign)
    peak = draft.draw(lay_off, "k", line, most, free=True)
    found = []
    for k in range(len(ground.shares)):
        side = draft.draw(join, "(k)", ground.near if ground.outer(k) else ground.far, peak)
        found.append(draft.draw(meet, "v", uprights(draft, ground, k), side, free=True))
    return tuple(found)


def _steps(draft: Draft, ground: Ground, height: Mark) -> tuple[Mark, ...]:
    """Lay off the constant accelerations: upward over the outer half, downward over the inner one."""
    much = draft.draw(law.parabola_A, "h_A", ground.stroke, ground.phase)
    lines = [uprights(draft, ground, k, up=ground.outer(k)) for k in range(len(ground.shares))]
    return tuple(draft.draw(lay_off, "a", over, much, free=True) for over in lines)


_PARABOLA = {"S": _parabola, "V": _triangle, "A": _steps}


def _polynomial(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    """Lay off calculated ordinates."""
    (share,) = ground.shares
    if which == "S":
        long = draft.draw(law.polynomial_S, "y", share, height)
    else:
        op = law.polynomial_V if which == "V" else law.polynomial_A
        long = draft.draw(op, "y", share, ground.stroke, ground.phase)
    over = uprights(draft, ground, up=which != "V" or ground.of.sign > 0)
    return (draft.draw(lay_off, which.lower(), over, long, free=True),)
