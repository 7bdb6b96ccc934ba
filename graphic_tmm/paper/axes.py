"""What stands along the axes of a graph: the numbers of positions on one level, names with units, distances."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.drawing import Ink, Label
from graphic_tmm.paper.finish import Named
from graphic_tmm.paper.graph_rules import TICK
from graphic_tmm.paper.labels import CLEAR, HEAVY, HEAVY_HALF, box, shape
from graphic_tmm.paper.lettering.letters import (
    letter,
)

BESIDE = 0.8
"""Clear width between a number and the perpendicular of its position, mm."""
SLIDE = 1.0
"""A number that a curve is in the way of is tried so much farther along the axis, again and again, mm."""
LEAST = 3.0
"""So far at least it is tried, mm."""
EVERY = (1, 2, 5, 10, 20, 50, 100)
"""Of positions that stand too close for their numbers every second, fifth … bears one."""
_HEAVY, _LABEL, _FOOT, _FAR = 20.0, 500.0, 3.0, 0.3
"""What it costs to stand on a main line, on the number before, past another position; a mm from its own. A thin
line costs 1."""
_OTHER_SIDE = 10.0
"""What it costs that the numbers stand above the axis, or one of them on the other side of it than the rest."""


def largest(values: Reals) -> float:
    """Return the largest of the values that are there, at least 0."""
    return float(np.max(values, initial=0.0, where=np.isfinite(values)))


def on_axis(symbol: str, unit: str) -> str:
    """Return what an axis is called: its quantity and, if it has one, the unit: V, m/s."""
    return f"{symbol}, {unit}" if unit else symbol


class _Row(NamedTuple):
    """Numbers on one level, and what it costs that they stand there."""

    labels: tuple[Label, ...]
    cost: float


def position_numbers(
    row: Sequence[Named], others: Sequence[Named], strokes: Iterable[Ink], size: float
) -> tuple[Label, ...]:
    """Return the numbers of positions on one level along the base: below it, or above it.

    ``row``: the positions that divide the base, with their feet; ``others``: the end of the base, positions
    beside the row. A number stands beside the perpendicular of its position, where no curve goes. Above the
    axis they all stand only where curves are in the way below, and one alone only where a curve is in the way
    of it in all its places. Where they have no room every second, or fifth … position of the row is numbered.
    """
    there = [one for one in (*_thinned(row, size), *others) if np.isfinite(one.at)]
    ink = _Inked(strokes)
    low, high = -TICK - CLEAR - size, TICK + CLEAR
    below, above = _level(there, (low, high), size, ink), _level(there, (high, low), size, ink)
    return below.labels if below.cost <= above.cost + _OTHER_SIDE else above.labels


def _thinned(row: Sequence[Named], size: float) -> list[Named]:
    """Return the positions that bear numbers: as many as have room beside each other."""
    feet = np.sort([one.at.real for one in row if np.isfinite(one.at)])
    apart = np.diff(feet)
    pitch = float(np.min(apart, initial=np.inf, where=apart > TICK))
    widest = max((letter(one.text, size=size).width for one in row), default=0.0)
    every = next((n for n in EVERY if n * pitch >= widest + BESIDE), EVERY[-1])
    return [one for k, one in enumerate(row) if k % every == 0]


class _Inked:
    """What is drawn, main lines and others, where letters look for places."""

    def __init__(self, strokes: Iterable[Ink]) -> None:
        drawn = [(stroke.pen in HEAVY, shape(stroke)) for stroke in strokes]
        self.heavy = shapely.STRtree([made for is_heavy, made in drawn if is_heavy])
        self.light = shapely.STRtree([made for is_heavy, made in drawn if not is_heavy])

    def cost(self, frame: shapely.Geometry) -> float:
        """Return what it costs to stand in a frame."""
        near = shapely.buffer(frame, CLEAR / 2)
        bold = self.heavy.query(shapely.buffer(frame, CLEAR / 2 + HEAVY_HALF), "intersects")
        return _HEAVY * bold.size + float(self.light.query(near, "intersects").size)


def _level(named: Sequence[Named], bases: tuple[float, float], size: float, ink: _Inked) -> _Row:
    """Return numbers on a level; ``bases``: its height, and the one for what finds no place there, mm."""
    labels: list[Label] = []
    cost, end = 0.0, -math.inf
    ordered = sorted(named, key=lambda one: one.at.real)
    feet = np.array([one.at.real for one in ordered])
    for one in ordered:
        wide = letter(one.text, size=size).width
        pitch = np.min(np.abs(feet - one.at.real), initial=np.inf, where=feet != one.at.real)
        far = np.arange(0.0, max(min(pitch, wide + LEAST) - wide, LEAST), SLIDE)
        tried: list[tuple[float, int, Label]] = []
        starts = np.stack([-BESIDE - far - wide, BESIDE + far], axis=1).ravel()
        for base, aside in zip(bases, (0.0, _OTHER_SIDE), strict=True):
            for k, left in enumerate((one.at.real + starts).tolist()):
                label = Label(one.text, complex(left, base), size)
                over = np.count_nonzero((feet > left) & (feet < left + wide))
                own = _LABEL * bool(left < end + CLEAR) + _FOOT * over + _FAR * float(far[k // 2])
                whole = round(float(aside + own + ink.cost(box(label))), 6)
                tried.append((whole, len(tried), label))
        least, _, label = min(tried, key=lambda one: one[:2])
        labels.append(label._replace(of=one.of, position=one.position))
        end = label.at.real + wide
        cost += least
    return _Row(tuple(labels), cost)
