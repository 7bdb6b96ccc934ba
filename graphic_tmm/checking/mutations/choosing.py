"""Which hypothesis is told: the gate that it must pass, how sure it is, which of those alike comes first."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from functools import partial

import numpy as np

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.checking.mutations.evidence import Readings
from graphic_tmm.checking.mutations.hypotheses import NO_MISTAKE, UNEXPLAINED, Hypothesis, groups
from graphic_tmm.checking.mutations.mutation import FAMILIES, Mutation
from graphic_tmm.checking.mutations.names import usual

Told = tuple[tuple[Hypothesis, ...], float]
"""Hypotheses that no reading tells apart, the plausible first, and how sure they are."""
SURE, UNSURE = 0.8, 0.79
"""A name is given where it is as sure as this; a perhaps is never as sure."""
TEMPER = 2.0
"""Errors of one position hang together, and no list holds every mistake: of what readings tell for one against
another (natural logarithm) it is divided by this when it is said how sure a name is."""
LIKELY = 0.5
"""A mistake is told as a perhaps if it is at least so likely among the mistakes that we know."""
DIRECT = 0.75
"""So much more usual is a mistake at the very step whose reading is off."""
PERHAPS = 0.1
"""Less sure than this nothing is told, not even as a perhaps."""
MOST = 3
"""So many groups of one step and family may be told as one of them."""
KEPT = 300
"""So many hypotheses are told apart."""
CLEAR = 8.0
"""A second mistake beside one that explains nearly all must explain so much more (natural logarithm)."""
REPEATED = 2
"""So many doubtful readings of one segment may be a mistake: by chance of 2 % each they are one in 2500."""


def acceptable(readings: Readings, one: Hypothesis) -> bool:
    """Whether a hypothesis passes the gate: it leaves few readings unexplained and draws all that was read."""
    most = int(UNEXPLAINED * readings.count)
    return one.lost == 0 and one.beyond <= most and float(one.gain.sum()) > 0.0


def best(allowed: list[Hypothesis], rest: Rest) -> Told | None:
    """Return the group of hypotheses that is sure, with how sure it is; None where none is."""
    if not allowed:
        return None
    allowed.sort(key=by_score)
    return _sure(groups(allowed[:KEPT]), together(allowed, rest.scores))


def _sure(found: Sequence[Sequence[Hypothesis]], whole: float) -> Told | None:
    """Return the best group if it is sure; else it with up to two more of the same step and family."""
    first = found[0]
    if not first[0].fits:  # what explains most explains it badly: the others even less
        return None
    alike = [one for one in found if at_step(one[0]) == at_step(first[0])][:MOST]
    told: list[Hypothesis] = []
    for group in alike:
        told += sorted(group, key=plausible)
        sure = tempered(together(told) - whole)
        if sure >= SURE:
            return tuple(told), sure
    return None


def together(some: Iterable[Hypothesis], others: Iterable[float] = ()) -> float:
    """Return how likely one of some hypotheses is, or of others by their scores (logarithm)."""
    return float(np.logaddexp.reduce([*others, *(one.score for one in some)]))


def tempered(chance: float) -> float:
    """Return how sure something is, of the logarithm of its share among all hypotheses."""
    against = np.log(max(-np.expm1(min(chance, 0.0)), 1e-300))
    return float(1.0 / (1.0 + np.exp(np.clip((against - chance) / TEMPER, -50.0, 50.0))))


def told_of(named: Told, off: Container[Mark]) -> Told:
    """Return those of a group that are told, the plausible first, and how sure it is that one of them is right.

    Of what no reading tells apart no more than `MOST` steps and families are told; the more others there are,
    the less sure these are.
    """
    group, sure = named
    kinds: dict[tuple[object, ...], list[Hypothesis]] = {}
    for one in sorted(group, key=partial(plausible, off=off)):
        kinds.setdefault(at_step(one), []).append(one)
    told = list(kinds.values())[:MOST]
    every, these = together(group), together([one for some in told for one in some])
    others = [one for some in told for one in some[1:]]
    return (*(some[0] for some in told), *others), sure * float(np.exp(these - every))


def perhaps(readings: Readings, found: Sequence[Hypothesis], rest: Rest) -> Told | None:
    """Return the likeliest mistake where it is not sure that it is one of those that we know.

    What leaves all that is far off as far off explains nothing of it.
    """
    allowed = [
        one
        for one in found
        if acceptable(readings, one)
        and not one.instrument
        and (one.beyond < rest.beyond or not rest.beyond)
    ]
    if not allowed:
        return None
    allowed.sort(key=by_score)
    group = groups(allowed[:KEPT])[0]
    mine, known = together(group), together(allowed)
    chance = float(np.exp(mine - np.logaddexp.reduce([*rest.scores, known])))
    if np.exp(mine - known) < LIKELY or chance < PERHAPS:
        return None
    return tuple(sorted(group, key=plausible)), min(chance, UNSURE)


def at_step(one: Hypothesis) -> tuple[object, ...]:
    """Return what is said of where and of what kind a mistake is."""
    what = one.what
    if not isinstance(what, Mutation):
        return (what.family, what.kind, what.plan, what.segment)
    return (what.family, what.at.it if what.at is not None else what.was)


def plausible(one: Hypothesis, off: Container[Mark] = ()) -> tuple[float, ...]:
    """Return the place of a hypothesis among those that no reading tells apart: the usual ones first.

    ``off``: marks whose readings are off; what is off itself is rather wrong than what it was found from.
    """
    what = one.what
    if not isinstance(what, Mutation):
        return (what.cost - 0.5, 0.0, 0.0, 0.0)
    odd = what.usual + (1.0 if what.wide else 0.0) - (1.0 if usual(what) else 0.0)
    odd -= DIRECT if what.at is not None and what.at.it in off else 0.0
    at = 0.0 if one.place is None else 1.0
    return (odd, at, float(FAMILIES.index(what.family)), float(min(what.slots, default=0)))


def but_one(readings: Readings, one: Hypothesis) -> bool:
    """Whether a hypothesis passes the gate but for one position, at which something else may be off."""
    most, worst = int(UNEXPLAINED * readings.count), int(np.argmax(one.far))
    elsewhere = np.delete(one.gain, worst)
    return (
        one.lost == 0
        and one.elsewhere <= most
        and int((elsewhere > 1.0).sum()) >= REPEATED
        and float(elsewhere.sum()) > CLEAR
        and not one.instrument
    )


class Rest:
    """What is not a name: no mistake at all, or something at a step that we do not know.

    ``marks``: those whose readings are not fine; one of their steps is the ``step`` that is farthest off.
    """

    def __init__(self, marks: Container[Mark] = ()) -> None:
        self.marks = marks
        self.scores = [float(np.log(NO_MISTAKE))]
        self.step: Step | None = None
        self.beyond = 0
        self.off = 0.0


def by_score(one: Hypothesis) -> float:
    """Return the place of a hypothesis among others: the likeliest first."""
    return -one.score
