"""Hypotheses: the hand, an instrument, a mistake of a family, a table written down amiss, the unknown."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.mutations.evidence import Readings, of_variations
from graphic_tmm.checking.mutations.execution import AssumedLog
from graphic_tmm.checking.mutations.likelihood import Evidence
from graphic_tmm.checking.mutations.mutation import FAMILIES, PREVIOUS, Mutation
from graphic_tmm.checking.mutations.tables import ReadingTable, Variation, copied, variations
from graphic_tmm.checking.records import INSTRUMENT, Taken

Array = NDArray[np.float64]
NO_MISTAKE, SOMETHING, INSTRUMENTS, KNOWN = 0.6, 0.1, 0.05, 0.25
"""What is expected beforehand: most drawings hold no mistake; of the others the known ones are most."""
A_NUMBER = 0.01
"""So rarely is a segment so many times what is due by a number that no mistake that we know makes."""
EVERYWHERE = 0.75
"""A mistake is made wherever it can be in three of four drawings, else in one position; what is taken from the
position before rather once."""
FITTED = 4.5
"""What a free number costs that is found from the readings: it may be any of some hundred (logarithm)."""
UNEXPLAINED = 0.03
"""No name is given that leaves a larger share of the readings beyond what a hand does."""
THOUSANDTH = 3.09
"""Of a normal distribution one of a thousand is farther off, standard deviations."""
ALIKE = 0.5
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


def of_table(some: Sequence[Variation], evidence: Evidence) -> Iterator[Hypothesis]:
    """Yield the hypotheses that a table written down otherwise makes; the first row is the base."""
    off = sum(one.kind == INSTRUMENT for one in some) or 1
    cost = sum(1.0 / one.cost for one in some[1:] if one.kind != INSTRUMENT) or 1.0
    for row, one in enumerate(some):
        if row == 0:
            continue
        known = KNOWN / len(FAMILIES) / cost / one.cost
        prior = INSTRUMENTS / off if one.kind == INSTRUMENT else known
        # nothing is lost by it: what cannot be drawn was written down so
        yield _everywhere(one, -1, row, float(np.log(prior)), evidence)._replace(lost=0)


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


FAR = 3.0, 0.01
"""Two readings are told apart if they should differ by so many deviations, and by such a share."""


def of_written(
    readings: Readings, base: AssumedLog, due: Mapping[tuple[Key, bool], Any] | None = None
) -> Iterator[Hypothesis]:
    """Yield the hypotheses of a table that was written down otherwise, on a board.

    ``due``: what tables say by the board, (1,), where that is not as it should be.
    """
    drawing = readings.drawing
    positions = drawing.names or tuple(dict.fromkeys(t.position for t in drawing.rows))
    table = ReadingTable(drawing.rows, positions)

    def off(k: int) -> complex:
        taken = drawing.rows[k]
        return taken.spot - drawing.spots.get(taken.key, taken.spot)

    def apart(k: int, j: int) -> bool:
        one, other = drawing.rows[k], drawing.rows[j]
        if one.pointed:
            return abs(drawing.spots[one.key] - drawing.spots[other.key]) > 1.0
        here, there = (_due(drawing, taken) for taken in (one, other))
        scatters, share = FAR
        return abs(here - there) > scatters * drawing.by.spread[one.at].rms + share * abs(here)

    scales = {
        one.symbol: one.value for board in drawing.made.boards for one in board.scales.values()
    }
    varied = variations(table, drawing.scale, off, scales, apart)
    some = [table.same(), *varied, *copied(table, apart)]
    yield from of_table(some, of_variations(readings, base, some, due or {}))


def _due(drawing: Comparison, taken: Taken) -> float:
    cell = drawing.due[taken.key]
    return float((cell.mm if taken.mm is not None else cell.value) or 0.0)
