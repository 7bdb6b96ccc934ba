"""The last of the hypotheses, weighed by the scatter of a hand that draws with the mistake.

A mistake may draw lines nearly parallel, or vectors a hundred times as long: the same swing of the hand then
moves points much farther. The hand draws the mutated log some times; its own errors there are those that count.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.checking.judging.step_scatter import as_read, where_read
from graphic_tmm.checking.mutations import changed
from graphic_tmm.checking.mutations.density import BEYOND, explained
from graphic_tmm.checking.mutations.entries import Own, Told, entry_of
from graphic_tmm.checking.mutations.evidence import Board, Readings
from graphic_tmm.checking.mutations.execution import executed
from graphic_tmm.checking.mutations.hypotheses import Hypothesis, groups
from graphic_tmm.checking.mutations.mutation import Mutation

Array = NDArray[np.float64]
FINALISTS, KEPT = 8, 100
"""So many of the best that readings tell apart are weighed anew, of so many."""
LEAST = 8.0
"""What gains less (natural logarithm) is not worth that."""
DRAWN = 50
"""So often the hand draws with the mistake: a standard deviation is then known to a tenth of itself."""


def reweighed(
    readings: Readings, base_of: Callable[[int], Board], found: Sequence[Hypothesis]
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
    for group in groups(best)[:FINALISTS]:
        first = group[0]
        now = refined(readings, base_of(first.board), first)
        for one in group:
            anew[id(one)] = now._replace(
                what=one.what,
                board=one.board,
                place=one.place,
                score=one.score + now.score - first.score,
                gain=one.gain + now.gain - first.gain,
            )
    return [anew.get(id(one), one) for one in found]


def refined(readings: Readings, base: Board, one: Hypothesis) -> Hypothesis:
    """Return a hypothesis weighed by the scatter of a hand that draws with it; of readings of marks only."""
    what = one.what
    work = readings.drawing.made.mechanism
    if not isinstance(what, Mutation) or base.board is not work or not readings.found:
        return one
    log, given = changed.made(base.log, base.given, what, one.place)
    other = Board(base.board, log, given)
    scatters = scatters_of(readings, other)
    own = Own(readings.drawing, readings.found, log)
    executed(log, given, (), readings.found, own.seen)
    right = Own(readings.drawing, readings.found, base.log)
    executed(base.log, base.given, (), readings.found, right.seen)
    gain, far, fit = one.gain.copy(), one.far.copy(), np.array([one.moved, one.squares])
    places = readings.places
    for mark, errors in own.base.items():
        read = readings.found[mark][0]
        known = entry_of(readings.drawing, mark, right.base[mark][:, 0], read, None)
        mine = entry_of(readings.drawing, mark, errors[:, 0], read, scatters)
        if known is None or mine is None:
            continue
        plain, told = Told(known), Told(mine)
        (before,), (off,), _ = plain.rows(errors[:, :1])
        gain[:places] += told.likely - before
        far[:places] += (told.off > BEYOND) * 1.0 - (off > BEYOND)
        fit += _fit(told.off, plain.off) - _fit(off, plain.off)
    score = one.score + float((gain - one.gain).sum())
    beyond, (moved, squares) = int(far.sum()), map(float, fit)
    return one._replace(
        score=score, gain=gain, beyond=beyond, far=far, moved=moved, squares=squares
    )


def _fit(off: Array, before: Array) -> Array:
    moved, squares = explained(off, before)
    return np.array([moved.sum(), squares.sum()])


def scatters_of(readings: Readings, other: Board) -> dict[Mark, Array]:
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
    own = Own(readings.drawing, found, other.log)
    executed(other.log, other.given, (), found, own.seen)
    with np.errstate(all="ignore"):
        return {mark: _rms(errors) for mark, errors in own.base.items()}


def _rms(errors: Array) -> Array:
    finite = np.isfinite(errors)
    squares = np.where(finite, errors, 0.0) ** 2
    return np.asarray(np.sqrt(squares.sum(axis=1) / np.maximum(finite.sum(axis=1), 1)))
