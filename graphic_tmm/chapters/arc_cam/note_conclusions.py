"""What follows from a cam given by arcs: its stroke, how near chords come to the instant centre, an extreme."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.arc_cam import note_words as words
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN
from graphic_tmm.chapters.arc_cam.table import arc_columns, results
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.note.bricks import filled, greatest, result_number
from graphic_tmm.note.document import Number, Run, Runs, Source, Text
from graphic_tmm.readers.columns import Column


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what a cam given by arcs comes to."""
    if ARC_CAM_PLAN.of(drawn) is None:
        return
    _ = speaking(language)
    yield filled(
        _(words.STROKE), {"stroke": result_number(drawn, results(drawn), "arc_stroke", language)}
    )
    found = {one.segment: one for one in arc_columns(drawn)}
    chords, instant = (found[name].told[1] for name in ("dS", "dS_P"))
    pairs = zip(chords, instant, strict=True)
    apart = [abs(a - b) if a is not None and b is not None else -1.0 for a, b in pairs]
    k = max(range(len(apart)), key=lambda at: (apart[at], -at))
    if apart[k] >= 0.0:
        put: dict[str, Run] = {
            "chords": _cell(drawn, found["dS"], k, language),
            "instant": _cell(drawn, found["dS_P"], k, language),
            "position": Text(drawn.names[k]),
        }
        yield filled(_(words.APART), put)
    sides = [greatest(drawn, found[name], language) for name in ("ddS_K", "ddS_K_after")]
    most = max(filter(None, sides), key=lambda one: abs(one[0].value), default=None)
    if most is not None:
        yield filled(_(words.SHARPEST), {"value": most[0], "position": Text(most[1])})


def _cell(drawn: Drawn, column: Column, k: int, language: str) -> Number:
    """Return the quantity that a column holds in a position."""
    value = column.told[1][k]
    assert value is not None
    source = Source("column", drawn.board, f"{column.plan}/{column.segment}", k, "", 1)
    return Number(number(value, language, 3), column.unit, source, value)
