"""What follows from an engine's forces: how far the series is off the motion, whether T does the gas's work."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.chapters.engine.beside import WORKS
from graphic_tmm.chapters.engine.table import engine_columns, engine_results
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import filled, greatest, result_number
from graphic_tmm.note.document import Run, Runs, Text

GREATEST = said("The greatest inertia force is {exact} by the plans (position {position}).")
SERIES = said("By the series of two terms it is {series} (position {position}).")

EQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "so they are equal but for what the graphs can show."
)
UNEQUAL = said(
    "Over a turn the tangential force does the work {work_T}, the gas {work_P}: they differ by {work_apart}, "
    "more than the graphs explain."
)
CLOSE = 5.0
"""Works that differ by no more than this, %, agree: graphs with twelve positions are no better."""


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield the greatest inertia force by the plans and by the series, and the works over a turn."""
    found = {column.segment: column for column in engine_columns(drawn)}
    for segment, told, key in (("P_in", GREATEST, "exact"), ("P_in_series", SERIES, "series")):
        most = greatest(drawn, found[segment], language) if segment in found else None
        if most is not None:
            put: dict[str, Run] = {key: most[0], "position": Text(most[1])}
            yield filled(speaking(language)(told), put)
    yield from _works(drawn, language)


def _works(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield whether the tangential force does the work of the gas over a turn."""
    results = engine_results(drawn)
    values = [value for name, (value, _) in single(results).items() if name in WORKS]
    if len(values) == len(WORKS) and all(map(math.isfinite, values)):
        told = EQUAL if abs(values[-1]) <= CLOSE else UNEQUAL
        put: dict[str, Run] = {
            name: result_number(drawn, results, name, language) for name in WORKS
        }
        yield filled(speaking(language)(told), put)
