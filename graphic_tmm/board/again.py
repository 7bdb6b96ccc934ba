"""A log that is run again, at other positions: what is known of it already, what follows from that."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import places


def kept(
    log: Construction, given: Mapping[Mark, object], drawn: Mapping[int, Any]
) -> dict[Mark, Any]:
    """Return what is given that does not vary, and what is drawn across positions, once for all of them.

    ``drawn``: by slot the numbers of the log, as it was executed at the positions of its row.
    """
    known: dict[Mark, Any] = {
        mark: value
        for mark, value in given.items()
        if not (isinstance(value, np.ndarray) and value.ndim == 2 and value.shape[1] > 1)
    }
    across = [step.it for step in log.steps if step.op.across and step.it.slot in drawn]
    return known | {mark: drawn[mark.slot] for mark in across if places(drawn[mark.slot]) == 1}


def again(log: Construction, known: Collection[Mark]) -> Construction:
    """Return the log of what follows, position by position, from what is known, and from nothing else."""
    there, steps = set(known), []
    for step in log.steps:
        if step.it in known:
            continue
        if not step.op.across and there.issuperset(step.uses):
            there.add(step.it)
            steps.append(step)
    begun = tuple(mark for mark in (*log.given, *(s.it for s in log.steps)) if mark in known)
    return log._replace(given=begun, steps=tuple(steps))
