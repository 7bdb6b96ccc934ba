"""What stands along the axes of a graph: numbers of positions, figures at ticks, names with units."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from graphic_tmm.board.values import Reals
from graphic_tmm.paper.drawing import Bezier, Ink, Label
from graphic_tmm.paper.graph_rules import TICK
from graphic_tmm.paper.label_places import CLEAR, HEAVY, HEAVY_HALF
from graphic_tmm.paper.labels import Named
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.shapes import shapes

BESIDE = 0.8
"""Clear width between a number and the perpendicular of its position, mm."""
FAR = (0.0, 1.0)
"""How much farther along the axis a number is tried that a curve is in the way of, mm."""
BETWEEN, WORDS = 1.6, 6 / 14
"""Clear width between two numbers at least, mm, and in their heights: that of words of type A (ГОСТ 2.304)."""
EVERY = (1, 2, 5, 10, 20, 50, 100)
"""Of positions that stand too close for their numbers every second, fifth … bears one."""
_HEAVY, _LIGHT, _LABEL, _FOOT, _FAR = 60.0, 0.3, 500.0, 12.0, 0.1
"""What it costs to stand on a main line, on a thin one, on the number before, past another position; a mm away
from its own."""
_OTHER_SIDE, _LOWER, _ALONE = 10.0, 12.0, 14.0
"""What it costs that the numbers stand above the axis, or one of them on the other side of it than those
before; that all stand on the next level below; that one stands a level farther out than the others."""
_LEVEL, _STAYS = 15.0, 2.0
"""What it costs to stand on a level line, read as a minus between numbers; to stay on the other side."""
HEAD = 3.0
"""Clear width between the letter of a row and its first number, mm."""
DEEPER, LEVELS = 4.5, 2
"""How far apart levels of numbers are at least, mm; so many stand below the first."""
CLEAR_LEVEL = 1.0
"""Clear height between numbers of two levels, mm: large ones need levels farther apart."""


def _deeper(size: float) -> tuple[float, ...]:
    """Return how far below the first level there are others, mm."""
    return tuple(k * max(DEEPER, size + CLEAR_LEVEL) for k in range(1, LEVELS + 1))


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
    """Return the numbers of positions on one level along the base, below it if curves leave room there.

    ``row``: the positions that divide the base, with their feet; ``others``: the end of the base, positions
    outside the row. A number stands next to the perpendicular of its position, clear of curves. Numbers move
    lower, or above the axis, only where curves are in the way; a single number changes sides, or stands farther
    out, only where a curve crosses all its places or it would be read as that of another position. Where there
    is no room, every second, fifth … position of the row is numbered; of others that stand too close, the
    first.
    """
    there = [one for one in (*_thinned(row, size), *others) if np.isfinite(one.at)]
    if not there:
        return ()
    low, high = -TICK - CLEAR - size, TICK + CLEAR
    most = _deeper(size)[-1]
    ink = _Inked(strokes, (low - 2 * most - size, high + most + 3 * size))
    rows = [_level(there, _around(low, high, size), size, ink)]
    if rows[0].cost > _OTHER_SIDE:
        rows += [
            _level(there, _around(high, low, size), size, ink, _OTHER_SIDE),
            *(
                _level(there, _around(low - by, high, size), size, ink, k * _LOWER)
                for k, by in enumerate(_deeper(size), 1)
            ),
        ]
    return min(rows, key=lambda one: one.cost).labels


def number_rows(
    rows: Mapping[str, Sequence[Named]], size: float, below: float
) -> tuple[Label, ...]:
    """Return the numbers of positions of several things along one base, a row for each below the row before.

    ``rows``: their positions, by the letters that begin the rows; ``below``: under which height, mm. A number
    for which its row has no room stands lower, and the rows behind it then, too.
    """
    found: list[Label] = []
    low, ink = below - TICK - CLEAR - size, _Inked((), (0.0, 0.0))
    for text, named in rows.items():
        there = [one for one in named if np.isfinite(one.at)]
        levels = [(low - k * _deeper(size)[0], k * _ALONE) for k in range(len(there) or 1)]
        labels = _level(there, levels, size, ink, beside=BETWEEN).labels
        if labels:
            left = min(label.at.real for label in labels) - HEAD
            found += [Label(text, complex(left, low), size, "end", of=labels[0].of), *labels]
            low = min(label.at.imag for label in labels) - size - BETWEEN
    return tuple(found)


def tick_figures(ticks: Iterable[tuple[float, str]], size: float) -> tuple[Label, ...]:
    """Return the figures of an axis of ordinates, each left of its tick: heights, mm, with what they say.

    Those without room are left out: 0 stays first, then what is farthest from it.
    """
    kept: list[tuple[float, str]] = []
    for one in sorted(ticks, key=lambda one: (one[0] != 0.0, -abs(one[0]))):
        if all(abs(one[0] - height) >= size + CLEAR for height, _ in kept):
            kept.append(one)
    left = -TICK - CLEAR
    return tuple(
        Label(text, complex(left, height - size / 2), size, "end") for height, text in sorted(kept)
    )


def base_figures(
    ticks: Iterable[tuple[float, str]], strokes: Iterable[Ink], size: float
) -> tuple[Label, ...]:
    """Return the figures of a base, each below its tick, or next to it or above it where a curve is in the way.

    ``ticks``: positions, mm, with their texts. The last one always stays, others where there is room.
    """
    low, high = -TICK - CLEAR - size, TICK + CLEAR
    ink = _Inked(strokes, (low, high + size))
    found: list[Label] = []
    taken: list[tuple[float, float]] = []
    there = sorted(ticks)
    for at, text in (*there[-1:], *there[:-1]):
        wide = letter(text, size=size).width
        left = np.repeat([at - wide / 2, at - BESIDE - wide, at + BESIDE], 2)
        level = np.tile([low, high], 3)
        free = ink.costs(left, level, left + wide, level + size) < _HEAVY
        for start, end in taken:
            free &= (left >= end + _apart(size)) | (left + wide <= start - _apart(size))
        if free.any():
            best = int(np.argmax(free))
            found.append(Label(text, complex(left[best], level[best]), size))
            taken.append((left[best], left[best] + wide))
    return tuple(found)


def _apart(size: float) -> float:
    """Return the clear width between two numbers of a height, mm."""
    return max(BETWEEN, WORDS * size)


def _thinned(row: Sequence[Named], size: float) -> list[Named]:
    """Return the positions that bear numbers: as many as fit side by side."""
    feet = np.sort([one.at.real for one in row if np.isfinite(one.at)])
    apart = np.diff(feet)
    pitch = float(np.min(apart, initial=np.inf, where=apart > 1e-6))
    widest = max((letter(one.text, size=size).width for one in row), default=0.0)
    every = next((n for n in EVERY if n * pitch >= widest + _apart(size)), EVERY[-1])
    return [one for k, one in enumerate(row) if k % every == 0]


class _Inked:
    """What is drawn, main lines and others, where letters look for places."""

    def __init__(self, strokes: Iterable[Ink], band: tuple[float, float]) -> None:
        """``band``: how low and how high letters are tried at all, mm; what is drawn beyond it is in no way."""
        kinds: dict[str, list[Ink]] = {"heavy": [], "level": [], "light": []}
        for one in strokes:
            if _meets(one, band):
                kind = "heavy" if one.pen in HEAVY else "level" if _is_level(one) else "light"
                kinds[kind].append(one)
        self.heavy, self.level, self.light = (shapely.STRtree(shapes(k)) for k in kinds.values())

    def costs(self, left: Reals, low: Reals, right: Reals, high: Reals) -> Reals:
        """Return what it costs to stand in frames; arrays of one shape."""

        def met(tree: shapely.STRtree, by: float) -> Reals:
            frames = shapely.box(left - by, low - by, right + by, high + by).ravel()
            hits = tree.query(frames, predicate="intersects")[0]
            return np.bincount(hits, minlength=frames.size).reshape(left.shape).astype(float)

        heavy = _HEAVY * met(self.heavy, CLEAR / 2 + HEAVY_HALF)
        level = _LEVEL * (met(self.level, CLEAR / 2) > 0.0)
        return np.asarray(heavy + level + _LIGHT * met(self.light, CLEAR / 2))


def _is_level(stroke: Ink) -> bool:
    """Whether a stroke is a straight line along the axis."""
    if isinstance(stroke, Bezier) or stroke.closed:
        return False
    return all(bulge == 0.0 and y == stroke.path[0][1] for _, y, bulge in stroke.path)


def _meets(stroke: Ink, band: tuple[float, float]) -> bool:
    """Whether a stroke may enter a band of heights; an arc bows out by its bulge at most."""
    if isinstance(stroke, Bezier):
        heights, by = [spot.imag for spot in stroke.controls], 0.0
    else:
        heights, bows = [y for _, y, _ in stroke.path], [abs(bulge) for _, _, bulge in stroke.path]
        along = [x for x, _, _ in stroke.path]
        by = max(bows) * (max(along) - min(along) + max(heights) - min(heights))
    return min(heights) - by <= band[1] and max(heights) + by >= band[0]


def _around(base: float, other: float, size: float) -> list[tuple[float, float]]:
    """Return levels of numbers, mm, and what it costs to stand there: on one side of an axis, on the other."""
    found = [(base, 0.0), (other, _OTHER_SIDE)]
    for k, by in enumerate(_deeper(size), 1):
        found += [
            (min(base, other) - by, k * _ALONE),
            (max(base, other) + by, k * _ALONE + _OTHER_SIDE),
        ]
    return found


def _level(
    named: Sequence[Named],
    bases: Sequence[tuple[float, float]],
    size: float,
    ink: _Inked,
    cost: float = 0.0,
    beside: float = BESIDE,
) -> _Row:
    """Return numbers on a level; ``bases``: its height, those for what finds no place there, mm, with costs.

    ``cost``: of the level; ``beside``: clear width to a perpendicular, mm.
    """
    if not named:
        return _Row((), cost)
    levels, moved = zip(*bases, strict=True)
    ordered = sorted(named, key=lambda one: one.at.real)
    made = [letter(one.text, size=size) for one in ordered]
    feet, wide = np.array([one.at.real for one in ordered]), np.array([one.width for one in made])
    up, down = (np.array([[getattr(m, k)] for m in made]) for k in ("ascent", "descent"))
    far = np.array(FAR)
    left = (feet - beside - wide)[:, None] - far, (feet + beside)[:, None] + far
    starts = np.concatenate(left, axis=1)
    ends = starts + wide[:, None]
    first, last = np.minimum(starts, feet[:, None]), np.maximum(ends, feet[:, None])
    passed = (feet > first[..., None]) & (feet < last[..., None])
    own = _FOOT * passed.sum(axis=2) + _FAR * np.tile(far, 2)
    whole = [
        own + ink.costs(starts, base - down + 0 * starts, ends, base + up + 0 * starts)
        for base in levels
    ]
    tried = np.round(np.concatenate(whole, axis=1), 6)
    sides = np.repeat(range(len(levels)), starts.shape[1])
    labels: list[Label] = []
    taken, side, apart = np.full(len(levels), -math.inf), 0, max(2 * beside, _apart(size))
    for k, one in enumerate(ordered):
        again = np.tile(starts[k], len(levels))
        costs = tried[k] + _LABEL * (again < taken[sides] + apart)
        costs = costs + np.where((sides == 1) & (side == 1), _STAYS, np.array(moved)[sides])
        best = int(np.argmin(costs))
        if costs[best] >= _LABEL:
            continue
        side = int(sides[best])
        at = complex(starts[k, best % starts.shape[1]], levels[best // starts.shape[1]])
        labels.append(Label(one.text, at, size, of=one.of, position=one.position))
        taken[side], cost = at.real + float(wide[k]), cost + float(costs[best])
    return _Row(tuple(labels), cost)
