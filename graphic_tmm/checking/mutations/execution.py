"""Mutations executed together: each a row beside the base, and the figures that they come to.

A row is run through a step only where one of its inputs differs from the base's, or the step itself is changed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.blocks import spread
from graphic_tmm.board.execute import Reading, cut, needed
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Complexes, Curve, Reals, arrays, places
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.cells import Key, figures, spots
from graphic_tmm.checking.mutations.mutation import Change, Mutation, changed_log
from graphic_tmm.drawn import Drawn, DrawnScene, Numbers

Rows = NDArray[np.intp]
SAME = 1e-9
"""Results that differ by less, of a mm or of themselves, are alike: steps agree to some 1e-12."""
BATCH = 2048
"""So many rows are run through a step at once: what a curve needs for them stays in memory."""


@dataclass(frozen=True)
class AssumedLog:
    """A log as it is taken to be drawn, and what is given."""

    board: Drawn
    log: Construction
    given: Mapping[Mark, object]

    @cached_property
    def marks(self) -> tuple[Mark, ...]:
        """Everything that it makes."""
        return tuple(step.it for step in self.log.steps)

    def mistaken(self, what: Mutation, place: int | None) -> AssumedLog:
        """Return it with a mistake, everywhere or at one position (its index)."""
        return AssumedLog(self.board, *changed_log(self.log, self.given, what, place))


class Sparse(NamedTuple):
    """The rows in which a mark differs from the base, in their order, and its values there, (row, position)."""

    rows: Rows
    value: Any


class Executed(NamedTuple):
    """A log executed with its mutations: the base's values by slot, (1, position), and where rows differ."""

    base: Mapping[int, Any]
    rows: Mapping[int, Sparse]
    size: int

    def whole(self, slot: int) -> Any:
        """Return a mark in all rows, (row, position); (1, position) where all are the base."""
        if slot not in self.rows:
            return self.base[slot]
        sparse = self.rows[slot]
        return _put(self.base[slot], self.size, sparse.rows, sparse.value)


Seen = Callable[[Step, Rows | None, list[Any], Any], Any]
"""Told of every step: rows (None: the base), its inputs and its result; returns what goes on from there."""


def executed(
    log: Construction,
    given: Mapping[Mark, object],
    mutations: Sequence[Mutation],
    wanted: Iterable[Mark],
    seen: Seen = lambda step, rows, drawn, value: value,
) -> Executed:
    """Execute a log and its mutations as far as some marks need it; NaN where something cannot be drawn."""
    own: dict[int, list[tuple[int, Change]]] = defaultdict(list)
    for row, one in enumerate(mutations):
        for slot, change in one.changes.items():
            own[slot].append((row, change))
    base: dict[int, Any] = {m.slot: as_value(given[m], m.kind) for m in log.given if m in given}
    count = max(map(places, base.values()), default=1)
    rows: dict[int, Sparse] = dict(_amiss(base, mutations))
    with np.errstate(all="ignore"):
        taken_ = (m for one in mutations for way in one.changes.values() for m in way.step.uses)
        for step in needed(log, (*wanted, *taken_)):
            it = step.it.slot
            drawn = [base[m.slot] for m in step.uses]
            base[it] = seen(step, None, drawn, _result(step, drawn, 1, count))
            parts = [*_inherited(step, base, rows, own.get(it, ()), seen, count)]
            parts += _mutated(own.get(it, ()), base, rows, seen, count)
            sparse = _differing(base[it], parts)
            if sparse is not None:
                rows[it] = sparse
    return Executed(base, rows, len(mutations))


def _amiss(base: Mapping[int, Any], mutations: Sequence[Mutation]) -> Iterator[tuple[int, Sparse]]:
    by: dict[int, list[tuple[int, Any]]] = defaultdict(list)
    for row, one in enumerate(mutations):
        for slot, way in one.amiss.items():
            if way.source.slot in base and slot in base:
                by[slot].append((row, way.factor * base[way.source.slot] + way.plus))
    for slot, found in by.items():
        values = [np.broadcast_to(v, (1, _wide([v for _, v in found]))) for _, v in found]
        yield slot, Sparse(np.array([row for row, _ in found]), np.concatenate(values))


def _wide(values: Iterable[Any]) -> int:
    return max(int(v.shape[1]) for v in values)


def _result(step: Step, drawn: Sequence[Any], rows: int, count: int) -> Any:
    """Return what a step makes of its inputs; one across positions is given all rows and positions of them."""
    run = partial(step.op.run, **step.choice) if step.choice else step.op.run
    if not step.op.across:
        return run(*drawn)
    return run(*(_each(spread(value, count), partial(_tall, count=rows)) for value in drawn))


