"""A pair of gears at any angle of wheel 1: how far both have turned or a rack has run; turns a minute."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.record import BESIDE
from graphic_tmm.chapters.gears.task import GEARS
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import Project
from graphic_tmm.readers.any_angles.turn import Between, Turn, Turning, TurnQuantity

WAY = Mark(-4, "s_2", Number, GEARS, unit="m")
"""How far the rack has run: no step draws it."""
ANGLES = tuple(Mark(-1 - k, f"φ_{k}", Number, GEARS) for k in (1, 2))
"""How far the wheels have turned, degrees: no step draws it."""


def quantities(project: Project) -> Iterator[TurnQuantity]:
    """Yield the angles of the wheels, and their speeds, where that of wheel 1 is given (rpm, without sign)."""
    motion, gear = BESIDE.on(project).motion, GEARS_PLAN.on(project)
    for k, mark in enumerate(ANGLES[: len(gear.wheels)], 1):
        yield TurnQuantity(GEARS, "columns", f"phi{k}", mark)
        if motion is not None:
            yield TurnQuantity(GEARS, "columns", f"n{k}", motion.turns[k - 1])
    if gear.rack is not None:
        yield TurnQuantity(GEARS, "columns", "s2", WAY)


def between(drawn: Drawn, turn: Turn) -> Between:
    """Return the angles: by the ratio, against each other where both wheels have their teeth outside."""
    assert turn.angles is not None
    gear, ratio_ = GEARS_PLAN.on(drawn), BESIDE.on(drawn).ratio
    if gear.sizes.rack is not None:
        far = turn.angles / 360.0 * drawn.numbers.drawn[gear.sizes.rack.travel]
        return {ANGLES[0]: turn.angles, WAY: far}
    assert ratio_ is not None
    sense, ratio = 1.0 if gear.order.internal else -1.0, drawn.numbers.drawn[ratio_]
    return dict(zip(ANGLES, (turn.angles, sense * turn.angles / ratio), strict=True))


TURNING = Turning(between=between, told=quantities, plan=GEARS)
