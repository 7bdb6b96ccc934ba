"""Figures that move with the crank: as chapters draw them, and their ink as rows over the angles.

The chapter's own ink is drawn at every fifth degree, and at each degree wherever that does not tell what lies
between: where a stroke comes or goes, jumps, or bends more than four places tell. What
lies between is laid through four places by Lagrange's cubic. So nothing is drawn by a second rule, and a turn
costs a fifth.

Where a mechanism can hardly be drawn a plan of it flies away: it is then kilometres large. It is not there at
such an angle, as where it cannot be drawn.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from math import isfinite
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense
from graphic_tmm.paper.drawing import Drawing, Stroke, Wanted
from graphic_tmm.readers.columns import Column
from graphic_tmm.scene.chapter import Answer


class Output(NamedTuple):
    """A link that a mechanism moves to and fro: its number, a point of it, what it turns about if it does."""

    link: int
    point: Mark
    pivot: Mark | None


@dataclass(frozen=True)
class Moving:
    """A figure that moves with the crank.

    ``name``: of its view in the log; ``title``, ``caption``: what people do (mark-up), its scale factors.
    ``at``: a position (index) -> its ink, its letters still wanted; empty where it cannot be drawn.
    ``on_sheet``: what the view of a position is called that shows the same on a sheet, by its number.
    ``still``: what stands about it and does not move. ``columns``: what is told of it along the positions.
    ``crank``: of the mechanism itself the pivot and the pin of what is turned; ``output``: what it moves.
    """

    name: str
    title: str
    caption: str
    at: Callable[[int], Drawing]
    on_sheet: Callable[[str], str]
    still: Callable[[], Drawing] | None = None
    columns: Callable[[], Iterable[Column]] = lambda: ()
    crank: tuple[Mark, Mark] | None = None
    output: Output | None = None


@dataclass(frozen=True)
class MovingFigures(Answer):
    """The ``figures`` that a chapter shows of one position, whichever it is.

    ``own``: the sheet's drawing and one of all angles -> what of the former's cache the latter has of its own.
    """

    stands: ClassVar[str] = "turning.FIGURES"
    figures: Callable[[Drawn], Iterable[Moving]] = lambda drawn: ()
    own: Callable[[Drawn, Drawn], Mapping[str, Any]] = lambda sheet, drawn: {}


STEP = 5
"""Degrees between two angles that are drawn anyway."""
NEAR = 0.05
"""What lies between is off by no more, mm, where it is smooth: a fifth of a thin line."""
HEAD = 0.25
"""How far off the head of an arrow counts: it turns fast where its vector is almost nothing."""
AWAY = 10.0
"""What reaches so many times as far as at half the angles has flown away."""
USUAL = 200.0, 1000.0
"""A figure is taken to reach so far there at least, and at most, mm: sheets are no larger."""
BENT = 500.0
"""An arc whose bulge is more is a whole turn but for nothing, and no arc."""
ASIDE = 5.0 / 128.0
"""How far a cubic through four even places is off half way between the first two, of the fourth difference."""


class MovingStroke(NamedTuple):
    """A stroke that moves: its pen, whether closed and filled, what it comes from, its vertices."""

    pen: str
    closed: bool
    filled: bool
    of: tuple[int, ...]
    part: str
    vertices: int
    ordinal: int


class Letter(NamedTuple):
    """A letter that moves: its mark-up without figures, its size, the marks that it names."""

    text: str
    size: float
    of: tuple[int, ...]
    ordinal: int


Key = MovingStroke | Letter
Bools = NDArray[np.bool_]
Ints = NDArray[np.int64]


@dataclass(frozen=True)
class Strands:
    """A figure over the angles that were drawn.

    ``drawn``: these (indices), every fifth degree first, then the insides of the intervals ``refined``
    (numbers), then what stands behind the whole degrees. ``rows``: x, y and bulge of each vertex, or where a
    letter's point is, by what moves, (drawn, column), mm; NaN where it is not there.
    """

    drawn: tuple[int, ...]
    refined: tuple[int, ...]
    rows: Mapping[Key, Reals]

    def at(self, whole: int, keys: Iterable[Key]) -> dict[Key, Reals]:
        """Return the rows of some keys at all whole degrees, and behind them."""
        return {key: spread(self.rows[key], whole, self.refined) for key in keys}


def strands(dense: Dense, moving: Moving) -> Strands:
    """Return a figure over the angles, drawn as often as it needs."""
    base = list(range(0, dense.whole, STEP))
    drawing = _drawing(dense, moving, base)
    rows = _rows(drawing(k) for k in base)
    refined = _refined(_filled(rows, len(base)), len(base), ends=dense.ends)
    more = [STEP * i + j for i in refined for j in range(1, STEP)]
    more += range(dense.whole, dense.turned.size)
    rows = _rows((drawing(k) for k in more), rows, len(base))
    return Strands((*base, *more), refined, _filled(rows, len(base) + len(more)))


def _drawing(dense: Dense, moving: Moving, usual: Iterable[int]) -> Callable[[int], Drawing]:
    """Return what draws a figure at an angle (index); where that cannot be drawn, or flies away, it is empty.

    ``usual``: the angles that tell how far it usually reaches.
    """
    nothing = Drawing(moving.name, "")

    @cache
    def drawing(k: int) -> Drawing:
        return nothing if k in dense.drawn.undrawn else moving.at(k)

    reaches = [_reach(drawing(k)) for k in usual if k not in dense.drawn.undrawn]
    far = AWAY * float(np.clip(np.median(reaches or [0.0]), *USUAL))
    return lambda k: drawing(k) if _reach(drawing(k)) <= far else nothing


def _reach(drawing: Drawing) -> float:
    """Return how far a figure reaches along either axis from where its places are counted, mm."""
    places = (abs(value) for _, values in _things(drawing) for value in _coordinates(values))
    return max(places, default=0.0)


def _coordinates(values: Sequence[float]) -> Iterator[float]:
    """Yield the coordinates of what `_things` tells: of a stroke every third value is a bulge."""
    for k, value in enumerate(values):
        if k % 3 < 2:
            yield value


_Rows = dict[Key, dict[int, list[float]]]


def _rows(drawings: Iterable[Drawing], rows: _Rows | None = None, begun: int = 0) -> _Rows:
    """Return the vertices of what moves, by what it is and by the number of the drawing."""
    found: _Rows = rows or {}
    for k, drawing in enumerate(drawings, begun):
        for key, values in _things(drawing):
            found.setdefault(key, {})[k] = values
    return found


def _filled(rows: _Rows, count: int) -> dict[Key, Reals]:
    """Return the same as arrays, (drawn, column)."""
    found = {}
    for key, own in rows.items():
        array = np.full((count, len(next(iter(own.values())))), np.nan)
        array[list(own)] = list(own.values())
        found[key] = array
    return found


def _things(drawing: Drawing) -> Iterator[tuple[Key, list[float]]]:
    met = Counter[object]()
    for stroke in drawing.strokes:
        if isinstance(stroke, Stroke):
            values = [value for vertex in stroke.path for value in vertex]
            if all(map(isfinite, values)) and all(abs(one) < BENT for one in values[2::3]):
                yield line_key(stroke, met), values
    for one in drawing.wanted:
        at = one.at
        if isfinite(at.real) and isfinite(at.imag):
            yield letter_key(one, met), [at.real, at.imag]


def line_key(stroke: Stroke, met: Counter[object]) -> MovingStroke:
    """Return by what a stroke is known again at another angle; ``met``: how often its like was met."""
    like = (stroke.pen, stroke.closed, stroke.filled, stroke.of, stroke.part, len(stroke.path))
    met[like] += 1
    return MovingStroke(*like, met[like])


def letter_key(one: Wanted, met: Counter[object]) -> Letter:
    """Return by what a letter is known again at another angle; a figure behind it is left out."""
    like = (bare(one.text), one.size, one.of)
    met[like] += 1
    return Letter(*like, met[like])


def bare(text: str) -> str:
    """Return the mark-up of a letter without the figure that it may tell.

    >>> bare("h_{G4} = 34,6"), bare("a")
    ('h_{G4}', 'a')
    """
    return text.partition(" = ")[0]


def _refined(rows: Mapping[Key, Reals], count: int, *, ends: bool) -> tuple[int, ...]:
    """Return the intervals whose inside four places do not tell: those where something comes, goes, jumps.

    ``ends``: the row has ends, and the last interval leads on to no first one.
    """
    lines = {key: row for key, row in rows.items() if isinstance(key, MovingStroke)}
    if not lines:
        return ()
    bad = np.zeros(count, dtype=bool)
    bad[-1] = ends
    for row in lines.values():
        there = np.isfinite(row[:, 0])
        bad |= there != np.roll(there, -1)
    first = np.concatenate([np.roll(row, -1, axis=0) - row for row in lines.values()], axis=1)
    fourth = first
    for _ in range(3):
        fourth = np.roll(fourth, -1, axis=0) - fourth
    counts = [np.full(row.shape[1], HEAD if key.filled else 1.0) for key, row in lines.items()]
    far = np.nan_to_num(np.abs(fourth)) * np.concatenate(counts) * ASIDE > NEAR  # from here on
    around = (np.arange(count)[:, None] + np.arange(4)) % count
    while True:
        bad |= _short(bad)
        open_ = ~bad[around].any(axis=1)
        at, column = np.nonzero(far & open_[:, None])
        if not at.size:
            return tuple(int(i) for i in np.flatnonzero(bad))
        own = first[around[at], column[:, None]]
        apart = np.abs(own - np.median(own, axis=1, keepdims=True))
        bad[np.unique((at + apart.argmax(axis=1)) % count)] = True


def _short(bad: Bools) -> Bools:
    """Return the intervals between bad ones that are fewer than four together: too few for a cubic."""
    if not bad.any():
        return bad
    first = int(np.argmax(bad))
    turned, found = np.roll(bad, -first), bad.copy()
    ends = np.flatnonzero(turned)
    for start, end in zip(ends, [*ends[1:], bad.size], strict=True):
        if end - start - 1 < 4:
            found[(np.arange(start, end) + first) % bad.size] = True
    return found


def begins(count: int, refined: Sequence[int]) -> list[int]:
    """Return where the four places begin that tell of each interval, counted from its own beginning.

    One before it; no four places reach over a refined interval.
    """
    bad = set(refined)
    return [
        0 if (i - 1) % count in bad else -2 if (i + 1) % count in bad else -1 for i in range(count)
    ]


def spread(rows: Reals, whole: int, refined: Sequence[int]) -> Reals:
    """Return rows of drawn angles at all whole degrees, (angle, column), and behind them what is behind.

    ``rows``: as in `Strands`. The page's program does the same.
    """
    count = whole // STEP
    base, inside = rows[:count], rows[count : count + (STEP - 1) * len(refined)]
    start = np.array(begins(count, refined))
    nodes = (np.arange(count) + start)[:, None] + np.arange(4)
    places = base[nodes % count]  # (interval, node, column)
    found = np.empty((whole, rows.shape[1]))
    found[::STEP] = base
    for j in range(1, STEP):
        share = np.array([weights(j / STEP - 1 - s) for s in start])
        found[j::STEP] = np.einsum("in,inc->ic", share, places)
    for n, i in enumerate(refined):
        found[STEP * i + 1 : STEP * (i + 1)] = inside[(STEP - 1) * n : (STEP - 1) * (n + 1)]
    return np.concatenate([found, rows[count + inside.shape[0] :]])


def folded(row: Ints, whole: int, refined: Sequence[int]) -> Ints:
    """Return a row of drawn angles, the insides of intervals told by how far they are off the straight line."""
    count = whole // STEP
    inside = slice(count, count + (STEP - 1) * len(refined))
    found = row.copy()
    found[inside] -= _straight(row, count, refined)
    return found


def unfolded(row: Ints, whole: int, refined: Sequence[int]) -> Ints:
    """Return the row that was `folded`; the page's program does the same."""
    count = whole // STEP
    inside = slice(count, count + (STEP - 1) * len(refined))
    found = row.copy()
    found[inside] += _straight(row, count, refined)
    return found


def _straight(row: Ints, count: int, refined: Sequence[int]) -> Ints:
    """Return what lies on the straight lines inside intervals, rounded down."""
    at = np.array(refined, dtype=int)
    start, end = row[at], row[(at + 1) % count]
    inner = np.arange(1, STEP)
    return np.asarray((start[:, None] + (end - start)[:, None] * inner // STEP).ravel())


def weights(u: float) -> tuple[float, float, float, float]:
    """Return how much of four even places makes what lies between the middle two, ``u`` of the way on."""
    return (
        -u * (u - 1) * (u - 2) / 6,
        (u + 1) * (u - 1) * (u - 2) / 2,
        -(u + 1) * u * (u - 2) / 2,
        (u + 1) * u * (u - 1) / 6,
    )
