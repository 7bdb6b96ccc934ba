"""Columns of figures read off the log: mm on the sheet, times μ, in SI; what they were called before."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isnan
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Length, Reals
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.errors import DrawnRemedy
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import unit_name
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.project import Project
from graphic_tmm.scene.chapter import MECHANISM, Answer

Row = list[float | None]
"""The figures of one drawing along the positions; None where there is none."""
Positions = tuple[tuple[str, float | None], ...]
"""Positions by their numbers and the coordinates of the drive, degrees or m."""


@dataclass(frozen=True, eq=False)
class Column:
    """Figures along the positions, drawing by drawing: mm on the sheet, and SI.

    ``mm``, ``value``: (trial, position), NaN where nothing is measured; one trial where all drawings are alike.
    ``quantity``: the letter of what it stands for, if that is not the one of the segment.
    ``at``: the numbers of its positions and their angles (degrees, None where there is none), if they are not
    those of the mechanism.
    """

    plan: str
    segment: str
    letter: str
    unit: str
    mm: Reals
    value: Reals
    at: Positions = ()
    quantity: str = ""

    def without(self, places: Sequence[int]) -> Column:
        """Return the column with nothing at the places (indices) of positions that cannot be drawn."""
        return self.blank(np.isin(range(self.value.shape[1]), places)[None]) if places else self

    def blank(self, gone: NDArray[np.bool_]) -> Column:
        """Return the column with nothing where ``gone``, (trial, position)."""
        mm, value = (np.where(gone, np.nan, rows) for rows in (self.mm, self.value))
        return replace(self, mm=mm, value=value)

    def placed_as(self, other: Column) -> Column:
        """Return the column with its positions in the order of those of another.

        A list stands in the order of its first drawing: the lists of two blocks of drawings may differ in it.
        """
        if self.at == other.at:
            return self
        names = [name for name, _ in self.at]
        order = [names.index(name) for name, _ in other.at]
        return replace(self, mm=self.mm[:, order], value=self.value[:, order], at=other.at)

    @property
    def drawn(self) -> bool:
        """Whether anything of it is measured in mm."""
        return bool(np.isfinite(self.mm).any())

    @property
    def first_figures(self) -> tuple[Row, Row]:
        """The figures of the first drawing, mm and value."""
        mm, value = (
            [None if isnan(x) else x for x in row[0].tolist()] for row in (self.mm, self.value)
        )
        return mm, value


def known_at(columns: Sequence[Column]) -> list[int]:
    """Return the positions (indices) at which any of some columns, all as long, has a value."""
    known = [np.isfinite(one.value).any(axis=0) for one in columns]
    return [int(k) for k in np.flatnonzero(np.any(known, axis=0))]


def row_of(values: Reals, places: Sequence[int], count: int) -> Reals:
    """Return values (trial, position) at ``places`` out of ``count`` positions; NaN elsewhere, and of ±∞."""
    row = np.full((len(values), count), np.nan)
    row[:, list(places)] = np.where(np.isfinite(values), values, np.nan)
    return row


def listed(
    plan: str,
    segment: str,
    letter: str,
    unit: str,
    figures: Sequence[Reals],
    heads: Sequence[str],
    mm: Sequence[Reals] = (),
) -> Column:
    """Return figures, (trial,), that stand under heads of their own: wheels, points of a line, rows of a list.

    ``mm``: what was measured for each of them; nothing if it is left out. Without heads it is one figure.
    """
    names = tuple((head, None) for head in heads or ("",))
    value = np.stack(np.broadcast_arrays(*figures), axis=1).astype(float)
    value[~np.isfinite(value)] = np.nan
    lengths = np.stack(np.broadcast_arrays(*mm), axis=1) if mm else empty(len(names))
    return Column(plan, segment, letter, unit, lengths, value, names)


def empty(count: int) -> Reals:
    """Return the figures of what is not drawn, or not known, at any of ``count`` positions; (1, position)."""
    return np.full((1, count), np.nan)


def ordinates(reading: Reading, mark: Mark, mu: Mark, count: int) -> tuple[Reals, Reals]:
    """Return an ordinate along the positions: mm, and what it stands for."""
    mm, value = (row_of(reading.figure(mark, by), range(count), count) for by in (None, mu))
    return mm, value


def measured_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return every length that is measured; one that is the same in all positions stands at the first."""
    found = []
    for step in drawn.construction.steps:
        if step.it.kind is not Length or not step.op.reads:
            continue
        view = drawn.construction.view(step.it.view)
        mu = view.scale if view is not None else None
        mm = drawn.reading.figure(step.it)
        count = mm.shape[1]
        value = drawn.reading.figure(step.it, mu) if mu is not None else empty(count)
        lengths, figures = (row_of(row, range(count), count) for row in (mm, value))
        unit = unit_name(unit_of_value(mu), drawn.scene.language) if mu is not None else ""
        at = tuple((name, None) for name in drawn.names[:count])
        segment = segment_name(step.it.letter)
        found.append(Column(step.it.view, segment, step.it.name, unit, lengths, figures, at))
    return tuple(found)


def unit_of_value(mu: Mark) -> str:
    """Return the unit of what a length stands for by a scale factor, in SI; "" where that is a number."""
    unit = mu.unit.removesuffix("/mm").strip("()")
    return "" if unit == "1" else unit


def own_columns(drawn: Drawn) -> Iterable[Column]:
    """Return what was measured on a board of its own; nothing of the mechanism's, which chapters share."""
    return measured_columns(drawn) if drawn.board != MECHANISM else ()


