"""What a sheet shows of a synthesis: the construction, the lengths measured and calculated."""

from __future__ import annotations

from graphic_tmm.chapters.linkage_synthesis.ink import draw_synthesis
from graphic_tmm.chapters.linkage_synthesis.plan import SYNTHESIS_PLAN
from graphic_tmm.chapters.linkage_synthesis.record import CALCULATED
from graphic_tmm.chapters.linkage_synthesis.task import SYNTHESIS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.ruled import ruled_table
from graphic_tmm.readers.task_sheet import given_views
from graphic_tmm.scene.captions import captions

PLACES = {"mm": 1, "in": 3}
"""Decimals of lengths: of those read off, as exact as a ruler shows them; one more where calculated."""


def synthesis_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the construction and the table of lengths; none where a scene asks for none."""
    made = SYNTHESIS_PLAN.of(drawn)
    if made is None:
        return []
    language = drawn.scene.language
    on = subject(drawn, captions(language)[SYNTHESIS], SYNTHESIS)
    scale = f"μ_l = {number(drawn.value(made.mu), language)} {unit('m/mm', language)}"
    return [
        with_caption(draw_synthesis(on, made, drawn.names), on, lettered, scale),
        _lengths(drawn),
    ]


def _lengths(drawn: Drawn) -> Drawing:
    made, calculated, language = (
        SYNTHESIS_PLAN.on(drawn),
        CALCULATED.on(drawn),
        drawn.scene.language,
    )
    words, high, rows = captions(language), heights(drawn.scene, SYNTHESIS), []
    for name, mark in calculated.items():
        value, of = small(drawn.value(mark), language)
        places = PLACES.get(of, 4)
        read = made.measured.get(name)
        shown = (
            "—" if read is None else fixed(small(drawn.value(read), language)[0], places, language)
        )
        figure = fixed(value, places + 1, language)
        if name == "departure":
            name, figure = "Δ", number(value, language)
        rows.append([name, shown, figure, unit(of, language)])
    for angle in made.transmission:
        rows.append([angle.letter, fixed(drawn.value(angle), 1, language), "—", "°"])
    heads = ["value", "synthesis by drawing", "synthesis by calculation", "unit"]
    return ruled_table(
        "table-synthesis", words["synthesis lengths"], [words[head] for head in heads], rows,
        size=high.number, title_size=high.title, align=["left", "centre", "centre", "left"],
    )  # fmt: skip


def _given(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of what is given; with a mechanism that is in its table."""
    (draw,) = given_views(SYNTHESIS).values()
    return draw(drawn, lettered) if drawn.scene.mechanism is None else []


SHOWN = Views(draw={SYNTHESIS: synthesis_views, f"{SYNTHESIS} given": _given})
