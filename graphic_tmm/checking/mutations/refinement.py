"""The last hypotheses refined: by a hand that draws with the mistake, by how much was misread."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board import roles
from graphic_tmm.board.execute import execute
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Angle, Arc, Length, Number, Point
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.step_scatter import as_read, where_read
from graphic_tmm.checking.mutations import words
from graphic_tmm.checking.mutations.calculated import POWERS_OF_TEN
from graphic_tmm.checking.mutations.entries import EntryEvidence, Own, Weighed, entry_of
from graphic_tmm.checking.mutations.evidence import Readings, of_mutations
from graphic_tmm.checking.mutations.execution import AssumedLog
from graphic_tmm.checking.mutations.hypotheses import Hypothesis, groups
from graphic_tmm.checking.mutations.likelihood import BEYOND, Evidence, explained
from graphic_tmm.checking.mutations.mistakes import NONE, Offered, amiss_by, misread
from graphic_tmm.checking.mutations.mutation import (
    FACTOR,
    GIVEN,
    UNUSUAL,
    Change,
    Mutation,
    at_step,
)

Array = NDArray[np.float64]
FINALISTS, KEPT = 8, 100
"""So many of the best that readings tell apart are weighed anew, of so many."""
LEAST = 8.0
"""What gains less (natural logarithm) is not worth that."""
DRAWN = 50
"""So often the hand draws with the mistake: a standard deviation is then known to a tenth of itself."""


def reweighed(
    readings: Readings, base_of: Callable[[int], AssumedLog], found: Sequence[Hypothesis]
) -> list[Hypothesis]:
    """Return hypotheses, the best of them weighed anew by a hand that draws with the mistake.

    What no reading tells apart is weighed once, or the chance of its drawings would tell it apart.
    """
    best = [
        one
        for one in sorted(found, key=lambda one: -one.score)
        if float(one.gain.sum()) > LEAST and not one.lost and isinstance(one.what, Mutation)
    ][:KEPT]
    anew: dict[int, Hypothesis] = {}
    of = cache(lambda board: Own(readings.drawing, readings.found, base_of(board)).base)
    for group in groups(best)[:FINALISTS]:
        first = group[0]
        now = refined(readings, base_of(first.board), first, lambda: of(first.board))  # noqa: B023
        for one in group:
            anew[id(one)] = now._replace(
                what=one.what,
                board=one.board,
                place=one.place,
                score=one.score + now.score - first.score,
                gain=one.gain + now.gain - first.gain,
            )
    return [anew.get(id(one), one) for one in found]


def refined(
    readings: Readings,
    base: AssumedLog,
    one: Hypothesis,
    right: Callable[[], Mapping[Mark, Array]],
) -> Hypothesis:
    """Return a hypothesis weighed by the scatter of a hand that draws with it; of readings of marks only.

    ``right``: the errors of marks by the base, (part, trial, position).
    """
    what = one.what
    work = readings.drawing.made.mechanism
    if not isinstance(what, Mutation) or base.board is not work or not readings.found:
        return one
    other = base.mistaken(what, one.place)
    scatters = scatters_of(readings, other)
    own, due = Own(readings.drawing, readings.found, other), right()
    gain, far, fit = one.gain.copy(), one.far.copy(), np.array([one.moved, one.squares])
    places = readings.places
    for mark, errors in own.base.items():
        read = readings.found[mark][0]
        known = entry_of(readings.drawing, mark, due[mark][:, 0], read, None)
        mine = entry_of(readings.drawing, mark, errors[:, 0], read, scatters)
        if known is None or mine is None:
            continue
        plain, told = EntryEvidence(known), EntryEvidence(mine)
        (before,), (off,), _ = plain.rows(errors[:, :1])
        gain[:places] += told.base.likely - before
        far[:places] += (told.base.off > BEYOND) * 1.0 - (off > BEYOND)
        fit += _fit(told.base.off, plain.base.off) - _fit(off, plain.base.off)
    score = one.score + float((gain - one.gain).sum())
    beyond, (moved, squares) = int(far.sum()), map(float, fit)
    return one._replace(
        score=score, gain=gain, beyond=beyond, far=far, moved=moved, squares=squares
    )


def _fit(off: Array, before: Array) -> Array:
    moved, squares = explained(off, before)
    return np.array([moved.sum(), squares.sum()])


def scatters_of(readings: Readings, other: AssumedLog) -> dict[Mark, Array]:
    """Return the hand's own errors where it draws a log, root mean squares, (part, position)."""
    by = readings.drawing.by.reader
    hand = by.hand._replace(trials=DRAWN)
    steps = {step.it: step for step in other.log.steps}
    drawn = execute(other.log, other.given, readings.found, hand=hand)
    places = readings.places
    found: dict[Mark, Any] = {}
    for mark, there in readings.found.items():
        row = np.broadcast_to(drawn[mark], (DRAWN, places))
        found[mark] = where_read(as_read(steps[mark], row, by), there)
    own = Own(readings.drawing, found, other)
    with np.errstate(all="ignore"):
        return {mark: _rms(errors) for mark, errors in own.base.items()}


