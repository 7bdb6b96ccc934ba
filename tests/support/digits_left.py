"""Digits that are said to be left, beside those that are: the same log run at 50 digits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np

from graphic_tmm.accuracy.hard.walk import Walk
from graphic_tmm.board.execute import execute, needed
from graphic_tmm.board.values import Reals
from graphic_tmm.board.values import given as as_value
from graphic_tmm.mechanism.records import Row
from graphic_tmm.scene.records import Scene, SheetOrder
from support.digits_run import digits_run
from support.figures_judge import SHOWN
from support.loaded import Loaded, order_of

ALL = 17.0
"""Digits of what is right to the last bit."""


class Judged(NamedTuple):
    """``said`` and ``true``: digits of figures that are there. ``drawn``: how many there are at 50 digits of
    those that are said to be missing, ``missing`` all in all; ``gone``: those that are said to be there, and
    are not; ``lost``: of how many no digit is sure.
    ``names``: of each figure its letter and coordinate.
    """

    said: Reals
    true: Reals
    names: list[tuple[str, float]]
    missing: int
    drawn: list[tuple[str, float]]
    lost: int
    gone: list[tuple[str, float]]

    @property
    def away(self) -> Reals:
        """How many digits are given away: said fewer than there are."""
        return self.true - self.said


def scene_of(one: Loaded, phi: float = 30.0) -> Scene:
    """A scene with all plans of a loaded mechanism."""
    order = order_of(one, gravity=True, inertia=True, balance="force")
    row = Row(12, 1, phi, (), ("all",))
    sheets = (SheetOrder("A1", SHOWN),)
    return Scene("random", "random", "en", one.mechanism, row, sheets=sheets).asking(forces=order)


def judged(walk: Walk, every: int = 1) -> Judged:
    """Run the log of a walk at 50 digits, at every so many of its places."""
    log, marks = walk.moving.log, [one.mark for one in walk.results]
    begun = walk.moving.given(walk.row)
    given = {m: as_value(begun[m], m.kind) for m in log.given if m in begun}
    places = range(0, walk.row.size, every)
    due = digits_run(needed(log, marks), given, marks, places)
    drawn = execute(log, given, marks)
    rows = [np.broadcast_to(drawn[mark][0], walk.row.shape) for mark in marks]
    return _compared(walk, due, rows, places)


def _compared(
    walk: Walk, due: Sequence[Sequence[object]], rows: Sequence[Reals], places: Sequence[int]
) -> Judged:
    said, true, names, there, gone = [], [], [], [], []
    for row, k in zip(due, places, strict=True):
        for j, exact in enumerate(row):
            name = (walk.results[j].letter, float(walk.row[k]))
            if walk.missing[j, k]:
                there += [name] if mp.isfinite(exact) else []
            elif not walk.lost[j, k] and not mp.isfinite(exact):
                gone.append(name)
            elif not walk.lost[j, k]:
                off = float(abs(mp.mpmathify(complex(rows[j][k])) - exact))
                # what is nothing, and is drawn as nothing, has no size to count against
                off = off / walk.sizes[j, k] if off else 0.0
                said.append(walk.digits[j, k])
                true.append(-np.log10(max(off, 10.0**-ALL)) if np.isfinite(off) else -np.inf)
                names.append(name)
    at = list(places)
    missing, lost = (int(mask[:, at].sum()) for mask in (walk.missing, walk.lost))
    return Judged(np.array(said), np.array(true), names, missing, there, lost, gone)
