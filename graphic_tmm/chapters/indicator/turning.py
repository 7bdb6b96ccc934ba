"""The pressure at any angle of the crank: read off the diagram as drawn, over where the piston stands."""

from __future__ import annotations

from graphic_tmm.board.operations.curve import over
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.indicator.diagram import Indicator
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.any_angles.turn import Between, Turn, Turning


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return the pressure of each side at every angle; at the positions it is that which was laid off."""
    found = dict[Mark, object]()
    for cylinder in INDICATOR_PLAN.on(drawn).every:
        found |= _pressures(drawn, turn, cylinder.indicator)
    return found


def _pressures(drawn: Drawn, turn: Turn, made: Indicator) -> dict[Mark, object]:
    found = dict[Mark, object]()
    by_mark = {step.it: step for step in drawn.construction.steps}
    feet = turn.read([made.feet])[made.feet][0].real
    mu = float(drawn.numbers.drawn[made.chart.mu][0, 0])
    behind = {one.points: one.behind for one in made.chart.followers}
    for side in made.sides:
        height = by_mark[side.points].uses[1]
        pressure = by_mark[height].uses[0]
        numbers = turn.numbers - behind.get(side.points, 0)
        heights = over(drawn.numbers.drawn[side.curve], numbers, feet)
        found[pressure] = (heights * mu)[None, :]
    return found


TURNING = Turning(between=between)