def _rms(errors: Array) -> Array:
    finite = np.isfinite(errors)
    squares = np.where(finite, errors, 0.0) ** 2
    return np.asarray(np.sqrt(squares.sum(axis=1) / np.maximum(finite.sum(axis=1), 1)))


GRID = (0.4, 0.5, 0.6, 0.7, 0.8, 0.88, 1.12, 1.25, 1.4, 1.6, 1.8, 2.2)
"""Where the search begins: so many times as large a given was taken."""
STEP, ROUNDS = 0.01, 3
"""The step of the differences, and how often a step is taken: from a grid of 12 % the third is below 0.1 %."""
NEAR = 0.1
"""What is nearer to 1 is an instrument's, or a reading's, not a mistake."""
FARTHEST = 0.2
"""No step goes farther (of the logarithm): a parabola is none beyond."""
STANDS = tuple(float(k) for k in range(-175, 180, 10))
"""Where the search for a crank that stands amiss at one position begins, degrees."""
TURN, FARTHEST_TURN, SEEN = 0.5, 6.0, 3.0
"""The step of the differences, the farthest step, degrees; what stands nearer is an instrument's error."""
KEPT_GIVENS = 3
"""So many positions may be the one."""


def fitted(readings: Readings, offered: Offered) -> tuple[list[Mutation], Evidence]:
    """Return givens that were misread, arcs struck amiss, each as it fits readings best, and the evidence.

    The first row is the log as it is.
    """
    every = _openings(offered.base.log)
    every += [partial(misread, marks) for marks in offered.free]
    trial = [NONE, *(one(1.2) for one in every)]
    rows = np.zeros(1, int)
    if every:
        rows = offered.moving(readings.least, offered.run(trial), readings.signed)
    free = [every[k - 1] for k in rows if k]
    if not free:
        return [], Evidence.none(1, readings.places)

    def gains(factors: Sequence[Sequence[float]]) -> np.ndarray:
        """Return what each given gains, taken so many times as large; (given, factor)."""
        some = [taken(f) for taken, row in zip(free, factors, strict=True) for f in row]
        found = _evidence(readings, offered, [NONE, *some]).gain[1:].sum(axis=1)
        return np.asarray(found.reshape(len(free), -1))

    first = gains([GRID] * len(free))
    some = np.flatnonzero(first.max(axis=1) > 0.0)  # what is nearer gains more
    if not some.size:
        return [], Evidence.none(1, readings.places)
    free = [free[k] for k in some]
    at = np.log(np.array(GRID)[np.argmax(first[some], axis=1)])
    for _ in range(ROUNDS):
        told = gains([np.exp(x + np.array([-STEP, 0.0, STEP])).tolist() for x in at])
        at = at + np.clip(_newton(told.T, STEP), -FARTHEST, FARTHEST)
    factors = np.exp(at)
    kept = [one(float(f)) for one, f in zip(free, factors, strict=True) if abs(f - 1.0) > NEAR]
    return [NONE, *kept], _evidence(readings, offered, [NONE, *kept])


def _openings(log: Construction) -> list[Callable[[float], Mutation]]:
    """Return the arcs of a log as they are struck with the compass opened so many times as wide.

    The other points of the link stay where they should be, or divide it as they should.
    """
    found: list[Callable[[float], Mutation]] = []
    for arc in log.steps:
        if arc.it.kind is Arc and arc.op.takes == (Point, Length):
            ends = {step.it for step in log.steps if arc.it in step.uses}
            links = {
                step.it for step in log.steps if arc.uses[0] in step.uses and ends & {*step.uses}
            }
            along = [step for step in log.steps if step.op is lay_off and step.uses[0] in links]
            found += [partial(_opened, (arc,))]
            found += [partial(_opened, (arc, *along))] if along else []
    return found


def _opened(steps: Sequence[Step], times: float) -> Mutation:
    changes = {step.it.slot: Change(step._replace(op=_longer(step.op, times))) for step in steps}
    arc = steps[0]
    return Mutation(GIVEN, words.OPENED, changes, {}, arc, arc.uses[1], times=times, usual=2.0)


