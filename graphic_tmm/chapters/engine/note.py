"""What follows from an engine's forces: how far the series of two terms is off the motion as drawn."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.engine.table import engine_columns
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, greatest
from graphic_tmm.note.document import Run, Runs, Text

GREATEST = said("The greatest inertia force is {exact} by the plans (position {position}).")
SERIES = said("By the series of two terms it is {series} (position {position}).")


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield the greatest inertia force by the plans and by the series."""
    found = {column.segment: column for column in engine_columns(drawn)}
    for segment, told, key in (("P_in", GREATEST, "exact"), ("P_in_series", SERIES, "series")):
        most = greatest(drawn, found[segment], language) if segment in found else None
        if most is not None:
            put: dict[str, Run] = {key: most[0], "position": Text(most[1])}
            yield filled(speaking(language)(told), put)