@dataclass(frozen=True)
class Tabled(Answer):
    """A chapter's tables.

    ``columns``: along the positions; by default the lengths measured on a board of its own. ``results``: by
    name; ``marks``: those that results are, by the same names; ``facts``: further data for machines.
    """

    stands: ClassVar[str] = "table.TABLE"
    columns: Callable[[Drawn], Iterable[Column]] = own_columns
    results: Callable[[Drawn], Results] = lambda drawn: {}
    marks: Callable[[Drawn], Mapping[str, Mark]] = lambda drawn: {}
    facts: Callable[[Drawn], Mapping[str, Any]] = lambda drawn: {}


def _no_plan(
    drawn: Drawn, plan: str, place: int, name: str, title: str, upon: Sequence[Stroke]
) -> Drawing:
    raise KeyError(plan)


Crossed = tuple[tuple[Mark, Mark], tuple[Mark, Mark]]
"""Two lines, each by two points, or by a point and a line along which it goes."""


class Choice(NamedTuple):
    """A point of a plan that may be chosen otherwise; ``others``: where it stands then, (choice, position), mm.

    ``hanging``: the names of it and of what is read of the plan that hangs on the choice.
    """

    plan: str
    point: str
    others: NDArray[np.complex128]
    hanging: frozenset[str]


class Elsewhere(NamedTuple):
    """What was laid in another of its places: its ``mark``, and what is given of that place."""

    mark: Mark
    given: Mapping[Mark, NDArray[np.float64]]


class GroupPlaces(NamedTuple):
    """The places that a group can take where it is drawn, each with what a scene writes that means it.

    ``group``: its name; ``taken``: which of them (index) is drawn.
    """

    group: str
    places: tuple[DrawnRemedy, ...]
    taken: int


@dataclass(frozen=True)
class Readings(Answer):
    """What a chapter knows of readings.

    ``pointed``: the plans of which readings may give points; ``plan_at``: such a plan in one position, lettered
    clear of what is drawn upon it; ``figure_at``: another figure by its view, None where it has none of it or
    not there. ``named_marks``: marks by plan and the name that machines read.
    ``vectors``: the columns of the vectors that are measured on its plans. ``crossings``: by a point, other
    pairs of lines that meet there, each through two points, or through one along a line. ``choices``: points
    that may be chosen otherwise. ``elsewhere``: what can be laid in other places by mistake;
    ``places``: these and that which is drawn, small, for people to choose from.
    """

    stands: ClassVar[str] = "views.READINGS"
    pointed: tuple[str, ...] = ()
    plan_at: Callable[[Drawn, str, int, str, str, Sequence[Stroke]], Drawing] = _no_plan
    figure_at: Callable[[Drawn, str, int, str], Drawing | None] = lambda drawn, view, place, name: (
        None
    )
    named_marks: Callable[[Project], Mapping[tuple[str, str], Mark]] = lambda project: {}
    vectors: Callable[[Drawn], Iterable[Column]] = lambda drawn: ()
    crossings: Callable[[Project], Mapping[Mark, tuple[Crossed, ...]]] = lambda project: {}
    choices: Callable[[Drawn], Iterable[Choice]] = lambda drawn: ()
    elsewhere: Callable[[Drawn], Iterable[Elsewhere]] = lambda drawn: ()
    places: Callable[[Drawn], Iterable[GroupPlaces]] = lambda drawn: ()


class Former(NamedTuple):
    """A kind of name that is printed no more.

    ``until``: the first version that has another; ``then``: a pattern of the name; ``now``: what the segment
    stands for, by the parts of the pattern: that letter has stayed.
    """

    until: str
    plan: str
    then: str
    now: str


_POINT = r"([^\W\d_]\d*′*)"
FORMER = (
    # nab, tba3, kaa3, raa3: an₂, n₃a₃, ak₂, k₂a₃ on the plan
    Former("0.13.0", "accelerations", rf"([ntkr]){_POINT}{_POINT}", "a_{2}{1}^{0}"),
    # na, ta, of a crank that speeds up: πn₁, n₁a
    Former("0.13.0", "accelerations", rf"([nt]){_POINT}", "a_{1}^{0}"),
    # noa, toa, of the same, with its pivot
    Former("0.4.0", "accelerations", rf"([nt]){_POINT}{_POINT}", "a_{2}^{0}"),
    # sB, a way that has no sign: |s_B|, apart from the way that a diagram lays off
    Former("0.13.0", "positions", rf"s{_POINT}", "|s_{0}|"),
)
"""Every name given up, the newest first; what several rows fit is what the first says, if it is there."""
_LEFT_OUT = str.maketrans("", "", "_{} ")


def renamed(plan: str, typed: str, known: Mapping[str, Collection[str]]) -> str:
    """Return the segment that a plan had under this name in an earlier version, "" if none or still.

    ``known``: the segments that are there now, with what they stand for (and whatever else they are called).
    """
    bare = typed.translate(_LEFT_OUT)
    for row in () if bare in known else FORMER:
        found = re.fullmatch(row.then, bare) if row.plan == plan else None
        if found is not None:
            now = row.now.format(*found.groups()).casefold()
            for segment, called in known.items():
                if now in map(str.casefold, called):
                    return segment
    return ""


def is_called(column: Column, name: str) -> bool:
    """Whether a column has this name, or had it in an earlier version."""
    return name == column.segment or bool(
        renamed(column.plan, name, {column.segment: (plain(column.quantity),)})
    )