def _longer(op: Operation, times: float) -> Operation:
    return op._replace(run=lambda begins, length: op.run(begins, times * length))


NUMBER = UNUSUAL + 0.5
"""A number that fits is less usual than whatever a student may do that comes to it."""
MULTIPLE, USUAL = 8.0, (2.0, 0.5, *POWERS_OF_TEN)
"""What is gained at least by a number that all readings of a segment have; numbers that the grammar has."""


def multiplied(readings: Readings, offered: Offered, told: Weighed) -> list[Mutation]:
    """Return steps whose results are so many times as large as due, in all positions or, if calculated, in one.

    The number is found from what was read; the first is the log as it is.
    """
    steps = {step.it: step for step in offered.base.log.steps}
    found = []
    for mark, entry in told.entries.items():
        step = steps[mark]
        if mark.kind not in (Length, Number):
            continue
        read = readings.found[mark][0]
        with np.errstate(all="ignore"):
            ratios = read / (read - entry.entry.error[0])
        off = entry.base.off > BEYOND
        if told.multiples.get(mark, 0.0) > MULTIPLE:
            times = float(np.nanmedian(ratios))
        elif off.sum() == 1 and not step.op.reads:
            times = float(ratios[off][0])
        else:
            continue
        known = any(abs(times / usual - 1.0) < NEAR for usual in USUAL)
        if np.isfinite(times) and times > 0.0 and abs(times - 1.0) > NEAR and not known:
            says = words.AS_LONG if step.op.reads else words.FACTOR
            change = Change(step, factor=times)
            found.append(at_step(step, FACTOR, says, change, times=times, usual=NUMBER))
    return [NONE, *found] if found else []


def _evidence(readings: Readings, offered: Offered, some: Sequence[Mutation]) -> Evidence:
    plain = plain_figures(readings, offered, some, offered.base)
    return of_mutations(readings, offered.base, some, plain)[0]


def plain_figures(
    readings: Readings, offered: Offered, some: Sequence[Mutation], base: AssumedLog
) -> dict[tuple[Key, bool], Any]:
    """Return what tables say with mutations of a log, found without readings."""
    if not readings.keys:
        return {}
    return readings.figures(base.board, offered.run(some, base), np.arange(len(some)))


def put_amiss(readings: Readings, offered: Offered) -> tuple[list[Mutation], Evidence]:
    """Return the crank put amiss, by as much as fits the readings of a position best, and the evidence.

    The first row is the log as it is; then the positions of which that explains most.
    """
    base = offered.base
    rows = [mark for mark in base.log.given if mark.role == roles.ROW and mark.kind is Angle]
    marks = [mark for mark in rows if mark in base.given]
    trial = [NONE, *(amiss_by([mark], STANDS[0]) for mark in marks)]
    if not marks or offered.moving(readings.least, offered.run(trial), readings.signed).size < 2:
        return [], Evidence.none(1, readings.places)

    def gains(angles: Array) -> Array:
        """Return what the crank gains that stands amiss by angles; both (angle, position)."""
        some = [NONE, *(amiss_by(marks, row) for row in angles)]
        told = readings.weighed(base, some, None, tables=False)
        evidence = _evidence(readings, offered, some) if told is None else told.evidence
        found = evidence.gain[1:, :-1]
        return np.asarray(np.broadcast_to(found, (len(angles), readings.places)))

    grid = np.repeat(np.array(STANDS)[:, None], readings.places, axis=1)
    first = gains(grid)
    if not (first > 0.0).any():
        return [], Evidence.none(1, readings.places)
    at = np.array(STANDS)[np.argmax(first, axis=0)]
    for _ in range(ROUNDS):
        told = gains(at + np.array([[-TURN], [0.0], [TURN]]))
        at = at + np.clip(_newton(told, TURN), -FARTHEST_TURN, FARTHEST_TURN)
    most = np.argsort(-gains(at[None])[0])[:KEPT_GIVENS]
    some = [NONE, *(amiss_by(marks, float(at[k])) for k in most if abs(at[k]) > SEEN)]
    return some, _evidence(readings, offered, some)


def _newton(told: Array, step: float) -> Array:
    """Return where a parabola through gains at three places, (place, row), has its top, from the middle one."""
    slope = (told[2] - told[0]) / (2.0 * step)
    bend = (told[2] - 2.0 * told[1] + told[0]) / step**2
    with np.errstate(all="ignore"):
        found = np.where(bend < 0.0, -slope / bend, np.sign(slope) * step * 5.0)
    return np.asarray(np.nan_to_num(found))
