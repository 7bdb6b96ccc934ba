"""How far the drawings of a hand scatter about what is due: the limits of every verdict follow from it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import Hand
from graphic_tmm.checking.cells import Key, cells, points
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG
from graphic_tmm.studio import Made, drawings


class Limits(NamedTuple):
    """``doubtful``: the quantile of the hand's deviations; ``wrong``: how many times their root mean square.

    A reading is never wrong within ``beyond`` times the farthest of the hand's own drawings.
    """

    doubtful: float = 0.97
    wrong: float = 5.0
    beyond: float = 1.2


class Scatter(NamedTuple):
    """How far the hand's drawings are off a figure: sorted deviations, the limits that follow."""

    sorted: np.ndarray
    doubtful: float
    wrong: float

    @property
    def usual(self) -> float:
        """The root mean square of the deviations; 0 of none."""
        return float(np.sqrt(np.mean(self.sorted**2))) if self.sorted.size else 0.0

    def quantile(self, deviation: float) -> float:
        """Return the share of the hand's drawings that are farther off."""
        if not self.sorted.size:
            return 1.0
        below = int(np.searchsorted(self.sorted, deviation, side="left"))
        return float(self.sorted.size - below) / self.sorted.size

    def verdict(self, deviation: float) -> str:
        """Return what a deviation is."""
        if deviation > self.wrong:
            return WRONG
        return DOUBTFUL if deviation > self.doubtful else FINE


def scatter(
    made: Made, hand: Hand, wanted: Mapping[Key, Iterable[bool]], limits: Limits
) -> dict[tuple[Key, bool], Scatter]:
    """Return how the hand's drawings scatter, by figure and whether it is in mm."""
    due = cells(made)
    spots = points(made)
    rows: dict[tuple[Key, bool], list[float]] = {
        (key, in_mm): [] for key, kinds in wanted.items() for in_mm in kinds if key in due
    }
    placed: dict[Key, list[float]] = {key: [] for key in wanted if key not in due}
    for drawn in drawings(made, hand):
        where = points(drawn) if placed else {}
        for key, deviations in placed.items():
            if key in where:
                deviations.append(abs(where[key] - spots[key]))
        found = cells(drawn) if rows else {}
        for (key, in_mm), deviations in rows.items():
            one = found.get(key)
            figure = None if one is None else (one.mm if in_mm else one.value)
            goal = due[key].mm if in_mm else due[key].value
            if figure is not None and goal is not None:
                deviations.append(abs(abs(figure) - abs(goal)))
    every = rows | {(key, True): deviations for key, deviations in placed.items()}
    return {at: limited(np.sort(np.array(d)), limits) for at, d in every.items()}


def limited(deviations: np.ndarray, limits: Limits) -> Scatter:
    """Return the limits that follow from sorted deviations; none from no deviations."""
    if not deviations.size:
        return Scatter(deviations, np.inf, np.inf)
    root = float(np.sqrt(np.mean(deviations**2)))
    doubtful = float(np.quantile(deviations, limits.doubtful))
    wrong = max(limits.wrong * root, limits.beyond * float(deviations[-1]))
    return Scatter(deviations, doubtful, max(wrong, doubtful))
