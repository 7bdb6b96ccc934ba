"""How an indicator diagram changes with the number of positions and with the size of a drawing."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.chapters.indicator.task import Gas, IndicatorTask
from graphic_tmm.chapters.kinematics.accuracy import resampled
from graphic_tmm.language.said import said


def at_count(order: IndicatorTask, count: int) -> IndicatorTask:
    """Return the same diagram for so many positions in a turn."""

    def gas(side: Gas) -> Gas:
        pressures = side.pressures
        size = count * order.turns
        return replace(side, pressures=resampled(pressures, size)) if pressures else side

    shaft = gas(order.shaft) if order.shaft is not None else None
    return replace(order, cover=gas(order.cover), shaft=shaft)


def one_sided(order: IndicatorTask) -> IndicatorTask:
    """Return the same diagram without the pressure on the side of the shaft."""
    return replace(order, shaft=None)


BELOW = said("gas on the shaft's side")
"""The effect of the pressure there."""


def sampled(order: IndicatorTask | None) -> bool:
    """Whether pressures are given at the positions only."""
    return order is not None and any(
        side.pressures for side in (order.cover, order.shaft) if side is not None
    )


def enlarged(order: IndicatorTask, times: float) -> IndicatorTask:
    """Return the same diagram so many times larger."""
    mu = None if order.mu is None else order.mu / times
    return replace(order, base=order.base * times, height=order.height * times, mu=mu)
