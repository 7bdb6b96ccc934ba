"""The columns of instantaneous centres: distances, velocities by them; their plan in protocols."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Length, Reals
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.columns import Column, Tabled, empty, row_of
from graphic_tmm.readers.protocol import Protocols


def columns(drawn: Drawn) -> Iterator[Column]:
    """Yield what is told in the positions asked for."""
    made = CENTRES_PLAN.of(drawn)
    if made is not None:
        yield from columns_at(drawn, made.places)


def columns_at(drawn: Drawn, places: Sequence[int]) -> Iterator[Column]:
    """Yield the distances that are measured, then ratios, ω and v, in some positions (indices)."""
    made = CENTRES_PLAN.on(drawn)
    count, known = len(drawn.names), set[str]()
    for step in drawn.construction.steps:
        if step.it.view == CENTRES and step.it.kind is Length and step.op.reads:
            mm, value = (_row(drawn, step.it, by, places) for by in (None, made.mu))
            segment = segment_name(step.it.letter)
            if segment not in known:
                known.add(segment)
                yield Column(CENTRES, segment, step.it.name, "m", np.abs(mm), np.abs(value))
    for name, mark in made.figures:
        row = _row(drawn, mark, None, places)
        yield Column(CENTRES, name, mark.name, mark.unit, empty(count), row)


def _row(drawn: Drawn, mark: Mark, by: Mark | None, places: Sequence[int]) -> Reals:
    """Return figures at some positions, NaN at the others."""
    value = drawn.reading.figure(mark, by)
    whole = np.broadcast_to(value, (len(value), len(drawn.names)))
    return row_of(whole[:, list(places)], places, len(drawn.names))


TABLE = Tabled(columns=columns)
PROTOCOL = Protocols(views=lambda project: {CENTRES: (CENTRES,)})
