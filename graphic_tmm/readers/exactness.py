"""How far a drawing read with a ruler is off the same drawing without error: plan by plan, results too."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.hand import EXACT
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.table import columns_of, results_of

EVEN = 1e-11
"""Results that differ by less of their own size differ by rounding only."""


class Deviation(NamedTuple):
    """The largest deviation of a plan, % of its largest figure of the same kind: where it stands.

    ``segment``: of a column, or the name of a result; ``place``: the index of a position.
    """

    plan: str
    segment: str
    place: int
    percent: float


def deviations(drawn: Drawn) -> tuple[Deviation, ...]:
    """Return the largest deviation of each plan from the exact hand's; none for a drawing by that hand.

    Figures of one plan and one unit are of one kind: a small one is held against the largest of them.
    """
    if drawn.hand == EXACT:
        return ()
    exact = drawn.drawn_by(EXACT)
    kinds: dict[tuple[str, str], list[tuple[Column, Column]]] = {}
    for told, due in zip(columns_of(drawn), columns_of(exact), strict=True):
        if told.unit != "%":
            kinds.setdefault((told.plan, told.unit), []).append((told, due))
    found = [one for pairs in kinds.values() for one in _of_kind(pairs)]
    worst: dict[str, Deviation] = {}
    for one in found:
        if one.plan not in worst or one.percent > worst[one.plan].percent:
            worst[one.plan] = one
    return (*worst.values(), *_results(drawn, exact))


def _of_kind(pairs: Sequence[tuple[Column, Column]]) -> Iterator[Deviation]:
    """Yield the largest deviation of each column of a kind, % of the largest due of all of them."""
    largest = max((_largest(due.value[0]) for _, due in pairs), default=0.0)
    for told, due in pairs:
        apart = np.abs(told.value[0] - due.value[0])
        if largest > 0.0 and np.isfinite(apart).any():
            k = int(np.nanargmax(apart))
            yield Deviation(told.plan, told.segment, k, 100.0 * float(apart[k]) / largest)


def _largest(row: np.ndarray) -> float:
    there = np.abs(row[np.isfinite(row)])
    return float(there.max()) if there.size else 0.0


def _results(drawn: Drawn, exact: Drawn) -> list[Deviation]:
    """Return how far the results are off, those that are not the same."""
    due, found = results_of(exact), []
    for name, (figures, unit) in results_of(drawn).items():
        told, right = float(figures[0]), float(due[name][0][0])
        if (
            unit != "%"
            and right
            and np.isfinite(told)
            and not math.isclose(told, right, rel_tol=EVEN)
        ):
            found.append(Deviation("", name, 0, 100.0 * abs(told - right) / abs(right)))
    return found
