"""What drawings cost: steps, minutes at the board, time on the machine; how much more than others do."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import NamedTuple

from graphic_tmm.accuracy.cost import count, varying
from graphic_tmm.accuracy.measure import TRIED, tried_works
from graphic_tmm.accuracy.timing import Stopwatch
from graphic_tmm.board.execute import Program, prepare
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.project import Project

UNSURE = 0.1
"""A time below this share of what is run is not told from nothing: so far runs differed on two busy cores."""

Key = tuple[str, str, str]
"""What a step is called: its operation, its view, its letter."""
_Timed = tuple[Program, Mapping[Mark, object]]


class Cost(NamedTuple):
    """Steps in the log, minutes at the board, seconds of the processor for one run; None if it is not timed."""

    steps: int
    minutes: float
    seconds: float | None

    def less(self, other: Cost) -> Cost:
        """Return how much more this is than the ``other``."""
        seconds = None
        if self.seconds is not None and other.seconds is not None:
            seconds = self.seconds - other.seconds
        return Cost(self.steps - other.steps, self.minutes - other.minutes, seconds)


def cost_of(drawings: Sequence[Project], minutes: Mapping[str, float] | None) -> Cost:
    """Return what drawings cost but for seconds."""
    steps = sum(len(drawing.construction.steps) for drawing in drawings)
    return Cost(steps, sum(_minutes(drawing, minutes) for drawing in drawings), None)


def _minutes(drawing: Project, minutes: Mapping[str, float] | None) -> float:
    """Return the minutes at the board, each view drawn at the positions that the scene wants it at.

    What a view that is drawn at all positions takes from it is drawn at all of them.
    """
    log, varies = drawing.construction, varying(drawing.given)
    views = {step.it.view for step in log.steps}
    told = {**drawing.told, **drawing.rows}
    only = {view: len(rows) for view, rows in told.items() if rows and view in views}
    inner = tried_works(drawing, minutes)
    everywhere = [step.it for step in log.steps if step.it.view not in only]

    def spent(wanted: Sequence[Mark] | None, at: Mapping[str, int]) -> float:
        return count(
            log,
            varies,
            wanted,
            positions=drawing.count,
            only=at,
            tried=inner,
            passes=TRIED,
            minutes=minutes,
        ).minutes

    return spent(None, only) + spent(everywhere, {}) - spent(everywhere, only)


def seconds_apart(
    drawings: Sequence[Project], rest: Sequence[Project], watch: Stopwatch
) -> tuple[float, float]:
    """Return how much longer logs run than the ``rest``, s, and below what that is not told from nothing.

    Curves take most of the time, and more or less by more than an effect does. Where the same steps lie behind
    steps across positions in both logs, these are not run; a log that stays as it is, is not either.
    """
    timed: list[list[_Timed]] = [[], []]
    other = {drawing.board: drawing for drawing in rest}
    for drawing in drawings:
        pair = [drawing, *(one for one in [other.get(drawing.board)] if one is not None)]
        parts = [_parts(one.construction) for one in pair]
        if len(pair) == 2 and parts[0] == parts[1]:
            continue
        same = len(pair) == 2 and parts[0][1] == parts[1][1]
        for row, one, (first, _) in zip(timed, pair, parts, strict=False):
            marks = [step.it for step in one.construction.steps if _key(step) in first]
            row.append((prepare(one.construction, marks if same else None), one.given))
    if not any(timed):
        return 0.0, 0.0
    found = watch.in_turns({k: partial(_run, row) for k, row in enumerate(timed)})
    scatter = max(one.high - one.low for one in found.values())
    return found[0].least - found[1].least, max(UNSURE * found[0].least, scatter)


def seconds_of(drawings: Sequence[Project], watch: Stopwatch) -> float:
    """Return the seconds of the processor that one run of the logs of drawings takes."""
    row = [(prepare(one.construction), one.given) for one in drawings]
    return watch.in_turns({"all": partial(_run, row)})["all"].least


def _run(row: Sequence[_Timed]) -> None:
    for program, given in row:
        program.run(given)


def _parts(log: Construction) -> tuple[frozenset[Key], frozenset[Key]]:
    """Return the steps of a log before any across positions, and those that such steps lead to."""
    behind: set[int] = set()
    for step in log.steps:
        if step.op.across or behind & {mark.slot for mark in step.uses}:
            behind.add(step.it.slot)
    parts: tuple[set[Key], set[Key]] = set(), set()
    for step in log.steps:
        parts[step.it.slot in behind].add(_key(step))
    return frozenset(parts[0]), frozenset(parts[1])


def _key(step: Step) -> Key:
    return step.op.name, step.it.view, step.it.letter
