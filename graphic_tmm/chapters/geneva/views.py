"""What a sheet shows of a Geneva wheel: the wheel at the entry of the pin, its results."""

from __future__ import annotations

from graphic_tmm.chapters.geneva.ink import draw_wheel
from graphic_tmm.chapters.geneva.plan import GENEVA_PLAN
from graphic_tmm.chapters.geneva.table import results as figures
from graphic_tmm.chapters.geneva.task import GENEVA
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import small, unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.readers.result_table import results
from graphic_tmm.scene.captions import captions

DIGITS = {"mm": 1, "in": 3, "°": 1}
"""Decimals by unit: as exact as a ruler and a protractor show them; other figures have four."""


def wheel_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the wheel and its results; none where a scene asks for none."""
    wheel = GENEVA_PLAN.of(drawn)
    if wheel is None:
        return []
    language = drawn.scene.language
    words = captions(language)
    on = subject(drawn, words[GENEVA], GENEVA)
    mu = drawn.value(wheel.mu)
    scale = f"μ_l = {number(mu, language)} {unit('m/mm', language)}"
    rows = []
    for name, (value, of) in single(figures(drawn)).items():
        size, shown = small(value, language) if of == "m" else (value, of)
        figure = fixed(size, DIGITS.get(shown, 4), language)
        rows.append([words[name], figure, unit(shown, language) if shown else "—"])
    high = heights(drawn.scene, GENEVA)
    return [
        with_caption(draw_wheel(on, wheel), on, lettered, scale),
        results("table-geneva", words["geneva results"], rows, language, high),
    ]


SHOWN = Views(draw={GENEVA: wheel_views})
