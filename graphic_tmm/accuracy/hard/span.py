"""What a drive is walked through: a turn in degrees, or the lengths that it reaches in millimetres."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.language.numbers import number
from graphic_tmm.language.units import unit
from graphic_tmm.mechanism.records import Sweep

ROW = 1440
"""Coordinates tried over it: every quarter of a degree of a turn."""
CELLS = 72
"""At most so many signs of a strip stand for it: one for five degrees of a turn."""
AROUND = 4
"""So many of them are left for what is beyond the reach of a length, at its ends."""
BEYOND = 0.02
"""The share of what a length can go through by which it is tried beyond that: its reach may end there."""
OFFS = 11
"""So many times a hard place is closed in on, each time ten times closer: of a turn 10 … 1e-9 degrees."""
SHIFT = 0.2468
"""The share of a step by which they lie beside round coordinates, at which mechanisms often stand still."""
PLACES = 7
"""Figures of a coordinate that is printed."""

SPACE = "\N{NO-BREAK SPACE}"

Coordinates = NDArray[np.float64]


@dataclass(frozen=True)
class Span:
    """What a drive is walked through, degrees or mm, from ``low`` to ``high``.

    ``cell``: for how much a sign of a strip stands, a round number. ``period``: after so many degrees every
    plan is the same, 0 where none is. ``letter``: of the coordinate.
    """

    letter: str
    unit: str
    low: float
    high: float
    cell: float
    period: float = 0.0

    @property
    def turns(self) -> bool:
        """Whether the coordinate is an angle."""
        return self.unit == "°"

    @property
    def in_si(self) -> float:
        """What the drive takes for one of the unit: degrees or m."""
        return 1.0 if self.turns else 1e-3

    @property
    def once(self) -> float:
        """How far it goes until all plans are the same again, or to its end."""
        return self.period or self.high - self.low

    @property
    def offs(self) -> tuple[float, ...]:
        """How close to a hard place it is walked, to both sides."""
        power = math.floor(math.log10(2.0 * self.cell))
        return tuple(10.0 ** (power - k) for k in range(OFFS))

    @property
    def even(self) -> Coordinates:
        """The even row: two coordinates for each sign of a strip."""
        row = np.arange(self.low, self.high + 0.25 * self.cell, 0.5 * self.cell)
        return row[row < self.high] if self.period else np.minimum(row, self.high)

    @property
    def tried(self) -> Coordinates:
        """The row on which hard places are looked for; over a turn its last is its first."""
        step = self.once / ROW
        row: Coordinates = self.low + step * (SHIFT + np.arange(ROW + 1, dtype=np.float64))
        return row if self.period else row[:-1]

    @property
    def step(self) -> float:
        """How far its coordinates are apart."""
        return self.once / ROW

    def within(self, value: float) -> float:
        """Return a coordinate within a turn, from 0 to 360; a length as it is."""
        return value % self.period if self.period else value

    def off(self, value: Coordinates, place: float) -> Coordinates:
        """Return how far coordinates are from a place, signed, over a turn the shorter way."""
        if not self.period:
            return np.asarray(value - place)
        half = self.period / 2.0
        return np.asarray((value - place + half) % self.period - half)

    def apart(self, first: float, second: float) -> float:
        """Return how far two coordinates are apart."""
        return abs(float(self.off(np.asarray(first), second)))

    def value(self, coordinate: float, language: str, digits: int = PLACES) -> str:
        """Return a coordinate with its unit: 12,5°, 612,5 mm."""
        return f"{number(coordinate, language, digits)}{self.behind(language)}"

    def at(self, coordinate: str) -> str:
        """Return a text of coordinates with the letter in front: φ = 12,5°."""
        return f"{self.letter}{SPACE}={SPACE}{coordinate}"

    def behind(self, language: str) -> str:
        """Return the unit as it stands behind a number."""
        return self.unit if self.turns else f"{SPACE}{unit(self.unit, language)}"


def span_of(
    sweep: Sweep, turned: float, row: Coordinates, there: Callable[[Span], NDArray[np.bool_]]
) -> Span:
    """Return what a drive is walked through.

    ``sweep``: what it can go through; ``turned``: degrees that its row goes through; ``row``: the coordinates
    of its positions, degrees or m; ``there``: where over `Span.tried` everything can be drawn.
    """
    if sweep.turns:
        cell = _rounded_up((sweep.high - sweep.low) / CELLS)
        span = Span(sweep.letter, "°", sweep.low, sweep.high, cell)
        if not sweep.closed:
            return _round_ends(span)
        whole = sweep.high * max(1, round(abs(turned) / sweep.high))
        return replace(span, high=whole, period=sweep.high)
    low, high = 1e3 * min(sweep.low, *row), 1e3 * max(sweep.high, *row)
    beyond = BEYOND * (high - low)
    # how far apart two pins are is never less than nothing
    least = low - beyond if low < 0.0 else 0.0
    cell = _rounded_up((high - low) / CELLS)
    every = Span(sweep.name or sweep.letter, "mm", least, high + beyond, cell)
    reached = np.concatenate([every.tried[there(every)], 1e3 * row])
    first, last = float(np.min(reached)), float(np.max(reached))
    cell = _rounded_up((last - first) / (CELLS - AROUND))
    found = _round_ends(replace(every, low=first - cell, high=last + cell, cell=cell))
    return found if least else replace(found, low=max(found.low, least))


def _round_ends(span: Span) -> Span:
    """Return a span that begins and ends where signs of a strip do."""
    low, high = math.floor(span.low / span.cell), math.ceil(span.high / span.cell)
    return replace(span, low=low * span.cell, high=high * span.cell)


def _rounded_up(value: float) -> float:
    """Return the least of 1, 2, 5 × 10ⁿ that is no less, but for the last bits."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(power * k for k in (1.0, 2.0, 5.0, 10.0) if power * k >= value * (1.0 - 1e-12))
