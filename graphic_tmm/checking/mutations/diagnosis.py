"""From judged readings to what happened: the right mistake, two of them at once, or none.

Hypotheses are weighed by all readings; a name is given where it is sure, and passes an absolute gate.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.record import Step
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.entries import column_multiples
from graphic_tmm.checking.mutations.evidence import Readings, likely, of_mutations, unexplained
from graphic_tmm.checking.mutations.execution import AssumedLog
from graphic_tmm.checking.mutations.hypotheses import (
    CLEAR,
    KEPT,
    LIKELY,
    PERHAPS,
    REPEATED,
    SOMETHING,
    SURE,
    UNSURE,
    Hypothesis,
    Rest,
    Told,
    acceptable,
    at_step,
    best,
    but_one,
    by_score,
    groups,
    of_board,
    of_written,
    perhaps,
    plausible,
    slip_alone,
    tempered,
    together,
    told_of,
)
from graphic_tmm.checking.mutations.likelihood import scores
from graphic_tmm.checking.mutations.mistakes import NONE, Mistakes, Offered
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.promising import promising
from graphic_tmm.checking.mutations.refinement import (
    fitted,
    multiplied,
    plain_figures,
    put_amiss,
    reweighed,
    scatters_of,
)
from graphic_tmm.checking.mutations.scaling import Scaling
from graphic_tmm.checking.records import FINE, WRONG, Judged

A_NUMBER = 0.01
"""So rarely is a segment so many times what is due by a number that no mistake that we know makes."""
OWN_SCALE = 0.1
"""So often a graph, or the polygons of forces, are: in a scale factor of which nothing was said."""
FIRST = 4
"""So many explanations are tried as the first of two mistakes."""


class _Pairs(NamedTuple):
    """A first mistake, with what no reading tells apart from it, and the seconds that explain the rest."""

    firsts: tuple[Hypothesis, ...]
    seconds: tuple[Hypothesis, ...]

    @property
    def score(self) -> float:
        """How likely the first is together with any second (logarithm)."""
        return together(self.seconds)


def two(
    readings: Readings, mistakes: Mistakes, found: Sequence[Hypothesis], rest: Rest
) -> tuple[Told, ...] | None:
    """Return two mistakes made at once, the first sure; None where there are not two, or none is sure."""
    firsts = [one for one in found if one.lost == 0 and float(one.gain.sum()) > CLEAR]
    firsts = [one for one in firsts if rest.beyond - one.beyond >= REPEATED]
    firsts = sorted((one for one in firsts if isinstance(one.what, Mutation)), key=by_score)
    tried: dict[tuple[object, ...], list[Hypothesis]] = {}
    for group in groups(firsts[:KEPT]):
        tried.setdefault(at_step(group[0]), group)  # the best of each step and family
    pairs = []
    for k, group in enumerate(list(tried.values())[:FIRST]):
        first = min(group, key=plausible)
        seconds = _allowed(readings, mistakes, first, whole=not k)
        if seconds:
            pairs.append(_Pairs(tuple(sorted(group, key=plausible)), seconds))
    if not pairs:
        return None
    best = max(pairs, key=lambda pair: pair.score)
    first, group = best.firsts[0], groups(best.seconds)[0]
    second = min(group, key=plausible)
    if float(second.gain.sum()) <= CLEAR or first.beyond - second.beyond < REPEATED:
        return None
    single = [*rest.scores, *(one.score for one in found if acceptable(readings, one))]
    sure = tempered(best.score - float(np.logaddexp(best.score, _other_pairs(best, pairs, single))))
    if sure < SURE:
        return None
    its = sure * tempered(together(group) - best.score)
    named: tuple[Told, ...] = ((best.firsts, sure),)
    return named if its < PERHAPS else (*named, (tuple(sorted(group, key=plausible)), its))


def _other_pairs(best: _Pairs, pairs: Iterable[_Pairs], single: Iterable[float]) -> float:
    """Return how likely it is (logarithm) that the first mistake is none of those of the best pairs."""
    own = {at_step(one) for one in best.firsts}
    other = [
        one.score
        for pair in pairs
        if pair is not best
        for one in pair.seconds
        if at_step(one) not in own
    ]
    return float(np.logaddexp.reduce([*single, *other]))


def second_mistake(readings: Readings, mistakes: Mistakes, first: Hypothesis) -> Told | None:
    """Return what perhaps was done amiss beside a mistake that is named and leaves something unexplained."""
    if not isinstance(first.what, Mutation):
        return None
    allowed = _allowed(readings, mistakes, first)
    if not allowed:
        return None
    group = groups(allowed)[0]
    mine, known = together(group), together(allowed)
    chance = float(np.exp(mine - np.logaddexp(known, first.score)))
    if first.beyond <= group[0].beyond or np.exp(mine - known) < LIKELY or chance < PERHAPS:
        return None
    return tuple(sorted(group, key=plausible)), min(chance, UNSURE)


def _allowed(
    readings: Readings, mistakes: Mistakes, first: Hypothesis, *, whole: bool = True
) -> tuple[Hypothesis, ...]:
    """Return the second mistakes that pass the gate, the likeliest first, scored with the first.

    ``whole``: where no mutation does, look for what is written down amiss, and by a hand that draws with both.
    """
    assert isinstance(first.what, Mutation)
    base = mistakes.base_of(first.board).mistaken(first.what, first.place)
    left = unexplained(readings, base)
    found = _seconds(readings, mistakes, base, first, left)
    ways: tuple[Callable[[], Sequence[Hypothesis]], ...] = (
        lambda: found,
        lambda: _written(readings, mistakes, base, first, left),
        lambda: reweighed(readings, lambda board: base, found),
    )
    for way in ways if whole else ways[:1]:  # the dearer ones where the others tell nothing
        allowed = [one for one in way() if acceptable(readings, one) and one.fits]
        if allowed:
            return tuple(sorted(allowed, key=by_score)[:KEPT])
    return ()


def _seconds(
    readings: Readings,
    mistakes: Mistakes,
    base: AssumedLog,
    first: Hypothesis,
    left: Collection[tuple[Key, bool]],
) -> list[Hypothesis]:
    """Return the mutations that move what a first mistake leaves unexplained."""
    offered = mistakes.boards[first.board]
    slots = first.what.slots if isinstance(first.what, Mutation) else frozenset()
    rows = promising(readings, offered, base, left, slots)
    if len(rows) < 2:
        return []
    some = [offered.mutations[k] for k in rows]
    evidence, _ = of_mutations(readings, base, some, plain_figures(readings, offered, some, base))
    found = of_board(first.board, some, evidence, offered.shares)
    return [one._replace(score=one.score + first.score) for one in found]


def _written(
    readings: Readings,
    mistakes: Mistakes,
    base: AssumedLog,
    first: Hypothesis,
    left: Collection[tuple[Key, bool]],
) -> list[Hypothesis]:
    """Return what may have been amiss with the table of readings, beside a first mistake."""
    plain = mistakes.boards[first.board].run([NONE], base)
    due = readings.figures(base.board, plain, np.arange(1))
    found = of_written(readings, base, left, due)
    return [one._replace(score=one.score + first.score) for one in found if not one.instrument]


CERTAIN = 0.95
"""Where no reading is wrong, a name must be as sure as this, and explain half as much again as `CLEAR`."""


class Diagnosis(NamedTuple):
    """What happened: groups of hypotheses that no reading tells apart, the plausible first, how sure each is.

    ``unknown``: the step that is farthest off where no name is given; None where there is one that leaves
    nothing. ``left``: the wrong readings that a sure name leaves unexplained. ``followed``: those with which
    others were drawn, so that they were not only read amiss. ``score``: how likely the readings are with the
    best of what may have happened (logarithm).
    """

    named: tuple[Told, ...]
    unknown: Step | None
    wrong: tuple[Judged, ...]
    readings: Readings | None = None
    doubtful: tuple[Judged, ...] = ()
    left: tuple[Judged, ...] = ()
    followed: frozenset[Key] = frozenset()
    score: float = 0.0

    @property
    def certain(self) -> bool:
        """Whether nothing is left to be explained: a name is sure, or nothing is wrong."""
        return not self.wrong or (
            self.unknown is None and any(one[1] >= SURE for one in self.named)
        )


def diagnosed(
    mistakes: Mistakes,
    drawing: Comparison,
    judged: Sequence[Judged],
    *,
    rare: bool,
    scaling: Scaling | None = None,
) -> Diagnosis:
    """Return what happened to a drawing; nothing where chance is enough: no mistake is looked for then.

    ``rare``: readings, none of them wrong, are together farther off than chance brings about; ``scaling``: what
    is known of scale factors, None where all are the scene's.
    """
    wrong = tuple(one for one in judged if one.verdict == WRONG)
    if not wrong and not rare:
        return Diagnosis((), None, ())
    doubtful = tuple(one for one in judged if one.verdict != FINE)
    readings = Readings(drawing, doubtful)
    wronged = {one.taken.key for one in doubtful}
    off = {mark for (mark, _), taken in readings.by_mark.items() if taken.key in wronged}
    followed = frozenset(one.follows.key for one in judged if one.follows is not None)
    found: list[Hypothesis] = []
    rest = Rest(off)
    for number, offered in enumerate(mistakes.boards):
        found += _of_board(readings, offered, number, rest, scaling or Scaling())
    written = of_written(readings, mistakes.base_of(0), readings.least)
    found += [one for one in written if not slip_alone(one, rest)]
    said = _said(readings, mistakes, found, rest)
    said = said if scaling is None else scaling.weighed(said)
    if not said and wrong:
        known = perhaps(readings, found, rest)
        said = () if known is None else (known,)
    if not wrong and said and (said[0][1] < CERTAIN or said[0][0][0].gain.sum() < 1.5 * CLEAR):
        said = ()
    score = likely(readings, mistakes.base_of(0)) + max(
        (*rest.scores, *_allowed_scores(readings, found))
    )
    told = (told_of(one, off) for one in said)
    said = tuple(one for one in told if one[1] >= PERHAPS)
    whole = len(said) > 1 or (bool(said) and acceptable(readings, said[0][0][0]))
    certain = whole and said[0][1] >= SURE
    if not certain:
        return Diagnosis(said, rest.step, wrong, readings, doubtful, (), followed, score)
    left = _left(readings, mistakes, said, wrong)
    steps = [step for one in left if (step := drawing.step(one.taken)) is not None]
    first = min(steps, key=lambda step: step.it.slot, default=None)
    return Diagnosis(said, first, wrong, readings, doubtful, left, followed, score)


def _allowed_scores(readings: Readings, found: Iterable[Hypothesis]) -> Iterator[float]:
    """Yield the scores of the mistakes that pass the gate."""
    return (one.score for one in found if acceptable(readings, one))


def _left(
    readings: Readings, mistakes: Mistakes, said: Sequence[Told], wrong: Sequence[Judged]
) -> tuple[Judged, ...]:
    """Return the wrong readings that what is sure does not explain; of the table all are explained."""
    base: AssumedLog | None = None
    for group, sure in said:
        one = group[0]
        if sure < SURE:
            continue
        board = mistakes.boards[one.board].board
        if not isinstance(one.what, Mutation) or (base is not None and base.board is not board):
            return ()
        base = (base or mistakes.base_of(one.board)).mistaken(one.what, one.place)
    if base is None:
        return ()
    far = unexplained(readings, base)
    if far and readings.found and base.board is readings.drawing.made.mechanism:
        far &= unexplained(readings, base, scatters_of(readings, base))
    return tuple(one for one in wrong if one.follows is None and one.taken.at in far)


def _said(
    readings: Readings, mistakes: Mistakes, found: Sequence[Hypothesis], rest: Rest
) -> tuple[Told, ...]:
    """Return what is sure: one mistake, two, or one beside which something is off at one position."""
    named = best([one for one in found if acceptable(readings, one)], rest)
    if named is None:
        found = reweighed(readings, mistakes.base_of, found)
        named = best([one for one in found if acceptable(readings, one)], rest)
    if named is None or named[0][0].beyond >= REPEATED:
        pair = two(readings, mistakes, found, rest)
        if pair is not None:
            return pair
    if named is None:
        named = best([one for one in found if but_one(readings, one)], rest)
    if named is None:
        return ()
    group, sure = named
    small = group[0].instrument and float(group[0].gain.sum()) > 1.5 * CLEAR
    if rest.beyond - group[0].beyond < REPEATED and not small:
        sure = min(sure, UNSURE)  # one reading alone is like many things
    other = second_mistake(readings, mistakes, group[0]) if group[0].beyond else None
    return ((group, sure),) if other is None else ((group, sure), other)


def _of_board(
    readings: Readings, offered: Offered, number: int, rest: Rest, scaling: Scaling
) -> Iterator[Hypothesis]:
    rows = promising(readings, offered, offered.base, readings.least)
    some = [offered.mutations[k] for k in rows]
    plain = offered.figures(readings.keys, np.array(rows))
    evidence, told = of_mutations(readings, offered.base, some, plain)
    rest.beyond = int(evidence.beyond[0].sum())
    if told is not None:
        steps = {step.it: step for step in offered.base.log.steps}
        prior = float(np.log(SOMETHING / max(1, len(told.entries))))
        for mark, entry in told.entries.items():
            gain = np.maximum(entry.unknown - entry.base.likely, 0.0)
            rest.scores.append(prior + float(gain.sum()))
            if mark in rest.marks and (far := float(entry.base.off.max())) > rest.off:
                rest.off, rest.step = far, steps[mark]
        rest.scores += scores(told.multiples.values(), A_NUMBER)
        if more := multiplied(readings, offered, told):
            plain = plain_figures(readings, offered, more, offered.base)
            numbers, _ = of_mutations(readings, offered.base, more, plain)
            yield from of_board(number, more, numbers, {}, fitted=True)
    if number == 0:
        drawn = [one for one in readings.columns if one.taken.mm is not None]
        others = [one for one in readings.columns if one.taken.mm is None]
        rest.scores += scores(column_multiples(others), A_NUMBER)
        drawn = [one for one in drawn if scaling.free(one.taken.plan)]
        rest.scores += scores(column_multiples(drawn, own=True), OWN_SCALE)
        rest.scores += scores(column_multiples(drawn, whole=True, own=True), OWN_SCALE)
    yield from of_board(number, some, evidence, offered.shares)
    if number == 0 or offered.made.mechanism is None:
        free, told_free = fitted(readings, offered)
        if free:
            yield from of_board(number, free, told_free, {"given": len(offered.free)}, fitted=True)
        if (evidence.beyond[0, :-1] >= REPEATED).any():
            stands, told_stands = put_amiss(readings, offered)
            yield from of_board(number, stands, told_stands, {}, fitted=True)
