"""Kinematic diagrams: displacement, velocity and acceleration of a slider's point over time or angle.

What the plans give is laid off over a base; the others follow by chords or tangents (differentiation) and by mean
ordinates (integration) against a pole, whose distance H sets the scale: μ_V = μ_S/(μ_t·H).

Sources: Артоболевский И. И., Теория механизмов и машин, гл. 4 (кинематические диаграммы).
"""

from __future__ import annotations

from collections.abc import Container

from graphic_tmm.board import roles
from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapter import Chapter, Holder, Place, Size
from graphic_tmm.chapters.diagrams.accuracy import ACCURACY
from graphic_tmm.chapters.diagrams.captions import CAPTIONS, called
from graphic_tmm.chapters.diagrams.plan import BASE_VIEW, DIAGRAMS, VIEWS, record
from graphic_tmm.chapters.diagrams.table import diagram_columns
from graphic_tmm.chapters.diagrams.task import ASKED, SECTIONS
from graphic_tmm.chapters.diagrams.views import diagram_views
from graphic_tmm.chapters.kinematics.plan import ACCELERATIONS, KINEMATICS, POSITIONS, VELOCITIES
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.project import Project


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
            beside=(ACCELERATIONS,),
            follows=(POSITIONS,),
            sizes=lambda scene, view: ("graphs",),
        ),
    ),
    sizes=(Size("graphs", least=0.2),),
    asked=lambda scene: ASKED.of(scene) is not None,
    needs=lambda scene: {VELOCITIES: True},
    sections=SECTIONS,
    record=record,
    charts=lambda made: made.charts.values(),
    scales=lambda fitting: fitting.shorter(
        "graphs", [("diagrams.base", view, roles.BASE) for view in (VIEWS["S"], VIEWS["V"])]
    ),
    named=_named,
    scale_key=lambda view: f"mu_{view.replace(' ', '_')}" if view in VIEWS.values() else "",
    plans=(DIAGRAMS.chapter,),
    columns=diagram_columns,
    views=lambda project: {
        DIAGRAMS.chapter: [chart.view for chart in DIAGRAMS.on(project).charts.values()]
    },
    titles=_title,
    accuracy=ACCURACY,
)
