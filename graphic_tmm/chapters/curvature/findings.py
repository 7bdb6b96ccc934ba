"""What is warned of curvature: positions in which a construction reaches too far, or is not there."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.scales import FAR
from graphic_tmm.chapters.curvature.table import drawn_places
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.findings import Warned
from graphic_tmm.scene.captions import captions

_NOT_DRAWN = said(
    "{view}: not drawn in positions {names}: parts of it are infinitely far, or {times:g} times as far as the "
    "link reaches (it nearly moves without turning, or is near a dead centre); write other positions"
)


def _warnings(drawn: Drawn, language: str) -> Iterator[str]:
    made = CURVATURE_PLAN.of(drawn)
    if made is None:
        return
    for figure in made.figures:
        there = drawn_places(drawn, figure.mu)
        names = ", ".join(drawn.names[k] for k in made.places if k not in there)
        if names:
            view = captions(language)[figure.view]
            yield speaking(language)(_NOT_DRAWN, view=view, names=names, times=FAR)


WARNINGS = Warned(_warnings)
