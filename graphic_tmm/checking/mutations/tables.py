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

from graphic_tmm.checking.mutations.likelihood import common
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
SWAPPED_AT = said("the readings of {one} and {other} at position {position} are exchanged")
TIMES = said("the readings of {where} are {times} times as large as they should be")
OPPOSITE_SIGNS = said("the readings of {where} have the opposite signs")
OTHER_WAY = said("the {axis} of the points of {where} were counted the other way")
INVERTED = said("{where}: the lengths were divided by the scale factor instead of multiplied")
OTHER_SCALE = said("{where}: the lengths were multiplied by the scale factor {now}")
DEGREES = said("{where}: degrees were written for radians")
COMMON = said(
    "all lengths of {where} are {times} times what is due: the compass, a copy or the ruler"
)
POLE = said("the points of {where} are read from a pole that stands {times} mm off")
ASKEW = said("the points of {where} are turned by {times}°: the paper lay askew")
EVERYTHING = said("the table")
EMPTY = said("the readings of {where} are 0: it was left out, or not measured")
FROM_A_CENTIMETRE = said(
    "the readings of {where} are 10 mm too long: the ruler was read from its 1 cm mark"
)
OWN_SCALE = said(
    "the lengths of {where} are {times} times what is due: this plan was drawn to another scale"
)
WHERE_AT = said("{where}, position {position}")
FACTORS = (10.0, 0.1, 100.0, 0.01, 1000.0, 0.001)
COPY, PLAN_COPY, LEAST_COPY = 0.16, 0.055, 0.004
"""A copy is larger or smaller by so much (a logarithm) at the most, a plan alone by less, and at least."""
OPPOSITE, UPSIDE_DOWN = 4.0, 0.2
"""Rates all of the opposite sign are rather calculated so than written down so; what is drawn and bears signs
(ordinates of a diagram) is rather read with the axis upside down than drawn by another construction."""
TURNS = (-5.0, -4.0, -3.0, -2.0, -1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0)
"""Degrees: so far askew a sheet may lie. What is turned farther was drawn so."""
KINDS = ("mm", "value", "xy")
CENTIMETRE = 10.0
"""What is read too much from the first mark of a ruler that bears a number, mm."""
SLIPPED, EXACTLY_NOTHING = 0.02, 0.1
"""Cm for mm, a decimal comma lost in a whole plan: more usual than anything else in a table. What is 0 where
something is due was left out."""
ANOTHER_SCALE, FREE = 0.06, 90.0
"""A plan is drawn to another scale if it is so much larger or smaller (logarithm); the factor is found from the
readings, it might be any of so many."""
Lengths = NDArray[np.float64]
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

    def changes(self, at: NDArray[np.bool_]) -> bool:
        """Whether any of some rows, (row,), is written otherwise."""
        same = (self.source == np.arange(self.source.size)) & (self.factor == 1.0)
        return bool((at & ~(same & (self.plus == 0.0))).any())

    def moved(self, says: str, rows: Mapping[int, int], **told: object) -> Variation:
        """Return the readings of some rows (keys) standing in others, −1 nowhere."""
        source = self.source.copy()
        source[list(rows)] = list(rows.values())
        return self._replace(says=says, source=source, told=told)

    def scaled(
        self,
        says: str,
        rows: Sequence[int],
        factor: complex | NDArray[np.float64],
        plus: complex | NDArray[np.float64] | NDArray[np.complex128] = 0.0,
        **told: object,
    ) -> Variation:
        """Return the readings of some rows times a factor, (row,) or one for all, and more by ``plus``."""
        by, more = self.factor.copy(), self.plus.copy()
        by[list(rows)], more[list(rows)] = factor, plus
        return self._replace(says=says, told=told, factor=by, plus=more)


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

    def places(self) -> Iterator[_Together]:
        """Yield what may have gone wrong together: everything, a plan, a column."""
        every = list(self.columns)
        yield self._together("", "", every)
        for plan in self.plans():
            mine = [column for column in every if column[0] == plan]
            if len(mine) < len(every):
                yield self._together(plan, "", mine)
            for column in mine:
                if len(mine) > 1:
                    yield self._together(plan, column[1], [column])

    def positions_of_plans(self) -> Iterator[_Together]:
        """Yield what may have gone wrong together at one position: everything there, a plan."""
        for plan in ("", *self.plans()):
            mine = [column for column in self.columns if plan in ("", column[0])]
            for position in self.positions:
                yield self._together(plan, "", mine, position)

    def _together(
        self, plan: str, segment: str, columns: Sequence[Column], position: str = ""
    ) -> _Together:
        cost = float(len(self.positions)) if position else 1.0
        named = self.same()._replace(plan=plan, segment=segment, position=position, cost=cost)
        kinds = [kind for _, _, kind in columns]
        rows = [self.columns[column] for column in columns]
        if position:
            rows = [{position: row[position]} if position in row else {} for row in rows]
        return _Together(self, named, kinds, rows)

    def same(self) -> Variation:
        """Return the table as it is."""
        n = len(self.rows)
        return Variation(
            MISTAKE, TABLE, "", np.arange(n), np.ones(n, complex), np.zeros(n, complex), {}
        )


