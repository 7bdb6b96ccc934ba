"""The grammar of mistakes: what a student may do instead of each step, read off its operation and its marks.

A new operation brings its mistakes with it: another mark of the same kind for each that it uses, the marks
of two arguments exchanged, the other sense, the other meeting; a formula brings what its text can be made
into. What a step may be mistaken for hangs on kinds, units, views and roles alone.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from functools import cache
from typing import Any

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.graphs import halve
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure_along,
    parallel,
    similar,
    square,
)
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Angle, Arc, Length, Line, Number, Point, Side
from graphic_tmm.checking.mutations import calculated, exchanged, words
from graphic_tmm.checking.mutations.calculated import is_product, with_sense
from graphic_tmm.checking.mutations.mutation import (
    DIRECTION,
    FACTOR,
    LEFT_OUT,
    MEASURES,
    MEETING,
    MIRRORED,
    OPERAND,
    PREVIOUS,
    SENSE,
    START,
    UNUSUAL,
    WRONG_END,
    Change,
    Key,
    Mutation,
    Scope,
    at_step,
    is_scale,
    using,
)

TENFOLD_EVERYWHERE = 20.0
"""So much rarer is a factor of ten in every step of a kind than in one: cm are written for mm instead."""


def mutations(log: Construction, wanted: Iterable[Step] | None = None) -> Iterator[Mutation]:
    """Yield the mutations of the steps of a log: each step's own, then those that every step of a kind has.

    ``wanted``: steps to mutate; None for all.
    """
    scope = Scope(log)
    together: dict[Key, list[Mutation]] = defaultdict(list)
    for step in log.steps if wanted is None else wanted:
        for key, one in _of(step, scope):
            yield one
            if key:
                together[key].append(one)
            if key[:1] == (roles.INERTIA,):
                together[key[:1]].append(one)  # forces and couples of inertia alike
    if len([key for key in together if key[:1] == (roles.INERTIA,)]) == 2:
        del together[roles.INERTIA,]  # nothing but what the other has
    for some in together.values():
        plans: dict[str, list[Mutation]] = defaultdict(list)
        for one in some:
            plans[one.at.it.view if one.at is not None else ""].append(one)
        every = [some] if len(plans) > 1 else []
        for alike in (*every, *plans.values()):
            if len(alike) > 1:
                changes = {slot: change for one in alike for slot, change in one.changes.items()}
                first = alike[0]
                tens = first.family == FACTOR and first.times in calculated.POWERS_OF_TEN
                usual = first.usual * (TENFOLD_EVERYWHERE if tens else 1.0)
                yield first._replace(changes=changes, wide=True, usual=usual)


def _of(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    for read in (
        _operands,
        _segments,
        _before,
        _exchanged,
        exchanged.openings,
        exchanged.directions,
        _zeros,
        _directions,
        _meetings,
        calculated.formulas,
        calculated.factors,
        calculated.units,
    ):
        yield from read(step, scope)


def _operands(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """Another mark of the same kind is taken."""
    for k, was in enumerate(step.uses):
        if was.kind not in (Point, Line, Length, Number, Angle, Arc):
            continue
        if was.kind is Line and step.op.name in MEASURES:
            continue  # of a length it tells the sense alone
        family, says = words.operand(step, k, scale=is_scale(was))
        for now in scope.candidates(was, step.it):
            if now in step.uses and was.kind in (Point, Line, Arc) and len(step.uses) <= 3:
                continue
            other = Change(using(step, k, now))
            if step.op.name == measure_along.name and was.kind is Point:
                apart = step._replace(op=_apart(step.op), uses=(*other.step.uses, *step.uses[:2]))
                other = Change(apart)
            if is_product(step.op) and was.kind in (Length, Number):
                uses = (*other.step.uses, *step.uses)
                other = Change(step._replace(op=with_sense(step.op, step.op), uses=uses))
            usual = 1.0 if now.view == was.view else UNUSUAL
            one = at_step(step, family, says, other, was=was, now=now, usual=usual)
            yield _everywhere(step, k, now, scope), one
            if family == START and (measured := scope.measured(step, was, now)):
                yield (), one._replace(changes={**one.changes, **measured})


def _everywhere(step: Step, k: int, now: Mark, scope: Scope) -> Key:
    """Return by what another point is taken in several steps: for moments, for the middles of intervals."""
    was, made = step.uses[k], scope.step(step.uses[k])
    if was.kind is Length:
        return _whole(step, scope, was, scope.uses(now)[:2])
    if was.kind is not Point:
        return ()
    if step.op is arm and k == 0:
        return (OPERAND, arm.name, was.slot, now.slot)
    if made is not None and made.op is halve and now in made.uses:
        return (START, halve.name, step.op.name, made.uses.index(now))
    return ()


def _zeros(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """What a graph lays off at its stations is counted from what it is at another of them."""
    on_graph = scope.rows.get(step.it.view, 0)
    drawn = any(was.kind is Length and was.view != step.it.view for was in step.uses)
    if step.it.kind is Length and step.op.formula and drawn:
        for place in range(1, on_graph):
            change = Change(step._replace(op=_counted_from(step.op, place)))
            yield (), at_step(step, START, words.ANOTHER_ZERO, change, times=float(place))


@cache
def _counted_from(op: Operation, place: int) -> Operation:
    def run(*values: Any) -> Any:
        found = op.run(*values)
        return found - found[:, place : place + 1]

    return op._replace(run=run)


def _segments(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """Another segment of the plan, which has no letter of its own, is measured for a length."""
    if not step.op.formula or step.op.across:
        return
    for k, was in enumerate(step.uses):
        made = scope.step(was)
        if was.kind is not Length or made is None or made.op.name not in MEASURES:
            continue
        ends = made.uses[:2]
        known = {
            frozenset(one.uses[:2]) for end in ends for one in scope.readings.get(end.slot, ())
        }
        for end in ends:
            for other in scope.candidates(end, step.it):
                if other.view != end.view or frozenset((end, other)) in known:
                    continue
                first, last = sorted((end, other), key=lambda mark: mark.slot)
                uses = (*step.uses[:k], first, last, *step.uses[k + 1 :], *step.uses)
                change = Change(step._replace(op=_by_segment(step.op, k), uses=uses))
                now = was._replace(letter=f"{first.letter}{last.letter}")
                one = at_step(step, OPERAND, words.CALCULATED, change, was=was, now=now)
                yield _whole(step, scope, was, (end, other)), one._replace(usual=1.5)


def _whole(step: Step, scope: Scope, was: Mark, ends: Collection[Mark]) -> Key:
    """Return by what a whole vector is taken, in several steps, for the rest of it beside what was laid off."""
    made = scope.step(was)
    if made is None or made.op.name not in MEASURES:
        return ()
    whole = {scope.begun(made.uses[0]), made.uses[1]}
    return (OPERAND, "whole", step.op.name) if whole == {*ends} else ()


@cache
def _by_segment(op: Operation, k: int) -> Operation:
    """Return a formula of two points' distance for its argument ``k``, with the sense of the right one."""
    right: Callable[..., Any] = op.run
    count = len(op.arguments) + 1

    def run(*values: Any) -> Any:
        length = np.abs(values[k + 1] - values[k])
        found, due = right(*values[:k], length, *values[k + 2 : count]), right(*values[count:])
        return np.abs(found) * np.where(due < 0.0, -1.0, 1.0) if is_product(op) else found

    return op._replace(run=run)


