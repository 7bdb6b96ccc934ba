"""Where the log of a page has what is told of its figures."""

from __future__ import annotations

from typing import Any

import numpy as np

from graphic_tmm.board.record import segment_name
from graphic_tmm.board.values import Length, Number, Point
from graphic_tmm.page.live.log import LiveLog
from graphic_tmm.readers.columns import Column

ALIKE = 1e-12
"""A row is that of a mark if it is off it by no more, as a share of its largest."""


def place_in_log(log: LiveLog, column: Column) -> list[Any]:
    """Return where the log has a column: slot, slot of its scale, 1 where its size counts; [] if nowhere."""
    row, reading = column.value[0], log.found.drawn.reading
    size = float(np.nanmax(np.abs(row), initial=0.0))
    marks = [*log.own, *(step.it for step in log.live)]
    names = {column.segment, column.letter, column.quantity}
    named = [m for m in marks if m.view == column.plan and names & {segment_name(m.letter), m.name}]
    still = np.ptp(row[np.isfinite(row)]) <= ALIKE * size
    for mark in (*named, *(() if still else marks)):
        view = log.found.log.view(mark.view)
        scale = None if view is None or mark.kind is Number else view.scale
        if mark.kind not in (Number, Length, Point) or (mark.kind is not Number and scale is None):
            continue
        value = np.asarray(log.own.get(mark, 0.0)) if mark in log.own else reading[mark]
        value = np.broadcast_to(np.ravel(value), row.shape) * (
            1.0 if scale is None else reading[scale][0]
        )
        for size_alone in (True, False):
            own = np.abs(value) if size_alone else value
            if (
                np.array_equal(np.isfinite(own), np.isfinite(row))
                and not np.nanmax(np.abs(own - row)) > ALIKE * size
            ):
                return [mark.slot, -1 if scale is None else scale.slot, int(size_alone)]
    return []