class _Together(NamedTuple):
    """What may have gone wrong together: its place, as a variation names it; the columns there.

    ``kinds``, ``columns``: of each what was read, and the row by position.
    """

    table: ReadingTable
    named: Variation
    kinds: Sequence[str]
    columns: Sequence[Mapping[str, int]]

    @property
    def at(self) -> dict[str, object]:
        """The name of its position in a sentence; nothing where it is of all positions."""
        return {"position": self.named.position} if self.named.position else {}

    def rows(self, *kinds: str) -> list[int]:
        """Return the rows of the columns of some kinds."""
        columns = zip(self.kinds, self.columns, strict=True)
        return [row for kind, column in columns if kind in kinds for row in column.values()]

    def standing(self, to: Mapping[str, str]) -> dict[int, int]:
        """Return by row the one of the position whose figure stands there; −1 where that was not read."""
        return {
            row: column.get(to.get(position, position), -1)
            for column in self.columns
            for position, row in column.items()
        }


def variations(
    table: ReadingTable,
    scales: Callable[[Taken], float],
    off: Callable[[int], complex],
    others: Mapping[str, float],
    apart: Callable[[int, int], bool],
    dues: Sequence[float],
) -> Iterator[Variation]:
    """Yield the variations of a table of readings.

    ``scales``: what a mm is in the unit of a reading; ``off``: how far a point that was read is from its
    due, mm; ``others``: the scale factors by their letters; ``apart``: whether two rows are due to differ;
    ``dues``: what is due in each row, of a point how far from its pole.
    """
    for place in table.positions_of_plans():
        yield from _times(place, scales)
        yield from _from_a_centimetre(place)
        if place.named.plan:
            yield from _own_scale(place, dues)
    for place in table.places():
        yield from _from_a_centimetre(place)
        yield from _empty(place)
        yield from _moved(place)
        if not place.named.segment:
            yield from _other_row(place)
        yield from _times(place, scales)
        yield from _quantities(place, scales, others)
        if not place.named.segment:
            yield from _instruments(place, off, dues)
    yield from _swapped(table, apart)


def _moved(place: _Together) -> Iterator[Variation]:
    """Rows one further, one too early, in the reversed order; two exchanged."""
    order = [p for p in place.table.positions if any(p in column for column in place.columns)]
    count = len(order)
    if count < 3:
        return
    for one, other in combinations(order, 2):
        rows = place.standing({one: other, other: one})
        found = place.named.moved(EXCHANGED, rows, one=one, other=other)
        yield found._replace(position=one, cost=float(count))
    if min(map(len, place.columns)) < count:
        return
    for says, shift in ((SHIFTED, 1), (SHIFTED_BACK, -1)):
        to = {p: order[(k + shift) % count] for k, p in enumerate(order)}
        yield place.named.moved(says, place.standing(to))
    for first in (0, count - 1):  # the first position stays, or is the last
        to = {p: order[(first - k) % count] for k, p in enumerate(order)}
        yield place.named.moved(REVERSED, place.standing(to))


