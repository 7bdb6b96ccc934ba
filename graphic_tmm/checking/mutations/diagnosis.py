"""From judged readings to what happened: the right mistake, or none.

Hypotheses are weighed by all readings; a name is given where it is sure, and passes an absolute gate:
posteriors only compare, and the best of bad explanations is none.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.choosing import (
    CLEAR,
    REPEATED,
    SURE,
    UNSURE,
    Rest,
    Told,
    acceptable,
    best,
    but_one,
    perhaps,
    told_of,
)
from graphic_tmm.checking.mutations.columns import multiples
from graphic_tmm.checking.mutations.evidence import Board, Readings, of_mutations, unexplained
from graphic_tmm.checking.mutations.finalists import reweighed, scatters_of
from graphic_tmm.checking.mutations.fitting import fitted, put_amiss
from graphic_tmm.checking.mutations.hypotheses import A_NUMBER, SOMETHING, Hypothesis, of_board
from graphic_tmm.checking.mutations.mistakes import Mistakes, Offered
from graphic_tmm.checking.mutations.multiples import scores
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.second import beside, two, with_mistake
from graphic_tmm.checking.mutations.written import of_written
from graphic_tmm.checking.records import FINE, WRONG, Judged

VISIBLE = 0.5
"""A mistake must move some reading that is not fine by this share of what a hand scatters by, with no
reading put in: else it explains noise."""
CERTAIN = 0.95
"""Where no reading is wrong, a name must be as sure as this, and explain half as much again as `CLEAR`."""


class Diagnosis(NamedTuple):
    """What happened: groups of hypotheses that no reading tells apart, the plausible first, how sure each is.

    ``unknown``: the step that is farthest off where no name is given; None where there is one that leaves
    nothing. ``left``: the wrong readings that a sure name leaves unexplained. ``followed``: those with which
    others were drawn, so that they were not only read amiss.
    """

    named: tuple[Told, ...]
    unknown: Step | None
    wrong: tuple[Judged, ...]
    readings: Readings | None = None
    doubtful: tuple[Judged, ...] = ()
    left: tuple[Judged, ...] = ()
    followed: frozenset[Key] = frozenset()


def diagnosed(mistakes: Mistakes, drawing: Comparison, judged: Sequence[Judged]) -> Diagnosis:
    """Return what happened to a drawing."""
    wrong = tuple(one for one in judged if one.verdict == WRONG)
    if not wrong and not _repeated(judged):
        return Diagnosis((), None, ())
    readings = Readings(drawing)
    least = _least(drawing, judged)
    doubtful = tuple(one for one in judged if one.verdict != FINE)
    wronged = {one.taken.key for one in doubtful}
    off = {mark for (mark, _), taken in readings.by_mark.items() if taken.key in wronged}
    followed = frozenset(one.follows.key for one in judged if one.follows is not None)
    found: list[Hypothesis] = []
    rest = Rest(off)
    for number, offered in enumerate(mistakes.boards):
        found += _of_board(readings, offered, number, least, rest)
    found += of_written(readings, mistakes.base_of(0))
    said = _said(readings, mistakes, least, found, rest)
    if not said and wrong:
        likely = perhaps(readings, found, rest)
        said = () if likely is None else (likely,)
    if not wrong and said and (said[0][1] < CERTAIN or said[0][0][0].gain.sum() < 1.5 * CLEAR):
        said = ()
    said = tuple(told_of(one, off) for one in said)
    whole = len(said) > 1 or (bool(said) and acceptable(readings, said[0][0][0]))
    certain = whole and said[0][1] >= SURE
    if not certain:
        return Diagnosis(said, rest.step, wrong, readings, doubtful, (), followed)
    left = _left(readings, mistakes, said, wrong)
    steps = [step for one in left if (step := drawing.step(one.taken)) is not None]
    first = min(steps, key=lambda step: step.it.slot, default=None)
    return Diagnosis(said, first, wrong, readings, doubtful, left, followed)


def _left(
    readings: Readings, mistakes: Mistakes, said: Sequence[Told], wrong: Sequence[Judged]
) -> tuple[Judged, ...]:
    """Return the wrong readings that what is sure does not explain; of the table all are explained."""
    base: Board | None = None
    for group, sure in said:
        one = group[0]
        if sure < SURE:
            continue
        board = mistakes.boards[one.board].board
        if not isinstance(one.what, Mutation) or (base is not None and base.board is not board):
            return ()
        base = with_mistake(mistakes, one, base)
    if base is None:
        return ()
    far = unexplained(readings, base)
    if far and readings.found and base.board is readings.drawing.made.mechanism:
        far &= unexplained(readings, base, scatters_of(readings, base))
    return tuple(one for one in wrong if one.follows is None and one.taken.at in far)


def _said(
    readings: Readings,
    mistakes: Mistakes,
    least: Mapping[tuple[Key, bool], float],
    found: Sequence[Hypothesis],
    rest: Rest,
) -> tuple[Told, ...]:
    """Return what is sure: one mistake, two, or one beside which something is off at one position."""
    named = best([one for one in found if acceptable(readings, one)], rest)
    if named is None:
        found = reweighed(readings, mistakes.base_of, found)
        named = best([one for one in found if acceptable(readings, one)], rest)
    if named is None or named[0][0].beyond >= REPEATED:
        pair = two(readings, mistakes, least, found, rest)
        if pair is not None:
            return pair
    if named is None:
        named = best([one for one in found if but_one(readings, one)], rest)
    if named is None:
        return ()
    group, sure = named
    if rest.beyond - group[0].beyond < REPEATED:
        sure = min(sure, UNSURE)  # one reading alone is like many things
    other = beside(readings, mistakes, least, group[0]) if group[0].beyond else None
    return ((group, sure),) if other is None else ((group, sure), other)


def _repeated(judged: Sequence[Judged]) -> bool:
    """Whether one segment is doubtful so often that a hand's slips are hardly the reason."""
    doubtful = [one.taken for one in judged if one.verdict != FINE]
    segments = Counter((one.plan, one.segment) for one in doubtful)
    places = Counter((one.plan, one.position) for one in doubtful)
    return any(n >= REPEATED for n in segments.values()) or any(
        n > REPEATED for n in places.values()
    )


