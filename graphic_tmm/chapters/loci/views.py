"""What a sheet shows of the places of a plate."""

from __future__ import annotations

from graphic_tmm.chapters.loci.ink import draw_loci
from graphic_tmm.chapters.loci.record import LOCI_PLAN
from graphic_tmm.chapters.loci.task import LOCI
from graphic_tmm.chapters.loci.words import TITLE
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.views import mu_text


def loci_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the construction."""
    made, language = LOCI_PLAN.of(drawn), drawn.scene.language
    if made is None:
        return []
    closing = made.closing
    title = speaking(language)(TITLE, plate=closing.plate, at=made.at, pin=closing.pins[2])
    on = subject(drawn, title, LOCI)
    view = draw_loci(on, made, len(drawn.names))
    return [with_caption(view, on, lettered, mu_text(drawn.scales[LOCI], language))]


SHOWN = Views(draw={LOCI: loci_views})
