"""Two steps exchanged where what they draw meets: of two arcs the openings, of two lines the directions."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.instruments import parallel, square
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Arc, Length, Line, Point
from graphic_tmm.checking.mutations import words
from graphic_tmm.checking.mutations.mutation import (
    DIRECTION,
    EXCHANGED,
    Change,
    Key,
    Mutation,
    Scope,
)


def openings(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """Of two arcs that meet each is struck with the opening of the other."""
    arcs = [scope.step(mark) for mark in step.uses if mark.kind is Arc]
    if len(arcs) != 2 or any(arc is None or arc.op.takes != (Point, Length) for arc in arcs):
        return
    one, other = (arc for arc in arcs if arc is not None)
    first, second = scope.step(one.uses[1]), scope.step(other.uses[1])
    if first is None or second is None or first is second:
        return
    if all(mark.slot in scope.given for mark in (*first.uses, *second.uses)):
        changes = {one.it.slot: _opened(one, second), other.it.slot: _opened(other, first)}
        yield (), Mutation(EXCHANGED, words.EXCHANGED_WITH, changes, {}, step, first.it, second.it)


def directions(step: Step, scope: Scope) -> Iterator[tuple[Key, Mutation]]:
    """Of two lines that meet each is drawn in the direction of the other."""
    lines = [scope.step(mark) for mark in step.uses if mark.kind is Line]
    if len(lines) != 2 or any(line is None or line.op not in (parallel, square) for line in lines):
        return
    one, other = (line for line in lines if line is not None)
    pairs = (one, other), (other, one)
    early = all(scope.turn[by.uses[1].slot] < scope.turn[line.it.slot] for line, by in pairs)
    if early and (one.op, one.uses[1]) != (other.op, other.uses[1]):
        changes = {line.it.slot: _along(line, by) for line, by in pairs}
        yield (), Mutation(DIRECTION, words.DIRECTIONS, changes, {}, step, one.it, other.it)


def _along(line: Step, by: Step) -> Change:
    """Return a line in the direction of another."""
    return Change(line._replace(op=by.op, uses=(line.uses[0], by.uses[1]), choice=by.choice))


def _opened(arc: Step, by: Step) -> Change:
    """Return an arc struck with what another step calculates of what is given."""
    return Change(arc._replace(op=_struck(arc.op, by.op), uses=(arc.uses[0], *by.uses)))


@cache
def _struck(arc: Operation, by: Operation) -> Operation:
    return arc._replace(run=lambda centre, *given: arc.run(centre, by.run(*given)))
