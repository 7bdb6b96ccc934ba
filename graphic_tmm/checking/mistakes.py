"""Which mistakes would explain the readings that are wrong: each of the catalogue is run and compared."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.alterations import Figures
from graphic_tmm.checking.catalogue import CATALOGUE, EVERYWHERE, POSITION, READING
from graphic_tmm.checking.cells import Cell, Key, cells
from graphic_tmm.checking.judge import amount, apart, spot_of
from graphic_tmm.checking.records import FINE, WRONG, Judged, Likely
from graphic_tmm.checking.scatter import Scatter
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said
from graphic_tmm.studio import Made

SEGMENT = said("another segment"), said("another segment is measured than the one named")
FACTOR = (
    said("wrong scale or pole distance"),
    said("all figures are {factor} times what is due: the scale or the pole distance is another"),
    said(
        "all figures of {segment} are {factor} times what is due: the scale or the pole distance is another"
    ),
)
BELIED = 0.3
"""What a mistake loses of its score that befalls some of the drawing only."""
LEAST_OFF = 3
"""So many readings off tell a factor."""
LESS = 0.9
"""Of readings that a mistake explains one at least lies nearer to what it leads to than to what is due."""
NOWHERE = complex(np.nan, np.nan)
LEAST = 0.6
"""A mistake has to explain this share of the wrong readings of its plans."""
MOST_LEFT = 0.25
"""A mistake that leaves more than this share of the deviations (of their squares) is not named."""
DIGITS = 0.5
"""A figure that is off a mistake's by this share of it does not show its digits."""


class Explained(NamedTuple):
    """A wrong reading that a mistake explains: its line, the figure it leads to, how well that can be read."""

    line: int
    due: complex
    usual: float


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


def likely(
    made: Made,
    judged: Sequence[Judged],
    spread: Mapping[tuple[Key, bool], Scatter],
    language: str,
) -> tuple[Likely, ...]:
    """Return the mistakes that explain wrong readings, the best first; those that none tells apart together.

    None is named that a fine reading disproves, that leaves too much, or that explains nothing but what a
    better one does.
    """
    wrong = [one for one in judged if one.verdict == WRONG]
    if not wrong:
        return ()
    tried = [
        one for one in _tried(made, judged, spread, language) if one.lines and one.rest <= MOST_LEFT
    ]
    tried.sort(key=lambda one: (-one.score, one.rest, one.name))
    found: list[Likely] = []
    first: list[Tried] = []
    for one in tried:
        if one.score <= 0.0 or len(one.lines) < LEAST * min(len(wrong), 3):
            continue
        same = next((k for k, other in enumerate(first) if _same(other, one)), None)
        if same is None and any(set(one.lines) <= set(other.lines) for other in first):
            continue
        if same is None:
            first.append(one)
            found.append(Likely(one.name, one.says, one.lines, len(wrong), one.rest))
        elif one.name != found[same].name and one.name not in found[same].like:
            found[same] = found[same]._replace(like=(*found[same].like, one.name))
    return tuple(found)


def _same(one: Tried, other: Tried) -> bool:
    """Whether two mistakes explain the same readings by figures that a hand cannot tell apart."""
    return one.lines == other.lines and all(
        abs(a.due - b.due) <= max(a.usual, b.usual)
        for a, b in zip(one.explained, other.explained, strict=True)
    )


def _tried(
    made: Made,
    judged: Sequence[Judged],
    spread: Mapping[tuple[Key, bool], Scatter],
    language: str,
) -> Iterator[Tried]:
    for mistake in CATALOGUE:
        says = speaking(language)(mistake.says)
        best: Tried | None = None
        for figures in mistake.figures(made):
            one = _compared(mistake.name, says, figures, judged, spread, mistake.reach)
            if best is None or (one.score, -one.rest) > (best.score, -best.rest):
                best = one
        if best is not None:
            yield best
    yield from _factor(judged, spread, language)
    yield _other_segments(made, judged, spread, language)


def _compared(
    name: str,
    says: str,
    figures: Figures,
    judged: Sequence[Judged],
    spread: Mapping[tuple[Key, bool], Scatter],
    reach: str = EVERYWHERE,
) -> Tried:
    """Compare all readings with the figures that a mistake leads to.

    Where it may befall some positions or readings only, it is counted where it explains more than it belies.
    """
    groups: dict[tuple[str, ...], _Group] = defaultdict(_Group)
    for one in judged:
        group = groups[_place(one, reach)]
        cell = figures.get(one.taken.key)
        moved, due = (None, NOWHERE) if cell is None else _moved(one, cell)
        limit = spread[one.taken.at]
        unit = _unit(limit, one)
        if one.verdict == WRONG:
            group.whole += (one.deviation / unit) ** 2
        if moved is None:
            group.left += (one.deviation / unit) ** 2 if one.verdict == WRONG else 0.0
            continue
        growth = max(1.0, abs(due) / abs(one.due)) if one.due else 1.0
        room = _room(limit, abs(due), growth)
        if reach == READING:
            room = min(room, DIGITS * abs(due))
        if one.verdict == WRONG:
            group.left += (moved / unit) ** 2
            group.nearer |= moved < LESS * abs(one.deviation)
            if moved <= room:
                group.explained.append(Explained(one.taken.line, due, growth * limit.usual))
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
class _Group:
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


