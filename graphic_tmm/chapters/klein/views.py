"""What a sheet shows of the constructions: each in its positions, their tables."""

from __future__ import annotations

from graphic_tmm.chapters.klein.ink import draw_construction
from graphic_tmm.chapters.klein.record import KLEIN_PLAN, Figure
from graphic_tmm.chapters.klein.table import figure_columns
from graphic_tmm.chapters.klein.table import results as figures
from graphic_tmm.chapters.klein.task import KLEIN, TABLE
from graphic_tmm.chapters.klein.words import SEVERAL
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.fitting.scales import scale_of
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.views import in_rows, mu_text
from graphic_tmm.readers.result_table import result_table, results
from graphic_tmm.scene.captions import captions


def construction_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the constructions, position by position."""
    made, found = KLEIN_PLAN.of(drawn), list[Drawing]()
    for figure in made.figures.values() if made is not None else ():
        found += _row(drawn, figure, lettered)
    return found


def _row(drawn: Drawn, figure: Figure, lettered: bool) -> list[Drawing]:
    language, view = drawn.scene.language, figure.view
    reading, words = drawn.of(view), captions(language)
    if reading is None or view not in drawn.scales:
        return []
    views, told = list[Drawing](), list[tuple[str, str]]()
    scales = [drawn.scales[view], *(scale_of(one, drawn.reading) for one in figure.scales[1:])]
    for k, place in enumerate(drawn.row(view)):
        if place in drawn.undrawn:
            continue
        name = drawn.names[place]
        title = f"{words[view]}, {words['position']} {name}"
        on = subject(drawn, title, KLEIN, name=f"{view}-{name}")._replace(reading=reading)
        drawing = finished(draw_construction(on, figure, k), lettered)
        views.append(drawing._replace(position=place))
        told.append((escape(name), ", ".join(mu_text(one.at(place), language) for one in scales)))
    several = speaking(language)(SEVERAL[view])
    return in_rows(views, view, several, told, heights(drawn.scene, KLEIN)) if views else []


def table_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the tables of the constructions."""
    made, found = KLEIN_PLAN.of(drawn), list[Drawing]()
    for figure in made.figures.values() if made is not None else ():
        rows = [one.without(drawn.undrawn) for one in figure_columns(drawn, figure)]
        if rows:
            high = heights(drawn.scene, TABLE, KLEIN)
            found.append(
                result_table(figure.view, rows, drawn.names, drawn.scene.language, heights=high)
            )
    return [*found, *_compared(drawn)] if found else []


def _compared(drawn: Drawn) -> list[Drawing]:
    """Return the table of what the ways take and how true they are."""
    language = drawn.scene.language
    words, high = captions(language), heights(drawn.scene, TABLE, KLEIN)
    rows = [
        [words[name], fixed(value, 1 if of else 0, language), unit(of, language) if of else "—"]
        for name, (value, of) in single(figures(drawn)).items()
    ]
    return [results("table-klein-ways", words["klein results"], rows, language, high)]


SHOWN = Views(draw={KLEIN: construction_views, TABLE: table_views})
