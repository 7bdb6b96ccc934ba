"""The table of readings, written down amiss: rows shifted, exchanged, copied, reversed, columns swapped, ×10.

Each variation says which reading stood where another should, and how many times it is too large; undone,
the rest of the drawing is as it was made. An instrument that is off is undone alike: a compass, a copy, a
pole, a sheet askew; it is told with a word and is never a mistake.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.mutations.mutation import SCALE, TABLE
from graphic_tmm.checking.records import INSTRUMENT, MISTAKE, Taken
from graphic_tmm.language.said import said

SHIFTED = said("the readings of {where} stand one position too far")
SHIFTED_BACK = said("the readings of {where} stand one position too early")
LOWER = said("the figures of {where} stand one row too low in the table")
HIGHER = said("the figures of {where} stand one row too high in the table")
REVERSED = said("the readings of {where} stand in the order of the positions reversed")
EXCHANGED = said("the readings of positions {one} and {other} are exchanged ({where})")
COPIED = said("the readings of position {one} are those of {other} again ({where})")
SWAPPED = said("the readings of {one} and {other} are exchanged")
TIMES = said("the readings of {where} are {times} times as large as they should be")
INVERTED = said("{where}: the lengths were divided by the scale factor instead of multiplied")
OTHER_SCALE = said("{where}: the lengths were multiplied by the scale factor {now}")
DEGREES = said("{where}: degrees were written for radians")
COMMON = said(
    "all lengths of {where} are {times} times what is due: the compass, a copy or the ruler"
)
POLE = said("the points of {where} are read from a pole that stands {times} mm off")
ASKEW = said("the points of {where} are turned by {times}°: the paper lay askew")
EVERYTHING = said("the table")
FACTORS = (10.0, 0.1, 100.0, 0.01, 1000.0, 0.001)
COMMON_FACTORS = tuple(float(f) for f in np.round(np.arange(0.95, 1.0501, 0.005), 3) if f != 1.0)
"""Up to 5 %: a scale or a copy may be so far off; what is more is a mistake."""
OPPOSITE = 4.0
"""Figures all of the opposite sign are rather calculated or drawn so than written down so."""
TURNS = (-5.0, -4.0, -3.0, -2.0, -1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0)
"""Degrees: so far askew a sheet may lie. What is turned farther was drawn so."""
Column = tuple[str, str, str]
"""A column of readings: plan, segment, and whether it is "mm", a "value" or "xy"."""


class Variation(NamedTuple):
    """Readings as they should have been written: of each the row that has it, how many times too large it is.

    ``source``: (row,), −1 for one that tells nothing; ``factor``, ``plus``: (row,), of points complex.
    ``told``: the names in the sentence. ``copied``: what tells nothing of its own is another's figure, exactly.
    """

    kind: str
    family: str
    says: str
    source: NDArray[np.intp]
    factor: NDArray[np.complex128]
    plus: NDArray[np.complex128]
    told: Mapping[str, object]
    plan: str = ""
    segment: str = ""
    position: str = ""
    cost: float = 1.0
    copied: bool = False


class ReadingTable:
    """The rows of readings by plan, segment and position."""

    def __init__(self, rows: Sequence[Taken], positions: Sequence[str]) -> None:
        self.rows, self.positions = rows, positions
        self.columns: dict[Column, dict[str, int]] = defaultdict(dict)
        for k, taken in enumerate(rows):
            kind = "xy" if taken.pointed else "mm" if taken.mm is not None else "value"
            self.columns[taken.plan, taken.segment, kind][taken.position] = k

    def plans(self) -> list[str]:
        """Return the plans that were read."""
        return list(dict.fromkeys(plan for plan, _, _ in self.columns))

    def places(self) -> Iterator[tuple[str, str, list[Column]]]:
        """Yield what may have gone wrong together: everything, a plan, a column; with its columns."""
        every = list(self.columns)
        yield "", "", every
        for plan in self.plans():
            mine = [column for column in every if column[0] == plan]
            if len(mine) < len(every):
                yield plan, "", mine
            for column in mine:
                if len(mine) > 1:
                    yield plan, column[1], [column]

    def same(self) -> Variation:
        """Return the table as it is."""
        n = len(self.rows)
        return Variation(
            MISTAKE, TABLE, "", np.arange(n), np.ones(n, complex), np.zeros(n, complex), {}
        )


def variations(
    table: ReadingTable,
    scales: Callable[[Taken], float],
    off: Callable[[int], complex],
    others: Mapping[str, float],
    apart: Callable[[int, int], bool],
) -> Iterator[Variation]:
    """Yield the variations of a table of readings.

    ``scales``: what a mm is in the unit of a reading; ``off``: how far a point that was read is from its
    due, mm.
    """
    for plan, segment, columns in table.places():
        named = table.same()._replace(plan=plan, segment=segment)
        told: dict[str, object] = {}
        yield from _moved(table, named, told, columns)
        if not segment:
            yield from _other_row(table, named, told, columns)
        yield from _times(table, named, told, columns)
        yield from _quantities(table, named, told, columns, scales, others)
        if not segment:
            yield from _instruments(table, named, told, columns, off)
    yield from _swapped(table, apart)


def _moved(
    table: ReadingTable,
    named: Variation,
    told: Mapping[str, object],
    columns: Sequence[Column],
) -> Iterator[Variation]:
    """Rows one further, one too early, in the reversed order; two exchanged, one copied from another."""
    order = [p for p in table.positions if any(p in table.columns[c] for c in columns)]
    count = len(order)
    if count < 3:
        return
    if min(len(table.columns[c]) for c in columns) == count:
        for says, shift in ((SHIFTED, 1), (SHIFTED_BACK, -1)):
            to = {p: order[(k + shift) % count] for k, p in enumerate(order)}
            yield _by_position(table, named, says, told, columns, to)
        back = {p: order[-k % count] for k, p in enumerate(order)}
        yield _by_position(table, named, REVERSED, told, columns, back)
        last = {p: order[count - 1 - k] for k, p in enumerate(order)}
        yield _by_position(table, named, REVERSED, told, columns, last)
        for one, other in combinations(order, 2):
            to = {p: p for p in order} | {one: other, other: one}
            words = {**told, "one": one, "other": other}
            found = _by_position(table, named, EXCHANGED, words, columns, to)
            yield found._replace(position=one, cost=float(count))


def _by_position(
    table: ReadingTable,
    named: Variation,
    says: str,
    told: Mapping[str, object],
    columns: Sequence[Column],
    to: dict[str, str],
) -> Variation:
    source = named.source.copy()
    for column in columns:
        rows = table.columns[column]
        for position, k in rows.items():
            source[k] = rows.get(to.get(position, position), -1)
    return named._replace(says=says, source=source, told=told)


def _other_row(
    table: ReadingTable,
    named: Variation,
    told: Mapping[str, object],
    columns: Sequence[Column],
) -> Iterator[Variation]:
    """Figures one row too low, or too high: each stands at the next segment, as rows follow one another."""
    for kind in ("mm", "value", "xy"):
        rows = sorted(k for c in columns if c[2] == kind for k in table.columns[c].values())
        if len(rows) < 3:
            continue
        for says, source in ((LOWER, [*rows[1:], -1]), (HIGHER, [-1, *rows[:-1]])):
            whole = named.source.copy()
            whole[rows] = source
            yield named._replace(says=says, source=whole, told=told)


def copied(table: ReadingTable, apart: Callable[[int, int], bool]) -> Iterator[Variation]:
    """Yield positions with the readings of the one before; ``apart``: whether two are due to differ."""
    for plan in table.plans():
        columns = [c for c in table.columns if c[0] == plan]
        for one, other in zip(table.positions[1:], table.positions, strict=False):
            pairs = [
                (table.columns[c][one], table.columns[c][other])
                for c in columns
                if one in table.columns[c] and other in table.columns[c]
            ]
            some = [(k, j) for k, j in pairs if apart(k, j)]
            alike = all(_figure(table.rows[k]) == _figure(table.rows[j]) for k, j in some)
            if len(some) < 2 or not alike:
                continue
            source = table.same().source.copy()
            source[[k for k, _ in some]] = -1
            yield table.same()._replace(
                says=COPIED,
                source=source,
                told={"one": one, "other": other},
                plan=plan,
                position=one,
                cost=0.1,
                copied=True,
            )


def _figure(taken: Taken) -> object:
    return taken.mm, taken.value, taken.x, taken.y


def _times(
    table: ReadingTable,
    named: Variation,
    told: Mapping[str, object],
    columns: Sequence[Column],
) -> Iterator[Variation]:
    for kind in ("mm", "value", "xy"):
        rows = [k for c in columns if c[2] == kind for k in table.columns[c].values()]
        if len(rows) < 2:
            continue
        for factor in (*FACTORS, -1.0):
            if factor == -1.0 and kind == "mm":
                continue
            found = _scaled(named, TIMES, {**told, "times": factor}, rows, 1.0 / factor)
            yield found._replace(cost=1.0 if factor > 0.0 else OPPOSITE)


def _scaled(
    named: Variation,
    says: str,
    told: Mapping[str, object],
    rows: Sequence[int],
    factor: complex | NDArray[np.float64],
    plus: complex = 0.0,
) -> Variation:
    by, more = named.factor.copy(), named.plus.copy()
    by[list(rows)] = factor
    more[list(rows)] = plus
    return named._replace(says=says, told=told, factor=by, plus=more)


def _quantities(
    table: ReadingTable,
    named: Variation,
    told: Mapping[str, object],
    columns: Sequence[Column],
    scales: Callable[[Taken], float],
    others: Mapping[str, float],
) -> Iterator[Variation]:
    """Of quantities the scale factor is inverted or another one; rates are in degrees."""
    rows = [k for c in columns if c[2] == "value" for k in table.columns[c].values()]
    mu = np.array([scales(table.rows[k]) for k in rows])
    drawn = [k for k, m in zip(rows, mu, strict=True) if np.isfinite(m) and m > 0.0]
    if len(drawn) > 1:
        own = mu[np.isfinite(mu) & (mu > 0.0)]
        yield _scaled(named, INVERTED, told, drawn, own**2)._replace(family=SCALE)
        for letter, other in others.items():
            if not np.allclose(own, other):
                words = {**told, "now": letter}
                found = _scaled(named, OTHER_SCALE, words, drawn, own / other)
                yield found._replace(family=SCALE)
    rates = [k for k, m in zip(rows, mu, strict=True) if not np.isfinite(m)]
    if len(rates) > 1:
        yield _scaled(named, DEGREES, told, rates, np.pi / 180.0)


def _swapped(table: ReadingTable, apart: Callable[[int, int], bool]) -> Iterator[Variation]:
    for plan in table.plans():
        mine = [c for c in table.columns if c[0] == plan]
        for one, other in combinations(mine, 2):
            if one[2] != other[2]:
                continue
            named = table.same()
            source = named.source.copy()
            first, second = table.columns[one], table.columns[other]
            common = first.keys() & second.keys()
            if sum(apart(first[p], second[p]) for p in common) < 2:
                continue  # links that turn alike have the same figures
            for p in common:
                source[first[p]], source[second[p]] = second[p], first[p]
            told = {"one": one[1], "other": other[1]}
            yield named._replace(says=SWAPPED, source=source, told=told, plan=plan, segment=one[1])


def _instruments(
    table: ReadingTable,
    named: Variation,
    told: Mapping[str, object],
    columns: Sequence[Column],
    off: Callable[[int], complex],
) -> Iterator[Variation]:
    one = named._replace(kind=INSTRUMENT, family="")
    drawn = [k for c in columns if c[2] in ("mm", "xy") for k in table.columns[c].values()]
    if len(drawn) > 2:
        for factor in COMMON_FACTORS:
            yield _scaled(one, COMMON, {**told, "times": factor}, drawn, 1.0 / factor)
    points = [k for c in columns if c[2] == "xy" for k in table.columns[c].values()]
    if len(points) > 2:
        for degrees in TURNS:
            turn = complex(np.exp(-1j * np.radians(degrees)))
            yield _scaled(one, ASKEW, {**told, "times": degrees}, points, turn)
        way = np.array([off(k) for k in points])
        mean = complex(np.median(way.real), np.median(way.imag))
        words = {**told, "times": round(abs(mean), 1)}
        yield _scaled(one, POLE, words, points, 1.0, -mean)
