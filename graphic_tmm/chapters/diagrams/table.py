"""The columns of kinematic diagrams, and what protocols call them."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN
from graphic_tmm.chapters.diagrams.task import CALCULATED, DIAGRAMS
from graphic_tmm.chapters.diagrams.words import called
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, ordinates, row_of
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.chapter import Holder

PLAN = DIAGRAMS
COMPARED = ("V", "a")
"""What plans give too."""
EVEN = 1e-11
"""Figures that differ by less of their own size differ by rounding only."""


def diagram_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield the columns of the diagrams: what they give, what the plans give, the difference in %.

    The difference is told in % of the largest that the plan gives.
    """
    kinematic, count = DIAGRAMS_PLAN.on(drawn), len(drawn.names)
    for symbol, chart in kinematic.charts.items():
        rows = ordinates(drawn.reading, chart.ordinates[0], chart.mu, count)
        yield Column(PLAN, symbol, symbol, chart.unit, *rows)
        if symbol not in COMPARED or symbol not in kinematic.planned:
            continue
        mark = kinematic.planned[symbol]
        source = drawn.of(mark.view)
        if source is None:
            continue
        due = source.figure(mark, drawn.project.scale(mark.view))
        plan = row_of(due, drawn.row(mark.view), count)
        name = f"{symbol}_plan"
        yield Column(PLAN, name, name, chart.unit, empty(count), plan)
        yield _difference(f"{symbol}_difference", rows[1], plan, drawn.percent_decimals)


def _difference(letter: str, found: Reals, due: Reals, places: int) -> Column:
    """Return by how much figures differ from what is due, in % of the largest due of their drawing.

    ``places``: decimals, as many as can be read.
    """
    largest = np.fmax.reduce(np.abs(due), axis=1, keepdims=True, initial=0.0)
    apart = np.where(np.isclose(found, due, rtol=EVEN, atol=0.0), 0.0, found - due)
    row = np.round(100.0 * apart / np.where(largest > 0.0, largest, np.nan), places) + 0.0
    return Column(PLAN, letter, letter, "%", empty(row.shape[1]), row)


TABLE = Tabled(columns=diagram_columns)


def _views(project: Project) -> dict[str, list[str]]:
    charts = DIAGRAMS_PLAN.on(project).charts.values()
    return {DIAGRAMS: [*(chart.view for chart in charts), CALCULATED]}


def _title(holder: Holder, view: str, language: str) -> str:
    made = DIAGRAMS_PLAN.on(holder)
    own = any(chart.view == view for chart in made.charts.values())
    return called(view, speaking(language), made.order.point) if own else ""


PROTOCOL = Protocols(views=_views, titles=_title)
