"""What follows from kinematic diagrams: how near the chords come to the plans, whether an integral closes."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.diagrams.plan import DIAGRAMS
from graphic_tmm.chapters.diagrams.table import diagram_columns
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, greatest
from graphic_tmm.note.document import Run, Runs, Symbol, Text
from graphic_tmm.note.steps import Told

APART = said(
    "The diagram of {symbol} differs from the plans by {apart} at most (position {position})."
)
CLOSED = said("After a turn the integrated diagram of S ends at {end}: it should end at 0.")


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield how far each diagram is off the plans, and how far an integral is from closing."""
    made, _ = DIAGRAMS.of(drawn), speaking(language)
    if made is None:
        return
    for column in diagram_columns(drawn):
        symbol, _sign, kind = column.segment.partition("_")
        found = greatest(drawn, column, language) if kind == "difference" else None
        if found is not None:
            apart, position = found
            put: dict[str, Run] = {
                "symbol": Symbol(symbol),
                "apart": apart,
                "position": Text(position),
            }
            yield filled(_(APART), put)
    end = made.charts["S"].end if "S" in made.charts else None
    if end is not None:
        view = made.charts["S"].view
        told = Told(drawn.board, drawn.construction, drawn.reading, view, 0, language)
        yield filled(_(CLOSED), {"end": told.number(end, unit=True)})
