"""The pressure at any angle of the crank: read off the diagram as drawn, over where the piston stands."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.operations.graphs import over
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.any_angles.turn import Turning


def read_off(drawn: Drawn, number: Mark) -> Iterator[Step]:
    """Yield how high each side's line is at any angle; at the positions it is what was laid off."""
    log = drawn.construction
    for cylinder in INDICATOR_PLAN.on(drawn).every:
        made = cylinder.indicator
        behind = {one.points: one.behind for one in made.chart.followers}
        for side in made.sides:
            laid_off = log.step(side.points)
            assert laid_off is not None
            _, height = laid_off.uses
            choice = {"behind": behind.get(side.points, 0)}
            yield Step(over, height, (side.curve, number, made.feet), choice, "")


TURNING = Turning(read_off=read_off)