def _before(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """What it uses is that of the position before."""
    if step.op.across or step.op.reads:
        return
    for k, was in enumerate(step.uses):
        if was.kind in (Line, Length) and scope.step(was) is not None:
            one = at_step(step, PREVIOUS, words.BEFORE, Change(step, before=k), was=was)
            # a plan drawn by that of the position before is one mistake
            key = (PREVIOUS, was.view) if was.kind is Line and was.view != step.it.view else ()
            yield key, one._replace(usual=1.0 if was.kind is Line else UNUSUAL)


def _exchanged(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """Two marks of one kind are taken for one another."""
    if step.op is similar or step.op.across or step.op.formula:
        pairs: Iterable[tuple[int, int]] = ((0, 1), (2, 3)) if step.op is similar else ()
    elif step.it.kind is Line and step.op.takes.count(Point) >= 2:
        first, second = [k for k, kind in enumerate(step.op.takes) if kind is Point][-2:]
        pairs = ((first, second),)
    else:
        pairs = ()
    for j, k in pairs:
        uses = list(step.uses)
        uses[j], uses[k] = uses[k], uses[j]
        change = Change(step._replace(uses=tuple(uses)))
        family = WRONG_END if step.op is similar else SENSE
        key: Key = (family, step.op.name, j)
        if step.it.role == roles.INERTIA:
            key = (roles.INERTIA, Line)
        says = words.LETTERS if step.op is similar else words.SENSE
        yield key, at_step(step, family, says, change, was=step.uses[j], now=step.uses[k])
    if step.op is similar:
        change = Change(step._replace(op=_mirrored(step.op)))
        yield (MIRRORED, "similar"), at_step(step, MIRRORED, words.MIRRORED, change)
        turned = Change(step._replace(op=_by_ratio(step.op, 0.0)))
        yield (), at_step(step, FACTOR, words.UPSIDE_DOWN, turned)
        other = Change(step._replace(op=_by_ratio(step.op, -1.0)))
        yield (), at_step(step, SENSE, words.SENSE, other)
        for factor in (2.0, 0.5):
            change = Change(step._replace(op=_by_ratio(step.op, factor)))
            yield (), at_step(step, FACTOR, words.AS_FAR, change, times=factor, usual=2.0)


@cache
def _apart(op: Operation) -> Operation:
    """Return the operation of measuring another distance than that along a line, with the sense of that."""

    def run(start: Any, end: Any, on: Any, first: Any, last: Any) -> Any:
        return np.abs(end - start) * np.sign(op.run(first, last, on))

    return op._replace(run=run)


@cache
def _by_ratio(op: Operation, times: float) -> Operation:
    """Return a similarity by a ratio so many times as large, or (0) by that upside down."""

    def run(base_a: Any, base_b: Any, A: Any, B: Any, S: Any) -> Any:
        ratio = times * (S - A) / (B - A) if times else (B - A) / (S - A)
        return base_a + (base_b - base_a) * ratio

    return op._replace(run=run)


@cache
def _mirrored(op: Operation) -> Operation:
    def run(base_a: Any, base_b: Any, A: Any, B: Any, S: Any) -> Any:
        return base_a + (base_b - base_a) * np.conj((S - A) / (B - A))

    return op._replace(run=run)


def _directions(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """A parallel is drawn for a square and the other way round; the sense is the other one."""
    if "sense" in step.choice:
        sense = step.choice["sense"]
        turned = Change(step._replace(choice={**step.choice, "sense": -sense}))
        normal = step.it.role == roles.NORMAL
        family = WRONG_END if normal else SENSE
        key: Key = (family, step.it.role) if normal else ()
        says = words.WRONG_END if normal else words.SENSE
        yield key, at_step(step, family, says, turned)
    if step.op in (parallel, square):
        other = square if step.op is parallel else parallel
        says = words.SQUARE if other is square else words.PARALLEL
        for sense in (1, -1):
            change = Change(step._replace(op=other, choice={"sense": sense}))
            yield (), at_step(step, DIRECTION, says, change, was=step.uses[1])
    if "quarters" in step.choice:
        for quarters in (1, 2, 3):
            change = Change(
                step._replace(choice={"quarters": (step.choice["quarters"] + quarters) % 4})
            )
            key = (DIRECTION, step.op.name, quarters)
            told = {
                "times": 90.0 * quarters,
                "usual": 2.0 if change.step.choice["quarters"] else 0.5,
            }
            yield key, at_step(step, DIRECTION, words.TURNED, change, **told)
    if step.it.kind is Line and step.op not in (parallel, square):
        for quarters in (1, 2, 3):
            change = Change(step._replace(op=_turned(step.op, quarters)))
            one = at_step(step, DIRECTION, words.TURNED, change, times=90.0 * quarters)
            yield (), one._replace(usual=UNUSUAL)
    if step.op is lay_off:
        for factor in (2.0, 0.5):
            change, was = Change(step._replace(op=_times(step.op, factor))), step.uses[1]
            yield (), at_step(step, FACTOR, words.LAID_TIMES, change, was=was, times=factor)
        change = Change(step._replace(op=_backwards(step.op)))
        says = words.SENSE if step.uses[0].role != roles.NORMAL else words.WRONG_END
        yield (), at_step(step, SENSE, says, change, was=step.uses[1])
        nothing = Change(step._replace(op=_not_at_all(step.op)))
        one = at_step(step, LEFT_OUT, words.LEFT_OUT, nothing, was=step.uses[1])
        yield (), one._replace(usual=1.5)


@cache
def _turned(op: Operation, quarters: int) -> Operation:
    def run(*values: Any, **choice: Any) -> Any:
        line = op.run(*values, **choice)
        return Line(line.at, line.along * 1j**quarters)

    return op._replace(run=run)


@cache
def _times(op: Operation, factor: float) -> Operation:
    return op._replace(run=lambda on, length: op.run(on, factor * length))


@cache
def _backwards(op: Operation) -> Operation:
    return op._replace(run=lambda on, length: op.run(on, -length))


@cache
def _not_at_all(op: Operation) -> Operation:
    return op._replace(run=lambda on, length: op.run(on, 0.0 * length))


def _meetings(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """Of two meetings the other one is marked."""
    for k, kind in enumerate(step.op.takes):
        if kind is Side:
            change = Change(step._replace(op=_other_side(step.op, k)))
            yield (), at_step(step, MEETING, words.MEETING, change)


@cache
def _other_side(op: Operation, side: int) -> Operation:
    run: Callable[..., Any] = op.run
    return op._replace(run=lambda *v, **c: run(*v[:side], -v[side], *v[side + 1 :], **c))


def count(some: Sequence[Mutation]) -> dict[str, int]:
    """Return how many mutations there are of each family."""
    found: dict[str, int] = defaultdict(int)
    for one in some:
        found[one.family] += 1
    return dict(found)