def _other_row(place: _Together) -> Iterator[Variation]:
    """Figures one row too low, or too high: each stands at the next segment, as rows follow one another."""
    for kind in KINDS:
        rows = sorted(place.rows(kind))
        if len(rows) >= 3:
            for says, source in ((LOWER, [*rows[1:], -1]), (HIGHER, [-1, *rows[:-1]])):
                yield place.named.moved(says, dict(zip(rows, source, strict=True)))


def copied(table: ReadingTable, apart: Callable[[int, int], bool]) -> Iterator[Variation]:
    """Yield positions with the readings of the one before; ``apart``: whether two are due to differ."""
    for plan in table.plans():
        columns = [rows for column, rows in table.columns.items() if column[0] == plan]
        for one, other in zip(table.positions[1:], table.positions, strict=False):
            pairs = [(c[one], c[other]) for c in columns if one in c and other in c]
            some = [(k, j) for k, j in pairs if apart(k, j)]
            alike = all(_figure(table.rows[k]) == _figure(table.rows[j]) for k, j in some)
            if len(some) >= 2 and alike:
                found = table.same().moved(COPIED, {k: -1 for k, _ in some}, one=one, other=other)
                yield found._replace(plan=plan, position=one, cost=0.1, copied=True)


def _figure(taken: Taken) -> tuple[float | None, ...]:
    return taken.mm, taken.value, taken.x, taken.y


NOTHING = ((0.0, None), (None, 0.0), (0.0, 0.0))
"""Of a length, and a quantity: 0 where anything was written."""


def _times(place: _Together, scales: Callable[[Taken], float]) -> Iterator[Variation]:
    for kind in KINDS:
        rows = place.rows(kind)
        if len(rows) < 2:
            continue
        for factor in FACTORS:
            found = place.named.scaled(TIMES, rows, 1.0 / factor)
            found = found._replace(told={"times": factor, **place.at})
            usual = not place.named.segment and factor in (10.0, 0.1)
            yield found._replace(cost=found.cost * SLIPPED) if usual else found
        some = [place.table.rows[k] for k in rows]
        if place.named.position:
            continue
        if kind == "xy":
            yield place.named.scaled(TIMES, rows, -1.0, times=-1.0)._replace(cost=OPPOSITE)
            stand = np.array([taken.spot for taken in some])
            for axis, there in (("x", -stand.conjugate()), ("y", stand.conjugate())):
                found = place.named.scaled(OTHER_WAY, rows, 1.0, there - stand, axis=axis)
                yield found._replace(cost=OPPOSITE)
        elif kind == "value" or any(taken.signed for taken in some):
            drawn = all(taken.signed and np.isfinite(scales(taken)) for taken in some)
            cost = UPSIDE_DOWN if drawn else OPPOSITE
            yield place.named.scaled(OPPOSITE_SIGNS, rows, -1.0)._replace(cost=cost)


def _from_a_centimetre(place: _Together) -> Iterator[Variation]:
    """The ruler was read from the mark of 1 cm: all that was measured is that much too long."""
    rows = place.rows("mm")
    if len(rows) > 1:
        found = np.array([place.table.rows[k].mm or 0.0 for k in rows])
        one = place.named.scaled(FROM_A_CENTIMETRE, rows, 1.0, -CENTIMETRE * np.sign(found))
        yield one._replace(told=place.at)


def _empty(place: _Together) -> Iterator[Variation]:
    """What is 0 in all positions though it is due to be something tells nothing but that."""
    rows = place.rows(*KINDS)
    if place.named.segment and all(_figure(place.table.rows[k])[:2] in NOTHING for k in rows):
        found = place.named.moved(EMPTY, dict.fromkeys(rows, -1))
        yield found._replace(cost=EXACTLY_NOTHING, copied=True)


