"""Columns of tables written down by hand."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.values import Reals


def along(*figures: float | None) -> Reals:
    """The figures of one drawing, (1, position); None is NaN."""
    return np.array([[np.nan if figure is None else figure for figure in figures]])