def _least(drawing: Comparison, judged: Sequence[Judged]) -> dict[tuple[Key, bool], float]:
    """Return by how much a mistake must move each reading that is not fine."""
    return {
        one.taken.at: VISIBLE * drawing.by.spread[one.taken.at].rms
        for one in judged
        if one.verdict != FINE and one.taken.at in drawing.by.spread
    }


def _of_board(
    readings: Readings,
    offered: Offered,
    number: int,
    least: Mapping[tuple[Key, bool], float],
    rest: Rest,
) -> Iterator[Hypothesis]:
    rows = offered.moving(least)
    some = [offered.mutations[k] for k in rows]
    evidence, told = of_mutations(readings, offered.base, some, offered.plain, rows)
    rest.beyond = int(evidence.beyond[0].sum())
    if told is not None:
        steps = {step.it: step for step in offered.base.log.steps}
        gains = {mark: told.unknown[mark] - told.base[mark] for mark in told.base}
        prior = float(np.log(SOMETHING / max(1, len(gains))))
        for mark, gain in gains.items():
            rest.scores.append(prior + float(np.maximum(gain, 0.0).sum()))
            if mark in rest.marks and (far := float(told.off[mark].max())) > rest.off:
                rest.off, rest.step = far, steps[mark]
        rest.scores += scores(told.multiples.values(), A_NUMBER)
    if number == 0:
        rest.scores += scores(multiples(readings.columns), A_NUMBER)
    yield from of_board(number, some, evidence, offered.shares)
    if number == 0 or offered.made.mechanism is None:
        free, told_free = fitted(readings, offered, offered.base, least)
        if free:
            yield from of_board(number, free, told_free, {"given": len(offered.free)}, fitted=True)
        if (evidence.beyond[0, :-1] >= REPEATED).any():
            stands, told_stands = put_amiss(readings, offered, offered.base, least)
            yield from of_board(number, stands, told_stands, {}, fitted=True)
