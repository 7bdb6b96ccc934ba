"""Hypotheses: the hand, an instrument, a mistake of a family, a table written down amiss, the unknown.

Which of them is told: the gate that it must pass, how sure it is, which of those alike comes first.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.mutations.evidence import Readings, of_variations
from graphic_tmm.checking.mutations.execution import AssumedLog
from graphic_tmm.checking.mutations.likelihood import Evidence
from graphic_tmm.checking.mutations.mutation import FAMILIES, LEFT_OUT, PREVIOUS, Mutation
from graphic_tmm.checking.mutations.tables import Variation
from graphic_tmm.checking.mutations.words import usual
from graphic_tmm.checking.records import INSTRUMENT

Array = NDArray[np.float64]
NO_MISTAKE, SOMETHING, INSTRUMENTS, KNOWN = 0.6, 0.1, 0.05, 0.25
"""What is expected beforehand: most drawings hold no mistake; of the others the known ones are most."""
EVERYWHERE = 0.75
"""A mistake is made wherever it can be in three of four drawings, else in one position; what is taken from the
position before rather once."""
FITTED = 4.5
"""What a free number costs that is found from the readings: it may be any of some hundred (logarithm)."""
UNEXPLAINED = 0.03
"""No name is given that leaves a larger share of the readings beyond what a hand does."""
THOUSANDTH = 3.09
"""Of a normal distribution one of a thousand is farther off, standard deviations."""
ALIKE = 0.6
"""Mistakes whose likelihoods differ by no more at any position (natural logarithm) no reading tells apart."""


class Hypothesis(NamedTuple):
    """A hypothesis weighed: what is mutated (or how the table was written), where, what speaks for it.

    ``place``: at one position only (its index); ``score``: the logarithm of how likely it is beforehand and
    by the readings, that of no mistake being `NO_MISTAKE`'s; ``gain``: (position,) of the readings;
    ``beyond``, ``lost``: how many readings it leaves unexplained, how many it cannot draw; ``far``: the former
    by position. ``moved``, ``squares``: how many it moves and explains, the sum of the squares of how far off
    these are, in standard deviations.
    """

    what: Mutation | Variation
    board: int
    place: int | None
    score: float
    gain: Array
    beyond: int
    lost: int
    far: Array
    moved: float = 0.0
    squares: float = 0.0

    @property
    def fits(self) -> bool:
        """Whether what it explains is as near as a hand's errors are: so bad a fit is one of a thousand.

        The sum of squares is as chi-square's; its cube root is nearly normal (Wilson and Hilferty, 1931).
        """
        if not self.moved:
            return True
        part = 2.0 / (9.0 * self.moved)
        return bool((self.squares / self.moved) ** (1 / 3) < 1.0 - part + THOUSANDTH * part**0.5)

    @property
    def elsewhere(self) -> int:
        """How many readings it leaves unexplained but in the worst position: there may be a slip beside it."""
        return self.beyond - int(self.far.max(initial=0.0))

    @property
    def wide(self) -> bool:
        """Whether it is that every step of a kind was done otherwise."""
        return isinstance(self.what, Mutation) and self.what.wide

    @property
    def instrument(self) -> bool:
        """Whether it is no mistake, but an instrument that is off."""
        return isinstance(self.what, Variation) and self.what.kind == INSTRUMENT


def of_board(
    board: int,
    some: Sequence[Mutation],
    evidence: Evidence,
    shares: Mapping[str, float],
    *,
    fitted: bool = False,
) -> Iterator[Hypothesis]:
    """Yield the hypotheses that mutations make, everywhere and at one position; the first row is the base."""
    for row, one in enumerate(some):
        if not one.family:
            continue
        share = KNOWN / len(FAMILIES) / (shares.get(one.family, 1.0) or 1.0) / one.usual
        prior = float(np.log(share)) - (FITTED if fitted else 0.0)
        yield from _scoped(one, board, row, prior, evidence)


def of_table(
    every: Sequence[Variation], some: Sequence[Variation], evidence: Evidence
) -> Iterator[Hypothesis]:
    """Yield the hypotheses that a table written down otherwise makes; the first row is the base.

    ``every``: all that it may be, among which these share what is expected beforehand.
    """
    off = sum(one.kind == INSTRUMENT for one in every) or 1
    cost = sum(1.0 / one.cost for one in every if one.kind != INSTRUMENT) or 1.0
    for row, one in enumerate(some):
        if row == 0:
            continue
        known = KNOWN / len(FAMILIES) / cost / one.cost
        prior = INSTRUMENTS / off if one.kind == INSTRUMENT else known
        found = _everywhere(one, -1, row, float(np.log(prior)), evidence)
        # nothing is lost by it: what cannot be drawn was written so; the rest of a position can be drawn
        yield found if "position" in one.told else found._replace(lost=0)


def _everywhere(
    what: Mutation | Variation, board: int, row: int, prior: float, evidence: Evidence
) -> Hypothesis:
    """Return the hypothesis of a row of the evidence, ``prior`` a logarithm."""
    gain, beyond, lost, moved, squares = (part[row] for part in evidence)
    return Hypothesis(
        what,
        board,
        None,
        prior + float(gain.sum()),
        gain,
        int(beyond.sum()),
        int(lost.sum()),
        beyond,
        float(moved.sum()),
        float(squares.sum()),
    )


def _scoped(
    one: Mutation, board: int, row: int, prior: float, evidence: Evidence
) -> Iterator[Hypothesis]:
    gain = evidence.gain[row]
    everywhere = 1.0 - EVERYWHERE if one.family == PREVIOUS else EVERYWHERE
    yield _everywhere(one, board, row, prior + float(np.log(everywhere)), evidence)
    places = np.flatnonzero(gain[:-1])
    if places.size < 2:
        return
    place = int(places[np.argmax(gain[places])])
    single = np.zeros_like(gain)
    single[place] = gain[place]
    one_of = float(np.log((1.0 - everywhere) / places.size))
    far = evidence.beyond[0].copy()
    far[place] = evidence.beyond[row, place]
    score = prior + one_of + float(gain[place])
    fit = float(evidence.moved[row, place]), float(evidence.squares[row, place])
    lost = int(evidence.lost[row, place])
    yield Hypothesis(one, board, place, score, single, int(far.sum()), lost, far, *fit)


def groups(some: Sequence[Hypothesis]) -> list[list[Hypothesis]]:
    """Return hypotheses that no reading tells apart together, the best group first."""
    found: list[list[Hypothesis]] = []
    for one in sorted(some, key=lambda h: -h.score):
        for group in found:
            if same(group[0], one):
                group.append(one)
                break
        else:
            found.append([one])
    return found


def same(one: Hypothesis, other: Hypothesis) -> bool:
    """Whether no reading tells two hypotheses apart."""
    return bool(
        one.beyond == other.beyond
        and one.instrument == other.instrument
        and np.all(np.abs(one.gain - other.gain) <= ALIKE)
    )


def of_written(
    readings: Readings,
    base: AssumedLog,
    wanted: Container[tuple[Key, bool]],
    due: Mapping[tuple[Key, bool], Any] | None = None,
) -> Iterator[Hypothesis]:
    """Yield the hypotheses of a table that was written down otherwise, on a board.

    ``wanted``: readings of which each must change some; ``due``: what tables say by the board, (1,), where that
    is not as it should be.
    """
    table, every = readings.written
    at = np.array([taken.at in wanted for taken in readings.drawing.rows])
    some = [table.same(), *(one for one in every if one.changes(at))]
    yield from of_table(every, some, of_variations(readings, base, some, due or {}))


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
    first = allowed[0]
    if isinstance(first.what, Variation):  # then it was not drawn so everywhere
        allowed = [one for one in allowed if not one.wide or one.beyond < first.beyond]
    return _sure(groups(allowed[:KEPT]), together(allowed, rest.scores))


def slip_alone(one: Hypothesis, rest: Rest) -> bool:
    """Whether a position written amiss explains one reading alone, or badly: that is a slip."""
    if not isinstance(one.what, Variation) or "position" not in one.what.told:
        return False
    return rest.beyond - one.beyond < REPEATED or not one.fits


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
    kept = [one for some in told for one in some]
    rivals = [one for some in [*kinds.values()][MOST:] for one in some]
    if isinstance(kept[0].what, Variation):  # readings are so, whatever drew them so
        rivals = [one for one in rivals if isinstance(one.what, Variation)]
    these = together(kept)
    every = together([*kept, *rivals])
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
    if not isinstance(what := one.what, Mutation):
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
    odd += (
        0.1 if what.formula and what.family == LEFT_OUT else 0.0
    )  # rather as a whole than in part
    odd -= what.usual if what.family == PREVIOUS and one.place is not None else 0.0
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
