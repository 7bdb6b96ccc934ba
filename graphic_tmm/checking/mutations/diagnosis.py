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
from graphic_tmm.checking.mutations import changed
from graphic_tmm.checking.mutations.choosing import (
    CLEAR,
    KEPT,
    LIKELY,
    PERHAPS,
    REPEATED,
    SURE,
    UNSURE,
    Rest,
    Told,
    acceptable,
    best,
    but_one,
    by_score,
    perhaps,
    plausible,
    tempered,
    told_of,
)
from graphic_tmm.checking.mutations.evidence import Board, Readings, of_mutations, of_variations
from graphic_tmm.checking.mutations.finalists import refined
from graphic_tmm.checking.mutations.fitting import fitted
from graphic_tmm.checking.mutations.hypotheses import (
    SOMETHING,
    Hypothesis,
    groups,
    of_board,
    of_table,
)
from graphic_tmm.checking.mutations.mistakes import NONE, Mistakes, Offered
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.tables import Table, copied, variations
from graphic_tmm.checking.records import FINE, WRONG, Judged, Taken

FIRST = 3
"""So many explanations are tried as the first of two mistakes."""
VISIBLE = 0.5
"""A mistake must move some reading that is not fine by this share of what a hand scatters by, with no
reading put in: else it explains noise."""
CERTAIN = 0.95
"""Where no reading is wrong, a name must be as sure as this, and explain half as much again as `CLEAR`."""
FINALISTS = 8
"""So many of the best are weighed anew where none is sure."""


class Diagnosis(NamedTuple):
    """What happened: groups of hypotheses that no reading tells apart, the plausible first, how sure each is.

    ``unknown``: the step that is farthest off where no name is given; None where there is one.
    """

    named: tuple[Told, ...]
    unknown: Step | None
    wrong: tuple[Judged, ...]
    readings: Readings | None = None
    doubtful: tuple[Judged, ...] = ()


def diagnosed(mistakes: Mistakes, drawing: Comparison, judged: Sequence[Judged]) -> Diagnosis:
    """Return what happened to a drawing."""
    wrong = tuple(one for one in judged if one.verdict == WRONG)
    if not wrong and not _repeated(judged):
        return Diagnosis((), None, ())
    readings = Readings(drawing)
    least = _least(drawing, judged)
    found: list[Hypothesis] = []
    rest = Rest()
    for number, offered in enumerate(mistakes.boards):
        found += _of_board(readings, offered, number, least, rest)
    table = mistakes.boards[0].base
    found += _of_table(readings, table)
    said = _said(readings, mistakes, least, found, rest)
    if not said and wrong:
        likely = perhaps(readings, found, rest)
        said = () if likely is None else (likely,)
    if not wrong and said and (said[0][1] < CERTAIN or said[0][0][0].gain.sum() < 1.5 * CLEAR):
        said = ()
    doubtful = tuple(one for one in judged if one.verdict != FINE)
    wronged = {one.taken.key for one in doubtful}
    off = {mark for (mark, _), taken in readings.by_mark.items() if taken.key in wronged}
    said = tuple(told_of(one, off) for one in said)
    whole = len(said) > 1 or (bool(said) and acceptable(readings, said[0][0][0]))
    certain = whole and said[0][1] >= SURE
    return Diagnosis(said, None if certain else rest.step, wrong, readings, doubtful)


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
        found = _with_finalists(readings, mistakes, found)
        named = best([one for one in found if acceptable(readings, one)], rest)
    if named is None or named[0][0].beyond >= REPEATED:
        pair = _two(readings, mistakes, least, found, rest)
        if pair is not None:
            first, second = pair[0][0][0], pair[1][0][0]
            if float(second.gain.sum()) > CLEAR and first.beyond - second.beyond >= REPEATED:
                return pair
    if named is None:
        named = best([one for one in found if but_one(readings, one)], rest)
    if named is None:
        return ()
    group, sure = named
    if rest.beyond - group[0].beyond < REPEATED:
        sure = min(sure, UNSURE)  # one reading alone is like many things
    beside = _beside(readings, mistakes, least, group[0]) if group[0].beyond else None
    return ((group, sure),) if beside is None else ((group, sure), beside)


def _with_finalists(
    readings: Readings, mistakes: Mistakes, found: Sequence[Hypothesis]
) -> list[Hypothesis]:
    """Return hypotheses, the best of them weighed anew by a hand that draws with the mistake."""
    last = [
        one
        for one in sorted(found, key=by_score)
        if float(one.gain.sum()) > CLEAR and not one.lost and isinstance(one.what, Mutation)
    ][:FINALISTS]
    anew = {id(one): refined(readings, mistakes.boards[one.board].base, one) for one in last}
    return [anew.get(id(one), one) for one in found]


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
            if (far := float(told.off[mark].max())) > rest.off:
                rest.off, rest.step = far, steps[mark]
    yield from of_board(number, some, evidence, offered.shares)
    if number == 0 or offered.made.mechanism is None:
        free, told_free = fitted(readings, offered, offered.base, least)
        if free:
            yield from of_board(number, free, told_free, {"given": len(offered.free)}, fitted=True)


