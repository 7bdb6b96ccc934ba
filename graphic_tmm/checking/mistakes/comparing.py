"""A mistake held against readings: which of the wrong ones it explains, which of the fine ones belie it."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from graphic_tmm.checking.cells import Cell, Key
from graphic_tmm.checking.judging.own_errors import apart
from graphic_tmm.checking.judging.scatter import Scatter
from graphic_tmm.checking.mistakes.alterations import Figures
from graphic_tmm.checking.mistakes.catalogue import EVERYWHERE, POSITION, READING
from graphic_tmm.checking.records import FINE, WRONG, Judged

BELIED = 0.3
"""What a mistake loses of its score that befalls some of the drawing only: less than one reading, so that
it decides between mistakes that explain as many. Could be at least 0.1 to 0.9."""

LESS = 0.9
"""Of readings that a mistake explains one at least lies nearer to what it leads to than to what is due,
by more than rounding. Could be at least 0.6 to 1."""

NOWHERE = complex(math.nan, math.nan)

UNKNOWN = 0.03
"""A figure of which no drawing of the hand is known is taken to be wrong beyond this share of it: about
what real hands keep to in 19 readings of 20 (3.5 % of a plan's longest vector). Could be at least 0.01 to
0.1."""
ROOM = 0.7
"""A reading shows a mistake within this share of where it would be wrong if the mistake were right: beyond
the hand's own scatter, and nearer than a mistake that merely resembles it. Could be at least 0.6 to 1; with
0.5 what is named changes in one."""
DIGITS = 0.5
"""A figure that is off a mistake's by this share of it does not show its digits: what is true of single
readings only (a slipped point, another scale) has to be read off them. Could be at least 0.2 to 0.7; with 1
what is named changes in two."""


class Explained(NamedTuple):
    """A wrong reading that a mistake explains: its line, the figure it leads to, how well that can be read."""

    line: int
    due: complex
    rms: float


class Tried(NamedTuple):
    """A mistake tried: the readings that it explains, what it leaves of the deviations."""

    name: str
    says: str
    explained: tuple[Explained, ...]
    score: float
    rest: float

    @property
    def lines(self) -> tuple[int, ...]:
        """The lines of what it explains."""
        return tuple(one.line for one in self.explained)


def compared(
    name: str,
    says: str,
    figures: Figures,
    judged: Sequence[Judged],
    spread: Mapping[tuple[Key, bool], Scatter],
    reach: str = EVERYWHERE,
) -> Tried:
    """Compare all readings with the figures that a mistake leads to.

    Where it may befall some positions or readings only, it is counted where it explains more than it
    belies.
    """
    groups: dict[tuple[str, ...], Group] = defaultdict(Group)
    for one in judged:
        group = groups[_place(one, reach)]
        cell = figures.get(one.taken.key)
        moved, due = (None, NOWHERE) if cell is None else _moved(one, cell)
        limit = spread[one.taken.at]
        wrong = one.verdict == WRONG
        unit = unit_of(limit, one) if wrong else 1.0
        if wrong:
            group.whole += (one.deviation / unit) ** 2
        if moved is None:
            group.left += (one.deviation / unit) ** 2 if wrong else 0.0
            continue
        growth = max(1.0, abs(due) / abs(one.due)) if one.due else 1.0
        room = _room(limit, abs(due), growth)
        if reach == READING:
            room = min(room, DIGITS * abs(due))
        if wrong:
            group.left += (moved / unit) ** 2
            group.nearer |= moved < LESS * abs(one.deviation)
            if moved <= room:
                group.explained.append(Explained(one.taken.line, due, growth * limit.rms))
        elif _disproves(one) and moved > max(limit.wrong, room):
            group.belied += 1
    said = [group for group in groups.values() if group.said]
    explained = [reading for group in said for reading in group.explained]
    score = float(sum(len(group.explained) - group.belied for group in said))
    if any(group.belied or (group.whole and not group.explained) for group in groups.values()):
        score -= BELIED
    whole = sum(group.whole for group in groups.values())
    left = sum(group.left if group in said else group.whole for group in groups.values())
    return Tried(name, says, tuple(explained), score, left / whole if whole else 1.0)


@dataclass
class Group:
    """Readings that a mistake befalls together: those explained, how many fine ones belied, squares left."""

    explained: list[Explained] = field(default_factory=list)
    belied: int = 0
    left: float = 0.0
    whole: float = 0.0
    nearer: bool = False

    @property
    def said(self) -> bool:
        """Whether the mistake befell them: it explains some, brings some nearer; no fine one disproves it."""
        return self.nearer and bool(self.explained) and not self.belied


def _disproves(one: Judged) -> bool:
    """Whether a reading can disprove a mistake: a fine one, not merely for what it was found from."""
    return one.verdict == FINE and one.follows is None


def unit_of(limit: Scatter, one: Judged) -> float:
    """Return by what deviations in mm and in all units are made comparable: by where the hand's ends."""
    if math.isfinite(limit.wrong) and limit.wrong > 0.0:
        return limit.wrong
    return UNKNOWN * abs(one.due) or 1.0


def _place(one: Judged, reach: str) -> tuple[str, ...]:
    if reach == EVERYWHERE:
        return ()
    return (one.taken.position,) if reach == POSITION else one.taken.key


def _moved(one: Judged, cell: Cell) -> tuple[float | None, complex]:
    """Return how far a reading is from a figure, and that figure (of a point: where it stands)."""
    if one.taken.pointed:
        if cell.spot is None:
            return None, NOWHERE
        return abs(one.taken.spot - cell.spot), cell.spot
    due = due_of(cell, one)
    if due is None:
        return None, NOWHERE
    return abs(apart(one.found, due)), complex(due)


def _room(limit: Scatter, due: float, growth: float) -> float:
    """Return how far a reading may be from what a mistake leads to: as the hand is, scaled with the figure."""
    if not math.isfinite(limit.wrong):
        return UNKNOWN * abs(due)
    return ROOM * limit.wrong * growth


def due_of(cell: Cell, one: Judged) -> float | None:
    """Return the figure that a reading is compared with; None where there is none of its kind."""
    return cell.mm if one.taken.mm is not None else cell.value
