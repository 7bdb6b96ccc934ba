"""What follows from kinematic diagrams: how near they come to the plans, extremes, the end of an integral."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.diagrams import note_words as words
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.table import diagram_columns
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.note.bricks import filled, greatest
from graphic_tmm.note.document import Run, Runs, Symbol, Text
from graphic_tmm.note.steps import Told


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield how far what was found is off the plans, and how far an integral is from closing."""
    made, _ = DIAGRAMS_PLAN.of(drawn), speaking(language)
    if made is None:
        return
    for column in diagram_columns(drawn):
        symbol, _sign, kind = column.segment.partition("_")
        if kind not in ("", "difference") or symbol == made.first:
            continue
        found = greatest(drawn, column, language)
        if found is not None and not kind:
            yield filled(_(words.EXTREME[symbol]), {"value": found[0], "position": Text(found[1])})
        elif found is not None:
            apart, position = found
            put: dict[str, Run] = {
                "symbol": Symbol(symbol),
                "apart": apart,
                "position": Text(position),
            }
            yield filled(_(words.APART), put)
    end = made.charts["S"].end if "S" in made.charts else None
    if end is not None:
        view = made.charts["S"].view
        told = Told(drawn.board, drawn.construction, drawn.reading, view, 0, language)
        yield filled(_(words.CLOSED), {"end": told.number(end, unit=True)})