def _of_table(readings: Readings, base: Board) -> Iterator[Hypothesis]:
    drawing = readings.drawing
    names = drawing.made.mechanism.names if drawing.made.mechanism is not None else ()
    table = Table(drawing.rows, names or tuple(dict.fromkeys(t.position for t in drawing.rows)))

    def off(k: int) -> complex:
        taken = drawing.rows[k]
        return taken.spot - drawing.spots.get(taken.key, taken.spot)

    def apart(k: int, j: int) -> bool:
        one, other = drawing.rows[k], drawing.rows[j]
        if one.pointed:
            return abs(drawing.spots[one.key] - drawing.spots[other.key]) > 1.0
        due, before = (_due(drawing, taken) for taken in (one, other))
        return abs(due - before) > 3.0 * drawing.by.spread[one.at].rms + 0.01 * abs(due)

    scales = {
        one.symbol: one.value for board in drawing.made.boards for one in board.scales.values()
    }
    varied = variations(table, drawing.scale, off, scales, apart)
    some = [table.same(), *varied, *copied(table, apart)]
    yield from of_table(some, of_variations(readings, base, some))


def _due(drawing: Comparison, taken: Taken) -> float:
    cell = drawing.due[taken.key]
    return float((cell.mm if taken.mm is not None else cell.value) or 0.0)


def _two(
    readings: Readings,
    mistakes: Mistakes,
    least: Mapping[tuple[Key, bool], float],
    found: Sequence[Hypothesis],
    rest: Rest,
) -> tuple[Told, ...] | None:
    """Return two mistakes made at once: a second round on top of the best explanations of a first."""
    single = [*rest.scores, *(one.score for one in found if acceptable(readings, one))]
    top: tuple[float, float, tuple[Hypothesis, ...], tuple[Hypothesis, ...]] | None = None
    firsts = [one for one in found if one.lost == 0 and float(one.gain.sum()) > 0.0]
    firsts = sorted((one for one in firsts if isinstance(one.what, Mutation)), key=by_score)
    for group in groups(firsts[:KEPT])[:FIRST]:
        first = min(group, key=plausible)
        offered = mistakes.boards[first.board]
        base = _with(offered, first)
        allowed = [
            one
            for one in _second(readings, offered, base, first, least)
            if acceptable(readings, one)
        ]
        if not allowed:
            continue
        second = groups(sorted(allowed, key=by_score)[:KEPT])[0]
        score = float(np.logaddexp.reduce([one.score for one in second]))
        whole = float(np.logaddexp.reduce([*single, *(one.score for one in allowed)]))
        if top is None or score > top[0]:
            pair = tuple(sorted(group, key=plausible)), tuple(sorted(second, key=plausible))
            top = score, tempered(score - whole), *pair
    if top is None or top[1] < SURE:
        return None
    return (top[2], top[1]), (top[3], top[1])


def _beside(
    readings: Readings,
    mistakes: Mistakes,
    least: Mapping[tuple[Key, bool], float],
    first: Hypothesis,
) -> Told | None:
    """Return what perhaps was done amiss beside a mistake that is named and leaves something unexplained."""
    if not isinstance(first.what, Mutation):
        return None
    base = _with(mistakes.boards[first.board], first)
    some = _second(readings, mistakes.boards[first.board], base, first, least)
    allowed = sorted((one for one in some if acceptable(readings, one)), key=by_score)[:KEPT]
    if not allowed:
        return None
    group = groups(allowed)[0]
    mine, known = (
        float(np.logaddexp.reduce([one.score for one in these])) for these in (group, allowed)
    )
    chance = float(np.exp(mine - np.logaddexp(known, first.score)))
    if first.beyond <= group[0].beyond or np.exp(mine - known) < LIKELY or chance < PERHAPS:
        return None
    return tuple(sorted(group, key=plausible)), min(chance, UNSURE)


def _with(offered: Offered, first: Hypothesis) -> Board:
    """Return a board on which a mistake is made."""
    assert isinstance(first.what, Mutation)
    log, given = changed.made(offered.base.log, offered.base.given, first.what, first.place)
    return Board(offered.board, log, given)


def _second(
    readings: Readings,
    offered: Offered,
    base: Board,
    first: Hypothesis,
    least: Mapping[tuple[Key, bool], float],
) -> list[Hypothesis]:
    """Return hypotheses of a second mistake, scored with the first."""
    rows = offered.moving(least)
    slots = first.what.slots if isinstance(first.what, Mutation) else frozenset()
    some = [one for one in (offered.mutations[k] for k in rows) if not one.slots & slots]
    some = some if some and some[0] is NONE else [NONE, *some]
    plain = offered.run(some, base)
    evidence, _ = of_mutations(readings, base, some, plain, np.arange(len(some)))
    return [
        one._replace(score=one.score + first.score, gain=one.gain)
        for one in of_board(first.board, some, evidence, offered.shares)
    ]