def _inherited(
    step: Step,
    base: Mapping[int, Any],
    rows: Mapping[int, Sparse],
    own: Sequence[tuple[int, Change]],
    seen: Seen,
    count: int,
) -> Iterator[tuple[Rows, Any]]:
    """Yield the rows in which an input differs, and what comes of it."""
    sources = [rows[m.slot].rows for m in step.uses if m.slot in rows]
    if not sources:
        return
    found = np.unique(np.concatenate(sources)) if len(sources) > 1 else sources[0]
    if own:
        found = found[~np.isin(found, [row for row, _ in own])]
    for start in range(0, found.size, BATCH):
        some = found[start : start + BATCH]
        drawn = [taken(base[m.slot], rows.get(m.slot), some) for m in step.uses]
        yield some, seen(step, some, drawn, _result(step, drawn, some.size, count))


def _mutated(
    own: Sequence[tuple[int, Change]],
    base: Mapping[int, Any],
    rows: Mapping[int, Sparse],
    seen: Seen,
    count: int,
) -> Iterator[tuple[Rows, Any]]:
    """Yield the rows of which a step is mutated, and what comes of it: those of one operation at once."""
    groups: dict[Any, list[tuple[int, Change]]] = defaultdict(list)
    for row, change in own:
        step = change.step
        shapes = tuple(_shape(base[m.slot]) for m in step.uses)
        groups[id(step.op.run), tuple(step.choice.items()), shapes].append((row, change))
    for some in groups.values():
        changes = [change for _, change in some]
        step, at = changes[0].step, np.array([row for row, _ in some])
        drawn = [
            _stacked([c.step.uses[k] for c in changes], at, base, rows)
            for k in range(len(step.uses))
        ]
        drawn = [_from_before(value, k, changes) for k, value in enumerate(drawn)]
        value = _result(step, drawn, at.size, count)
        factors = np.array([c.factor for c in changes])
        if (factors != 1.0).any():
            value = value * factors[:, None]
        yield at, seen(_alike(step), at, drawn, value)


def _alike(step: Step) -> Step:
    """Return a step whose inputs are of slots of their own: of several rows they are different marks."""
    uses = tuple(mark._replace(slot=-1 - k) for k, mark in enumerate(step.uses))
    return step._replace(uses=uses)


def _shape(value: Any) -> Any:
    return (value.knots.shape[1], value.closed) if isinstance(value, Curve) else type(value)


def _stacked(
    marks: Sequence[Mark], at: Rows, base: Mapping[int, Any], rows: Mapping[int, Sparse]
) -> Any:
    """Return what each of some rows takes of a mark of its own, (row, position)."""
    first = marks[0]
    if all(m.slot == first.slot for m in marks):
        return taken(base[first.slot], rows.get(first.slot), at)
    some = [taken(base[m.slot], rows.get(m.slot), at[k : k + 1]) for k, m in enumerate(marks)]
    return _joined(some)


def _from_before(value: Any, use: int, changes: Sequence[Change]) -> Any:
    back = np.array([c.before == use for c in changes])
    if not back.any() or isinstance(value, Curve):
        return value
    return _each(value, lambda array: np.where(back[:, None], np.roll(array, 1, axis=1), array))


def taken(base: Any, sparse: Sparse | None, at: Rows) -> Any:
    """Return a mark in some rows, (row, position); the base's (1, position) where it is that in all of them."""
    if sparse is None:
        return base
    place = np.searchsorted(sparse.rows, at)
    place = np.minimum(place, sparse.rows.size - 1)
    there = sparse.rows[place] == at
    if not there.any():
        return base
    if there.all():
        return _each(sparse.value, lambda array: array[place])
    return _put(
        base, at.size, np.flatnonzero(there), _each(sparse.value, lambda a: a[place[there]])
    )


def _put(base: Any, count: int, rows: Rows, value: Any) -> Any:
    """Return (row, position): the base everywhere but in some rows."""

    def put(one: NDArray[Any], other: NDArray[Any]) -> NDArray[Any]:
        wide = max(one.shape[1], other.shape[1])
        found = np.empty((count, wide), np.result_type(one, other))
        found[:] = one[:1]
        found[rows] = other
        return found

    return _both(base, value, put)


def _each(value: Any, change: Callable[[NDArray[Any]], NDArray[Any]]) -> Any:
    if isinstance(value, Curve):
        return Curve(change(value.knots), change(value.tangents), value.closed)
    if isinstance(value, tuple):
        return type(value)(*map(change, value))
    return change(value)


