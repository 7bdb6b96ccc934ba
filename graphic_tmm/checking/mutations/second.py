"""Two mistakes at once: a second round on top of the best explanations of the first.

What is told of a first mistake holds whatever the second is; a second that is not sure is a perhaps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.cells import Key
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
    at_step,
    by_score,
    plausible,
    tempered,
)
from graphic_tmm.checking.mutations.evidence import Board, Readings, of_mutations
from graphic_tmm.checking.mutations.finalists import reweighed
from graphic_tmm.checking.mutations.hypotheses import Hypothesis, groups, of_board
from graphic_tmm.checking.mutations.mistakes import NONE, Mistakes
from graphic_tmm.checking.mutations.mutation import Mutation
from graphic_tmm.checking.mutations.written import of_written

FIRST = 4
"""So many explanations are tried as the first of two mistakes."""
Least = Mapping[tuple[Key, bool], float]


class _Pairs(NamedTuple):
    """A first mistake, with what no reading tells apart from it, and the seconds that explain the rest."""

    firsts: tuple[Hypothesis, ...]
    seconds: tuple[Hypothesis, ...]

    @property
    def score(self) -> float:
        """How likely the first is together with any second (logarithm)."""
        return _whole(self.seconds)


def two(
    readings: Readings, mistakes: Mistakes, least: Least, found: Sequence[Hypothesis], rest: Rest
) -> tuple[Told, ...] | None:
    """Return two mistakes made at once, the first sure; None where there are not two, or none is sure."""
    firsts = [one for one in found if one.lost == 0 and float(one.gain.sum()) > CLEAR]
    firsts = [one for one in firsts if rest.beyond - one.beyond >= REPEATED]
    firsts = sorted((one for one in firsts if isinstance(one.what, Mutation)), key=by_score)
    tried: dict[tuple[object, ...], list[Hypothesis]] = {}
    for group in groups(firsts[:KEPT]):
        tried.setdefault(at_step(group[0]), group)  # the best of each step and family
    pairs = []
    for group in list(tried.values())[:FIRST]:
        first = min(group, key=plausible)
        seconds = _allowed(readings, mistakes, least, first)
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
    sure = tempered(best.score - float(np.logaddexp(best.score, _others(best, pairs, single))))
    if sure < SURE:
        return None
    its = sure * tempered(_whole(group) - best.score)
    named: tuple[Told, ...] = ((best.firsts, sure),)
    return named if its < PERHAPS else (*named, (tuple(sorted(group, key=plausible)), its))


def _others(best: _Pairs, pairs: Iterable[_Pairs], single: Iterable[float]) -> float:
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


def beside(readings: Readings, mistakes: Mistakes, least: Least, first: Hypothesis) -> Told | None:
    """Return what perhaps was done amiss beside a mistake that is named and leaves something unexplained."""
    if not isinstance(first.what, Mutation):
        return None
    allowed = _allowed(readings, mistakes, least, first)
    if not allowed:
        return None
    group = groups(allowed)[0]
    mine, known = _whole(group), _whole(allowed)
    chance = float(np.exp(mine - np.logaddexp(known, first.score)))
    if first.beyond <= group[0].beyond or np.exp(mine - known) < LIKELY or chance < PERHAPS:
        return None
    return tuple(sorted(group, key=plausible)), min(chance, UNSURE)


def with_mistake(mistakes: Mistakes, one: Hypothesis, base: Board | None = None) -> Board:
    """Return a board on which a mistake is made."""
    assert isinstance(one.what, Mutation)
    base = base or mistakes.boards[one.board].base
    log, given = changed.made(base.log, base.given, one.what, one.place)
    return Board(base.board, log, given)


def _allowed(
    readings: Readings, mistakes: Mistakes, least: Least, first: Hypothesis
) -> tuple[Hypothesis, ...]:
    """Return the second mistakes that pass the gate, the likeliest first, scored with the first."""
    base = with_mistake(mistakes, first)
    found = _seconds(readings, mistakes, base, first, least)
    ways: tuple[Callable[[], Sequence[Hypothesis]], ...] = (
        lambda: found,
        lambda: _written(readings, mistakes, base, first),
        lambda: reweighed(readings, lambda board: base, found),
    )
    for way in ways:  # the dearer ones where the others tell nothing
        allowed = [one for one in way() if acceptable(readings, one) and one.fits]
        if allowed:
            return tuple(sorted(allowed, key=by_score)[:KEPT])
    return ()


def _seconds(
    readings: Readings, mistakes: Mistakes, base: Board, first: Hypothesis, least: Least
) -> list[Hypothesis]:
    offered = mistakes.boards[first.board]
    slots = first.what.slots if isinstance(first.what, Mutation) else frozenset()
    rows = offered.moving(least)
    some = [one for one in (offered.mutations[k] for k in rows) if not one.slots & slots]
    some = some if some and some[0] is NONE else [NONE, *some]
    plain = offered.run(some, base)
    evidence, _ = of_mutations(readings, base, some, plain, np.arange(len(some)))
    found = of_board(first.board, some, evidence, offered.shares)
    return [one._replace(score=one.score + first.score) for one in found]


def _written(
    readings: Readings, mistakes: Mistakes, base: Board, first: Hypothesis
) -> list[Hypothesis]:
    """Return what may have been amiss with the table of readings, beside a first mistake."""
    plain = mistakes.boards[first.board].run([NONE], base)
    found = of_written(readings, base, readings.figures(base.board, plain, np.arange(1)))
    return [one._replace(score=one.score + first.score) for one in found if not one.instrument]


def _whole(some: Iterable[Hypothesis]) -> float:
    return float(np.logaddexp.reduce([one.score for one in some]))
