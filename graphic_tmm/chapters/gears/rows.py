"""How many points are rolled, chosen before the log runs: which of the parts of a string a flank needs."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.gears.dimensions import GearSizes, WheelSizes

STATIONS = 13
"""Stations of a curve of specific sliding."""


@dataclass(frozen=True)
class Roll:
    """A flank: its string to the tip has ``parts`` parts; ``count`` points are rolled, from ``first`` on."""

    parts: int
    first: int
    count: int


@dataclass(frozen=True)
class Rows:
    """The rows of a gear pair along the one axis of positions: its length, both flanks, points of a fillet."""

    axis: int
    flanks: tuple[Roll, Roll]
    fillet: int

    def row(self, values: object) -> Reals:
        """Return the values of a row, (1, position); what stands behind them is missing."""
        given = np.asarray(values, dtype=np.float64)
        return np.concatenate([given, np.full(self.axis - given.size, np.nan)])[None, :]


def choose_rows(sizes: GearSizes, value: Callable[[Mark], float]) -> Rows:
    """Choose how the flanks are rolled; ``value``: of a calculated mark."""
    steps, one, other = sizes.order.steps, *sizes.wheels
    flanks = (_roll(one, sizes, value), _roll(other, sizes, value))
    counts = (*(flank.count for flank in flanks), steps + 1, STATIONS, len(sizes.order.stations))
    return Rows(max(counts), flanks, steps + 1)


def _roll(wheel: WheelSizes, sizes: GearSizes, value: Callable[[Mark], float]) -> Roll:
    """Divide the string to the tip so that the steps go from below the fillet to beyond the tip.

    Inside go the pitch circle too, where the thickness is laid off, and the lowest working point.
    """
    tip = value(wheel.r_b) * math.tan(math.radians(value(wheel.alpha_a)))
    pitch = value(wheel.r) * math.sin(math.radians(value(sizes.alpha)))
    inside = (tip, pitch, max(value(wheel.lowest), 0.0), max(value(wheel.limit), 0.0))
    low, high = min(inside), max(inside)
    parts = max(1, math.floor(sizes.order.steps * tip / (high - low)))
    first = max(0, math.floor(low / tip * parts) - 1)
    last = math.ceil(high / tip * parts) + 1
    return Roll(parts, first, last - first + 1)