def _unit(limit: Scatter, one: Judged) -> float:
    """Return by what deviations in mm and in all units are made comparable: by where the hand's ends."""
    if np.isfinite(limit.wrong) and limit.wrong > 0.0:
        return limit.wrong
    return 0.03 * abs(one.due) or 1.0


def _place(one: Judged, reach: str) -> tuple[str, ...]:
    if reach == EVERYWHERE:
        return ()
    return (one.taken.position,) if reach == POSITION else one.taken.key


def _moved(one: Judged, cell: Cell) -> tuple[float | None, complex]:
    """Return how far a reading is from a figure, and that figure (of a point: where it stands)."""
    if one.taken.pointed:
        if cell.spot is None:
            return None, NOWHERE
        return abs(spot_of(one.taken) - cell.spot), cell.spot
    due = _due(cell, one)
    if due is None:
        return None, NOWHERE
    return abs(apart(one.found, due)), complex(due)


def _room(limit: Scatter, due: float, growth: float) -> float:
    """Return how far a reading may be from what a mistake leads to: as the hand is, scaled with the figure."""
    if not np.isfinite(limit.wrong):
        return 0.03 * abs(due)
    return 0.7 * limit.wrong * growth


def _due(cell: Cell, one: Judged) -> float | None:
    return cell.mm if one.taken.mm is not None else cell.value


def _factor(
    judged: Sequence[Judged], spread: Mapping[tuple[Key, bool], Scatter], language: str
) -> Iterator[Tried]:
    """One factor between the figures of a plan and their dues, or between those of one of its segments."""
    drawn = [one for one in judged if not one.taken.pointed and one.due]
    wrong = {(one.taken.plan, one.taken.segment) for one in drawn if one.verdict == WRONG}
    groups: dict[tuple[str, ...], list[Judged]] = defaultdict(list)
    for one in drawn:
        segment = (one.taken.plan, one.taken.segment)
        if segment in wrong:
            groups[segment[:1]].append(one)
            groups[segment].append(one)
    for group, rows in groups.items():
        off = [one for one in rows if one.verdict == WRONG]
        if len(off) < LEAST_OFF:
            off = [one for one in rows if one.verdict != FINE]
        factor = float(np.median([one.found / abs(one.due) for one in off]))
        if len(off) < LEAST_OFF or not 0.02 < factor < 50.0 or abs(factor - 1.0) < 0.05:
            continue
        figures = {
            one.taken.key: Cell(abs(one.due) * factor, abs(one.due) * factor, one.unit)
            for one in rows
        }
        told = f"{factor:.4g}".replace(".", decimal_sign(language))
        says = speaking(language)(FACTOR[len(group)], factor=told, segment=group[-1])
        found = _compared(FACTOR[0], says, figures, judged, spread)
        yield found._replace(score=found.score - 0.5)


def _other_segments(
    made: Made,
    judged: Sequence[Judged],
    spread: Mapping[tuple[Key, bool], Scatter],
    language: str,
) -> Tried:
    """Readings that are another segment's of the same plan and position.

    Where one of the wrong readings of a plan and position is no other's, its segments were not mistaken for
    one another.
    """
    by_place: dict[tuple[str, str], list[tuple[str, Cell]]] = defaultdict(list)
    for (plan, segment, position), cell in cells(made).items():
        by_place[plan, position].append((segment, cell))
    groups: dict[tuple[str, str], _Group] = defaultdict(_Group)
    for one in judged:
        if one.verdict != WRONG or one.taken.pointed:
            continue
        place = (one.taken.plan, one.taken.position)
        group, own = groups[place], spread[one.taken.at]
        nearest, other = _nearest(one, by_place[place])
        limit = spread.get(((place[0], other, place[1]), one.taken.in_mm), own)
        unit = _unit(own, one)
        group.whole += (one.deviation / unit) ** 2
        group.left += (min(nearest, abs(one.deviation)) / unit) ** 2
        if nearest <= 0.5 * limit.wrong:
            group.explained.append(Explained(one.taken.line, NOWHERE, 0.0))
        else:
            group.belied += 1
    said = [group for group in groups.values() if not group.belied]
    explained = tuple(reading for group in said for reading in group.explained)
    whole = sum(group.whole for group in groups.values())
    left = sum(group.whole if group.belied else group.left for group in groups.values())
    score = 0.55 * len(explained)  # some segment or other is near by chance
    says = speaking(language)(SEGMENT[1])
    return Tried(SEGMENT[0], says, explained, score, left / whole if whole else 1.0)


def _nearest(one: Judged, others: Sequence[tuple[str, Cell]]) -> tuple[float, str]:
    """Return how far a reading is from the nearest of other segments' figures, and that segment."""
    near = [
        (abs(apart(one.found, amount(cell, one.taken))), segment)
        for segment, cell in others
        if segment != one.taken.segment and _due(cell, one) is not None
    ]
    return min(near, default=(float("inf"), one.taken.segment))
