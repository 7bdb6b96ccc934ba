"""What can be practised: each plan that a check reads, step by step, in each position and at other angles."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from graphic_tmm.board.execute import Reading, execute, needed
from graphic_tmm.board.geometry import wedge
from graphic_tmm.board.operations.instruments import join, parallel
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.script import Script
from graphic_tmm.board.source import NotCompiled
from graphic_tmm.board.values import Length, Line, Number, Point, Reals, arrays, undefined
from graphic_tmm.board.values import given as as_value
from graphic_tmm.checking.cells import cells, pointed, points
from graphic_tmm.checking.judging.equivalents import crossings
from graphic_tmm.checking.judging.own_errors import alone
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.page.dense import Dense, dense


@dataclass(frozen=True)
class PoseRow:
    """A mechanism at a row of positions, drawn by the exact hand: those of the sheet, or others.

    ``given``: what is given there; ``places``: the positions (indices) in which each plan is practised;
    ``own``: the rows of which it is made, each drawn by itself by a hand; () of one that is made of no others.
    ``free``: lines behind the log that may be drawn besides: they lead to a point as well as its own.
    """

    work: Drawn
    log: Construction
    given: Mapping[Mark, object]
    names: Sequence[str]
    places: Mapping[str, Sequence[int]]
    own: tuple[PoseRow, ...] = ()
    free: tuple[Step, ...] = ()

    @cached_property
    def steps(self) -> tuple[Step, ...]:
        """The steps of plans that are practised, with what they need, that follow from their position alone."""
        free = {step.it for step in alone(self.log)}
        wanted = [mark for mark in free if mark.view in self.places]
        return tuple(step for step in needed(self.log, wanted) if step.it in free)

    @cached_property
    def reading(self) -> Reading:
        """The numbers of all that these need."""
        marks = {mark for step in self.steps for mark in (step.it, *step.uses)}
        return execute(self.log, self.given, marks)

    def there(self, mark: Mark, at: int) -> bool:
        """Whether a mark is there in a position."""
        gone = undefined(self.reading[mark])[0]
        return not gone[at if gone.size > 1 else 0]

    def numbers(self, mark: Mark) -> list[list[float]]:
        """Return what a mark is, number by number, in each position; in one if it is always alike."""
        flat: list[Any] = []
        for part in arrays(self.reading[mark]):
            flat += [part[0].real, part[0].imag] if np.iscomplexobj(part) else [part[0]]
        return np.stack(np.broadcast_arrays(*flat), axis=1).tolist()  # type: ignore[no-any-return]


def sheet_row(made: DrawnScene) -> PoseRow | None:
    """Return the row of the sheet; None of a scene without a mechanism, or without a plan that is practised."""
    work = made.mechanism
    if work is None:
        return None
    plans = {step.it.view for step in work.construction.steps} & set(pointed())
    shown = {plan: work.project.told.get(plan, frozenset(work.row(plan))) for plan in plans}
    places = {
        plan: at
        for plan in pointed()
        if plan in plans and (at := [k for k in work.row(plan) if k in shown[plan]])
    }
    if not places:
        return None
    free = tuple(_other_lines(work))
    log, size = work.construction, work.construction.size + len(free)
    log = log._replace(steps=(*log.steps, *free), size=size)
    return PoseRow(work, log, work.given, work.names, places, free=free)


def _other_lines(work: Drawn) -> Iterator[Step]:
    """Yield the lines that other constructions of points draw, behind the log, each once."""
    log = work.construction
    drawn = [step.it for step in log.steps if step.it.kind is Line]
    by = {step.it: step for step in log.steps}
    tried = dict.fromkeys(
        (limb.centre, *limb.of)
        for ways in crossings(work.project).values()
        for way in ways
        for limb in way
    )
    for first, second in tried:
        straight = second.kind is Line
        end = (
            second.letter[1:-1].removeprefix(by[second].uses[0].letter)
            if straight
            else second.letter
        )
        mark = Mark(log.size, f"({first.letter}{end})", Line, first.view)
        step = Step(parallel if straight else join, mark, (first, second), {}, "")
        longer = log._replace(steps=(*log.steps, step), size=log.size + 1)
        own = [one for one in drawn if one.view == first.view]
        reading = execute(longer, work.given, [mark, *own])
        if not any(_is_one(reading[mark], reading[other]) for other in own):
            log, drawn = longer, [*drawn, mark]
            yield step


def _is_one(first: Line, second: Line) -> bool:
    """Whether two lines are one wherever both are there."""
    turn = np.abs(wedge(first.along, second.along))
    off = np.abs(wedge(first.along, second.at - first.at))
    there = np.isfinite(turn + off)
    return bool(there.any()) and bool((turn + off)[there].max() < ONE_LINE)


def with_others(row: PoseRow, other: PoseRow) -> PoseRow:
    """Return a row with the positions of another one behind its own."""
    count, more = len(row.names), len(other.names)
    used = {mark for step in row.steps for mark in step.uses}
    given = {}
    for mark in used & row.given.keys():
        value = row.given[mark]
        first = as_value(value, mark.kind)
        second = as_value(other.given.get(mark, value), mark.kind)
        if isinstance(first, np.ndarray) and isinstance(second, np.ndarray):
            wide = [np.broadcast_to(first, (1, count)), np.broadcast_to(second, (1, more))]
            joined = np.concatenate(wide, axis=1)
            given[mark] = first if np.ptp(joined) == 0.0 else joined
        else:
            given[mark] = first
    places = {
        plan: (*at, *(count + k for k in other.places.get(plan, ())))
        for plan, at in row.places.items()
    }
    names = (*row.names, *other.names)
    return PoseRow(row.work, row.log, given, names, places, (row, other), row.free)


def written(script: Script, steps: Iterable[Step]) -> dict[str, Any]:
    """Return the functions of operations that can be written down in JavaScript, by their names."""
    found = {}
    for op in {step.op.name: step.op for step in steps}.values():
        try:
            script.add(op.run)
        except NotCompiled:
            continue
        found[op.name] = op.run
    return found


def readable(made: DrawnScene) -> dict[Mark, tuple[str, str, str, str]]:
    """Return what a check reads of marks: "point", "length" or "rate", plan, name, unit."""
    due, spots = cells(made), points(made)
    figures = {(plan, name): cell for (plan, name, _), cell in due.items()}
    stand = {(plan, name) for plan, name, _ in spots}
    found: dict[Mark, tuple[str, str, str, str]] = {}
    for (plan, name), step in steps_of(made.mechanism).items():
        kind, cell = step.it.kind, figures.get((plan, name))
        if kind is Point and (plan, name) in stand:
            found.setdefault(step.it, ("point", plan, name, "mm"))
        elif kind is Length and cell is not None and cell.mm is not None:
            found.setdefault(step.it, ("length", plan, name, "mm"))
        elif kind is Number and cell is not None and cell.value is not None:
            found.setdefault(step.it, ("rate", plan, name, cell.unit))
    return found


ONE_LINE = 1e-6
"""Lines that differ by less, mm, or in direction, are one."""
APART = 5
"""So many degrees a pose is from an angle that cannot be drawn, at least."""
SHORT = 4.0
"""No vector of a pose is shorter, mm, if the turn has such an angle: directions of shorter ones are lost."""


def posed(row: PoseRow, seed: int) -> PoseRow | None:
    """Return poses of a mechanism, one for each plan of a row; None where nothing turns.

    The same seed poses the same.
    """
    turn = dense(row.work)
    if turn is None or any(step not in turn.log.steps for step in row.steps):
        return None
    chosen = {plan: k for plan in row.places if (k := _angle(turn, row, plan, seed)) is not None}
    at = sorted(set(chosen.values()))
    if not at:
        return None
    given: Mapping[Mark, Any] = {mark: _cut(value, mark, at) for mark, value in turn.given.items()}
    language = row.work.scene.language
    names = tuple(turn.named(k, language) for k in at)
    places = {plan: (at.index(k),) for plan, k in chosen.items()}
    return PoseRow(turn.drawn, turn.log, given, names, places)


def _angle(turn: Dense, row: PoseRow, plan: str, seed: int) -> int | None:
    """Return the angle (its index) that a plan is posed at; None where it is nowhere drawn."""
    good = _drawn(turn)
    shortest = np.where(good, _shortest(turn, row, plan), -1.0)
    order = list(range(turn.whole))
    random.Random(f"{seed}|{plan}").shuffle(order)
    order = [k for k in order if k not in turn.at]
    found = next((k for k in order if shortest[k] >= SHORT), None)
    if found is None and order:
        best = max(order, key=lambda k: shortest[k])
        found = best if shortest[best] > 0.0 else None
    return found


def _drawn(turn: Dense) -> Any:
    """Return at which whole degrees a mechanism is drawn, and at all near them."""
    bad = np.zeros(turn.whole, dtype=bool)
    bad[[k for k in turn.drawn.undrawn if k < turn.whole]] = True
    near = np.zeros_like(bad)
    for by in range(-APART, APART + 1):
        near |= np.roll(bad, by)
    return ~near


def _shortest(turn: Dense, row: PoseRow, plan: str) -> Reals:
    """Return the shortest vector of a plan at every whole degree, mm; NaN counts as none."""
    rows = list(_vectors(turn, row, plan))
    if not rows:
        return np.full(turn.whole, -1.0)
    return np.asarray(np.nan_to_num(np.min(rows, axis=0), nan=-1.0))


def _vectors(turn: Dense, row: PoseRow, plan: str) -> Iterator[Reals]:
    """Yield what is to be drawn of a plan, mm along the angles: lengths, points from its pole.

    What is nothing everywhere is none.
    """
    reading = turn.drawn.reading
    for step in row.steps:
        if step.it.view != plan or step.it.kind not in (Length, Point):
            continue
        length = np.abs(np.broadcast_to(reading[step.it], (1, turn.turned.size))[0, : turn.whole])
        if not (length < SHORT).all():
            yield length


def _cut(value: object, mark: Mark, at: list[int]) -> Any:
    found = as_value(value, mark.kind)
    if isinstance(found, np.ndarray) and found.shape[1] > 1:
        return found[:, at]
    return found
