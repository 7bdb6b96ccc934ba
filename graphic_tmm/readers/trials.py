"""The figures of many drawings by one hand as arrays: columns (trial, position), results (trial,)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.drawn import DrawnScene, Results, hand_of
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.studio import blocks


def trial_figures(made: DrawnScene, trials: int) -> tuple[list[Column], Results]:
    """Return the columns and the results of a drawing, or of as many as the scene's hand makes.

    ``mm``, ``value`` of a column: (trial, position), results (trial,); one trial where all drawings are alike,
    NaN where one of them has none. All of them are kept: what a table tells of many needs less, see `spread`.
    """
    if trials == 1:
        return scene_columns(made), scene_results(made)
    columns, results = [], []
    for one in blocks(made, hand_of(made.scene, trials)):
        columns.append((one.trials, scene_columns(one)))
        results.append((one.trials, scene_results(one)))
        del one  # lest it be held while the next is drawn
    return joined_columns(columns), joined_results(results)


def joined_columns(blocks: Sequence[tuple[int, Sequence[Column]]]) -> list[Column]:
    """Return the columns of blocks of drawings, each of so many trials, as those of all of them."""
    trials = [n for n, _ in blocks]
    found = []
    for first, *others in zip(*(columns for _, columns in blocks), strict=True):
        same = first, *(column.placed_as(first) for column in others)
        mm, value = (
            _joined(rows, trials) for rows in zip(*((c.mm, c.value) for c in same), strict=True)
        )
        found.append(replace(first, mm=mm, value=value))
    return found


def joined_results(blocks: Sequence[tuple[int, Results]]) -> Results:
    """Return the results of blocks of drawings, each of so many trials, as those of all of them."""
    trials, nothing = [n for n, _ in blocks], np.full(1, np.nan)
    units = {name: unit for _, some in blocks for name, (_, unit) in some.items()}
    rows = {name: [some.get(name, (nothing,))[0] for _, some in blocks] for name in units}
    return {name: (_joined(rows[name], trials), unit) for name, unit in units.items()}


def _joined(blocks: Sequence[Reals], trials: Sequence[int]) -> Reals:
    """Return rows of blocks one below the other; a single one where nothing varies."""
    first = blocks[0]
    if len(first) == 1 and all(np.array_equal(rows, first, equal_nan=True) for rows in blocks):
        return first
    pairs = zip(blocks, trials, strict=True)
    return np.concatenate([np.broadcast_to(rows, (n, *rows.shape[1:])) for rows, n in pairs])
