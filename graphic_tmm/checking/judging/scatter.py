"""How far the drawings of a hand scatter about what is due: the limits of every verdict follow from it.

The drawings are made once, block by block, and keep of the figures only what was read (`Sample`).
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping
from typing import Any, NamedTuple, TypeVar

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.cells import Cell, Key, cells, figures, points, spots, turned_near
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.own_errors import apart, exact
from graphic_tmm.checking.judging.taken_marks import Reader
from graphic_tmm.checking.records import VERDICTS
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.studio import blocks

T = TypeVar("T")


class Sample(NamedTuple):
    """What drawings have: figures (by key, and whether in mm) and points, (trial,), of those that have them.

    ``marks``: the numbers of marks, (trial, position).
    """

    figures: Mapping[tuple[Key, bool], Reals]
    spots: Mapping[Key, Complexes]
    marks: Mapping[Mark, Any]


def sample(
    made: DrawnScene,
    hand: Hand,
    wanted: Mapping[Key, Collection[bool]],
    marks: Collection[Mark] = (),
) -> Sample:
    """Return what the drawings of a hand, so many as its trials, have of what was read.

    Parameters
    ----------
    made
        The scene as the exact hand draws it.
    wanted
        By figure, whether it was read in mm (or as a point), as a quantity, or both.
    marks
        Marks of the mechanism.
    """
    rows: defaultdict[tuple[Key, bool], list[Any]] = defaultdict(list)
    stand: defaultdict[Key, list[Any]] = defaultdict(list)
    drawn: defaultdict[Mark, list[Any]] = defaultdict(list)
    for block in blocks(made, hand):
        where, told = spots(block), {mm: figures(block, in_mm=mm) for mm in (True, False)}
        for key, kinds in wanted.items():
            if key in where:
                stand[key].append(_known(where[key], block.trials))
            for in_mm in kinds:
                if key in told[in_mm]:
                    rows[key, in_mm].append(_known(told[in_mm][key], block.trials))
        for mark in marks:
            assert block.mechanism is not None
            row = exact(block.mechanism, mark)
            drawn[mark].append(np.broadcast_to(row, (block.trials, row.shape[1])))
    return Sample(_whole_sample(rows), _whole_sample(stand), _whole_sample(drawn))


def joined(one: Sample, other: Sample) -> Sample:
    """Return what two samples of the same drawings have."""
    return Sample(
        {**one.figures, **other.figures},
        {**one.spots, **other.spots},
        {**one.marks, **other.marks},
    )


def _whole_sample(blocks: Mapping[T, list[Any]]) -> dict[T, Any]:
    return {name: np.concatenate(rows) for name, rows in blocks.items()}


def _known(row: Any, trials: int) -> Any:
    """Return what is known of a figure in so many trials; of a single number, that all of them are alike."""
    whole = np.broadcast_to(row, trials)
    return whole[np.isfinite(whole)]


NEAR, ABSURD = float(np.log(4.0)), float(np.log(10.0))
"""A figure an order of magnitude off is absurd where no drawing of the hand is off by four times: a decimal
point slips by ten, and a hand that is off by four now and then may once be off by ten. NEAR could be at
least 2 to 6 times, ABSURD 6 to 20."""
READ = 0.8
"""A figure that scatters by this share of the slip of reading, or more, has it in it already: a length that
was calculated scatters by less, one that was measured by the whole slip; and of 20 drawings, the fewest
that there are, a scatter is off by 16 %. With 0.5, 0.65 or 1 one verdict of 2000 changes, with 1.25 ten."""


class Limits(NamedTuple):
    """``doubtful``: the quantile of the hand's deviations; ``wrong``: how many times their root mean square.

    A reading is never wrong within ``beyond`` times the farthest of the hand's own drawings.

    The command has options for the first two. By 0.97 three honest readings of a hundred might be called
    doubtful (2 % are: the README's table); 5 with 1.2 leaves one honest drawing of a thousand with a wrong
    reading.
    """

    doubtful: float = 0.97
    wrong: float = 5.0
    beyond: float = 1.2


LEAST = 2.0
"""Up to so many times what the hand is usually off a reading costs nothing."""
NOTHING = np.empty(0)


class Scatter(NamedTuple):
    """How far the hand's drawings are off a figure: sorted deviations, the limits that follow.

    ``times``: a figure so many times too large or too small (as a logarithm) is not the hand's, though it
    may scatter by more than the figure itself. ``drawn``: the deviations with their signs, drawing by drawing;
    none where some drawings do not have the figure.
    """

    sorted: np.ndarray
    doubtful: float
    wrong: float
    times: float = np.inf
    drawn: np.ndarray = NOTHING

    @property
    def rms(self) -> float:
        """The root mean square of the deviations; 0 of none."""
        return float(np.sqrt(np.mean(self.sorted**2))) if self.sorted.size else 0.0

    def quantile(self, deviation: float) -> float:
        """Return the share of the hand's drawings that are farther off."""
        if not self.sorted.size:
            return 1.0
        below = int(np.searchsorted(self.sorted, deviation, side="left"))
        return float(self.sorted.size - below) / self.sorted.size

    def doubt(self, deviation: float) -> float:
        """Return how near to wrong a deviation is: 0 within twice the root mean square, 1 at the limit."""
        least = LEAST * self.rms
        room = self.wrong - least
        return min(max((deviation - least) / room, 0.0), 1.0) if room > 0.0 else 1.0

    def verdict(self, deviation: float, times: float = 0.0) -> str:
        """Return what a deviation is, of a figure so many times too large or too small (a logarithm)."""
        return VERDICTS[slips.severity(deviation, times, self.doubtful, self.wrong, self.times)]


def scatter(
    made: DrawnScene,
    drawn: Sample,
    by: Reader,
    wanted: Mapping[Key, Iterable[bool]],
    limits: Limits,
) -> dict[tuple[Key, bool], Scatter]:
    """Return how what is read of the hand's drawings scatters, by figure and whether it is in mm."""
    due, stand, none = cells(made), points(made), np.empty(0)
    at = {
        (key, in_mm): limited_figure(
            drawn.figures.get((key, in_mm), none), key, due[key], by, limits, in_mm
        )
        for key, kinds in wanted.items()
        for in_mm in kinds
        if _figure(due.get(key), in_mm) is not None
    }
    for key in wanted:
        if key in stand:
            read = by.pointed(drawn.spots[key][:, None], "|".join(key))
            off = np.abs(read[:, 0] - stand[key])
            at[key, True] = limited(np.sort(off), limits)._replace(drawn=_whole(off, by))
    return at


def limited(deviations: np.ndarray, limits: Limits) -> Scatter:
    """Return the limits that follow from sorted deviations; none from no deviations."""
    if not deviations.size:
        return Scatter(deviations, np.inf, np.inf)
    root = float(np.sqrt(np.mean(deviations**2)))
    # all drawings of a sure hand may be off by the same rounding: what is as far off as they is not doubtful
    doubtful = max(float(np.quantile(deviations, limits.doubtful)), limits.beyond * root)
    wrong = max(limits.wrong * root, limits.beyond * float(deviations[-1]))
    return Scatter(deviations, doubtful, max(wrong, doubtful))


def times_off(found: Reals | float, due: float) -> Reals:
    """Return by how many times figures differ from what is due, as logarithms of their sizes."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(slips.times_off(np.asarray(found, dtype=np.float64), due))


def limited_figure(
    figures: Reals, key: Key, due: Cell, by: Reader, limits: Limits, in_mm: bool
) -> Scatter:
    """Return the limits that follow from what drawings have of a figure, of those that have it."""
    goal = _figure(due, in_mm)
    assert goal is not None
    figures = _read(figures, goal, key, due, by, in_mm)
    if due.direction:
        figures = turned_near(figures, goal)
    off = np.asarray(apart(figures, goal, due.direction))
    found = limited(np.sort(np.abs(off)), limits)._replace(drawn=_whole(off, by))
    near = figures.size > 0 and float(np.max(times_off(figures, goal))) <= NEAR
    return found._replace(times=ABSURD) if near else found


def _whole(deviations: np.ndarray, by: Reader) -> np.ndarray:
    """Return deviations of all drawings; of a figure that some do not have, or that is alike in all, none."""
    return deviations.astype(np.float32) if deviations.size == by.hand.trials else NOTHING


def _read(figures: Reals, goal: float, key: Key, due: Cell, by: Reader, in_mm: bool) -> Reals:
    """Return figures as they are read: no length on paper is known better than the hand reads it."""
    if not due.mm or (not in_mm and not due.value):
        return figures
    mu = 1.0 if in_mm else abs((due.value or 0.0) / due.mm)
    off = apart(figures, goal)
    if not figures.size or np.sqrt(np.mean(off**2)) >= READ * by.hand.reading * mu:
        return figures
    sign = np.where(figures < 0.0, -1.0, 1.0)
    return np.asarray(sign * mu * by.measured(np.abs(figures)[:, None] / mu, "|".join(key))[:, 0])


def _figure(cell: Cell | None, in_mm: bool) -> float | None:
    figure = None if cell is None else cell.mm if in_mm else cell.value
    return figure if figure is not None and math.isfinite(figure) else None
