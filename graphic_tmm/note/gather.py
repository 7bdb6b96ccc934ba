"""Steps of pure drawing told together: two lines and where they meet, lengths laid off along one line.

What is told is the same as step by step, line for line and letter for letter; only the words between are fewer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    meet,
    parallel,
    ray,
    square,
    strike,
)
from graphic_tmm.board.operations.statics import carry
from graphic_tmm.board.record import Step
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Run, Runs, Text
from graphic_tmm.note.steps import NumberSource, marks_of, put, sentence_runs
from graphic_tmm.readers.sentences import phrase

ELEMENTARY = (join, lay_off, meet, parallel, ray, square, strike)
"""Operations whose general reasons are those of elementary geometry: nobody writes them down."""
LINES = (parallel, square)
NEXT = {
    parallel.name: said("through {through} {it} parallel to {to}"),
    square.name: said("through {through} {it} square to {to}"),
}
THERE = said("through {through} likewise {it}")
SAME = said("through {through} {it}")
CROSS = said("; they meet in {it}")
TO_OTHER, TO_BASE = said(" up to {other} in {it}"), said(" up to {base} in {it}")
AND_OFF = said(" and lay off {length} on it up to {it}")
AND_ON_RAY = said(" and lay off {length} on the ray up to {it}")
NEXT_OFF = said(", {length} up to {it}")
ALONG, OFF = said("On {on} lay off from its beginning "), said("{length} up to {it}")
AND_CARRY = said(", likewise ")


class DrawingStep(NamedTuple):
    """A step of drawing, and where its words are read."""

    here: NumberSource
    step: Step


def gathered(work: Sequence[DrawingStep]) -> Iterator[tuple[Runs, Sequence[DrawingStep]]]:
    """Yield sentences, each with the steps that it tells, in their order."""
    k = 0
    while k < len(work):
        for rule in RULES:
            told, count = rule(work[k:])
            if count:
                yield told, work[k : k + count]
                k += count
                break
        else:
            yield sentence_runs(*work[k]), work[k : k + 1]
            k += 1


def _chain(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell lines, each drawn to lay something off on it, one behind another."""
    runs: list[Run] = []
    k = 0
    while len(work) >= k + 2 and _laid(work[k], work[k + 1]):
        line, off = work[k : k + 2]
        begun = [Text("; "), *_next(line)] if runs else [*_first(line)]
        on = AND_ON_RAY if line.step.op is ray else NEXT_OFF if runs else AND_OFF
        runs += [*begun, *_clause(off, on)]
        k += 2
    return (*runs, Text(".")) if runs else (), k


def _laid(line: DrawingStep, off: DrawingStep) -> bool:
    """Whether a line is drawn, and something laid off on it."""
    drawn = line.step.op in (*LINES, ray)
    return drawn and off.step.op is lay_off and off.step.uses[0] == line.step.it


def _crossing(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell two lines and the point where they meet."""
    if len(work) < 3 or work[2].step.op is not meet:
        return (), 0
    first, second, third = work[:3]
    lines = {first.step.it, second.step.it}
    if not all(one.step.op in LINES for one in (first, second)) or set(third.step.uses) != lines:
        return (), 0
    runs = (*_first(first), Text(", "), *_next(second), *_clause(third, CROSS), Text("."))
    return runs, 3


def _reaching(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell a line that is drawn as far as another."""
    if len(work) < 2 or work[0].step.op not in (*LINES, ray) or work[1].step.op is not meet:
        return (), 0
    line, point = work[:2]
    if line.step.it not in point.step.uses:
        return (), 0
    template = TO_OTHER if point.step.uses[0] == line.step.it else TO_BASE
    return (*_first(line), *_clause(point, template), Text(".")), 2


def _alike(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell lines of one direction that are drawn one after another."""
    some = _while(work, lambda a, b: a.op in LINES and a.op is b.op and a.uses[1:] == b.uses[1:])
    if len(some) < len(work) and _laid(some[-1], work[len(some)]):
        some = some[:-1]  # it is told with what is laid off on it
    if len(some) < 2:
        return (), 0
    runs = list(_first(some[0]))
    for one in some[1:]:
        runs += [Text(", "), *_clause(one, SAME)]
    return (*runs, Text(".")), len(some)


def _forces(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell lines of other views that are carried over, through points that are carried over with them."""
    some = _while(work, lambda a, b: all(_over(one) for one in (a, b)))
    if len(some) < 3 or not _over(some[0].step):
        return (), 0
    points = [one for one in some if one.step.op is carry]
    lines = [one for one in some if one.step.op is parallel]
    runs: list[Run] = [*_carried(points)[0]] if len(points) > 1 else []
    if points and not runs:
        runs = [*_first(points[0]), Text(".")]
    for k, one in enumerate(lines):
        runs += [Text(", " if k else " " if runs else "")]
        runs += _first(one) if k == 0 else _clause(one, THERE)
    return (*runs, *([Text(".")] if lines else [])), len(some)


def _over(step: Step) -> bool:
    return step.op is carry or _namesake(step)


def _namesake(step: Step) -> bool:
    """Whether a line is drawn parallel to its namesake in another view."""
    if step.op is not parallel:
        return False
    to = step.uses[1]
    return to.view != step.it.view and to.name == step.it.name


def _offs(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell lengths that are laid off along one line."""
    some = _while(work, lambda a, b: a.op is b.op is lay_off and a.uses[0] == b.uses[0])
    if len(some) < 2:
        return (), 0
    runs = list(_clause(some[0], ALONG))
    for k, one in enumerate(some):
        runs += [*([Text(", ")] if k else []), *_clause(one, OFF)]
    return (*runs, Text(".")), len(some)


def _carried(work: Sequence[DrawingStep]) -> tuple[Runs, int]:
    """Tell points that are carried over to the lever."""
    some = _while(work, lambda a, b: a.op is b.op is carry)
    if len(some) < 2:
        return (), 0
    runs = list(_first(some[0]))
    for k, one in enumerate(some[1:]):
        runs += [Text(", ") if k else Text(speaking(one.here.language)(AND_CARRY))]
        runs.append(one.here.symbol(one.step.it))
    return (*runs, Text(".")), len(some)


RULES = (_forces, _carried, _chain, _crossing, _reaching, _alike, _offs)
"""What is tried, in this order."""


def _while(
    work: Sequence[DrawingStep], alike: Callable[[Step, Step], bool]
) -> Sequence[DrawingStep]:
    """Return the first steps that are alike one after another."""
    k = 1
    while k < len(work) and alike(work[k - 1].step, work[k].step):
        k += 1
    return work[:k]


def _first(one: DrawingStep) -> Runs:
    """Return the sentence of a step without its full stop."""
    runs = sentence_runs(*one)
    last = runs[-1]
    if isinstance(last, Text) and last.text.endswith("."):
        return (*runs[:-1], *([Text(last.text[:-1])] if last.text != "." else []))
    return runs


def _next(one: DrawingStep) -> Runs:
    """Return a step as a clause that goes on with a sentence."""
    if _namesake(one.step):
        return _clause(one, THERE)
    if one.step.op.name in NEXT:
        return _clause(one, NEXT[one.step.op.name])
    begun, *rest = _first(one)
    return (
        (Text(begun.text[:1].lower() + begun.text[1:]), *rest)
        if isinstance(begun, Text)
        else (begun, *rest)
    )


def _clause(one: DrawingStep, template: str) -> Runs:
    """Return a clause with the letters of a step."""
    here, step = one
    words = phrase(step, here.language, here.reading, here.place)[1]
    return put((speaking(here.language)(template), words), marks_of(step), here)
