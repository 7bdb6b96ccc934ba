"""The columns of all that is measured on a drawing, mm and times the scale of the view."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from graphic_tmm.board.naming import (
    segment_name,
)
from graphic_tmm.board.values import Length
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.language.units import unit_name
from graphic_tmm.readers.columns import (
    Column,
    empty,
    row_of,
)
from graphic_tmm.scene.chapter import MECHANISM, Answer


def measured_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return every length that is measured; one that is the same in all positions stands at the first."""
    found = []
    for step in drawn.construction.steps:
        if step.it.kind is not Length or not step.op.reads:
            continue
        view = drawn.construction.view(step.it.view)
        mu = view.scale if view is not None else None
        mm = drawn.reading.figure(step.it)
        count = mm.shape[1]
        value = drawn.reading.figure(step.it, mu) if mu is not None else empty(count)
        lengths, figures = (row_of(row, range(count), count) for row in (mm, value))
        unit = mu.unit.removesuffix("/mm").strip("()") if mu is not None else ""
        unit = "" if unit == "1" else unit_name(unit, drawn.scene.language)
        at = tuple((name, None) for name in drawn.names[:count])
        segment = segment_name(step.it.letter)
        found.append(Column(step.it.view, segment, step.it.name, unit, lengths, figures, at))
    return tuple(found)


def own_columns(drawn: Drawn) -> Iterable[Column]:
    """Return what was measured on a board of its own; nothing of the mechanism's, which chapters share."""
    return measured_columns(drawn) if drawn.board != MECHANISM else ()


@dataclass(frozen=True)
class Tabled(Answer):
    """What tables tell of a chapter.

    ``columns``: along the positions, if they are not what was measured on a board of its own; ``results``: by
    name; ``facts``: what is told besides, for machines.
    """

    stands: ClassVar[str] = "table.TABLE"
    columns: Callable[[Drawn], Iterable[Column]] = own_columns
    results: Callable[[Drawn], Results] = lambda drawn: {}
    facts: Callable[[Drawn], Mapping[str, Any]] = lambda drawn: {}