def _both(one: Any, other: Any, change: Callable[[Any, Any], Any]) -> Any:
    if isinstance(one, Curve):
        return Curve(
            change(one.knots, other.knots), change(one.tangents, other.tangents), one.closed
        )
    if isinstance(one, tuple):
        return type(one)(*map(change, one, other))
    return change(one, other)


def _joined(values: Sequence[Any]) -> Any:
    if len(values) == 1:
        return values[0]
    first = values[0]
    if isinstance(first, Curve):
        knots, tangents = (np.concatenate([arrays(v)[k] for v in values]) for k in (0, 1))
        return Curve(knots, tangents, first.closed)
    if isinstance(first, tuple):
        return type(first)(*(_joined([v[k] for v in values]) for k in range(len(first))))
    wide = _wide(values)
    return np.concatenate([np.broadcast_to(v, (v.shape[0], wide)) for v in values])


def _differing(base: Any, parts: Sequence[tuple[Rows, Any]]) -> Sparse | None:
    """Return the rows whose results differ from the base's, in order; None if there is none."""
    found = []
    for rows, value in parts:
        value = _each(value, partial(_tall, count=rows.size))
        apart = np.zeros(rows.size, dtype=bool)
        for mine, due in zip(arrays(value), arrays(base), strict=True):
            apart |= _apart(mine, due)
        if apart.any():
            found.append((rows[apart], _each(value, lambda array: array[apart])))  # noqa: B023
    if not found:
        return None
    rows = np.concatenate([rows for rows, _ in found])
    order = np.argsort(rows, kind="stable")
    value = _joined([value for _, value in found])
    return Sparse(rows[order], _each(value, lambda array: array[order]))


def _tall(array: Any, count: int) -> Any:
    return array if array.shape[0] == count else np.broadcast_to(array, (count, array.shape[1]))


def _apart(mine: NDArray[Any], due: NDArray[Any]) -> NDArray[np.bool_]:
    off = np.abs(mine - due)
    near = off <= SAME * np.maximum(1.0, np.abs(due))
    lost = np.isnan(mine) & np.isnan(due)
    return np.asarray(~(near | lost).all(axis=1))


class _Rows(Mapping[int, Any]):
    """The values of some rows, put together when they are asked for; a position that is not drawn is NaN."""

    def __init__(
        self,
        beside: Executed,
        base: Mapping[int, Any],
        rows: NDArray[np.intp],
        places: Sequence[int],
    ) -> None:
        self.beside, self.base, self.rows, self.places = beside, base, rows, places

    def __getitem__(self, slot: int) -> Any:
        if slot not in self.beside.base:
            return self.base[slot]
        found = taken(self.beside.base[slot], self.beside.rows.get(slot), self.rows)
        return cut(found, self.places) if self.places else found

    def __iter__(self) -> Iterator[int]:
        return iter(self.base)

    def __len__(self) -> int:
        return len(self.base)


def as_drawn(
    made: DrawnScene, board: Drawn, beside: Executed, rows: NDArray[np.intp]
) -> DrawnScene:
    """Return a scene as some rows of a board draw it: one trial a row."""
    numbers = board.numbers
    whole = _Rows(beside, numbers.whole.values, rows, ())
    own = {
        view: Reading(_Rows(beside, one.values, rows, board.row(view)), one.positions)
        for view, one in numbers.own.items()
    }
    drawn = Reading(_Rows(beside, numbers.drawn.values, rows, ()), numbers.drawn.positions)
    other = Numbers(Reading(whole, numbers.whole.positions), own, drawn)
    boards = (replace(one, numbers=other) if one is board else one for one in made.boards)
    return DrawnScene(made.scene, tuple(boards))


def figures_of(
    made: DrawnScene,
    board: Drawn,
    beside: Executed,
    rows: NDArray[np.intp],
    wanted: Sequence[tuple[Key, bool]],
) -> dict[tuple[Key, bool], Reals | Complexes]:
    """Return figures of some rows, by key and whether in mm; (row,), of a point where it stands."""
    scene = as_drawn(made, board, beside, rows)
    found: dict[tuple[Key, bool], Any] = {}
    with np.errstate(all="ignore"):
        told = {mm: figures(scene, in_mm=mm) for mm in {mm for _, mm in wanted}}
        where = spots(scene) if board.board == made.boards[0].board else {}
    for key, mm in wanted:
        row = told[mm].get(key, where.get(key))
        if row is not None:
            found[key, mm] = np.broadcast_to(row, rows.shape)
    return found
