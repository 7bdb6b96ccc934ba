"""Small things that add up: readings that are none of them wrong, but together no hand's.

Readings of a position, of a plan in it, of a segment in all positions: each is measured by what the hand is
usually off, and their squares are added; lengths of one plan are also held against one another, for a polygon
that does not close has deviations that never come together by a slip. The same sums of the hand's own drawings
tell how rare that is: as theirs hang together, so do the readings'.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.judging.counted import CountedReading, counted_readings
from graphic_tmm.checking.judging.covariance import tail
from graphic_tmm.checking.judging.taken_marks import step_name
from graphic_tmm.checking.judging.yardstick import Yardstick
from graphic_tmm.checking.records import FINE, UNKNOWN, WRONG, Judged, Likely
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import captions

RARE = 0.005
"""Of honest drawings so many may be told of a group: as many as may be told of a mistake."""
FLOOR = 0.25
"""What is added to the variance of every length, each measured by its size, where lengths are held against
one another: no length is known better than half of what a hand is off by it, whatever others tell of it.
Chosen by eye: with 0.05 to 1 no honest drawing of 120 has a group."""
MOST = 3
"""So many groups are told: further ones tell the same again."""
NAME = said("small errors together")
POSITION, CLOSED, SEGMENT, POINT = "position", "closed", "segment", "point"
SAYS = {
    POSITION: said(
        "position {position}: {count} readings, none of them wrong by itself, are together farther off than a "
        "hand's; look first at {segment}"
    ),
    CLOSED: said(
        "position {position}, {plan}: the lengths, none of them wrong by itself, fit one another worse than a "
        "hand's; look first at {segment}"
    ),
    SEGMENT: said(
        "{plan}: the readings of {segment}, none of them wrong by itself, are together farther off than a "
        "hand's, by {percent} % of what is due on the average"
    ),
    POINT: said(
        "{plan}: point {segment} stands in no position wrongly by itself, but in all of them together farther "
        "off than a hand's"
    ),
}


class Group(NamedTuple):
    """Readings that belong together: of which kind, how likely a hand's are so far off."""

    kind: str
    entries: tuple[CountedReading, ...]
    likely: float

    @property
    def first(self) -> CountedReading:
        """The reading that is the farthest off."""
        return max(self.entries, key=lambda one: abs(one.times))


def groups(made: DrawnScene, judged: Sequence[Judged], by: Yardstick) -> tuple[Likely, ...]:
    """Return what small errors that add up tell: of groups in which no reading is wrong, the rarest first.

    Of honest drawings `RARE` have any.

    Parameters
    ----------
    made
        The scene as the exact hand draws it.
    judged
        The readings of a drawing, judged.
    by
        By what they were judged.
    """
    together: dict[tuple[str, ...], list[CountedReading]] = defaultdict(list)
    for one in counted_readings(made, judged, by):
        taken = one.judged.taken
        if taken.position:
            # what is laid off is off by the ruler alone: it would hide what was drawn wrongly
            if one.step is None or one.judged.taken.pointed or one.step.op.reads:
                together[POSITION, taken.position].append(one)
            together[CLOSED, taken.plan, taken.position].append(one)
        together[SEGMENT, taken.plan, taken.segment].append(one)
    broken = {at for one in judged if one.verdict == WRONG for at in _of(one)}
    whole = [
        Group(at[0], tuple(some), rarity(at[0], some))
        for at, some in together.items()
        if len(some) > 1 and at not in broken
    ]
    rare = [one for one in whole if one.likely * len(whole) <= RARE]
    told: list[Group] = []
    for group in sorted(rare, key=lambda one: (one.likely, one.kind)):
        seen = {one.judged.taken for other in told for one in other.entries}
        if len(told) < MOST and group.first.judged.taken not in seen:
            told.append(group)
    wrong = sum(one.verdict == WRONG for one in judged)
    return tuple(_likely(made, one, one.likely * len(whole), wrong) for one in told)


def _of(one: Judged) -> tuple[tuple[str, ...], ...]:
    taken = one.taken
    return (
        (POSITION, taken.position),
        (CLOSED, taken.plan, taken.position),
        (SEGMENT, taken.plan, taken.segment),
    )


def rarity(kind: str, some: Sequence[CountedReading]) -> float:
    """Return in which share of a hand's drawings readings are together so far off."""
    if kind == CLOSED:
        # only lengths that are drawn together: those of diagrams are found from one another by figures
        some = [one for one in some if one.step is not None and not one.judged.taken.pointed]
    if len(some) < 2:
        return 1.0
    here = np.array([[one.times] for one in some])
    hand = np.array([one.hand for one in some])
    if kind == CLOSED:
        between = np.linalg.inv(np.cov(hand) + FLOOR * np.eye(len(some)))
        mine, its = (np.einsum("it,ij,jt->t", rows, between, rows) for rows in (here, hand))
        return tail(float(mine[0]), its)
    return tail(float(np.sum(here**2)), np.sum(hand * hand, axis=0))


def _likely(made: DrawnScene, group: Group, chance: float, wrong: int) -> Likely:
    """Return a group as a finding: no mistake is named, but where to look."""
    first, language = group.first, made.scene.language
    taken = first.judged.taken
    off = [
        one.judged
        for one in group.entries
        if one.judged.verdict != FINE or abs(one.judged.times) > 1.0
    ]
    kind = POINT if group.kind == SEGMENT and taken.pointed else group.kind
    says = speaking(language)(
        SAYS[kind],
        position=taken.position,
        plan=captions(language)[taken.plan],
        segment=taken.segment,
        count=str(len(group.entries)),
        percent=fixed(_percent(group), 0, language),
    )
    return Likely(
        name=NAME,
        says=says,
        lines=tuple(sorted(one.taken.line for one in off)),
        wrong=wrong,
        rest=1.0,
        kind=UNKNOWN,
        plan=taken.plan if group.kind != POSITION else "",
        segment=taken.segment,
        position=taken.position if group.kind != SEGMENT else "",
        step=step_name(made.mechanism, first.step),
        chance=1.0 - chance,
    )


def _percent(group: Group) -> float:
    """Return by how much readings are off on the average, % of what is due: long ones tell it best."""
    rows = [one.judged for one in group.entries]
    whole = sum(one.due**2 for one in rows)
    return 100.0 * sum(one.deviation * abs(one.due) for one in rows) / whole if whole else 0.0
