"""Settings worth having: those that no other setting beats in both cost and error."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray


def front(costs: Sequence[float], errors: Sequence[float]) -> tuple[int, ...]:
    """Return the indices of the settings on the Pareto front, from the cheapest to the most exact.

    A setting stands on it if no other costs as little and errs as little, one of the two less; of equal ones
    the first stands for all. A cost or an error that is not finite keeps a setting out.
    """
    cost, error = _alike(costs, errors)
    there = np.flatnonzero(np.isfinite(cost) & np.isfinite(error))
    order = there[np.lexsort((there, error[there], cost[there]))]
    found, best = [], np.inf
    for index in order:
        if error[index] < best:
            found.append(int(index))
            best = error[index]
    return tuple(found)


def cheapest(costs: Sequence[float], errors: ArrayLike, budget: ArrayLike) -> int | None:
    """Return the index of the cheapest setting that keeps within the budget; None if none does.

    Parameters
    ----------
    costs
        The cost of each setting.
    errors
        The error of each setting, (setting,), or of each quantity there, (setting, quantity).
    budget
        The largest error allowed, in the same unit: one number, or one for each quantity.

    Of settings that cost the same the one with the smaller largest error is taken, then the first. A setting
    with an error that is not a number keeps within no budget.
    """
    cost, error = _alike(costs, errors)
    error = error.reshape(cost.size, -1) if cost.size else np.empty((0, 1))
    within = np.all(error <= np.asarray(budget, dtype=np.float64), axis=1) & np.isfinite(cost)
    if not within.any():
        return None
    there = np.flatnonzero(within)
    largest = error[there].max(axis=1, initial=0.0)
    return int(there[np.lexsort((there, largest, cost[there]))[0]])


def _alike(
    costs: Sequence[float], errors: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    cost, error = np.asarray(costs, dtype=np.float64), np.asarray(errors, dtype=np.float64)
    if cost.shape != error.shape[:1]:
        raise ValueError(f"{cost.size} costs, but errors of {error.shape[:1]} settings")
    return cost, error