def _own_scale(place: _Together, dues: Sequence[float]) -> Iterator[Variation]:
    """A plan of one position is drawn to a scale of its own; what was calculated of it is right, or is not."""
    rows = place.rows("mm", "xy")
    read, whole = _lengths(place, dues)
    if len(rows) < 3 or not read.sum() > 0.0 or not whole.sum() > 0.0:
        return
    with np.errstate(all="ignore"):
        times = float(np.exp(np.median(np.log(read / whole))))
    if not np.isfinite(times) or times <= 0.0 or abs(np.log(times)) < ANOTHER_SCALE:
        return
    for kinds in (("mm", "xy"), KINDS):
        found = place.named.scaled(OWN_SCALE, place.rows(*kinds), 1.0 / times)
        found = found._replace(told={"times": round(times, 2), **place.at})
        yield found._replace(family=SCALE, cost=found.cost * FREE)


def _lengths(place: _Together, dues: Sequence[float]) -> tuple[Lengths, Lengths]:
    """Return the lengths of a place, of points how far from their pole, and what they should be, mm."""
    rows, every = place.rows("mm", "xy"), place.table.rows
    read = [abs(every[k].spot) if every[k].pointed else abs(every[k].mm or 0.0) for k in rows]
    return np.array(read), np.abs([dues[k] for k in rows])


def _quantities(
    place: _Together, scales: Callable[[Taken], float], others: Mapping[str, float]
) -> Iterator[Variation]:
    """Of quantities the scale factor is inverted or another one; rates are in degrees."""
    rows = place.rows("value")
    mu = np.array([scales(place.table.rows[k]) for k in rows])
    drawn = [k for k, m in zip(rows, mu, strict=True) if np.isfinite(m) and m > 0.0]
    if len(drawn) > 1:
        own, of_scale = mu[np.isfinite(mu) & (mu > 0.0)], place.named._replace(family=SCALE)
        yield of_scale.scaled(INVERTED, drawn, own**2)
        for letter, other in others.items():
            if not np.allclose(own, other):
                yield of_scale.scaled(OTHER_SCALE, drawn, own / other, now=letter)
    rates = [k for k, m in zip(rows, mu, strict=True) if not np.isfinite(m)]
    if len(rates) > 1:
        yield place.named.scaled(DEGREES, rates, np.pi / 180.0)


def _swapped(table: ReadingTable, apart: Callable[[int, int], bool]) -> Iterator[Variation]:
    for plan in table.plans():
        mine = [column for column in table.columns if column[0] == plan]
        for one, other in combinations(mine, 2):
            first, second = table.columns[one], table.columns[other]
            common = first.keys() & second.keys() if one[2] == other[2] else set()
            told = [p for p in common if apart(first[p], second[p])]
            for p in told:
                pair = {first[p]: second[p], second[p]: first[p]}
                names = {"one": one[1], "other": other[1], "position": p}
                found = table.same().moved(SWAPPED_AT, pair, **names)
                cost = float(len(table.positions))
                yield found._replace(plan=plan, segment=one[1], position=p, cost=cost)
            if len(told) < 2:
                continue  # links that turn alike have the same figures
            rows = {first[p]: second[p] for p in common} | {second[p]: first[p] for p in common}
            found = table.same().moved(SWAPPED, rows, one=one[1], other=other[1])
            yield found._replace(plan=plan, segment=one[1])


def _instruments(
    place: _Together, off: Callable[[int], complex], dues: Sequence[float]
) -> Iterator[Variation]:
    one = place.named._replace(kind=INSTRUMENT, family="")
    drawn, points = place.rows("mm", "xy"), place.rows("xy")
    times = common(*_lengths(place, dues)) if len(drawn) > 2 else 1.0
    if LEAST_COPY < abs(np.log(times)) < (PLAN_COPY if place.named.plan else COPY):
        yield one.scaled(COMMON, drawn, 1.0 / times, times=round(times, 2))
    if len(points) > 2:
        for degrees in TURNS:
            turn = complex(np.exp(-1j * np.radians(degrees)))
            yield one.scaled(ASKEW, points, turn, times=degrees)
        way = np.array([off(k) for k in points])
        mean = complex(np.median(way.real), np.median(way.imag))
        yield one.scaled(POLE, points, 1.0, -mean, times=round(abs(mean), 1))
