"""What is told of a figure that moves, along the positions of the sheet and at all angles."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.page.strands import Moving
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.rounding import Figures, rounded_figures


def figure_columns(moving: Moving, own: Moving) -> Iterator[tuple[Column, Column, Figures]]:
    """Yield what is told of a figure: its column on the sheet, at all angles, its figures there."""
    at_angles = {(c.plan, c.segment): c for c in moving.columns()}
    on_sheet = list(own.columns())
    for column, figures in zip(on_sheet, rounded_figures(on_sheet), strict=True):
        dense_ = at_angles.get((column.plan, column.segment))
        if dense_ is not None and np.isfinite(dense_.value).any():
            yield column, dense_, figures
