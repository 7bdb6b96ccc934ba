"""Which mistakes would explain the readings that are wrong: each of the catalogue is run and compared."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence

import numpy as np

from graphic_tmm.checking.cells import Cell, Key, cells
from graphic_tmm.checking.judging.own_errors import apart
from graphic_tmm.checking.judging.scatter import Scatter
from graphic_tmm.checking.mistakes.alterations import Figures
from graphic_tmm.checking.mistakes.catalogue import CATALOGUE, Mistake
from graphic_tmm.checking.mistakes.comparing import (
    NOWHERE,
    Explained,
    Group,
    Tried,
    compared,
    due_of,
    unit_of,
)
from graphic_tmm.checking.readings.units import due_figure
from graphic_tmm.checking.records import FINE, WRONG, Judged, Likely
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign
from graphic_tmm.language.said import said

SEGMENT = said("another segment"), said("another segment is measured than the one named")
FACTOR = (
    said("wrong scale or pole distance"),
    said("all figures are {factor} times what is due: the scale or the pole distance is another"),
    said(
        "all figures of {segment} are {factor} times what is due: the scale or the pole distance "
        "is another"
    ),
)
LEAST_OFF = 3
"""So many readings off tell a factor: two may have one by chance. With 2 what is named changes in
two of the 36 drawings, with 4 in one."""
FARTHEST, ALIKE = 50.0, 0.05
"""A factor is no scale's or pole distance's beyond so many times, nor so near to 1 that a hand's slips make
it: neighbouring scales are at least 1.25 apart; a decimal point has an entry of its own. Could be at least
20 to 100, and 0.02 to 0.2.
"""
BEHIND = 0.5
"""Less than one reading: of mistakes that explain as many, one of the catalogue goes before a factor, which
can be chosen at will. Could be at least 0.1 to 1.5."""
NEAR, CHANCE = 0.5, 0.55
"""Another segment's figure is near within this share of where the hand's readings become wrong. Some
segment or other is near by chance, so what it explains counts for little more than half. Could be at least
0.25 to 0.7 (with 1 what is named changes in two), and 0.3 to 0.9."""
LEAST = 0.6
"""A mistake has to explain this share of three wrong readings, or of all if there are fewer: two of three,
both of two. Could be at least 0.45 to 0.9."""
MOST_LEFT = 0.25
"""A mistake that leaves more than this share of the deviations (of their squares) is not named: half of
each deviation. Could be at least 0.1 to 0.35; with 0.5 what is named changes in two."""

KEPT = 10_000
"""Of a scene of so many steps times positions at most, what mistakes lead to is kept: some 20 MB."""


class Alternatives:
    """What the mistakes of the catalogue make of a scene's figures: of many drawings it is found once."""

    def __init__(self, made: DrawnScene) -> None:
        self.made = made
        size = sum(len(one.construction.steps) * one.reading.positions for one in made.boards)
        self._kept: dict[str, tuple[Figures, ...]] | None = {} if size <= KEPT else None

    def of(self, mistake: Mistake) -> Iterable[Figures]:
        """Return the figures that a mistake leads to, variant by variant."""
        if self._kept is None:
            return mistake.figures(self.made)
        if mistake.name not in self._kept:
            self._kept[mistake.name] = tuple(mistake.figures(self.made))
        return self._kept[mistake.name]


def likely(
    others: Alternatives,
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
        one
        for one in _tried(others, judged, spread, language)
        if one.lines and one.rest <= MOST_LEFT
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
        abs(a.due - b.due) <= max(a.rms, b.rms)
        for a, b in zip(one.explained, other.explained, strict=True)
    )


def _tried(
    others: Alternatives,
    judged: Sequence[Judged],
    spread: Mapping[tuple[Key, bool], Scatter],
    language: str,
) -> Iterator[Tried]:
    for mistake in CATALOGUE:
        says = speaking(language)(mistake.says)
        best: Tried | None = None
        for figures in others.of(mistake):
            one = compared(mistake.name, says, figures, judged, spread, mistake.reach)
            if best is None or (one.score, -one.rest) > (best.score, -best.rest):
                best = one
        if best is not None:
            yield best
    yield from _factor(judged, spread, language)
    yield _other_segments(others.made, judged, spread, language)


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
        if len(off) < LEAST_OFF or not 1 / FARTHEST < factor < FARTHEST or abs(factor - 1) < ALIKE:
            continue
        figures = {
            one.taken.key: Cell(abs(one.due) * factor, abs(one.due) * factor, one.unit)
            for one in rows
        }
        told = f"{factor:.4g}".replace(".", decimal_sign(language))
        says = speaking(language)(FACTOR[len(group)], factor=told, segment=group[-1])
        found = compared(FACTOR[0], says, figures, judged, spread)
        yield found._replace(score=found.score - BEHIND)


def _other_segments(
    made: DrawnScene,
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
    groups: dict[tuple[str, str], Group] = defaultdict(Group)
    for one in judged:
        if one.verdict != WRONG or one.taken.pointed:
            continue
        place = (one.taken.plan, one.taken.position)
        group, own = groups[place], spread[one.taken.at]
        nearest, other = _nearest(one, by_place[place])
        limit = spread.get(((place[0], other, place[1]), one.taken.in_mm), own)
        unit = unit_of(own, one)
        group.whole += (one.deviation / unit) ** 2
        group.left += (min(nearest, abs(one.deviation)) / unit) ** 2
        if nearest <= NEAR * limit.wrong:
            group.explained.append(Explained(one.taken.line, NOWHERE, 0.0))
        else:
            group.belied += 1
    said = [group for group in groups.values() if not group.belied]
    explained = tuple(reading for group in said for reading in group.explained)
    whole = sum(group.whole for group in groups.values())
    left = sum(group.whole if group.belied else group.left for group in groups.values())
    score = CHANCE * len(explained)
    says = speaking(language)(SEGMENT[1])
    return Tried(SEGMENT[0], says, explained, score, left / whole if whole else 1.0)


def _nearest(one: Judged, others: Sequence[tuple[str, Cell]]) -> tuple[float, str]:
    """Return how far a reading is from the nearest of other segments' figures, and that segment."""
    near = [
        (abs(apart(one.found, due_figure(cell, one.taken))), segment)
        for segment, cell in others
        if segment != one.taken.segment and due_of(cell, one) is not None
    ]
    return min(near, default=(float("inf"), one.taken.segment))
