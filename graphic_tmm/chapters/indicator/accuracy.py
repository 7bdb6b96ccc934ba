"""How an indicator diagram changes with the number of positions and with the size of a drawing."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.chapters.indicator.task import Gas, IndicatorTask, mapped
from graphic_tmm.chapters.kinematics.accuracy import resampled
from graphic_tmm.language.said import said


def at_count(order: IndicatorTask, count: int) -> IndicatorTask:
    """Return the same diagram for so many positions in a turn."""

    def gas(side: Gas) -> Gas:
        pressures = side.pressures
        size = count * order.turns
        return replace(side, pressures=resampled(pressures, size)) if pressures else side

    def cylinder(one: IndicatorTask) -> IndicatorTask:
        shaft = gas(one.shaft) if one.shaft is not None else None
        return replace(one, cover=gas(one.cover), shaft=shaft)

    return mapped(order, cylinder)


def one_sided(order: IndicatorTask) -> IndicatorTask:
    """Return the same diagram without the pressure on the side of the shaft."""
    return mapped(order, lambda one: replace(one, shaft=None))


def two_sided(order: IndicatorTask | None) -> bool:
    """Whether a cylinder has gas on the side of the shaft."""
    return order is not None and any(one.shaft is not None for one in order.every)


BELOW = said("gas on the shaft's side")
"""The effect of the pressure there."""


def sampled(order: IndicatorTask | None) -> bool:
    """Whether pressures are given at the positions only."""
    sides = [side for one in order.every for side in (one.cover, one.shaft)] if order else []
    return any(side.pressures for side in sides if side is not None)


def enlarged(order: IndicatorTask, times: float) -> IndicatorTask:
    """Return the same diagram so many times larger."""

    def cylinder(one: IndicatorTask) -> IndicatorTask:
        mu = None if one.mu is None else one.mu / times
        return replace(one, base=one.base * times, height=one.height * times, mu=mu)

    return mapped(order, cylinder)
