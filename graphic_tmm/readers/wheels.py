"""The columns of gears and trains: what is measured on their drawings, mm and times the scale of the view."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction
from graphic_tmm.board.values import Length
from graphic_tmm.readers.columns import Column, row_of, segment_name


class Drawn(Protocol):
    """A part as drawn."""

    @property
    def construction(self) -> Construction:
        """Its log."""

    @property
    def reading(self) -> Reading:
        """Its numbers."""

    @property
    def names(self) -> tuple[str, ...]:
        """The numbers of its positions."""


def wheel_columns(part: Drawn) -> tuple[Column, ...]:
    """Return every length that is measured; one that is the same in all positions stands at the first."""
    found = []
    for step in part.construction.steps:
        if step.it.kind is not Length or not step.op.reads:
            continue
        view = part.construction.view(step.it.view)
        mu = view.scale if view is not None else None
        mm = part.reading.figure(step.it)
        count = mm.shape[1]
        value = part.reading.figure(step.it, mu) if mu is not None else np.full_like(mm, np.nan)
        lengths, figures = (row_of(row, range(count), count) for row in (mm, value))
        unit = mu.unit.removesuffix("/mm").strip("()") if mu is not None else ""
        unit = "" if unit == "1" else unit
        at = tuple((name, None) for name in part.names[:count])
        segment = segment_name(step.it.letter)
        found.append(Column(step.it.view, segment, step.it.name, unit, lengths, figures, at))
    return tuple(found)
