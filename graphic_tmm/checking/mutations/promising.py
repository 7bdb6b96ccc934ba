"""Which mutations are worth weighing by everything that was read: others are not likely, whatever it says.

Most of thousands spoil readings of marks that were right; that is seen before any table is calculated with
them.
"""

from __future__ import annotations

from collections.abc import Collection, Container
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.checking.cells import Key
from graphic_tmm.checking.mutations.evidence import Readings
from graphic_tmm.checking.mutations.execution import AssumedLog
from graphic_tmm.checking.mutations.mistakes import Offered

SLACK, LEAST = 20.0, 2.0
"""What tells so much less for (natural logarithm) than for another is not the likeliest any more; what tells
less for anything is chance."""


def promising(
    readings: Readings,
    offered: Offered,
    base: AssumedLog,
    left: Collection[tuple[Key, bool]],
    slots: Container[int] = (),
) -> list[int]:
    """Return the rows of the mutations of a board that may explain readings; the first row, none at all, too.

    ``left``: readings that the base does not explain, of which each must move some; ``slots``: what none may
    change. In tables others may have followed from what was read: a mutation is not held to spoil these.
    """
    rows = [
        0,
        *(int(k) for k in offered.moving(readings.visible(left), signed=readings.signed) if k),
    ]
    rows = [k for k in rows if not any(slot in slots for slot in offered.mutations[k].slots)]
    some = [offered.mutations[k] for k in rows]
    gain = np.zeros((len(rows), readings.places + 1))
    marks = readings.weighed(base, some, None, tables=False)
    if marks is not None:
        gain += marks.evidence.gain
    clear, other = gain.copy(), np.zeros_like(gain)
    ways = readings.ways_of(base)
    by = offered.figures(readings.keys, np.array(rows))
    for one in readings.columns:
        if one.at in by and one.at in ways[0] and not one.beside:
            figures = np.concatenate([_added(by[one.at], way[one.at]) for way in ways])
            likely = one.evidence(figures).likely.max(axis=0)
            gains = likely - likely[0]
            if one.at in left:
                clear[:, one.place] += np.maximum(gains, 0.0)
                other[:, one.place] += np.minimum(gains, 0.0)
            else:
                other[:, one.place] += gains
    best = max(0.0, float(_whole(clear + other).max()))
    worth = _whole(clear + np.maximum(other, 0.0)) > max(LEAST, best - SLACK)
    return [k for k, kept in zip(rows, worth, strict=True) if kept or not k]


def _whole(gain: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return what mutations gain everywhere, or at one position."""
    return np.asarray(np.maximum(gain.sum(axis=1), gain.max(axis=1)))


def _added(figures: Any, base: Any) -> NDArray[Any]:
    """Return what figures come to beside something else amiss, (way, row): moved by as much, or in proportion.

    ``figures``: as they are without it, the first not mutated; ``base``: that one with it.
    """
    more = base + figures - figures[0]
    with np.errstate(all="ignore"):
        times = base * figures / figures[0]
    return np.stack([more, np.where(np.isfinite(times), times, more)])
