"""Which step of a construction costs most accuracy: the share of the variance that each step has.

The same log is drawn over and over; in each drawing but one step slips, all steps in turn. Slips are small and
independent, so the variances that they leave add up to that of a hand all of whose steps slip.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import hypot, sqrt
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.quantities import Quantity, quantities
from graphic_tmm.board.execute import execute, needed
from graphic_tmm.board.hand import Hand, slip_of
from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Reals
from graphic_tmm.project import Project

EACH = 16
"""How often each step slips alone. A variance is then known to about a third of itself, √(2/15)."""


class Share(NamedTuple):
    """A step and its share of the variance of a quantity, 0 … 1; ``deviation`` in % of the largest."""

    step: Step
    share: float
    deviation: float


def shares(drawing: Project, who: Hand, each: int = EACH) -> Mapping[str, tuple[Share, ...]]:
    """Return, for each quantity of a drawing, the shares of its steps, the largest first.

    ``who``: whose slips; the rounding of the ruler is taken as a slip of its reading. ``each``: how often each
    step slips. Steps that the quantity does not need have no share.
    """
    asked = quantities(drawing)
    steps = needed(drawing.construction, [mark for q in asked for mark in q.marks])
    slipping: dict[str, Step] = {}
    for step in steps:
        slip = slip_of(step.op, *step.it.key)
        if slip is not None and _size(who, slip.kind) > 0.0:
            slipping[slip.key] = step
    if not slipping:
        return {}
    hand = who._replace(
        ruler=None,
        digits=None,
        reading=_size(who, "reading"),
        alone=tuple(slipping),
        trials=each * len(slipping),
        first=0,
    )
    marks = [mark for q in asked for mark in q.marks]
    drawn = execute(drawing.construction, drawing.given, marks, hand=hand)
    exact = execute(drawing.construction, drawing.given, marks)
    found = {}
    for quantity in asked:
        variances = _variances(
            quantity.read(drawn, hand.trials), quantity.read(exact, 1), len(slipping)
        )
        found[quantity.name] = _ranked(drawing, quantity, tuple(slipping.values()), variances)
    return found


def _size(who: Hand, kind: str) -> float:
    """Return the size of a slip; a length read off a ruler is rounded, too."""
    if kind == "digits":
        return 0.0
    if kind == "reading":
        return hypot(who.reading, (who.ruler or 0.0) / sqrt(12.0))
    return float(getattr(who, kind))


def _variances(values: Reals, exact: Reals, steps: int) -> Reals:
    """Return the mean square deviation that each step leaves, in % of the largest; 0 if nothing is read."""
    largest = float(np.max(np.abs(exact), initial=0.0, where=np.isfinite(exact)))
    if largest == 0.0:
        return np.zeros(steps)
    square = (100.0 * (values - exact) / largest) ** 2
    mine = square.reshape(-1, steps, square.shape[1]).transpose(1, 0, 2).reshape(steps, -1)
    there = np.isfinite(mine)
    total = np.sum(mine, axis=1, where=there)
    return np.asarray(total / np.maximum(there.sum(axis=1), 1))


def _ranked(
    drawing: Project, quantity: Quantity, steps: tuple[Step, ...], variances: Reals
) -> tuple[Share, ...]:
    own = {step.it.slot for step in needed(drawing.construction, quantity.marks)}
    rows = [(s, float(v)) for s, v in zip(steps, variances, strict=True) if s.it.slot in own]
    total = sum(variance for _, variance in rows)
    if total == 0.0:
        return ()
    rows.sort(key=lambda row: -row[1])
    return tuple(Share(step, v / total, sqrt(v)) for step, v in rows)
