"""Kinematic diagrams: displacement, velocity and acceleration of a slider's point over time or angle.

One of them is laid off over a base from what the plans give; the others follow from it on the board,
without calculation. A diagram of y over x drawn to μ_y and μ_x has the slope (μ_x/μ_y)·dy/dx on paper. From
a pole at the distance H to the left of the next diagram's origin a ray with that slope cuts off
H·(μ_x/μ_y)·dy/dx on the axis of ordinates: that is the derivative to the scale

    μ_V = μ_S/(μ_t·H),      and backwards, for integration,      μ_S = μ_V·μ_t·H.

So H is the only freedom: either H is chosen and the scale follows, or a standard scale is wanted and H
follows from it (H = μ_S/(μ_V·μ_t)).

- Chords: the slope of a chord is the mean derivative over its interval, so what it gives belongs to the
  interval's *middle* (a `Middles`, never a `Boundaries`); a smooth curve through the middles is read at the
  boundaries.
- Tangents: the smooth curve is drawn first; what its tangents give belongs to the boundaries.
- Integration: over each interval the curve is replaced by its mean ordinate (by the area under the curve,
  or by the ordinate at the middle), and rays from the pole give the segments of the integral, one after
  another.

Both kinds of mistakes of the method, that of chords on few intervals and that of the ruler enlarged by the
pole, are measured in `graphic_tmm/accuracy`. Over the angle of the crank μ_φ stands for μ_t, and ω is left
to the reader.

Draws: place ``diagrams`` (graphs one below the other, and their table). Builds on kinematics: a point that
slides on the frame (`plan.sliding_leg`), its plans of velocities or positions.

Sources: Артоболевский И. И., Теория механизмов и машин (кинематические диаграммы, графическое
дифференцирование и интегрирование); as worked in the course project with chords on 8 intervals (scene
``slider-diagrams``).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from graphic_tmm.board import roles
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapter import Chapter, Place
from graphic_tmm.chapters.diagrams.captions import CAPTIONS, SYMBOLS
from graphic_tmm.chapters.diagrams.names import BASE_VIEW, CALCULATED, DIAGRAMS, VIEWS
from graphic_tmm.chapters.diagrams.task import ASKED, SECTIONS
from graphic_tmm.chapters.kinematics.names import (
    ACCELERATIONS,
    FULL_TURN,
    KINEMATICS,
    POSITIONS,
    VELOCITIES,
)
from graphic_tmm.fitting.scales import GRAPH, GRAPHS
from graphic_tmm.late import late

if TYPE_CHECKING:
    from collections.abc import Container

    from graphic_tmm.board.execute import Reading
    from graphic_tmm.board.record import Mark
    from graphic_tmm.chapter import Holder
    from graphic_tmm.project import Project

with late(__name__):
    from graphic_tmm.chapters.diagrams.accuracy import ACCURACY
    from graphic_tmm.chapters.diagrams.asks import asks
    from graphic_tmm.chapters.diagrams.beside import record_beside
    from graphic_tmm.chapters.diagrams.captions import called
    from graphic_tmm.chapters.diagrams.choice import choose
    from graphic_tmm.chapters.diagrams.note import note
    from graphic_tmm.chapters.diagrams.note_conclusions import concludes
    from graphic_tmm.chapters.diagrams.plan import record
    from graphic_tmm.chapters.diagrams.table import diagram_columns
    from graphic_tmm.chapters.diagrams.views import diagram_views
    from graphic_tmm.language.catalogue import speaking


def _named(project: Project, reading: Reading, given: Container[Mark]) -> dict[str, Scale]:
    """Return the scale of the base."""
    mu = DIAGRAMS.on(project).base.mu
    return {BASE_VIEW: Scale(mu.name, float(reading[mu][0, 0]), mu.unit)}


def _title(holder: Holder, view: str, language: str) -> str:
    made = DIAGRAMS.on(holder)
    own = any(chart.view == view for chart in made.charts.values())
    return called(view, speaking(language), made.order.point) if own else ""


CHAPTER = Chapter(
    name=DIAGRAMS.chapter,
    number=3,
    captions=CAPTIONS,
    called=called,
    builds_on=(KINEMATICS.chapter,),
    places=(
        Place(
            DIAGRAMS.chapter,
            30,
            diagram_views,
            asks=asks,
            beside=(ACCELERATIONS,),
            follows=(POSITIONS,),
            sizes=lambda scene, view: (GRAPHS,),
        ),
    ),
    sizes=(GRAPH,),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=lambda scene: {VELOCITIES: True},
    sections=SECTIONS,
    record=record,
    aside=record_beside,
    result=lambda made: [chart.ordinates[0] for chart in made.charts.values()],
    remedy=FULL_TURN,
    charts=lambda made: made.charts.values(),
    choice=choose,
    scales=lambda fitting: fitting.shorter(
        GRAPHS, [("diagrams.base", view, roles.BASE) for view in (VIEWS["S"], VIEWS["V"])]
    ),
    named=_named,
    scale_key=lambda view: f"mu_{view.replace(' ', '_')}" if view in VIEWS.values() else "",
    plans=(DIAGRAMS.chapter,),
    columns=diagram_columns,
    views=lambda project: {
        DIAGRAMS.chapter: [
            *(chart.view for chart in DIAGRAMS.on(project).charts.values()),
            CALCULATED,
        ]
    },
    titles=_title,
    accuracy=ACCURACY,
    concludes=concludes,
    note=note,
    sources=("artobolevsky",),
    symbols=SYMBOLS,
)
