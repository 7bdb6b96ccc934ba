"""What a sheet shows of centrodes: both curves of each link, the table of their points and arcs."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.centrodes.ink import draw_centrodes
from graphic_tmm.chapters.centrodes.record import CENTRODES_PLAN, Centrodes
from graphic_tmm.chapters.centrodes.table import lengths, link_columns
from graphic_tmm.chapters.centrodes.task import CENTRODES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.scene.captions import view_name


def centrode_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the centrodes of each link and their table; none where a scene asks for none."""
    return [
        view for made in CENTRODES_PLAN.of(drawn) or () for view in _link(drawn, made, lettered)
    ]


def _link(drawn: Drawn, made: Centrodes, lettered: bool) -> list[Drawing]:
    language = drawn.scene.language
    _, high = speaking(language), heights(drawn.scene, CENTRODES)
    on = subject(drawn, view_name(made.view, language), CENTRODES)
    places = [k for k in drawn.all if k not in drawn.undrawn]
    lines = [
        mu_text(drawn.scales[made.view], language),
        _("the moving centrode dashed, as in position {name}", name=drawn.names[made.touching]),
    ]
    off = abs(float(drawn.reading.figure(made.off)[0, 0]))
    if off == off:
        lines.append(f"δ = {fixed(off, 1, language)}°")
    drawing = draw_centrodes(on, made, drawn.names, places)
    table = result_table(
        CENTRODES, [*link_columns(drawn, made)], drawn.names, language, heights=high, upright=True
    )
    return [
        with_caption(drawing, on, lettered, *lines),
        table._replace(name=f"table-{made.view}".replace(" ", "-")),
    ]


def _named_marks(project: Project) -> dict[tuple[str, str], Mark]:
    return {
        (made.view, name): mark
        for made in CENTRODES_PLAN.of(project) or ()
        for name, mark in lengths(made).items()
    }


SHOWN = Views(draw={CENTRODES: centrode_views})
READINGS = Readings(named_marks=_named_marks)
